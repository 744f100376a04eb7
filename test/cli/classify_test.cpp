// `cob classify`, end to end.
#include "cob/error.hpp"
#include "program.hpp"
#include "tables.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <set>

namespace cob {
namespace {

using test::files_in;
using test::read_all;

const std::string desk = COB_DATA "/desk.obj";

TEST(Classify, TablesFitEachOther) {
    const test::TemporaryFolder folder;
    const auto run = test::run_program("classify " + desk + " --level 1 -o " + folder / "new/folder");
    ASSERT_EQ(run.code, 0) << run.error;
    const std::string out = folder / "new/folder";
    EXPECT_EQ(files_in(out),
              (std::set<std::string>{"boxes.csv", "elements.ply", "relations.csv", "states.csv", "summary.json"}));
    const auto boxes = read_all<BoxRow>(out);
    const auto states = read_all<StateRow>(out);
    const auto relations = read_all<RelationRow>(out);
    ASSERT_EQ(boxes.size(), states.size());
    ASSERT_GT(boxes.size(), 500u);

    // The lists of a state are those of its relations, where the buffer is not occluded.
    std::size_t next = 0, counts[4] = {};
    for (std::size_t k = 0; k < states.size(); ++k) {
        ASSERT_EQ(states[k].box, static_cast<RowId>(k));
        ASSERT_EQ(boxes[k].box, static_cast<RowId>(k));
        std::vector<PolygonId> close, cover;
        for (; next < relations.size() && relations[next].box == states[k].box; ++next) {
            EXPECT_NE(relations[next].relation, Relation::disjoint);
            EXPECT_NE(relations[next].polygon, boxes[k].question.polygon);
            if (is_close(relations[next].relation)) close.push_back(relations[next].polygon);
            if (relations[next].covers) cover.push_back(relations[next].polygon);
        }
        ++counts[static_cast<std::size_t>(states[k].state)];
        EXPECT_EQ(states[k].cover, cover);
        if (states[k].state == BufferState::occluded) close.clear();
        EXPECT_EQ(states[k].close, close);
        EXPECT_EQ(states[k].state == BufferState::close, !close.empty());
    }
    EXPECT_EQ(next, relations.size());

    const auto json = nlohmann::json::parse(read_file(out + "/summary.json"));
    EXPECT_EQ(json["elements"]["total"], states.size());
    EXPECT_EQ(json["elements"]["empty"], counts[1]);
    EXPECT_EQ(json["elements"]["close"], counts[2]);
    EXPECT_EQ(json["elements"]["occluded"], counts[3]);
    EXPECT_EQ(json["bytes"]["per_buffer"], 4.0);
    EXPECT_GT(counts[1] * counts[2] * counts[3], 0u);  // all states occur
}

// "Same bytes out for 1 and 2 threads", and for every source and every level of buffers.
TEST(Classify, SameBytesForThreadsSourcesAndLevels) {
    const test::TemporaryFolder folder;
    const std::string common = "classify " + desk + " --level 1 --margin 1/10 --height 0x1p-3 -o ";
    const auto compare = [&](const std::string& options) {
        SCOPED_TRACE(options);
        const auto run = test::run_program(common + folder / "other " + options);
        ASSERT_EQ(run.code, 0) << run.error;
        for (const char* name : {"boxes.csv", "states.csv", "relations.csv", "elements.ply"})
            EXPECT_EQ(read_file(folder / "other/" + name), read_file(folder / "first/" + name)) << name;
    };
    ASSERT_EQ(test::run_program(common + folder / "first --threads 1").code, 0);
    compare("--threads 2");
    compare("--threads 7 --source all");
    compare("--buffer element");
    compare("--buffer polygon --threads 2");
    compare("--buffer tree --mode inherit");
}

// Inherit, the paper's mode: what it calls occluded and is not is listed and counted; the states stay SPEC 7's.
TEST(Classify, InheritListsWhatDiffers) {
    const test::TemporaryFolder folder;
    // A sheet over a small table: the table's box is covered, and the sheet is above the boxes of its elements.
    write_file(folder / "sheet.obj",
               "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv -1 -1 0.25\nv 2 -1 0.25\nv 2 2 0.25\nv -1 2 0.25\n"
               "f 1 2 3 4\nf 5 6 7 8\n");
    const auto run = test::run_program("classify " + folder / "sheet.obj" +
                                       " --level 2 --buffer polygon --mode inherit --states-only -o " + folder / "o");
    ASSERT_EQ(run.code, 0) << run.error;
    EXPECT_EQ(files_in(folder / "o"), (std::set<std::string>{"inherited.csv", "states.csv", "summary.json"}));
    const auto states = read_all<StateRow>(folder / "o");
    for (int k = 0; k < 16; ++k) EXPECT_EQ(states[static_cast<std::size_t>(k)].state, BufferState::empty);
    std::string expected = "box,state,inherited\n";
    for (int k = 0; k < 16; ++k) expected += std::to_string(k) + ",empty,occluded\n";
    EXPECT_EQ(read_file(folder / "o/inherited.csv"), expected);
    const auto json = nlohmann::json::parse(read_file(folder / "o/summary.json"));
    EXPECT_EQ(json["inherited"]["occluded"], 16);
    EXPECT_EQ(json["inherited"]["otherwise_from_the_scene"], 16);
}

TEST(Classify, ThePlyIsWhatItsHeaderSays) {
    const test::TemporaryFolder folder;
    ASSERT_EQ(test::run_program("classify " COB_DATA "/cornell.obj -o " + folder.path()).code, 0);
    const auto boxes = read_all<BoxRow>(folder.path());
    const std::string ply = read_file(folder / "elements.ply");
    std::size_t corners = 0, faces = 0;
    for (const BoxRow& row : boxes) {
        corners += static_cast<std::size_t>(row.question.corners.count);
        faces += 1 + 4 * static_cast<std::size_t>(row.question.corners.count) + 4;
    }
    const std::string end = "end_header\n";
    const std::size_t header = ply.find(end) + end.size();
    EXPECT_NE(ply.find("element vertex " + std::to_string(corners) + "\n"), std::string::npos);
    EXPECT_NE(ply.find("element face " + std::to_string(boxes.size()) + "\n"), std::string::npos);
    EXPECT_EQ(ply.size(), header + 24 * corners + faces);
}

TEST(Classify, HelpShowsEveryDefault) {
    const auto run = test::run_program("classify --help");
    EXPECT_EQ(run.code, 0);
    for (const char* shown : {"--level", "=0", "--edge", "--margin", "=0.125", "--height", "=0.25", "--buffer", "=auto",
                              "--mode", "=strict", "--source", "=tree", "--threads"})
        EXPECT_NE(run.out.find(shown), std::string::npos) << shown;
}

// Bad input: exit code 2, one line on standard error, and no file.
TEST(Classify, RefusesWithoutLeavingFiles) {
    const test::TemporaryFolder folder;
    write_file(folder / "flat.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n");
    write_file(folder / "file", "");
    const std::string out = " -o " + folder / "out";
    for (const std::string& arguments :
         {desk + " --margin -1" + out, desk + " --height 0" + out, desk + " --margin nan" + out,
          desk + " --height 1/0" + out, desk + " --edge x" + out, desk + " --level 21" + out,
          desk + " --buffer octree" + out, desk + " --threads -1" + out, desk, desk + out + " --source",
          folder / "none.obj" + out, folder / "flat.obj" + out, desk + " -o " + folder / "file"}) {
        const auto run = test::run_program("classify " + arguments);
        EXPECT_EQ(run.code, 2) << arguments;
        EXPECT_FALSE(run.error.empty()) << arguments;
        EXPECT_TRUE(files_in(folder / "out").empty()) << arguments;
    }
}

// A refused polygon keeps its number and occurs in no answer.
TEST(Classify, SkipInvalidGoesOn) {
    const test::TemporaryFolder folder;
    write_file(folder / "some.obj",
               "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nv 0 0 0.125\nv 1 0 0.125\nv 1 1 0.125\n"
               "f 1 2 5\nf 1 2 3 4\nf 6 7 8\n");
    const std::string command = "classify " + folder / "some.obj -o " + folder / "out";
    EXPECT_EQ(test::run_program(command).code, 2);
    const auto run = test::run_program(command + " --skip-invalid");
    ASSERT_EQ(run.code, 0) << run.error;
    EXPECT_NE(run.error.find("skipped polygon 0"), std::string::npos) << run.error;
    const auto boxes = read_all<BoxRow>(folder / "out");
    ASSERT_EQ(boxes.size(), 2u);
    EXPECT_EQ(boxes[0].question.polygon, 1);
    EXPECT_EQ(read_all<StateRow>(folder / "out")[0].close, std::vector<PolygonId>{2});
}

}  // namespace
}  // namespace cob
