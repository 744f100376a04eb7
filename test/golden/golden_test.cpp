// Making golden sets (SPEC 7): right, reproducible from the manifest, the same bytes however they were made.
#include "cob/golden.hpp"

#include "cob/error.hpp"
#include "cob/files.hpp"
#include "cob/manifest.hpp"
#include "cob/tables.hpp"
#include "cob/verify.hpp"
#include "golden/dice.hpp"
#include "golden/twin_check.hpp"
#include "program.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <set>

namespace cob {
namespace {

namespace fs = std::filesystem;

std::string data(const std::string& name) {
    return std::string(COB_DATA) + "/" + name;
}

GoldenParameters small_set() {
    GoldenParameters parameters;
    parameters.segments = 60;
    parameters.hard = 72;
    return parameters;
}

GoldenOptions shards_of(std::uint64_t size) {
    GoldenOptions options;
    options.shard_size = size;
    return options;
}

std::map<std::string, int> kinds_of(const std::string& set, const std::string& question) {
    std::map<std::string, int> kinds;
    verify::Table tags(set + "/tags.csv", {"question,id,kind,band"});
    while (tags.next())
        if (tags.field(0) == question) ++kinds[std::string(tags.field(2))];
    return kinds;
}

// "Every generated set agrees with the naive twin": meshing, segments and every hard kind, as it stands and snapped.
TEST(Golden, SetsAgreeWithTheNaiveTwin) {
    struct Row {
        const char* scene;
        std::optional<int> grid;
        bool binary32;
    };
    const Row rows[] = {
        {"cornell.obj", {}, false}, {"figure4.obj", {}, false}, {"figure2.obj", 20, false}, {"cornell.obj", {}, true}};
    for (const Row& row : rows) {
        const test::TemporaryFolder folder;
        GoldenParameters parameters = small_set();
        parameters.grid = row.grid;
        parameters.binary32 = row.binary32;
        parameters.skip_invalid = true;
        const GoldenResult result = make_golden(data(row.scene), folder / "set", parameters);
        EXPECT_TRUE(result.finished);
        EXPECT_EQ(result.snapped.has_value(), row.grid || row.binary32);
        const test::TwinCheck check = test::check_with_twin(folder / "set");
        EXPECT_EQ(check.boxes, result.boxes);
        EXPECT_EQ(check.segments, result.segments);
        EXPECT_GT(check.pairs, 300u);
        for (const std::string& difference : check.differences) ADD_FAILURE() << row.scene << ": " << difference;
    }
}

// SPEC 1: "for any finite input, 1e-300, 1e300 and subnormals included", in one scene: lengths, heights and moves of
// which binary64 knows only 0 and infinity.
TEST(Golden, AScene600OrdersOfMagnitudeLongIsAnswered) {
    const test::TemporaryFolder folder;
    write_file(folder / "scene.obj",
               "v 0 0 0\nv 1e-300 0 0\nv 1e-300 1e300 0\nv 0 1e300 0\nv 0 0 1\nv 1e-300 0 1\nv 0 1e300 -1\n"
               "f 1 2 3 4\nf 5 6 7\n");
    const GoldenResult result = make_golden(folder / "scene.obj", folder / "set", small_set());
    EXPECT_GE(result.boxes, 2u);
    EXPECT_GE(result.segments, 60u);
    const test::TwinCheck check = test::check_with_twin(folder / "set");
    for (const std::string& difference : check.differences) ADD_FAILURE() << difference;
}

// SPEC 2: "straight angles are allowed". Wherever its loop begins, a quadrilateral gets right answers and one band.
TEST(Golden, AStraightAngleMayStandAtAnyCorner) {
    std::set<std::string> bands;
    for (int first = 0; first < 4; ++first) {
        const test::TemporaryFolder folder;
        std::string quadrilateral = "f";
        for (int k = 0; k < 4; ++k) quadrilateral += " " + std::to_string(1 + (first + k) % 4);
        write_file(folder / "scene.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 2 0\nv .6 .3 .1\nv 1 .5 1\nv .2 .4 .3\n" +
                                             quadrilateral + "\nf 5 6 7\n");
        make_golden(folder / "scene.obj", folder / "set", small_set());
        const test::TwinCheck check = test::check_with_twin(folder / "set");
        for (const std::string& difference : check.differences) ADD_FAILURE() << quadrilateral << ": " << difference;
        verify::Table tags(folder / "set/tags.csv", {"question,id,kind,band"});
        ASSERT_TRUE(tags.next());
        bands.insert(std::string(tags.field(3)));
    }
    EXPECT_EQ(bands, std::set<std::string>{"8"});
}

// A level of 12 can have more elements than 2^32: all of them are drawn.
TEST(Golden, DiceReachEveryNumber) {
    const std::uint64_t n = std::uint64_t{3} << 33;
    Dice dice(1, 2, 3);
    std::set<std::uint64_t> sixths;
    for (int k = 0; k < 100; ++k) sixths.insert(dice.below(n) >> 32);
    EXPECT_EQ(sixths, (std::set<std::uint64_t>{0, 1, 2, 3, 4, 5}));
}

// Nothing is made of a size with which the number of shards would overflow to none.
TEST(Golden, AShardSizeOutOfRangeIsRefused) {
    const test::TemporaryFolder folder;
    for (const std::uint64_t size : {std::uint64_t{0}, ~std::uint64_t{0}}) {
        EXPECT_THROW(make_golden(data("figure2.obj"), folder / "set", small_set(), shards_of(size)), InputError);
        EXPECT_FALSE(fs::exists(folder / "set"));
    }
}

TEST(Golden, EveryHardKindIsMade) {
    const test::TemporaryFolder folder;
    GoldenParameters parameters = small_set();
    parameters.hard = 200;
    make_golden(data("cornell.obj"), folder / "set", parameters);
    const auto boxes = kinds_of(folder / "set", "box"), segments = kinds_of(folder / "set", "segment");
    for (const char* kind : {"element", "seam", "plane", "side", "side-ulp", "top", "top-ulp", "far", "small"})
        EXPECT_GE(boxes.count(kind), 1u) << kind;
    for (const char* kind :
         {"light", "surface", "edge", "corner", "edge-ulp", "corner-ulp", "seam", "plane", "vertices", "far", "small"})
        EXPECT_GE(segments.count(kind), 1u) << kind;
}

// "Same command, same bytes": whatever the threads, the shards and who made them.
TEST(Golden, BytesDependOnSceneAndParametersAlone) {
    const test::TemporaryFolder folder;
    const std::string scene = data("figure5.obj");
    const GoldenParameters parameters = small_set();
    GoldenOptions one = shards_of(1000);
    one.threads = 1;
    make_golden(scene, folder / "one", parameters, one);
    const auto expected = test::bytes_of(folder / "one");
    EXPECT_EQ(expected.size(), 10u) << "three tables of questions, three of answers, tags, scene, materials, manifest";

    make_golden(scene, folder / "many", parameters, shards_of(7));
    EXPECT_EQ(test::bytes_of(folder / "many"), expected);

    // Three machines, each into a folder of its own, brought together.
    for (std::uint64_t machine = 1; machine <= 3; ++machine) {
        GoldenOptions options = shards_of(7);
        options.shard = machine, options.shards = 3;
        const GoldenResult result = make_golden(scene, folder / std::to_string(machine), parameters, options);
        EXPECT_FALSE(result.finished);
        EXPECT_GT(result.made, 5u);
        EXPECT_FALSE(fs::exists(folder / std::to_string(machine) + "/manifest.json"));
    }
    GoldenOptions merge = shards_of(7);
    merge.merge = {folder / "1", folder / "2", folder / "3"};
    const GoldenResult merged = make_golden(scene, folder / "merged", parameters, merge);
    EXPECT_TRUE(merged.finished);
    EXPECT_EQ(merged.made, 0u);
    EXPECT_EQ(test::bytes_of(folder / "merged"), expected);

    // Three machines into one folder: the last one finishes it.
    for (std::uint64_t machine = 0; machine < 3; ++machine) {
        GoldenOptions options = shards_of(7);
        options.shard = machine, options.shards = 3;
        EXPECT_EQ(make_golden(scene, folder / "shared", parameters, options).finished, machine == 2);
    }
    EXPECT_EQ(test::bytes_of(folder / "shared"), expected);

    // A finished set is left alone; another one is not written over it.
    EXPECT_EQ(make_golden(scene, folder / "one", parameters).made, 0u);
    GoldenParameters other = parameters;
    other.seed = 2;
    EXPECT_THROW(make_golden(scene, folder / "one", other), InputError);
    EXPECT_EQ(test::bytes_of(folder / "one"), expected);
}

// "Reproducible from its manifest": the parameters there and the scene of the set are enough.
TEST(Golden, TheSetReproducesItselfFromItsOwnScene) {
    const test::TemporaryFolder folder;
    GoldenParameters parameters = small_set();
    parameters.binary32 = true;
    make_golden(data("figure7.obj"), folder / "set", parameters);
    const GoldenResult again = make_golden(folder / "set" + "/scene.obj", folder / "again", parameters);
    EXPECT_EQ(again.snapped->moved, 0u);
    EXPECT_EQ(test::bytes_of(folder / "again"), test::bytes_of(folder / "set"));
    const Manifest manifest = read_manifest(folder / "set" + "/manifest.json");
    EXPECT_EQ(manifest.parameters.at("float"), "true");
    EXPECT_EQ(manifest.counts.at("segments"), 132);
}

// SPEC 7: "every corner and sample point is exactly a binary64 number"; --float: binary32.
TEST(Golden, SnappedSetsAreExactlyConsumable) {
    for (const bool binary32 : {false, true}) {
        const test::TemporaryFolder folder;
        GoldenParameters parameters = small_set();
        parameters.level = 2;
        parameters.binary32 = binary32;
        if (!binary32) parameters.grid = 24;
        const GoldenResult result = make_golden(data("cornell.obj"), folder / "set", parameters);
        EXPECT_GT(result.snapped->moved, 0u);
        EXPECT_LE(result.snapped->largest_move, std::ldexp(1.0, -result.snapped->grid))
            << "at most sqrt(3)/2 of the grid";
        std::size_t numbers = 0;
        for (const auto& [name, first] : {std::pair{"boxes.csv", 2u}, std::pair{"segments.csv", 1u}}) {
            verify::Table table(folder / "set" + "/" + name,
                                {verify::detail::boxes_header, verify::detail::segments_headers[0]});
            while (table.next())
                for (std::size_t k = first; k < (first == 2 ? 19u : 7u); ++k) {
                    const std::string text(table.field(k));
                    if (text.empty()) continue;
                    ++numbers;
                    ASSERT_EQ(text.find('/'), std::string::npos) << text;
                    const double value = table.number(k);
                    if (binary32) {
                        ASSERT_EQ(static_cast<double>(static_cast<float>(value)), value) << text;
                    }
                }
        }
        EXPECT_GT(numbers, 1000u);
    }
}

TEST(Golden, AGridTooFineIsRefusedWithTheFinestPossible) {
    const test::TemporaryFolder folder;
    GoldenParameters parameters;
    parameters.level = 3;
    parameters.grid = 60;
    std::string said;
    try {
        make_golden(data("cornell.obj"), folder / "set", parameters);
    } catch (const InputError& error) {
        said = error.what();
    }
    const std::size_t at = said.find("choose --grid ");
    ASSERT_NE(at, std::string::npos) << said;
    parameters.grid = std::stoi(said.substr(at + 14));
    EXPECT_TRUE(make_golden(data("cornell.obj"), folder / "set", parameters).finished) << "the remedy works";
    EXPECT_FALSE(fs::exists(folder / "set" + "/shards"));
}

// A set may lack boxes or segments, with their answers (SPEC 7).
TEST(Golden, SetsOfOneSortHaveNoTablesOfTheOther) {
    const test::TemporaryFolder folder;
    GoldenParameters parameters;
    parameters.boxes = false;
    parameters.segments = 10;
    make_golden(data("figure2.obj"), folder / "segments", parameters);
    EXPECT_FALSE(fs::exists(folder / "segments" + "/boxes.csv"));
    EXPECT_FALSE(fs::exists(folder / "segments" + "/states.csv"));
    make_golden(data("figure2.obj"), folder / "boxes", {});
    EXPECT_FALSE(fs::exists(folder / "boxes" + "/visibility.csv"));
    EXPECT_TRUE(verify_answers(folder / "boxes", folder / "boxes", {}).agree());
}

}  // namespace
}  // namespace cob
