#pragma once
/// Submitting a job's tasks to Slurm and collecting what they made.

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "farm/job.h"
#include "farm/status.h"

namespace tyndall::farm {

/// What a submission did.
struct Submission {
    std::vector<int> tasks;  ///< that were sent; empty = there was nothing to send
    std::string job;         ///< Slurm's number of it
};

/// Sends the tasks that are dead or failed or were never sent; those in the queue and those done are left alone. Two of
/// these at once do not send a task twice. Throws Error.
Submission submit(const Job& job);

struct CollectOptions {
    std::filesystem::path out;  ///< the merged film, or the folder of pictures; empty = in the job's folder
    int retry = -1;             ///< wait for the queue and send a dead task again up to so often; negative = neither
    std::string program;        ///< merges films
    std::function<void(const Status&)> progress;  ///< called while waiting
};

/// Merges the shards of a trace or gathers the pictures of captures. Returns the state it found: a trace is merged only
/// when all is done; of captures, what is there is gathered. Throws Error.
Status collect(const Job& job, const CollectOptions& options);
/// Where `collect` puts it.
[[nodiscard]] std::filesystem::path destination(const Job& job, const CollectOptions& options);

}  // namespace tyndall::farm
