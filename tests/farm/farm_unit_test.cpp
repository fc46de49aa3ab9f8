// The farm without a cluster: quoting, the script, what Slurm writes, states, reports.
#include <csignal>
#include <fstream>

#include "../unit/temporary_folder.h"
#include "core/error.h"
#include "core/paths.h"
#include "core/process.h"
#include "farm/farm.h"
#include "farm/script.h"

namespace tyndall::farm {
namespace {
namespace fs = std::filesystem;

class Farm : public TemporaryFolder {
 protected:
    /// A trace in shards by a program that does what `does` says, in shell.
    Job job(const std::string& does, int shards = 3) {
        const fs::path program = folder_ / "a program's";
        std::ofstream(program) << "#!/bin/bash\n" << does << "\n";
        fs::permissions(program, fs::perms::owner_all);
        Job job;
        job.name = "test-1";
        job.program = program;
        job.directory = folder_;
        job.scene = "/no/scene \"of\" $mine.json";
        job.shards = shards;
        job.options = {"--set", "/entities/My 'Sun'/x=[1, 2]"};
        job.folder = folder_ / "a 'job' \"$HOME\" `x` é";
        save_job(job);
        return job;
    }
    /// Runs the script as Slurm would.
    static int run(const Job& job, int task) {
        const std::vector<int> tasks{task};
        paths::write_file_atomically(job.folder / "job.sbatch", script_of(job, tasks));
        return run_process({"env", "SLURM_ARRAY_TASK_ID=" + std::to_string(task), "SLURM_ARRAY_JOB_ID=12",
                            "SLURMD_NODENAME=node3", "bash", "job.sbatch"},
                           job.folder)
            .end.code;
    }
    static TaskStatus judged(const Job& job, int task, const char* slurm = nullptr, const char* reason = "") {
        const Task it = tasks_of(job)[static_cast<size_t>(task - 1)];
        const QueueEntry entry{slurm == nullptr ? "" : slurm, reason, "node1", "7_1", "3:12"};
        return judge(it, read_end(it.end), slurm == nullptr ? nullptr : &entry);
    }
    static std::string message(const fs::path& folder) {
        try {
            (void)load_job(folder);
        } catch (const Error& error) {
            return error.what();
        }
        return "nothing is wrong";
    }
};

TEST_F(Farm, WordsReachProgramsThroughTheShell) {
    for (const std::string word :
         {"plain", "", " ", "it's", "\"", "$HOME `id` $(id)", "\\", "a\nb", "*", "--x=[1,2]", "~", "'", "#", "é"})
        EXPECT_EQ(run_process({"bash", "-c", "printf %s " + shell_quote(word)}).output, word);
}

TEST_F(Farm, ArraysAreShort) {
    EXPECT_EQ(array_of(std::vector{1, 2, 3, 7, 9, 10}), "1-3,7,9-10");
    EXPECT_EQ(array_of(std::vector{4}), "4");
}

TEST_F(Farm, ATaskGetsItsCommandLineAndMarksItsEnd) {
    const Job it = job(R"(printf '%s\n' "$PWD" "$@" >words; echo >"${@: -2:1}")");
    EXPECT_EQ(judged(it, 2).state, State::dead);
    ASSERT_EQ(run(it, 2), 0);
    EXPECT_EQ(paths::read_file(folder_ / "words"), it.directory + "\ntrace\n" + it.scene +
                                                       "\n--set\n/entities/My 'Sun'/x=[1, 2]\n--shard\n2/3\n--out\n" +
                                                       (it.folder / "tasks" / "2.exr").string() + "\n--resume\n");
    const auto end = read_end(it.folder / "tasks" / "2.end");
    ASSERT_TRUE(end);
    EXPECT_EQ(end->code, 0);
    EXPECT_EQ(end->job, "12_2");
    EXPECT_EQ(end->node, "node3");
    EXPECT_EQ(judged(it, 2).state, State::done);
    EXPECT_EQ(judged(it, 2, "RUNNING").state, State::done);                        // Slurm knows later
    EXPECT_EQ(std::distance(fs::directory_iterator(it.folder / "tasks"), {}), 2);  // no half-written mark is left
}

TEST_F(Farm, ATaskThatIsDoneIsNotDoneAgain) {
    const Job it = job(R"(echo once >>runs; echo >"${@: -2:1}")");
    ASSERT_EQ(run(it, 1), 0);
    ASSERT_EQ(run(it, 1), 0);
    EXPECT_EQ(paths::read_file(folder_ / "runs"), "once\n");
    fs::remove(it.folder / "tasks" / "1.exr");  // as one does with a damaged shard
    EXPECT_EQ(judged(it, 1).state, State::dead);
    ASSERT_EQ(run(it, 1), 0);
    EXPECT_EQ(paths::read_file(folder_ / "runs"), "once\nonce\n");
    EXPECT_EQ(judged(it, 1).state, State::done);
}

TEST_F(Farm, WhatTheProgramSaidOfItsEndDecides) {
    const Job it = job("exit 3");
    EXPECT_EQ(run(it, 1), 3);
    EXPECT_EQ(judged(it, 1).state, State::failed);
    EXPECT_NE(judged(it, 1).detail.find("code 3 on node3 (job 12_1)"), std::string::npos);
    EXPECT_EQ(judged(it, 1, "PENDING").state, State::waiting);  // sent again
    const Job killed = job("kill -KILL $$");
    EXPECT_EQ(run(killed, 1), 137);
    EXPECT_EQ(judged(killed, 1).state, State::dead);
    EXPECT_NE(judged(killed, 1).detail.find("signal 9"), std::string::npos);
    const Job crashed = job("ulimit -c 0; kill -SEGV $$");
    EXPECT_EQ(run(crashed, 1), 139);
    EXPECT_EQ(judged(crashed, 1).state, State::failed);
    const Job nothing = job("exit 0");
    EXPECT_EQ(run(nothing, 1), 0);
    EXPECT_EQ(judged(nothing, 1).state, State::dead);
    EXPECT_NE(judged(nothing, 1).detail.find("result is not there"), std::string::npos);
}

TEST_F(Farm, ATaskThatIsStoppedSavesAndHasNoEnd) {
    // The program stops its own task once it can be told.
    const Job it = job("trap 'echo saved >saved; exit 0' TERM; kill -TERM $PPID; while :; do sleep 0.01; done");
    EXPECT_EQ(run(it, 1), 143);
    EXPECT_EQ(paths::read_file(folder_ / "saved"), "saved\n");
    EXPECT_FALSE(read_end(it.folder / "tasks" / "1.end"));
    EXPECT_EQ(judged(it, 1, "TIMEOUT").state, State::dead);
}

TEST_F(Farm, SlurmSaysTheRest) {
    const Job it = job("true");
    EXPECT_EQ(judged(it, 1, "PENDING", "Resources").state, State::waiting);
    EXPECT_EQ(judged(it, 1, "PENDING", "Resources").detail, "Resources");
    EXPECT_EQ(judged(it, 1, "RUNNING").state, State::running);
    EXPECT_EQ(judged(it, 1, "COMPLETING").state, State::running);
    for (const auto& [state, words] : {std::pair{"TIMEOUT", "time ran out"},
                                       {"NODE_FAIL", "node failed on node1"},
                                       {"OUT_OF_MEMORY", "--mem"},
                                       {"CANCELLED", "cancelled"},
                                       {"PREEMPTED", "preempted"},
                                       {"FAILED", "without a result"},
                                       {"COMPLETED", "not there"},
                                       {"A_NEW_STATE", "without"}}) {
        EXPECT_EQ(judged(it, 1, state).state, State::dead);
        EXPECT_NE(judged(it, 1, state).detail.find(words), std::string::npos) << judged(it, 1, state).detail;
    }
    EXPECT_NE(judged(it, 1).detail.find("never began"), std::string::npos);
}

TEST_F(Farm, OfSeveralAttemptsTheLiveOrTheLastCounts) {
    const Queue queue = parse_queue(
        "1|CANCELLED|None|localhost|7_1|0:05\n"
        "1|RUNNING|None|localhost|9_1|0:01\n"
        "1|FAILED|NonZeroExitCode|localhost|11_1|0:01\n"
        "2|TIMEOUT|TimeLimit|localhost|10_2|0:05\n"
        "2|CANCELLED|None|localhost|9_2|0:05\n"
        "3|PENDING|Resources||11_3|0:00\n"
        "N/A|RUNNING|None|localhost|12|0:01\n"
        "nonsense\n");
    ASSERT_EQ(queue.size(), 3u);
    EXPECT_EQ(queue.at(1).job, "9_1");
    EXPECT_EQ(queue.at(1).reason, "");
    EXPECT_EQ(queue.at(2).state, "TIMEOUT");
    EXPECT_EQ(queue.at(3).reason, "Resources");
    const Queue history =
        parse_history("7_1|CANCELLED by 1000|node1\n9_1|NODE_FAIL|node2\n9_2|RUNNING|node2\n12|FAILED|node1\n");
    ASSERT_EQ(history.size(), 1u);
    EXPECT_EQ(history.at(1).state, "NODE_FAIL");
    EXPECT_EQ(parse_history("7_1|CANCELLED by 1000|node1\n").at(1).state, "CANCELLED");
}

TEST_F(Farm, ALogsEndIsOfTheLastAttempt) {
    const fs::path log = folder_ / "log";
    std::ofstream(log)
        << "== task 1, job 1_1, a, b\nold\n== task 1, job 2_1, a, b\n10 %\r20 %\r\x1b[31m30 %\n\n  \nlast";
    EXPECT_EQ(last_lines(log, 3), (std::vector<std::string>{"20 %", "[31m30 %", "last"}));
    EXPECT_EQ(last_lines(log, 9).size(), 4u);
    EXPECT_TRUE(last_lines(folder_ / "no", 3).empty());
}

TEST_F(Farm, TheReportSaysWhatToDoNext) {
    const Job it = job("true", 4);
    Status status;
    for (const Task& task : tasks_of(it)) status.tasks.push_back({task, State::done, "", {}});
    EXPECT_NE(report(it, status).find("farm collect " + shell_quote(it.folder)), std::string::npos);
    status.tasks[1].state = State::dead;
    status.tasks[2].state = State::running;
    EXPECT_EQ(bar(status), "[####################>>>>>>>>>>!!!!!!!!!!] 2 of 4 done, 1 running, 1 DEAD");
    EXPECT_NE(report(it, status).find("farm submit " + shell_quote(it.folder)), std::string::npos);
    EXPECT_EQ(status.tasks_in(State::dead), std::vector<int>{2});
}

TEST_F(Farm, JobsAreReadBack) {
    Job it = job("true");
    it.slurm = {"night", "2:00:00", "4G", 8, {"--account=film"}};
    save_job(it);
    const Job read = load_job(it.folder);
    EXPECT_EQ(read.scene, it.scene);
    EXPECT_EQ(read.options, it.options);
    EXPECT_EQ(read.slurm.sbatch, it.slurm.sbatch);
    EXPECT_NO_THROW(require_same_work(read, it));
    const std::string script = script_of(read, std::vector{1, 2, 3});
    for (const char* line : {"\n#SBATCH --array=1-3\n", "\n#SBATCH --partition=night\n", "\n#SBATCH --time=2:00:00\n",
                             "\n#SBATCH --mem=4G\n", "\n#SBATCH --cpus-per-task=8\n", "\n#SBATCH --account=film\n"})
        EXPECT_NE(script.find(line), std::string::npos) << line;
    it.shards = 4;
    EXPECT_THROW(require_same_work(read, it), Error);
    it.slurm.partition = "night\n#SBATCH --exclusive";
    EXPECT_THROW(save_job(it), Error);
}

TEST_F(Farm, WhatIsNoJobIsRefused) {
    EXPECT_NE(message(folder_).find("is no farm job"), std::string::npos);
    EXPECT_NE(message(folder_ / "no").find("is no farm job"), std::string::npos);
    const auto wrong = [&](const std::string& text, const std::string& words) {
        paths::write_file_atomically(folder_ / "job.json", text);
        EXPECT_NE(message(folder_).find("job.json"), std::string::npos) << message(folder_);
        EXPECT_NE(message(folder_).find(words), std::string::npos) << message(folder_);
    };
    wrong("", "job.json");
    wrong("{ \"tyndall_farm\": 1, ", ":1:");
    wrong("[]", "object");
    wrong("{}", "no name of a job");
    wrong(R"({ "tyndall_farm": 2 })", "/tyndall_farm");
    wrong(R"({ "name": "a b", "program": "x", "scene": "s", "shards": 2 })", "'a b'");
    wrong(R"({ "name": "a", "program": "x", "scene": "s" })", "nothing to do");
    wrong(R"({ "name": "a", "program": "x", "scene": "s", "shards": -3 })", "/shards");
    wrong(R"({ "name": "a", "program": "x", "scene": "s", "shards": 3, "captures": ["c"] })", "both");
    wrong(R"({ "name": "a", "program": "x", "scene": "s", "shards": 3, "slurm": { "time": "1; id" } })", "/slurm/time");
    wrong(R"({ "name": "a", "program": "x", "scene": "s", "shards": 3, "sahrds": 3 })", "sahrds");
    Job other;
    other.folder = folder_ / "taken";
    fs::create_directories(other.folder / "x");
    other.name = "a";
    other.program = "x";
    other.scene = "s";
    other.shards = 1;
    EXPECT_THROW(save_job(other), Error);
    for (const char* name : {"per%cent", "back\\slash"}) {
        other.folder = folder_ / name;
        EXPECT_THROW(save_job(other), Error);
        EXPECT_FALSE(fs::exists(other.folder));
    }
}

}  // namespace
}  // namespace tyndall::farm
