#pragma once
/// Slurm's programs: sbatch, squeue, sacct, sinfo.

#include <filesystem>
#include <map>
#include <string>
#include <string_view>

namespace tyndall::farm {

/// What Slurm says of a task.
struct QueueEntry {
    std::string state;    ///< as Slurm writes it: PENDING, RUNNING, TIMEOUT, ...
    std::string reason;   ///< why it waits or failed, as Slurm writes it; may be empty
    std::string node;     ///< where it runs or ran; may be empty
    std::string job;      ///< Slurm's number of it, "12_3"
    std::string elapsed;  ///< of running, "3:12"

    [[nodiscard]] bool waits() const;
    [[nodiscard]] bool runs() const;
};

/// By the task's number.
using Queue = std::map<int, QueueEntry>;

/// What `squeue` wrote in the form that ask_queue wants: of several attempts of a task the one that is under way, or
/// the last.
[[nodiscard]] Queue parse_queue(std::string_view text);
/// What `sacct` wrote in the form that ask_history wants; the last ended attempt of each task.
[[nodiscard]] Queue parse_history(std::string_view text);

/// The tasks of the job of that name that are in the queue, or ended so recently that the controller remembers them.
/// Throws Error when Slurm is not there or does not answer.
[[nodiscard]] Queue ask_queue(const std::string& name);
/// How the tasks of the job of that name ended, from the accounting database; empty where there is none.
[[nodiscard]] Queue ask_history(const std::string& name);
/// Submits `folder`/job.sbatch for the tasks of `array`; returns Slurm's number of the job. `partition` is what the
/// script asks for, for messages. Throws Error.
std::string send(const std::filesystem::path& folder, const std::string& array, const std::string& partition);

}  // namespace tyndall::farm
