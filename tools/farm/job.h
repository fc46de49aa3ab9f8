#pragma once
/// A farm job: a folder on a shared file system that says what is to be computed, and gathers what was.
///
///     JOB/job.json         what: a trace in shards, or capture files; written once
///     JOB/job.sbatch       the script that Slurm runs; written on each submission
///     JOB/tasks/3.exr      a shard of a trace, or tasks/3/ the pictures of a capture
///     JOB/tasks/3.end      how the task ended; written by the task itself, at once and whole
///     JOB/logs/3.log       what its program said, over all attempts

#include <filesystem>
#include <string>
#include <vector>

#include "ecs/description.h"

namespace tyndall::farm {

/// What a task asks of the cluster, as sbatch takes it; empty or 0 = the cluster's own choice.
struct Resources {
    std::string partition, time, memory;
    int32_t cpus = 0;
    std::vector<std::string> sbatch;  ///< further options, such as "--account=film"
};
void describe(StructBuilder<Resources>& d);

/// The content of a job.json.
struct Job {
    int32_t tyndall_farm = 1;           ///< version of the format
    std::string name;                   ///< of the job in Slurm's queue; no other job has it
    std::string program;                ///< tyndall, as the nodes find it
    std::string directory;              ///< where tasks run: relative names in `options` start there
    std::string scene;                  ///< of a trace
    int32_t shards = 0;                 ///< of a trace: one task each
    std::vector<std::string> captures;  ///< scene or capture files: one task each
    std::vector<std::string> options;   ///< of `tyndall trace` or `tyndall capture`
    Resources slurm;
    std::filesystem::path folder;  ///< absolute; where it was read from

    [[nodiscard]] bool is_trace() const { return captures.empty(); }
    /// "trace of chapel.json in 8 shards"
    [[nodiscard]] std::string title() const;
};
void describe(StructBuilder<Job>& d);

/// One task of a job and where its files are.
struct Task {
    int number = 0;     ///< index in Slurm's array, from 1
    std::string title;  ///< "shard 3/8", or the capture's name
    std::filesystem::path result, end, log;
};
[[nodiscard]] std::vector<Task> tasks_of(const Job& job);

/// Whether a folder holds a job.json.
[[nodiscard]] bool is_job(const std::filesystem::path& folder);
/// Throws Error for a folder that is no job, and for a job.json that does not make sense.
[[nodiscard]] Job load_job(const std::filesystem::path& folder);
/// Makes the job's folders and writes its job.json. Throws Error, also when the folder holds something else.
void save_job(const Job& job);
/// A name like "chapel-3f2a91c4" that no other job has.
[[nodiscard]] std::string unique_name(const std::string& stem);
/// Throws Error when two jobs would compute different things: a folder keeps one job.
void require_same_work(const Job& there, const Job& wanted);

}  // namespace tyndall::farm
