#pragma once
/// How the tasks of a job are: what the folder says, joined with what Slurm says.

#include <optional>
#include <string>
#include <vector>

#include "farm/job.h"
#include "farm/slurm.h"

namespace tyndall::farm {

/// See docs/farm.md.
enum class State {
    waiting,  ///< in Slurm's queue
    running,
    done,    ///< ended well, and its result is there
    failed,  ///< its program said that it cannot: doing it again would not help
    dead,    ///< killed, out of time, lost with its node: left the queue without a result
    unknown  ///< without a result, and Slurm does not answer
};
[[nodiscard]] const char* name_of(State state);

/// What a task wrote when it ended.
struct TaskEnd {
    int code = 0;  ///< of its program
    std::string job, node, time;
};
/// Reads `tasks/N.end`; empty when it is not there or makes no sense.
[[nodiscard]] std::optional<TaskEnd> read_end(const std::filesystem::path& file);

struct TaskStatus {
    Task task;
    State state = State::unknown;
    std::string detail;             ///< where, since when, why
    std::vector<std::string> said;  ///< the last lines of its log, of tasks that run, failed or died
};

struct Status {
    std::vector<TaskStatus> tasks;
    std::string problem;  ///< why Slurm does not answer; empty = it does, or was not asked

    [[nodiscard]] int count(State state) const;
    /// The numbers of the tasks in that state.
    [[nodiscard]] std::vector<int> tasks_in(State state) const;
    [[nodiscard]] bool under_way() const { return count(State::waiting) + count(State::running) > 0; }
    [[nodiscard]] bool all_done() const { return count(State::done) == static_cast<int>(tasks.size()); }
};

/// The state of a task from its end, if it wrote one, and from Slurm's word of it, if there is one.
[[nodiscard]] TaskStatus judge(const Task& task, const std::optional<TaskEnd>& end, const QueueEntry* entry);
/// Looks at the folder and asks Slurm of what is not done.
[[nodiscard]] Status look_at(const Job& job);

/// The last `count` lines of a log's last attempt that say something.
[[nodiscard]] std::vector<std::string> last_lines(const std::filesystem::path& log, size_t count);
/// "[#####>>..] 5 of 8 done, 2 running, 1 waiting"
[[nodiscard]] std::string bar(const Status& status);
/// The bar, a line per task that has news, and what to do next.
[[nodiscard]] std::string report(const Job& job, const Status& status);

}  // namespace tyndall::farm
