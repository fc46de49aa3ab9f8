#include "farm/script.h"

#include <fmt/format.h>

namespace tyndall::farm {
namespace {

std::string quoted(const std::vector<std::string>& words) {
    std::string line;
    for (const std::string& word : words) line += " " + shell_quote(word);
    return line;
}

/// The lines that sbatch itself reads.
std::string directives(const Job& job, std::span<const int> tasks) {
    std::string text;
    const auto add = [&](const char* option, const std::string& value) {
        if (!value.empty()) text += fmt::format("#SBATCH {}={}\n", option, value);
    };
    add("--job-name", job.name);
    add("--array", array_of(tasks));
    add("--output", "logs/%a.log");
    add("--open-mode", "append");
    text += "#SBATCH --requeue\n";
    add("--partition", job.slurm.partition);
    add("--time", job.slurm.time);
    add("--mem", job.slurm.memory);
    add("--cpus-per-task", job.slurm.cpus > 0 ? std::to_string(job.slurm.cpus) : "");
    for (const std::string& option : job.slurm.sbatch) text += fmt::format("#SBATCH {}\n", option);
    return text;
}

/// Makes the task's command line the script's arguments.
std::string arguments(const Job& job, std::span<const int> tasks) {
    if (job.is_trace())
        return fmt::format(
            "result=$job/tasks/$task.exr\n"
            "set -- trace {}{} --shard \"$task/{}\" --out \"$result\" --resume\n",
            shell_quote(job.scene), quoted(job.options), job.shards);
    std::string text = "result=$job/tasks/$task\ncase $task in\n";
    for (const int task : tasks)
        text +=
            fmt::format("{}) set -- capture {} ;;\n", task, shell_quote(job.captures[static_cast<size_t>(task - 1)]));
    return text + fmt::format("esac\nset -- \"$@\"{} --out \"$result\"\n", quoted(job.options));
}

constexpr const char* kRun = R"sh(
printf '== task %s, job %s, %s, %s\n' "$task" "$id" "$node" "$(date +%FT%T)"
end=$job/tasks/$task.end
if grep -qs '^0 ' "$end" && [ -e "$result" ]; then
    echo "this task was done before"
    exit 0
fi
rm -f -- "$end"

# Slurm sends TERM when the time is up or the job is cancelled: the program saves what it has, and the task has no end,
# so that it goes on when it is submitted again.
trap 'stopped=yes; [ -z "$!" ] || kill -TERM "$!" 2>/dev/null' TERM
"$program" "$@" &
[ -z "$stopped" ] || kill -TERM "$!"
wait "$!"
code=$?
while [ -n "$stopped" ] && kill -0 "$!" 2>/dev/null; do wait "$!"; done
[ -z "$stopped" ] || exit 143

# The end is there at once and whole, or not at all.
printf '%s %s %s %s\n' "$code" "$id" "$node" "$(date +%FT%T)" >"$end.$id" && mv -- "$end.$id" "$end"
exit "$code"
)sh";

}  // namespace

std::string shell_quote(const std::string& text) {
    constexpr const char* kPlain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=./,:@%";
    if (!text.empty() && text.find_first_not_of(kPlain) == std::string::npos) return text;
    std::string word = "'";
    for (const char c : text) {
        if (c == '\'')
            word += "'\\''";
        else
            word += c;
    }
    return word + "'";
}

std::string array_of(std::span<const int> tasks) {
    std::string text;
    for (size_t i = 0; i < tasks.size();) {
        size_t last = i;
        while (last + 1 < tasks.size() && tasks[last + 1] == tasks[last] + 1) ++last;
        text += (text.empty() ? "" : ",") + std::to_string(tasks[i]);
        if (last > i) text += "-" + std::to_string(tasks[last]);
        i = last + 1;
    }
    return text;
}

std::string script_of(const Job& job, std::span<const int> tasks) {
    return fmt::format(
        "#!/bin/bash\n"
        "# Written by 'tyndall farm submit', again on each submission. A task of the array runs one command line, and\n"
        "# marks its end with the exit code. By hand, from this folder: sbatch job.sbatch\n"
        "{}\n"
        "job={}\n"
        "program={}\n"
        "cd {} || exit\n"
        "task=$SLURM_ARRAY_TASK_ID id=${{SLURM_ARRAY_JOB_ID}}_$task node=${{SLURMD_NODENAME:-$(hostname)}}\n"
        "stopped=\n"
        "{}{}",
        directives(job, tasks), shell_quote(job.folder.string()), shell_quote(job.program), shell_quote(job.directory),
        arguments(job, tasks), kRun);
}

}  // namespace tyndall::farm
