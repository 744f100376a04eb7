// Ctrl-C and full disks: what is not finished leaves no file.
#include "cli/terminal.hpp"
#include "cob/error.hpp"
#include "cob/files.hpp"
#include "program.hpp"
#include "report/classify_scene.hpp"
#include "report/truth_report.hpp"

#include <gtest/gtest.h>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>
#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <stdexcept>
#include <thread>

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
    const auto source = make_candidates(scene, Source::tree);
    for (const int threads : {1, 2}) {
        const test::TemporaryFolder folder;
        ClassifySceneOptions options;
        options.threads = threads;
        int calls = 0;
        options.progress = [&](std::uint64_t done, std::uint64_t total) {
            EXPECT_EQ(done, 0u);  // inside the first of 1024 elements
            EXPECT_GT(total, 1024u);
            EXPECT_FALSE(std::filesystem::is_empty(folder.path()));  // it was under way
            if (++calls >= 2) throw std::runtime_error("enough");
        };
        EXPECT_THROW(classify_scene(elements, *source, folder.path(), options), std::runtime_error);
        EXPECT_GE(calls, 2);
        EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
    }
}

// One element takes ten seconds where coordinates range from 1e-258 to 1e279: its truth is heard inside, too.
TEST(Interrupt, TruthIsEndedInsideAnElement) {
    const test::TemporaryFolder folder;
    write_file(folder / "scene.mtl", "newmtl lamp\nKe 1 1 1\n");
    write_file(folder / "scene.obj",
               "mtllib scene.mtl\n"
               "v 1e-177 3e188 4e-47\nv -2e-120 -2e-54 1e15\nv -7e-62 -3e-140 -8e-78\n"
               "v -1e40 -3e-184 8e82\nv -4e189 -1e-211 1e93\nv -1e43 -5e66 -2e279\n"
               "v -1e-27 -2e277 -1e-258\nv -8e-146 -2e-139 -1e12\nv 1e39 -6e-252 -8e227\n"
               "v 8e-31 1e-49 2e275\nv -6e-213 -1e166 -8e-154\nv -6e-100 -9e-124 -8e-26\n"
               "f 1 2 3\nf 4 5 6\nf 7 8 9\nusemtl lamp\nf 10 11 12\n");
    const Scene scene = read_obj(folder / "scene.obj", ReadOptions{});
    const Roots roots(scene);
    const ElementList elements(scene, roots, Meshing{});
    ASSERT_EQ(elements.size(), 4u);
    const auto source = make_candidates(scene, Source::tree);
    for (const int threads : {1, 2}) {
        TruthOptions options;
        options.threads = threads;
        int calls = 0;
        options.progress = [&](std::uint64_t, std::uint64_t) {
            if (++calls >= 20) throw std::runtime_error("enough");
        };
        EXPECT_THROW(write_truth(elements, *source, folder / "out", options), std::runtime_error);
        EXPECT_FALSE(exists(folder / "out"));
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

std::map<std::string, std::string> finished_runs(const std::string& study) {
    std::map<std::string, std::string> bytes;
    if (!std::filesystem::exists(study + "/runs")) return bytes;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(study + "/runs"))
        if (entry.path().extension() == ".csv") bytes[entry.path().string()] = read_file(entry.path().string());
    return bytes;
}

/// The program under way, silent.
pid_t start_program(const std::string& arguments) {
    const pid_t child = ::fork();
    EXPECT_GE(child, 0);
    if (child == 0) {
        const int null = ::open("/dev/null", O_WRONLY);
        ::dup2(null, 1), ::dup2(null, 2);
        ::execl("/bin/sh", "sh", "-c", ("exec " COB_PROGRAM " " + arguments).c_str(), static_cast<char*>(nullptr));
        ::_exit(127);
    }
    return child;
}

/// Waits until the file is there or the process has ended.
void wait_for(const std::string& file, pid_t process) {
    siginfo_t ended{};
    while (!std::filesystem::exists(file) && ended.si_pid == 0) {
        ::waitid(P_PID, static_cast<id_t>(process), &ended, WEXITED | WNOHANG | WNOWAIT);
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
}

// "Long work: Ctrl-C safe, nothing finished is lost": pictures of 10^9 rays, which take minutes, are ended while they
// are drawn, and the solution is there; also where a first Ctrl-C has ended the shots.
TEST(Interrupt, RenderIsEndedWhileItDraws) {
    for (const bool twice : {false, true}) {
        const test::TemporaryFolder folder;
        const std::string out = folder / "out", checkpoint = folder / "checkpoint";
        const pid_t child =
            start_program("render " COB_DATA
                          "/figure2.obj --width 2048 --picture-height 2048 "
                          "--antialias 16 --unshot 0 --checkpoint-seconds 0 --shots " +
                          std::string(twice ? "1000000000" : "2") + " --checkpoint " + checkpoint + " -o " + out);
        if (twice) {
            wait_for(checkpoint, child);
            ::kill(child, SIGINT);
        }
        wait_for(out + "/exitance.csv", child);
        std::this_thread::sleep_for(std::chrono::milliseconds(100));  // so that rows are under way
        ::kill(child, SIGINT);
        int status = 0;
        ::waitpid(child, &status, 0);
        ASSERT_TRUE(WIFEXITED(status));
        EXPECT_EQ(WEXITSTATUS(status), 130);
        EXPECT_EQ(test::files_in(out),
                  (std::set<std::string>{"exitance.csv", "mesh.vtp", "summary.json", "summary.txt"}));
        const std::string summary = read_file(out + "/summary.txt");
        EXPECT_NE(summary.find(twice ? "ended by interrupt" : "ended by number of shots"), std::string::npos)
            << summary;
        EXPECT_NE(summary.find("not written: interrupted"), std::string::npos) << summary;
    }
}

// "Progress; interruptible; finished runs are kept and skipped on a rerun": a real signal to a real process.
TEST(Interrupt, FinishedRunsOfAStudyAreSkippedByTheNext) {
    const test::TemporaryFolder folder;
    const std::string study = folder / "study", scene = COB_DATA "/figure2.obj";
    const std::string arguments =
        "study " + scene + " --budgets 2 --points 50 --repeats 1 --picture-shots 0 --threads 1 -o " + study;
    const pid_t child = start_program(arguments);
    int status = 0;
    while (finished_runs(study).size() < 3 && ::waitpid(child, &status, WNOHANG) == 0)
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    ::kill(child, SIGINT);
    ::waitpid(child, &status, 0);
    ASSERT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), 130);
    const std::map<std::string, std::string> kept = finished_runs(study);
    EXPECT_GE(kept.size(), 3u);
    EXPECT_FALSE(std::filesystem::exists(study + "/study.csv"));

    // The times in them tell whether they were made again.
    ASSERT_EQ(test::run_program(arguments).code, 0);
    const std::map<std::string, std::string> all = finished_runs(study);
    EXPECT_GT(all.size(), kept.size());
    for (const auto& [file, bytes] : kept) EXPECT_EQ(all.at(file), bytes) << file;

    // All skipped: the same bytes.
    const std::string table = read_file(study + "/study.csv");
    ASSERT_EQ(test::run_program(arguments).code, 0);
    EXPECT_EQ(finished_runs(study), all);
    EXPECT_EQ(read_file(study + "/study.csv"), table);
}

// What is kept of a run and was cut off later, or is no run's, is made again.
TEST(Interrupt, DamagedRunsOfAStudyAreMadeAgain) {
    const test::TemporaryFolder folder;
    const std::string arguments = "study " COB_DATA
                                  "/figure2.obj --budgets 1 --points 10 --repeats 1 --picture-shots 0 --threads 1 -o " +
                                  folder / "study";
    ASSERT_EQ(test::run_program(arguments).code, 0);
    const auto [file, text] = *finished_runs(folder / "study").begin();
    const auto commas = [](const std::string& line) { return std::count(line.begin(), line.end(), ','); };
    const std::size_t last = text.rfind(',', text.rfind(',') - 1), count = text.find(",0.25,") + 1;
    for (const std::string& damaged : {text.substr(0, text.size() - 1), text.substr(0, last + 2), std::string(),
                                       std::string("\n"), text.substr(0, last + 1) + "-1" + text.substr(last + 1),
                                       text.substr(0, count) + "1e300" + text.substr(count)}) {
        write_file(file, damaged);
        ASSERT_EQ(test::run_program(arguments).code, 0);
        const std::string now = read_file(file);
        EXPECT_EQ(commas(now), commas(text)) << damaged;
        EXPECT_EQ(now.back(), '\n') << damaged;
        EXPECT_EQ(now.find("1e300"), std::string::npos);
    }
}

// Two at once in one folder: both succeed, whoever is first.
TEST(Interrupt, TwoProcessesMayMakeTheSame) {
    for (const std::string& arguments :
         {std::string("golden " COB_DATA "/figure4.obj --segments 2000 --hard 20 --shard-size 300 --threads 1 -o "),
          std::string("study " COB_DATA "/figure2.obj --budgets 1 --points 10 --repeats 1 --picture-shots 1 "
                      "--threads 1 -o ")})
        for (int repeat = 0; repeat < 2; ++repeat) {
            const test::TemporaryFolder folder;
            const std::string command = COB_PROGRAM " " + arguments + folder / "out";
            const auto run =
                test::run_shell(command + " & first=$!; " + command + "; echo code $?; wait $first; echo code $?");
            const std::size_t one = run.out.find("code 0\n"), other = run.out.rfind("code 0\n");
            EXPECT_TRUE(one != std::string::npos && one < other) << run.out << run.error;
            EXPECT_FALSE(std::filesystem::exists(folder / "out/shards"));
            for (const auto& [name, bytes] : test::bytes_of(folder.path()))
                EXPECT_EQ(name.find(".tmp"), std::string::npos) << name;
        }
}

// Another light is another scene, although the OBJ file is the same.
TEST(Interrupt, RunsOfAStudyAreNotThoseOfOtherMaterials) {
    const test::TemporaryFolder folder;
    for (const char* ending : {".obj", ".mtl"})
        write_file(folder / ("figure2" + std::string(ending)), read_file(COB_DATA "/figure2" + std::string(ending)));
    const std::string arguments = "study " + folder / "figure2.obj" +
                                  " --budgets 1 --points 10 --repeats 1 --picture-shots 0 --threads 1 -o " +
                                  folder / "study";
    ASSERT_EQ(test::run_program(arguments).code, 0);
    const std::size_t runs = finished_runs(folder / "study").size();
    write_file(folder / "figure2.mtl", read_file(folder / "figure2.mtl") + "newmtl other\nKd .1 .1 .1\n");
    ASSERT_EQ(test::run_program(arguments).code, 0);
    EXPECT_EQ(finished_runs(folder / "study").size(), runs);  // a material of no polygon changes nothing
    std::string materials = read_file(folder / "figure2.mtl");
    materials.replace(materials.find("Ke"), 2, "Ke 1 2 3\n#");
    write_file(folder / "figure2.mtl", materials);
    ASSERT_EQ(test::run_program(arguments).code, 0);
    EXPECT_EQ(finished_runs(folder / "study").size(), 2 * runs);
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

// The same where the name leaves no room for a temporary's ending: as if this process had been killed, the number in
// its temporary's name becomes that of a dead one.
TEST(Interrupt, LeftoversOfLongNamesAreRemoved) {
    const test::TemporaryFolder folder;
    const std::string path = folder / std::string(255, 'n'), ours = ".tmp" + std::to_string(::getpid());
    {
        const OutputFile under_way(path);
        const std::set<std::string> files = test::files_in(folder.path());
        ASSERT_EQ(files.size(), 1u);
        std::string left = *files.begin();
        ASSERT_NE(left.rfind(ours), std::string::npos) << left;
        left.replace(left.rfind(ours), ours.size(), ".tmp" + std::to_string(dead_process()));
        std::ofstream(folder / left) << "left over";
    }
    EXPECT_EQ(test::files_in(folder.path()).size(), 1u);
    write_file(path, "ours");
    EXPECT_EQ(test::files_in(folder.path()), std::set<std::string>{std::string(255, 'n')});
}

}  // namespace
}  // namespace cob
