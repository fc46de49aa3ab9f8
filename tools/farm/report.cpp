// A job's state, for people.
#include <fmt/format.h>

#include <array>
#include <fstream>

#include "farm/script.h"
#include "farm/status.h"

namespace tyndall::farm {
namespace fs = std::filesystem;
namespace {

constexpr std::array kStates{State::done, State::running, State::waiting, State::failed, State::dead, State::unknown};
constexpr int kBarWidth = 40;
/// Jobs with more tasks than this list those that need an eye only.
constexpr size_t kAllListed = 40;

char mark_of(State state) {
    switch (state) {
        case State::done:
            return '#';
        case State::running:
            return '>';
        case State::failed:
        case State::dead:
            return '!';
        case State::unknown:
            return '?';
        case State::waiting:
            break;
    }
    return '.';
}

/// The end of a file.
std::string tail(const fs::path& file, std::streamoff bytes) {
    std::ifstream in(file, std::ios::binary | std::ios::ate);
    if (!in) return {};
    const std::streamoff size = in.tellg(), wanted = std::min(size, bytes);
    std::string text(static_cast<size_t>(wanted), '\0');
    in.seekg(size - wanted);
    in.read(text.data(), wanted);
    return text;
}

std::string next_steps(const Job& job, const Status& status) {
    const std::string folder = shell_quote(job.folder.string());
    if (!status.problem.empty()) return status.problem + "\n";
    if (status.all_done()) return fmt::format("next: tyndall farm collect {}\n", folder);
    std::string text;
    if (status.count(State::failed) > 0) text += "failed: see the logs; when the cause is gone, submit again\n";
    if (status.count(State::failed) + status.count(State::dead) > 0)
        text += fmt::format("next: tyndall farm submit {}    (only what is not done)\n", folder);
    return text;
}

}  // namespace

std::vector<std::string> last_lines(const fs::path& log, size_t count) {
    std::vector<std::string> lines;
    std::string line;
    const auto finish = [&] {
        if (line.starts_with("== task "))
            lines.clear();  // another attempt begins
        else if (line.find_first_not_of(" \t") != std::string::npos)
            lines.push_back(line);
        line.clear();
    };
    for (const char c : tail(log, 8192)) {
        if (c == '\n' || c == '\r')
            finish();
        else if (static_cast<unsigned char>(c) >= ' ')  // no terminal codes
            line += c;
    }
    finish();
    if (lines.size() > count) lines.erase(lines.begin(), lines.end() - static_cast<std::ptrdiff_t>(count));
    return lines;
}

std::string bar(const Status& status) {
    const auto total = static_cast<int>(status.tasks.size());
    std::string cells, words;
    int before = 0;
    for (const State state : kStates) {
        const int n = status.count(state);
        const int end = (before + n) * kBarWidth / total;
        cells.append(static_cast<size_t>(end - before * kBarWidth / total), mark_of(state));
        before += n;
        if (state == State::done)
            words += fmt::format("{} of {} done", n, total);
        else if (n > 0)
            words += fmt::format(", {} {}", n, name_of(state));
    }
    return fmt::format("[{}] {}", cells, words);
}

std::string report(const Job& job, const Status& status) {
    std::string text = fmt::format("{}: {}\n{}\n", job.name, job.title(), bar(status));
    const bool brief = status.tasks.size() > kAllListed;
    for (const TaskStatus& task : status.tasks) {
        if (brief && (task.state == State::done || task.state == State::waiting)) continue;
        text += fmt::format("{:>5}  {:8} {}{}{}\n", task.task.number, name_of(task.state), task.task.title,
                            task.detail.empty() ? "" : ": ", task.detail);
        for (const std::string& line : task.said) text += "           | " + line + "\n";
        if (task.state == State::failed) text += "           " + task.task.log.string() + "\n";
    }
    return text + next_steps(job, status);
}

}  // namespace tyndall::farm
