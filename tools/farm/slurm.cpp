#include "farm/slurm.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <set>
#include <sstream>
#include <vector>

#include "core/error.h"
#include "core/process.h"

namespace tyndall::farm {
namespace {

constexpr std::array kWaits{"PENDING",     "CONFIGURING",  "REQUEUED",     "REQUEUE_HOLD",
                            "REQUEUE_FED", "SPECIAL_EXIT", "RESV_DEL_HOLD"};
constexpr std::array kRuns{"RUNNING", "COMPLETING", "SIGNALING", "STAGE_OUT", "RESIZING", "SUSPENDED", "STOPPED"};

std::vector<std::string> split(const std::string& line) {
    std::vector<std::string> fields;
    std::istringstream in(line);
    for (std::string field; std::getline(in, field, '|');) fields.push_back(field);
    return fields;
}

/// 0 for what is no number.
long number(std::string_view text) {
    long value = 0;
    std::from_chars(text.data(), text.data() + text.size(), value);
    return value;
}

/// Keeps the newer of two attempts, and one that is under way before all.
void keep(Queue& queue, int task, const QueueEntry& entry) {
    const auto rank = [](const QueueEntry& e) {
        return std::pair(e.runs() ? 2 : e.waits() ? 1 : 0, number(e.job));  // "12_3" reads as 12
    };
    const auto [old, is_new] = queue.try_emplace(task, entry);
    if (!is_new && rank(entry) >= rank(old->second)) old->second = entry;
}

/// The program's complaint without its name in front of each line.
std::string complaint(const std::string& program, const std::string& errors) {
    std::istringstream in(errors);
    std::string text;
    for (std::string line; std::getline(in, line);) {
        for (const std::string& prefix : {program + ": ", std::string("error: "), std::string("fatal: ")})
            if (line.starts_with(prefix)) line.erase(0, prefix.size());
        if (!line.empty()) text += (text.empty() ? "" : "; ") + line;
    }
    return text.empty() ? "it does not say why" : text;
}

ProcessResult run_slurm(const std::vector<std::string>& command, const std::filesystem::path& folder = {}) {
    try {
        return run_process(command, folder);
    } catch (const Error& error) {
        throw Error(
            Diagnostic{{},
                       std::string("Slurm: ") + error.what(),
                       "Slurm's programs on this machine (Debian: slurm-client) and a cluster to send jobs to"});
    }
}

[[noreturn]] void refuse(const std::string& program, const std::string& errors) {
    const std::string text = complaint(program, errors);
    std::string hint;
    if (text.find("contact slurm controller") != std::string::npos ||
        text.find("configuration source") != std::string::npos)
        hint = "a slurmctld that answers, and a slurm.conf here or in SLURM_CONF that names it";
    if (text.find("job array specification") != std::string::npos)
        hint = "fewer tasks: the cluster's MaxArraySize says how many ('scontrol show config')";
    throw Error(Diagnostic{{}, fmt::format("Slurm ({}): {}", program, text), hint, {}});
}

/// Throws for a partition that the cluster does not have.
void check_partition(const std::string& partition) {
    const ProcessResult said = run_slurm({"sinfo", "--noheader", "--format=%R"});
    std::istringstream in(said.output);
    std::set<std::string> unique;
    for (std::string line; std::getline(in, line);) unique.insert(line);
    if (!said.end.well() || partition.empty() || unique.empty() || unique.contains(partition)) return;
    const std::vector<std::string> names(unique.begin(), unique.end());
    throw Error(Diagnostic{{},
                           "Slurm: unknown partition '" + partition + "'",
                           fmt::format("one of: {}", fmt::join(names, ", ")),
                           nearest_name(partition, names)});
}

}  // namespace

bool QueueEntry::waits() const {
    return std::find(kWaits.begin(), kWaits.end(), state) != kWaits.end();
}
bool QueueEntry::runs() const {
    return std::find(kRuns.begin(), kRuns.end(), state) != kRuns.end();
}

Queue parse_queue(std::string_view text) {
    Queue queue;
    std::istringstream in{std::string(text)};
    for (std::string line; std::getline(in, line);) {
        const std::vector<std::string> f = split(line);
        const int task = f.size() == 6 ? static_cast<int>(number(f[0])) : 0;
        if (task > 0) keep(queue, task, {f[1], f[2] == "None" ? "" : f[2], f[3], f[4], f[5]});
    }
    return queue;
}

Queue parse_history(std::string_view text) {
    Queue queue;
    std::istringstream in{std::string(text)};
    for (std::string line; std::getline(in, line);) {
        const std::vector<std::string> f = split(line);
        const size_t underscore = f.size() == 3 ? f[0].find('_') : std::string::npos;
        if (underscore == std::string::npos) continue;
        const int task = static_cast<int>(number(std::string_view(f[0]).substr(underscore + 1)));
        const QueueEntry entry{f[1].substr(0, f[1].find(' ')), "", f[2], f[0], ""};  // "CANCELLED by 1000"
        if (task > 0 && !entry.waits() && !entry.runs()) keep(queue, task, entry);
    }
    return queue;
}

Queue ask_queue(const std::string& name) {
    const ProcessResult said =
        run_slurm({"squeue", "--noheader", "--array", "--states=all", "--name=" + name, "--format=%K|%T|%r|%N|%i|%M"});
    if (!said.end.well()) refuse("squeue", said.errors);
    return parse_queue(said.output);
}

Queue ask_history(const std::string& name) {
    try {
        const ProcessResult said =
            run_process({"sacct", "--noheader", "--allocations", "--array", "--parsable2", "--name=" + name,
                         "--starttime=now-60days", "--format=JobID,State,NodeList"});
        if (said.end.well()) return parse_history(said.output);
    } catch (const Error&) {  // accounting is a courtesy
    }
    return {};
}

std::string send(const std::filesystem::path& folder, const std::string& array, const std::string& partition) {
    const ProcessResult said = run_slurm({"sbatch", "--parsable", "--array=" + array, "job.sbatch"}, folder);
    if (!said.end.well()) {
        if (said.errors.find("partition") != std::string::npos) check_partition(partition);
        refuse("sbatch", said.errors);
    }
    return said.output.substr(0, said.output.find_first_of(";\n"));
}

}  // namespace tyndall::farm
