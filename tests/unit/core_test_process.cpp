// Starting other programs.
#include <csignal>
#include <thread>

#include "core/error.h"
#include "core/paths.h"
#include "core/process.h"
#include "temporary_folder.h"

namespace tyndall {
namespace {

using Processes = TemporaryFolder;

TEST_F(Processes, ArgumentsArriveAsTheyAre) {
    const std::string odd = "a b'c\"d $HOME `id` \\ *\n%s";
    const ProcessResult said = run_process({"printf", "%s|%s", odd, ""});
    EXPECT_TRUE(said.end.well());
    EXPECT_EQ(said.output, odd + "|");
    EXPECT_EQ(said.errors, "");
}

TEST_F(Processes, OutputErrorsCodeAndFolder) {
    const ProcessResult said = run_process({"sh", "-c", "pwd; echo wrong >&2; cat; exit 3"}, folder_);
    EXPECT_EQ(said.end.code, 3);
    EXPECT_EQ(said.end.signal, 0);
    EXPECT_EQ(said.output, std::filesystem::canonical(folder_).string() + "\n");
    EXPECT_EQ(said.errors, "wrong\n");
}

TEST_F(Processes, MuchOutputBlocksNothing) {
    const ProcessResult said = run_process({"sh", "-c", "head -c 3000000 /dev/zero; head -c 3000000 /dev/zero >&2"});
    EXPECT_EQ(said.output.size(), 3000000u);
    EXPECT_EQ(said.errors.size(), 3000000u);
}

TEST_F(Processes, ASignalIsTold) {
    const ProcessResult said = run_process({"sh", "-c", "kill -KILL $$"});
    EXPECT_EQ(said.end.signal, SIGKILL);
    EXPECT_EQ(said.end.code, 128 + SIGKILL);
    EXPECT_FALSE(said.end.well());
}

TEST_F(Processes, WhatIsNotThereIsAnError) {
    try {
        (void)run_process({"tyndall-no-such-program"});
        FAIL();
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("'tyndall-no-such-program' could not be started"), std::string::npos);
    }
    EXPECT_THROW((void)run_process({"true"}, folder_ / "no"), Error);
    EXPECT_THROW(Process({"true"}, folder_ / "no" / "log"), Error);
}

TEST_F(Processes, InTheBackground) {
    const std::filesystem::path gate = folder_ / "gate", log = folder_ / "log";
    Process process({"sh", "-c", "until [ -e \"$0\" ]; do sleep 0.01; done; echo out; echo err >&2; exit 7", gate},
                    log);
    EXPECT_FALSE(process.poll());
    paths::write_file_atomically(gate, "");
    std::optional<ProcessEnd> end;
    while (!(end = process.poll())) std::this_thread::yield();
    EXPECT_EQ(end->code, 7);
    EXPECT_EQ(process.poll()->code, 7);  // again
    EXPECT_EQ(paths::read_file(log), "out\nerr\n");
}

}  // namespace
}  // namespace tyndall
