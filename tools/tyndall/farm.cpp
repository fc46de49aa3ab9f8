// farm: traces and captures on a Slurm cluster.
#include "farm/farm.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <thread>

#include "app/capture_file.h"
#include "commands.h"
#include "core/error.h"
#include "core/log.h"
#include "core/paths.h"

namespace tyndall {
namespace fs = std::filesystem;
namespace {

struct SubmitOptions {
    std::vector<std::string> inputs, options;
    farm::Resources slurm;
    std::string folder, program;
    int shards = 0;
};

/// The running program's file, as a node can start it.
std::string this_program() {
    std::error_code ignored;
    return fs::read_symlink("/proc/self/exe", ignored).string();
}

/// What stands in front of the first option is scenes, captures or a folder; the rest is trace's or capture's.
void split_inputs(const std::vector<std::string>& words, SubmitOptions& options) {
    const auto first = std::find_if(words.begin(), words.end(), [](const auto& word) { return word.starts_with("-"); });
    options.inputs.assign(words.begin(), first);
    options.options.assign(first, words.end());
}

/// Throws Error for a file that its task could not read either. Returns whether it is a capture.
bool check_input(const fs::path& file) {
    const bool capture = is_capture(paths::read_file(file));
    if (capture) {
        const CaptureFile read = load_capture(file);
        Engine(false).load_scene(file.parent_path() / read.scene);
    } else {
        Engine(false).load_scene(file);
    }
    return capture;
}

std::vector<std::string> captures_in(const fs::path& folder) {
    std::vector<std::string> files;
    for (const auto& entry : fs::directory_iterator(folder))
        if (entry.path().extension() == ".json" && is_capture(paths::read_file(entry.path())))
            files.push_back(fs::absolute(entry.path()).lexically_normal().string());
    std::sort(files.begin(), files.end());
    if (files.empty())
        throw Error(Diagnostic{{folder.string()},
                               "is no farm job and holds no captures",
                               "a folder with job.json, a folder with capture files, a scene, or capture files"});
    return files;
}

/// The job that the command line asks for, without folder and name.
farm::Job wanted_job(const SubmitOptions& options) {
    farm::Job job;
    job.program = options.program.empty() ? this_program() : fs::absolute(options.program).string();
    job.directory = fs::current_path().string();
    job.options = options.options;
    int scenes = 0;
    for (const std::string& input : options.inputs) {
        if (fs::is_directory(input)) {
            for (const std::string& file : captures_in(input)) {
                (void)check_input(file);
                job.captures.push_back(file);
            }
            continue;
        }
        const std::string file = fs::absolute(input).lexically_normal().string();
        const bool capture = check_input(file);
        (capture ? job.captures.emplace_back() : job.scene) = file;
        if (!capture) ++scenes;
    }
    if (scenes > 1 || (scenes == 1 && !job.captures.empty()))
        throw Error("a job is the trace of one scene, or captures: not both, and not several scenes");
    job.shards = job.captures.empty() ? std::max(options.shards, 1) : 0;
    if (!job.captures.empty() && options.shards > 0) throw Error("captures have no shards: each is one task");
    return job;
}

/// What the command line asks of the cluster goes before what the job had.
void override(farm::Resources& there, const farm::Resources& asked) {
    if (!asked.partition.empty()) there.partition = asked.partition;
    if (!asked.time.empty()) there.time = asked.time;
    if (!asked.memory.empty()) there.memory = asked.memory;
    if (asked.cpus > 0) there.cpus = asked.cpus;
    if (!asked.sbatch.empty()) there.sbatch = asked.sbatch;
}

farm::Job resumed_job(const SubmitOptions& options) {
    if (!options.options.empty() || options.shards > 0 || !options.folder.empty())
        throw Error(Diagnostic{{options.inputs[0]},
                               "is a job already: what it computes is settled",
                               "options of the cluster only: --partition, --time-limit, --mem, --cpus, --sbatch"});
    return farm::load_job(options.inputs[0]);
}

farm::Job job_of(const SubmitOptions& options) {
    if (options.inputs.size() == 1 && farm::is_job(options.inputs[0])) return resumed_job(options);
    farm::Job wanted = wanted_job(options);
    const std::string stem = fs::path(wanted.is_trace() ? wanted.scene : wanted.captures[0]).stem().string();
    wanted.folder = fs::absolute(options.folder.empty() ? stem + ".farm" : options.folder).lexically_normal();
    if (!farm::is_job(wanted.folder)) {
        wanted.name = farm::unique_name(stem);
        return wanted;
    }
    farm::Job there = farm::load_job(wanted.folder);
    farm::require_same_work(there, wanted);
    return there;
}

int submit(const SubmitOptions& options) {
    if (options.inputs.empty()) throw Error("nothing to submit (expected a scene, capture files, or a job's folder)");
    farm::Job job = job_of(options);
    override(job.slurm, options.slurm);
    if (!options.program.empty()) job.program = fs::absolute(options.program).string();
    farm::save_job(job);
    job.folder = fs::canonical(job.folder);
    try {
        const farm::Submission sent = farm::submit(job);
        if (sent.tasks.empty())
            fmt::print("{}: nothing to send: every task is done, runs or waits\n", job.folder.string());
        else
            fmt::print("{}: {}; sent {} of {} tasks as job {}\n", job.folder.string(), job.title(), sent.tasks.size(),
                       farm::tasks_of(job).size(), sent.job);
    } catch (Error& error) {
        throw error.within("the job is written to " + job.folder.string() + " but not submitted");
    }
    return 0;
}

int status(const std::string& folder, bool watch) {
    const farm::Job job = farm::load_job(folder);
    for (;;) {
        const farm::Status now = farm::look_at(job);
        if (watch && isatty(STDOUT_FILENO) != 0) fmt::print("\033[H\033[2J");
        fmt::print("{}", farm::report(job, now));
        std::fflush(stdout);
        const bool bad = now.count(farm::State::failed) + now.count(farm::State::dead) > 0 || !now.problem.empty();
        if (!watch || (!now.under_way() && now.problem.empty())) return bad ? 1 : 0;
        std::this_thread::sleep_for(std::chrono::seconds(2));
    }
}

int collect(const std::string& folder, farm::CollectOptions options) {
    const farm::Job job = farm::load_job(folder);
    if (options.program.empty()) options.program = this_program();
    std::string shown;
    options.progress = [&](const farm::Status& now) {
        const std::string line = farm::bar(now) + (now.problem.empty() ? "" : "  " + now.problem);
        if (line != shown) fmt::print(stderr, "{}\n", line);
        shown = line;
    };
    const farm::Status found = farm::collect(job, options);
    const fs::path out = farm::destination(job, options);
    if (!found.all_done()) fmt::print("{}", farm::report(job, found));
    if (found.all_done() || (!job.is_trace() && fs::exists(out))) fmt::print("wrote {}\n", out.string());
    if (!found.all_done())
        fmt::print("{} of {} tasks are missing\n",
                   found.tasks.size() - static_cast<size_t>(found.count(farm::State::done)), found.tasks.size());
    return found.all_done() ? 0 : 1;
}

/// Whether the tasks will run `tyndall capture`.
bool will_capture(const std::string& input) {
    std::error_code ignored;
    return fs::is_directory(input, ignored) || is_capture(paths::read_file(input));
}

/// Parses the options that tasks will be given as `tyndall trace` or `tyndall capture` would, so that a slip shows now.
void check_options(CLI::App& app, const SubmitOptions& options) {
    for (const std::string& word : options.options)
        for (const std::string own : {"--shard", "--out", "--resume"})
            if (word == own || word.starts_with(own + "="))
                throw Error(own + " is what the farm itself gives each task");
    if (options.options.empty() || options.inputs.empty()) return;
    const bool captures = will_capture(options.inputs[0]);
    CLI::App* task = app.get_subcommand(captures ? "capture" : "trace");
    std::vector<std::string> words = {options.inputs[0]};
    words.insert(words.end(), options.options.begin(), options.options.end());
    std::reverse(words.begin(), words.end());  // as CLI11 takes them
    try {
        task->parse(std::move(words));
    } catch (const CLI::ParseError& error) {
        throw Error(fmt::format("neither 'tyndall farm submit' nor 'tyndall {}' takes this: {}", task->get_name(),
                                error.what()));
    }
}

void add_submit(CLI::App& farm_command, CLI::App& app, Command& command) {
    auto options = std::make_shared<SubmitOptions>();
    CLI::App* sub = farm_command.add_subcommand(
        "submit", "Send a trace in shards, or captures, to the cluster; or what is not done of a job");
    sub->allow_extras();
    sub->add_option("--shards", options->shards, "Tasks that a trace is split into")->check(CLI::Range(1, 100000));
    sub->add_option("--folder", options->folder,
                    "The job's folder, on a file system that all nodes share; otherwise NAME.farm");
    sub->add_option("--partition", options->slurm.partition, "Slurm partition");
    sub->add_option("--time-limit", options->slurm.time, "Longest time of a task: MINUTES, H:MM:SS, D-HH:MM:SS");
    sub->add_option("--mem", options->slurm.memory, "Memory of a task, such as 4G");
    sub->add_option("--cpus", options->slurm.cpus, "Processors of a task")->check(CLI::Range(1, 4096));
    sub->add_option("--sbatch", options->slurm.sbatch, "A further option of sbatch, such as --sbatch=--account=film")
        ->allow_extra_args(false);
    sub->add_option("--program", options->program, "The program that tasks run; otherwise this one");
    sub->footer(
        "In front stands what to submit: a scene, capture files or a folder of them, or a job's folder.\n"
        "Other options are those of 'tyndall trace' or 'tyndall capture'.\n\n"
        "  tyndall farm submit scene.json --spp 4096 --size 1920x1080 --shards 32 --time-limit 2:00:00 --folder "
        "/shared/still\n"
        "  tyndall farm submit tests/captures --partition gpu\n"
        "  tyndall farm submit /shared/still --time-limit 8:00:00      what is not done, with more time");
    sub->callback([options, sub, &app, &command] {
        split_inputs(sub->remaining(), *options);
        check_options(app, *options);
        command = [options] { return submit(*options); };
    });
}

}  // namespace

void add_farm(CLI::App& app, Command& command) {
    CLI::App* farm_command = app.add_subcommand("farm", "Trace and capture on a Slurm cluster (docs/farm.md)");
    farm_command->require_subcommand(1);
    add_submit(*farm_command, app, command);

    auto folder = std::make_shared<std::string>();
    auto watch = std::make_shared<bool>(false);
    CLI::App* sub = farm_command->add_subcommand("status", "How a job's tasks are, and why those that failed did");
    sub->add_option("job", *folder, "The job's folder")->required();
    sub->add_flag("--watch", *watch, "Look again until nothing runs or waits");
    sub->footer("Exit code 1: a task failed or died, or Slurm does not answer.");
    sub->callback([folder, watch, &command] { command = [folder, watch] { return status(*folder, *watch); }; });

    auto options = std::make_shared<farm::CollectOptions>();
    sub = farm_command->add_subcommand("collect", "Merge a job's shards, or gather its pictures");
    sub->add_option("job", *folder, "The job's folder")->required();
    sub->add_option("--out", options->out,
                    "The merged picture, or the folder for pictures; otherwise in the job's folder");
    sub->add_option("--retry", options->retry, "Wait for the queue, and send a dead task again up to so often")
        ->check(CLI::Range(0, 1000));
    sub->add_option("--program", options->program, "The program that merges; otherwise this one");
    sub->footer("Exit code 1: not every task is done.");
    sub->callback([folder, options, &command] { command = [folder, options] { return collect(*folder, *options); }; });
}

}  // namespace tyndall
