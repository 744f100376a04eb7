// Ctrl-C and full disks: what is not finished leaves no file.
#include "cli/terminal.hpp"
#include "cob/error.hpp"
#include "cob/files.hpp"
#include "program.hpp"
#include "report/classify_scene.hpp"

#include <gtest/gtest.h>

#include <sys/wait.h>
#include <unistd.h>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <set>
#include <stdexcept>

namespace cob {
namespace {

// Runs first in this process: the flag that the signal sets stays set.
TEST(Interrupt, CtrlCIsThrownFromTheProgress) {
    const Progress progress = cli::terminal_progress("working");
    progress(1, 2);
    EXPECT_FALSE(cli::interrupted());
    std::raise(SIGINT);
    EXPECT_TRUE(cli::interrupted());
    EXPECT_THROW(progress(2, 2), cli::Interrupted);
}

TEST(Interrupt, ClassifyLeavesNothingBehind) {
    const Scene scene = read_obj(COB_DATA "/desk.obj", ReadOptions{});
    const Roots roots(scene);
    const ElementList elements(scene, roots, Meshing{0, 2});
    const auto source = make_candidates(scene, Source::cgal);
    for (const int threads : {1, 2}) {
        const test::TemporaryFolder folder;
        ClassifySceneOptions options;
        options.threads = threads;
        int calls = 0;
        options.progress = [&](std::uint64_t done, std::uint64_t total) {
            EXPECT_LE(done, total);
            EXPECT_FALSE(std::filesystem::is_empty(folder.path()));  // it was under way
            if (++calls == 2) throw std::runtime_error("enough");
        };
        EXPECT_THROW(classify_scene(elements, *source, folder.path(), options), std::runtime_error);
        EXPECT_EQ(calls, 2);
        EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
    }
}

// A name that a folder has already: the table cannot appear, which is an error and not silence.
TEST(Interrupt, WhatCannotBeWrittenIsTold) {
    const test::TemporaryFolder folder;
    create_folder(folder / "states.csv");
    create_folder(folder / "states.csv/kept");
    const auto run = test::run_program("classify " COB_DATA "/figure2.obj -o " + folder.path());
    EXPECT_EQ(run.code, 2);
    EXPECT_NE(run.error.find("states.csv"), std::string::npos) << run.error;
}

/// A process that has ended.
pid_t dead_process() {
    const pid_t child = ::fork();
    if (child == 0) ::_exit(0);
    EXPECT_GT(child, 0);
    ::waitpid(child, nullptr, 0);
    return child;
}

// Killed without a chance to tidy up: the next run does, and touches nothing that may belong to somebody.
TEST(Interrupt, LeftoversOfKilledRunsAreRemoved) {
    const test::TemporaryFolder folder;
    const std::string dead = std::to_string(dead_process()), alive = std::to_string(::getppid());
    const std::set<std::string> kept = {"states.csv.tmp" + alive, "states.csv.tmp" + dead + "x", "states.csv.tmp",
                                        "states.csv.tmp-1", "other.csv.tmp" + dead};
    for (const std::string& name : kept) write_file(folder / name, "theirs");
    std::ofstream(folder / ("states.csv.tmp" + dead)) << "left over";
    write_file(folder / "states.csv", "ours");
    std::set<std::string> found;
    for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
        found.insert(entry.path().filename().string());
    std::set<std::string> expected = kept;
    expected.insert("states.csv");
    EXPECT_EQ(found, expected);
}

}  // namespace
}  // namespace cob
