#include "farm/status.h"

#include <fmt/format.h>

#include <algorithm>
#include <csignal>
#include <cstring>
#include <set>
#include <sstream>

#include "core/error.h"
#include "core/paths.h"

namespace tyndall::farm {
namespace fs = std::filesystem;
namespace {

/// The signals that come from outside: somebody, the system or Slurm ended the program.
bool from_outside(int signal) {
    return signal == SIGKILL || signal == SIGTERM || signal == SIGINT || signal == SIGHUP || signal == SIGXCPU;
}

std::string place(const std::string& node, const std::string& job) {
    std::string text;
    if (!node.empty()) text += " on " + node;
    if (!job.empty()) text += " (job " + job + ")";
    return text;
}

/// Why a task that left the queue has no result.
std::string cause(const QueueEntry& entry) {
    const std::string where = place(entry.node, entry.job);
    if (entry.state == "TIMEOUT" || entry.state == "DEADLINE") return "its time ran out (--time-limit)" + where;
    if (entry.state == "OUT_OF_MEMORY") return "out of memory (--mem)" + where;
    if (entry.state == "NODE_FAIL" || entry.state == "BOOT_FAIL") return "its node failed" + where;
    if (entry.state == "CANCELLED") return "cancelled" + where;
    if (entry.state == "PREEMPTED") return "preempted" + where;
    if (entry.state == "COMPLETED") return "ended, but its result is not there" + where;
    return "ended without a result" + where + (entry.reason.empty() ? "" : ", " + entry.reason);
}

bool is_done(const Task& task, const std::optional<TaskEnd>& end) {
    std::error_code ignored;
    return end && end->code == 0 && fs::exists(task.result, ignored);
}

/// Of a task that is neither done nor in the queue.
void judge_end(TaskStatus& status, const TaskEnd& end) {
    const std::string where = place(end.node, end.job);
    const int signal = end.code > 128 ? end.code - 128 : 0;
    status.state = end.code == 0 || from_outside(signal) ? State::dead : State::failed;
    if (end.code == 0)
        status.detail = "ended, but its result is not there" + where;
    else if (signal > 0)
        status.detail = fmt::format("its program was ended by signal {} ({}){}", signal, strsignal(signal), where);
    else
        status.detail = fmt::format("its program ended with code {}{}", end.code, where);
}

/// Slurm's word of the tasks: of those without an entry in the queue, the accounting's, when there is one.
Queue ask(const Job& job, const std::vector<Task>& open, std::string& problem) {
    Queue queue;
    try {
        queue = ask_queue(job.name);
    } catch (const Error& error) {
        problem = error.what();
        return {};
    }
    const bool all_known =
        std::all_of(open.begin(), open.end(), [&](const Task& task) { return queue.contains(task.number); });
    if (!all_known) queue.merge(ask_history(job.name));
    return queue;
}

}  // namespace

const char* name_of(State state) {
    switch (state) {
        case State::waiting:
            return "waiting";
        case State::running:
            return "running";
        case State::done:
            return "done";
        case State::failed:
            return "FAILED";
        case State::dead:
            return "DEAD";
        case State::unknown:
            break;
    }
    return "unknown";
}

std::optional<TaskEnd> read_end(const fs::path& file) {
    std::error_code ignored;
    if (!fs::is_regular_file(file, ignored)) return std::nullopt;
    TaskEnd end;
    std::istringstream in(paths::read_file(file));
    if (!(in >> end.code >> end.job >> end.node >> end.time)) return std::nullopt;
    return end;
}

int Status::count(State state) const {
    return static_cast<int>(
        std::count_if(tasks.begin(), tasks.end(), [&](const TaskStatus& task) { return task.state == state; }));
}

std::vector<int> Status::tasks_in(State state) const {
    std::vector<int> numbers;
    for (const TaskStatus& task : tasks)
        if (task.state == state) numbers.push_back(task.task.number);
    return numbers;
}

TaskStatus judge(const Task& task, const std::optional<TaskEnd>& end, const QueueEntry* entry) {
    TaskStatus status{task, State::dead, {}, {}};
    if (is_done(task, end)) {
        status.state = State::done;
        status.detail = end->time + place(end->node, end->job);
    } else if (entry != nullptr && entry->waits()) {
        status.state = State::waiting;
        status.detail = entry->reason;
    } else if (entry != nullptr && entry->runs()) {
        status.state = State::running;
        status.detail = entry->elapsed + place(entry->node, entry->job);
    } else if (end) {
        judge_end(status, *end);
    } else if (entry != nullptr) {
        status.detail = cause(*entry);
    } else {
        std::error_code ignored;
        status.detail =
            fs::exists(task.log, ignored) ? "left the queue without a result" : "not in the queue, never began";
    }
    return status;
}

Status look_at(const Job& job) {
    Status status;
    const std::vector<Task> tasks = tasks_of(job);
    std::vector<Task> open;
    for (const Task& task : tasks)
        if (!is_done(task, read_end(task.end))) open.push_back(task);
    const Queue queue = open.empty() ? Queue{} : ask(job, open, status.problem);
    for (const Task& task : tasks) {
        const std::optional<TaskEnd> end = read_end(task.end);  // after Slurm was asked: it may have come meanwhile
        const auto entry = queue.find(task.number);
        TaskStatus judged = judge(task, end, entry == queue.end() ? nullptr : &entry->second);
        if (!status.problem.empty() && judged.state == State::dead && !end)
            judged = {task, State::unknown, "no result yet", {}};
        if (judged.state == State::running) judged.said = last_lines(task.log, 1);
        if (judged.state == State::failed || judged.state == State::dead) judged.said = last_lines(task.log, 3);
        status.tasks.push_back(std::move(judged));
    }
    return status;
}

}  // namespace tyndall::farm
