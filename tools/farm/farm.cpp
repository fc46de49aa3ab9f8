#include "farm/farm.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <map>
#include <thread>

#include "core/error.h"
#include "core/function_ref.h"
#include "core/log.h"
#include "core/paths.h"
#include "core/process.h"
#include "farm/script.h"

namespace tyndall::farm {
namespace fs = std::filesystem;
namespace {

constexpr std::chrono::seconds kLookEvery{2};
/// Slurm's programs try for some seconds each: a controller that restarts is back by then.
constexpr int kPatience = 20;

/// Keeps other submissions of the job out, on this and, on a shared file system, other machines.
class Lock {
 public:
    explicit Lock(const fs::path& folder)
        : descriptor_(open((folder / ".lock").c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0664)) {
        if (descriptor_ < 0)
            throw Error(Diagnostic{{folder.string()}, std::string("cannot be written: ") + std::strerror(errno)});
        (void)flock(descriptor_, LOCK_EX);  // file systems without locks do without
    }
    ~Lock() { close(descriptor_); }
    Lock(const Lock&) = delete;
    Lock& operator=(const Lock&) = delete;

 private:
    int descriptor_;
};

/// Sends the tasks that are `wanted` when nobody else sends any.
Submission send_wanted(const Job& job, FunctionRef<bool(const TaskStatus&)> wanted) {
    const Lock lock(job.folder);
    const Status status = look_at(job);
    if (!status.problem.empty()) throw Error(status.problem);
    std::vector<int> numbers;
    for (const TaskStatus& task : status.tasks)
        if (wanted(task)) numbers.push_back(task.task.number);
    if (numbers.empty()) return {};
    paths::write_file_atomically(job.folder / "job.sbatch", script_of(job, numbers));
    return {numbers, send(job.folder, array_of(numbers), job.slurm.partition)};
}

/// Waits until the queue holds nothing of the job; sends dead tasks again.
Status wait_for_end(const Job& job, const CollectOptions& options) {
    std::map<int, int> sent;
    const auto again = [&](const TaskStatus& task) {
        return task.state == State::dead && sent[task.task.number] < options.retry;
    };
    for (int silent = 0;;) {
        const Status status = look_at(job);
        if (options.progress) options.progress(status);
        silent = status.problem.empty() ? 0 : silent + 1;
        if (silent > kPatience) return status;
        if (silent == 0 && std::any_of(status.tasks.begin(), status.tasks.end(), again)) {
            const Submission now = send_wanted(job, again);
            for (const int task : now.tasks) ++sent[task];
            if (!now.tasks.empty()) log::info("task {} sent again as job {}", array_of(now.tasks), now.job);
        } else if (silent == 0 && !status.under_way()) {
            return status;
        }
        std::this_thread::sleep_for(kLookEvery);
    }
}

/// What was merged before stays when the shards do not merge.
void merge(const Job& job, const fs::path& out, const std::string& program) {
    const fs::path partial = out.parent_path() / (".merging-" + out.filename().string());
    std::vector<std::string> command{program, "merge"};
    for (const Task& task : tasks_of(job)) command.push_back(task.result.string());
    command.insert(command.end(), {"--out", partial.string()});
    const ProcessResult said = run_process(command);
    if (said.end.well()) return fs::rename(partial, out);
    std::error_code ignored;
    fs::remove(partial, ignored);
    std::string why = said.errors.empty() ? said.output : said.errors;
    while (!why.empty() && why.back() == '\n') why.pop_back();
    throw Error(
        fmt::format("the shards do not merge: {}\nA shard that is damaged is made again after its file is deleted: "
                    "tyndall farm submit {}",
                    why, shell_quote(job.folder.string())));
}

/// A folder per capture, with its name; a name that comes twice has a number.
void gather(const Job& job, const fs::path& out) {
    std::map<std::string, int> names;
    for (const Task& task : tasks_of(job)) {
        const int n = ++names[task.title];
        if (!fs::is_directory(task.result)) continue;
        const fs::path folder = out / (n == 1 ? task.title : fmt::format("{}-{}", task.title, n));
        fs::create_directories(folder);
        fs::copy(task.result, folder, fs::copy_options::overwrite_existing | fs::copy_options::recursive);
    }
}

}  // namespace

Submission submit(const Job& job) {
    return send_wanted(job,
                       [](const TaskStatus& task) { return task.state == State::dead || task.state == State::failed; });
}

fs::path destination(const Job& job, const CollectOptions& options) {
    if (!options.out.empty()) return options.out;
    return job.folder / (job.is_trace() ? fs::path(job.scene).stem().string() + ".exr" : "pictures");
}

Status collect(const Job& job, const CollectOptions& options) {
    Status status = options.retry >= 0 ? wait_for_end(job, options) : look_at(job);
    const fs::path out = destination(job, options);
    try {
        if (!job.is_trace())
            gather(job, out);
        else if (status.all_done())
            merge(job, out, options.program);
    } catch (const fs::filesystem_error& error) {
        throw Error(Diagnostic{{error.path1().string()}, "cannot be gathered: " + error.code().message()});
    }
    return status;
}

}  // namespace tyndall::farm
