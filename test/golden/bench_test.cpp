// "Error against run time. `cob bench SET`: for each variant and kind: wrong, undecided, nanoseconds per question (min,
// median), memory." and "the exact one shows none; the interval one shows only undecided".
#include "cob/bench.hpp"

#include "cob/error.hpp"
#include "cob/files.hpp"
#include "cob/golden.hpp"
#include "golden/shipped_sets.hpp"
#include "temporary_folder.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <set>

namespace cob {
namespace {

namespace fs = std::filesystem;

BenchOptions quick() {
    BenchOptions options;
    options.repetitions = 2;
    options.most_of_kind = 4;
    return options;
}

TEST(Bench, EveryVariantOnEveryKindOfTheShippedSets) {
    const std::vector<BenchRow> rows = bench_sets(test::shipped_sets(), quick());

    std::map<std::string, std::set<std::string>> kinds;  // of each variant, of which every one has a row of its own
    std::map<std::string, std::uint64_t> wrong, undecided;
    for (const BenchRow& row : rows) {
        const std::string variant = row.question + " " + row.variant;
        EXPECT_TRUE(kinds[variant].insert(row.kind).second) << variant << " " << row.kind;
        EXPECT_GT(row.questions, 0u) << variant << " " << row.kind;
        EXPECT_LE(row.wrong + row.undecided, row.questions) << variant << " " << row.kind;
        EXPECT_GT(row.nanoseconds_min, 0) << variant << " " << row.kind;
        EXPECT_LE(row.nanoseconds_min, row.nanoseconds_median) << variant << " " << row.kind;
        EXPECT_GT(row.bytes, 0u) << variant << " " << row.kind;
        if (row.kind == "all") continue;
        wrong[variant] += row.wrong, undecided[variant] += row.undecided;
    }

    for (const std::string question : {"box ", "segment "}) {
        for (const char* variant : {"float", "double", "epsilon", "interval", "exact", "rational"})
            EXPECT_EQ(kinds[question + variant], kinds[question + "exact"]) << question << variant;
        for (const char* variant : {"exact", "rational"}) {
            EXPECT_EQ(wrong[question + variant], 0u) << question << variant;
            EXPECT_EQ(undecided[question + variant], 0u) << question << variant;
        }
        EXPECT_EQ(wrong[question + "interval"], 0u);
        EXPECT_GT(undecided[question + "interval"], 0u);
        for (const char* variant : {"float", "double", "epsilon"})
            EXPECT_GT(wrong[question + variant], 0u) << question << variant;
    }
    EXPECT_GE(kinds["box exact"].size() + kinds["segment exact"].size(), 18u);
    for (const char* variant : {"box cgal-epick", "box cgal-epeck"}) EXPECT_GT(kinds[variant].size(), 2u) << variant;
}

// Ctrl-C ends the work by an exception from the progress.
TEST(Bench, TellsEveryKindAndCanBeEnded) {
    const std::string set = std::string(COB_DATA) + "/golden/cornell";
    std::uint64_t calls = 0;
    BenchOptions options = quick();
    options.progress = [&](std::uint64_t done, std::uint64_t) { EXPECT_EQ(done, calls++); };
    std::uint64_t kinds = 0;
    for (const BenchRow& row : bench_set(set, options)) kinds += row.kind != "all";
    EXPECT_GE(calls, kinds);
    EXPECT_GT(kinds, 10u);
    options.progress = [&](std::uint64_t done, std::uint64_t) {
        if (done == 3) throw std::runtime_error("enough");
    };
    EXPECT_THROW(bench_set(set, options), std::runtime_error);
}

TEST(Bench, SumsOfSeveralSetsAreThoseOfEach) {
    const std::string golden = std::string(COB_DATA) + "/golden/";
    std::map<std::string, std::uint64_t> questions, wrong;
    for (const char* set : {"cornell", "figure5"})
        for (const BenchRow& row : bench_set(golden + set, quick())) {
            const std::string name = row.question + " " + row.variant + " " + row.kind;
            questions[name] += row.questions, wrong[name] += row.wrong;
        }
    for (const BenchRow& row : bench_sets({golden + "cornell", golden + "figure5"}, quick())) {
        const std::string name = row.question + " " + row.variant + " " + row.kind;
        EXPECT_EQ(row.questions, questions[name]) << name;
        EXPECT_EQ(row.wrong, wrong[name]) << name;
        questions.erase(name);
    }
    EXPECT_TRUE(questions.empty());
}

// Embree flushes subnormal numbers to zero: nothing exact that follows in the same process may notice.
TEST(Bench, LeavesExactArithmeticAsItWas) {
    const std::string set = std::string(COB_DATA) + "/golden/edge-ulp";
    bench_set(set, quick());
    const test::TemporaryFolder folder;
    make_golden(set + "/scene.obj", folder / "again", parameters_of(read_manifest(set + "/manifest.json")));
    for (const char* table : {"/segments.csv", "/visibility.csv", "/tags.csv"})
        EXPECT_TRUE(read_file(folder / "again" + table) == read_file(set + table)) << table;
}

TEST(Bench, AFolderThatIsNoSetIsRefused) {
    EXPECT_THROW(bench_set(std::string(COB_DATA) + "/golden"), InputError);
}

}  // namespace
}  // namespace cob
