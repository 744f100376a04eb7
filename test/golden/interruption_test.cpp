// "Killed at random moments, then resumed: same bytes as uninterrupted. Full disk, read-only folder, truncated shard: a
// clear error, nothing finished is lost."
#include "cob/error.hpp"
#include "cob/files.hpp"
#include "cob/golden.hpp"
#include "program.hpp"

#include <gtest/gtest.h>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <random>
#include <thread>

namespace cob {
namespace {

namespace fs = std::filesystem;
using test::bytes_of;

constexpr int kills = COB_KILLS;

const std::string scene = std::string(COB_DATA) + "/cornell.obj";

std::string command(const std::string& set) {
    return std::string(COB_PROGRAM) + " golden " + scene + " -o " + set +
           " --level 2 --segments 1000 --hard 200 --shard-size 200";
}

int run(const std::string& text) {
    return test::run_shell(text).code;
}

std::size_t finished_shards(const std::string& set) {
    std::size_t count = 0;
    if (fs::exists(set + "/shards"))
        for (const auto& entry : fs::directory_iterator(set + "/shards"))
            count += entry.path().filename().string().find(".tmp") == std::string::npos;
    return count;
}

/// Runs the command and kills it after a while; whether it was still running.
bool kill_after(const std::string& text, std::chrono::microseconds delay) {
    const pid_t child = ::fork();
    if (child == 0) {
        const int null = ::open("/dev/null", O_WRONLY);
        ::dup2(null, 1), ::dup2(null, 2);
        ::execl("/bin/sh", "sh", "-c", ("exec " + text).c_str(), static_cast<char*>(nullptr));
        ::_exit(127);
    }
    std::this_thread::sleep_for(delay);
    ::kill(child, SIGKILL);
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFSIGNALED(status);
}

class Interruption : public ::testing::Test {
protected:
    static void SetUpTestSuite() {
        whole_ = new test::TemporaryFolder;
        const auto begin = std::chrono::steady_clock::now();
        ASSERT_EQ(run(command(*whole_ / "set")), 0);
        duration_ = std::chrono::duration_cast<std::chrono::microseconds>(std::chrono::steady_clock::now() - begin);
    }
    static void TearDownTestSuite() { delete whole_; }
    static test::TemporaryFolder* whole_;
    static std::chrono::microseconds duration_;
    test::TemporaryFolder folder_;
};
test::TemporaryFolder* Interruption::whole_ = nullptr;
std::chrono::microseconds Interruption::duration_{};

TEST_F(Interruption, KilledAtAnyMomentAndResumedGivesTheSameBytes) {
    const auto expected = bytes_of(*whole_ / "set");
    std::mt19937_64 engine(1);
    int killed = 0;
    for (int k = 0; k < kills; ++k) {
        const std::string set = folder_ / std::to_string(k);
        // Now and then twice in a row; spread over the whole run, the merge at its end included. The first at once:
        // how many of the others hit a running program is the machine's affair.
        const std::string threads = k % 4 < 2 ? " --threads 1" : " --threads 2";
        for (int again = 0; again <= k % 2; ++again) {
            const int thousandths = killed == 0 ? 0 : static_cast<int>(engine() % 1000);
            killed += kill_after(command(set) + threads, duration_ * thousandths / 1000);
        }
        const std::size_t before = finished_shards(set);
        ASSERT_EQ(run(command(set) + threads), 0);
        EXPECT_EQ(bytes_of(set), expected) << "after a kill with " << before << " shards finished";
        fs::remove_all(set);
    }
    EXPECT_GT(killed, 0) << "no kill hit a running program";
}

// "Shards made by different machines merge to the same bytes": each half in a folder of its own, each killed once.
TEST_F(Interruption, TwoMachinesKilledAndMergedGiveTheSameBytes) {
    const auto expected = bytes_of(*whole_ / "set");
    std::mt19937_64 engine(2);
    for (int k = 0; k < (kills + 2) / 3; ++k) {
        const std::string set = folder_ / ("set" + std::to_string(k)), other = folder_ / ("other" + std::to_string(k));
        for (const auto& [folder, part] : {std::pair{set, " --shard 1/2"}, std::pair{other, " --shard 2/2"}}) {
            kill_after(command(folder) + part, duration_ * static_cast<int>(engine() % 500) / 1000);
            ASSERT_EQ(run(command(folder) + part), 0);
            EXPECT_FALSE(fs::exists(folder + "/manifest.json")) << "half a set must not look like a whole one";
        }
        kill_after(command(set) + " --merge " + other, duration_ * static_cast<int>(engine() % 500) / 1000);
        ASSERT_EQ(run(command(set) + " --merge " + other), 0);
        EXPECT_EQ(bytes_of(set), expected);
    }
}

TEST_F(Interruption, FullDiskIsAClearErrorAndLosesNothingFinished) {
    const std::string set = folder_ / "set";
    // Files may not grow beyond some blocks: shards fit, the merged tables do not.
    const std::string limited = "trap '' XFSZ; ulimit -f 100; exec " + command(set);
    ASSERT_EQ(run("sh -c \"" + limited + "\""), 2);
    const std::size_t kept = finished_shards(set);
    EXPECT_GT(kept, 5u);
    EXPECT_FALSE(fs::exists(set + "/manifest.json")) << "half a set must not look like a whole one";
    ASSERT_EQ(run(command(set)), 0);
    EXPECT_EQ(bytes_of(set), bytes_of(*whole_ / "set"));

    // Not even one shard fits.
    const std::string other = folder_ / "other";
    ASSERT_EQ(run("sh -c \"trap '' XFSZ; ulimit -f 1; exec " + command(other) + "\""), 2);
    EXPECT_EQ(finished_shards(other), 0u);
}

TEST_F(Interruption, DamagedShardsAreNamedAndTheOthersKept) {
    const std::string set = folder_ / "set";
    GoldenParameters parameters;
    parameters.level = 2, parameters.segments = 1000, parameters.hard = 200;
    GoldenOptions half;
    half.shard_size = 200, half.shard = 1, half.shards = 2;
    ASSERT_FALSE(make_golden(scene, set, parameters, half).finished);
    const std::size_t kept = finished_shards(set);
    const std::string victim = set + "/shards/00000001";
    const std::string whole = read_file(victim + "/boxes.csv");

    for (const bool truncated : {true, false}) {
        // Truncated, or of the same size with one digit changed.
        std::string damaged = truncated ? whole.substr(0, whole.size() / 2) : whole;
        if (!truncated) damaged[0] = '9';
        write_file(victim + "/boxes.csv", damaged);
        GoldenOptions all;
        all.shard_size = 200;
        try {
            make_golden(scene, set, parameters, all);
            ADD_FAILURE() << "accepted a damaged shard";
        } catch (const InputError& error) {
            EXPECT_NE(std::string(error.what()).find("00000001"), std::string::npos) << error.what();
            EXPECT_NE(std::string(error.what()).find("boxes.csv"), std::string::npos) << error.what();
        }
        EXPECT_GE(finished_shards(set), kept);
        EXPECT_FALSE(fs::exists(set + "/manifest.json"));
    }
    fs::remove_all(victim);  // the remedy that the message names
    ASSERT_EQ(run(command(set)), 0);
    EXPECT_EQ(bytes_of(set), bytes_of(*whole_ / "set"));
}

TEST_F(Interruption, ShardsOfAnotherSetAreRefused) {
    const std::string set = folder_ / "set";
    GoldenParameters parameters;
    GoldenOptions half;
    half.shard_size = 10, half.shard = 1, half.shards = 2;
    ASSERT_FALSE(make_golden(scene, set, parameters, half).finished);
    parameters.margin = 0.25;
    EXPECT_THROW(make_golden(scene, set, parameters, half), InputError);
}

TEST_F(Interruption, AFolderThatCannotBeWrittenIsAClearError) {
    EXPECT_EQ(run(command("/dev/null/set")), 2);
    if (::geteuid() == 0) return;  // root writes anywhere
    fs::permissions(folder_.path(), fs::perms::owner_read | fs::perms::owner_exec);
    EXPECT_EQ(run(command(folder_ / "set")), 2);
    fs::permissions(folder_.path(), fs::perms::owner_all);
}

}  // namespace
}  // namespace cob
