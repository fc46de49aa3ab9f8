#include "farm/job.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <random>

#include "core/error.h"
#include "core/paths.h"
#include "scene/scene_file.h"

namespace tyndall::farm {
namespace fs = std::filesystem;

void describe(StructBuilder<Resources>& d) {
    d.doc("What a task asks of the cluster; empty = the cluster's own choice.");
    d.field("partition", &Resources::partition, "Slurm partition.");
    d.field("time", &Resources::time, "Longest time of a task, such as \"2:00:00\".");
    d.field("memory", &Resources::memory, "Memory of a task, such as \"4G\".");
    d.field("cpus", &Resources::cpus, "Processors of a task; 0 = the cluster's own choice.").range(0, 4096);
    d.field("sbatch", &Resources::sbatch, "Further options of sbatch.");
}

void describe(StructBuilder<Job>& d) {
    d.doc("What a farm job computes.");
    d.field("tyndall_farm", &Job::tyndall_farm, "Version of the format.").range(1, 1);
    d.field("name", &Job::name, "Name in Slurm's queue.");
    d.field("program", &Job::program, "The program that tasks run.");
    d.field("directory", &Job::directory, "Where tasks run.");
    d.field("scene", &Job::scene, "Scene to trace.");
    d.field("shards", &Job::shards, "Tasks of a trace.").range(0, 1000000);
    d.field("captures", &Job::captures, "Files to capture, a task each.");
    d.field("options", &Job::options, "Options of trace or capture.");
    d.field("slurm", &Job::slurm, "What a task asks of the cluster.");
}

std::string Job::title() const {
    const auto plural = [](size_t n, const char* one) { return fmt::format("{} {}{}", n, one, n == 1 ? "" : "s"); };
    if (!is_trace()) return plural(captures.size(), "capture");
    return fmt::format("trace of {} in {}", fs::path(scene).filename().string(),
                       plural(static_cast<size_t>(shards), "shard"));
}

std::vector<Task> tasks_of(const Job& job) {
    const int count = job.is_trace() ? job.shards : static_cast<int>(job.captures.size());
    std::vector<Task> tasks;
    for (int i = 1; i <= count; ++i) {
        Task task;
        const std::string number = std::to_string(i);
        task.number = i;
        task.title = job.is_trace() ? fmt::format("shard {}/{}", i, count)
                                    : fs::path(job.captures[static_cast<size_t>(i - 1)]).stem().string();
        task.result = job.folder / "tasks" / (job.is_trace() ? number + ".exr" : number);
        task.end = job.folder / "tasks" / (number + ".end");
        task.log = job.folder / "logs" / (number + ".log");
        tasks.push_back(std::move(task));
    }
    return tasks;
}

namespace {

/// What stands in the script's #SBATCH lines, which know no safe quoting.
bool is_plain(const std::string& text) {
    return std::none_of(text.begin(), text.end(), [](char c) {
        return static_cast<unsigned char>(c) <= ' ' || c == '\'' || c == '"' || c == '\\' || c == '#';
    });
}

void check(const Job& job, std::vector<Diagnostic>& problems) {
    const auto wrong = [&](std::string pointer, std::string what, std::string expected) {
        problems.push_back({{{}, 0, 0, std::move(pointer)}, std::move(what), std::move(expected), {}});
    };
    if (job.name.empty() || !is_plain(job.name) || job.name.find_first_of("/,%") != std::string::npos)
        wrong("/name", "'" + job.name + "' is no name of a job", "letters, digits, '-', '_'");
    if (job.program.empty()) wrong("/program", "no program is named", "");
    if (job.captures.empty() && (job.scene.empty() || job.shards < 1))
        wrong("", "there is nothing to do", "a scene and shards, or captures");
    if (!job.captures.empty() && !job.scene.empty()) wrong("", "both a scene and captures", "one of them");
    for (const auto& [key, value] :
         {std::pair{"partition", job.slurm.partition}, {"time", job.slurm.time}, {"memory", job.slurm.memory}})
        if (!is_plain(value))
            wrong(std::string("/slurm/") + key, "'" + value + "' is nothing that sbatch takes", "a word");
    for (const std::string& option : job.slurm.sbatch)
        if (!option.starts_with("-") || !is_plain(option))
            wrong("/slurm/sbatch", "'" + option + "' is no option of sbatch", "such as --account=film");
}

}  // namespace

bool is_job(const fs::path& folder) {
    std::error_code ignored;
    return fs::is_regular_file(folder / "job.json", ignored);
}

Job load_job(const fs::path& folder) {
    if (!is_job(folder))
        throw Error(
            Diagnostic{{folder.string()}, "is no farm job", "a folder with job.json, made by 'tyndall farm submit'"});
    const fs::path file = folder / "job.json";
    Job job;
    std::vector<Diagnostic> problems;
    const std::string unknown =
        component_from_json(*describe_struct<Job>("job"), &job, paths::read_file(file), problems);
    if (problems.empty() && unknown.size() > 2)
        problems.push_back({{}, "unknown fields " + unknown, "the fields of docs/farm.md"});
    if (problems.empty()) check(job, problems);
    for (Diagnostic& problem : problems) problem.where.file = file.string();
    if (!problems.empty()) throw Error(std::move(problems));
    job.folder = fs::canonical(folder);
    return job;
}

void save_job(const Job& job) {
    std::vector<Diagnostic> problems;
    check(job, problems);
    if (!problems.empty()) throw Error(std::move(problems));
    if (job.folder.string().find_first_of("%\\") != std::string::npos)
        throw Error(
            Diagnostic{{job.folder.string()}, "Slurm writes no logs below a name with '%' or '\\'", "another folder"});
    std::error_code failed;
    if (!is_job(job.folder) && fs::exists(job.folder, failed) && !fs::is_empty(job.folder, failed))
        throw Error(Diagnostic{{job.folder.string()},
                               "is there and is no farm job",
                               "a folder that is empty or does not exist, or a job's; --folder names it"});
    for (const char* part : {"tasks", "logs"}) {
        fs::create_directories(job.folder / part, failed);
        if (failed) throw Error(Diagnostic{{(job.folder / part).string()}, "cannot be made: " + failed.message()});
    }
    paths::write_file_atomically(
        job.folder / "job.json",
        nlohmann::ordered_json::parse(component_to_json(*describe_struct<Job>("job"), &job)).dump(2) + "\n");
}

std::string unique_name(const std::string& stem) {
    std::string name;
    for (const char c : stem.substr(0, 32)) name += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
    std::random_device random;
    return fmt::format("{}-{:08x}", name, random());
}

void require_same_work(const Job& there, const Job& wanted) {
    const auto differ = [&](const std::string& what, const std::string& is, const std::string& asked) {
        throw Error(Diagnostic{{there.folder.string()},
                               fmt::format("holds another job: its {} '{}', not '{}'", what, is, asked),
                               "the same job, or another --folder"});
    };
    const auto joined = [](const std::vector<std::string>& words) { return fmt::format("{}", fmt::join(words, " ")); };
    if (there.scene != wanted.scene) differ("scene is", there.scene, wanted.scene);
    if (there.shards != wanted.shards)
        differ("number of shards is", std::to_string(there.shards), std::to_string(wanted.shards));
    if (there.captures != wanted.captures) differ("captures are", joined(there.captures), joined(wanted.captures));
    if (there.options != wanted.options) differ("options are", joined(there.options), joined(wanted.options));
}

}  // namespace tyndall::farm
