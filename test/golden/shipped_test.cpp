// The sets in data/golden: reproducible, right, and hard enough that the usual shortcuts are caught.
#include "cob/answer.hpp"
#include "cob/files.hpp"
#include "cob/golden.hpp"
#include "golden/shipped_sets.hpp"
#include "golden/twin_check.hpp"
#include "program.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <map>

namespace cob {
namespace {

namespace fs = std::filesystem;

TEST(ShippedSets, AreReproducedByTheirManifests) {
    std::uintmax_t bytes = 0;
    for (const std::string& set : test::shipped_sets()) {
        const test::TemporaryFolder folder;
        const Manifest manifest = read_manifest(set + "/manifest.json");
        make_golden(set + "/scene.obj", folder / "again", parameters_of(manifest));
        for (const auto& entry : fs::directory_iterator(set)) {
            const std::string name = entry.path().filename().string();
            EXPECT_TRUE(read_file(folder / "again" + "/" + name) == read_file(set + "/" + name)) << set << " " << name;
            bytes += entry.file_size();
        }
    }
    EXPECT_GE(test::shipped_sets().size(), 18u) << "one for each kind of degeneracy and for each sort of scene";
    EXPECT_LT(bytes, 2u << 20) << "they stay small";
}

TEST(ShippedSets, AgreeWithTheNaiveTwin) {
    std::uint64_t pairs = 0, segments = 0;
    for (const std::string& set : test::shipped_sets()) {
        const test::TwinCheck check = test::check_with_twin(set);
        pairs += check.pairs, segments += check.segments;
        for (const std::string& difference : check.differences) ADD_FAILURE() << set << ": " << difference;
    }
    EXPECT_GT(pairs, 10000u);
    EXPECT_GT(segments, 500u);
}

// The twin's check has teeth: answers that nobody asked for are differences, too.
TEST(ShippedSets, RowsTooManyAreSeen) {
    for (const auto& [table, row] : {std::pair{"states.csv", "999999,empty,,,\n"},
                                     {"relations.csv", "999999,0,base,0,none\n"},
                                     {"visibility.csv", "999999,clear\n"}}) {
        const test::TemporaryFolder folder;
        fs::copy(COB_DATA "/golden/cornell", folder.path(), fs::copy_options::recursive);
        EXPECT_TRUE(test::check_with_twin(folder.path()).differences.empty());
        write_file(folder / table, read_file(folder / table) + row);
        EXPECT_EQ(test::check_with_twin(folder.path()).differences.size(), 1u) << table;
    }
}

/// Wrong and undecided answers of a variant, by "question kind", over all shipped sets.
std::map<std::string, verify::Counts> judge(Arithmetic arithmetic) {
    std::map<std::string, verify::Counts> sums;
    for (const std::string& set : test::shipped_sets()) {
        const test::TemporaryFolder folder;
        AnswerOptions options;
        options.arithmetic = arithmetic;
        answer_set(set, folder.path(), options);
        for (const verify::TableReport& table : verify_answers(set, folder.path(), {}).tables)
            for (const auto& [kind, part] : table.kinds) {
                verify::Counts& sum = sums[(table.table == "visibility" ? "segment " : "box ") + kind];
                sum.compared += part.counts.compared, sum.wrong += part.counts.wrong;
                sum.undecided += part.counts.undecided;
                sum.missing += part.counts.missing + part.counts.doubled + part.counts.unknown;
            }
    }
    return sums;
}

// "A float variant is caught: each kind that float gets wrong shows wrong answers; the exact one shows none; the
// interval one shows only undecided."
TEST(ShippedSets, CatchFloatAndPassExact) {
    std::uint64_t compared = 0;
    for (const Arithmetic arithmetic : {Arithmetic::exact, Arithmetic::rational})
        for (const auto& [kind, counts] : judge(arithmetic)) {
            EXPECT_TRUE(counts.agree()) << kind;
            compared += counts.compared;
        }
    EXPECT_GT(compared, 1000u);

    std::uint64_t undecided = 0;
    for (const auto& [kind, counts] : judge(Arithmetic::interval)) {
        EXPECT_EQ(counts.wrong + counts.missing, 0u) << kind;
        undecided += counts.undecided;
    }
    EXPECT_GT(undecided, 0u);

    const auto in_float = judge(Arithmetic::binary32), in_double = judge(Arithmetic::binary64);
    for (const char* kind : {"box side", "box side-ulp", "box top", "box top-ulp", "box seam", "box small",
                             "segment edge-ulp", "segment corner-ulp"}) {
        ASSERT_EQ(in_float.count(kind), 1u) << kind;
        EXPECT_GT(in_float.at(kind).wrong, 0u) << kind;
    }
    for (const char* kind : {"box side-ulp", "box top-ulp"}) EXPECT_GT(in_double.at(kind).wrong, 0u) << kind;
}

// The example of the README, which needs neither the library nor CGAL, catches its own float implementation.
TEST(ShippedSets, TheExampleReportsItsErrors) {
    const auto run = [](const std::string& set) { return test::run_shell(COB_EXAMPLE " " + set).code; };
    const std::string golden = std::string(COB_DATA) + "/golden/";
    EXPECT_EQ(run(golden + "corner-ulp"), 1);
    EXPECT_EQ(run(golden + "vertices"), 0);
    EXPECT_EQ(run(golden + "none"), 2);
}

}  // namespace
}  // namespace cob
