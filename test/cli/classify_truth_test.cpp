// `cob classify --truth`, end to end: the paper's heuristic beside what is truly seen, on the paper's own figures.
#include "program.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <sstream>
#include <vector>

namespace cob {
namespace {

const std::string quarter = " --edge 0.25", eighth = " --edge 0.125";

using Row = std::map<std::string, std::string>;  ///< By column.

std::vector<std::string> split(const std::string& text, char separator) {
    std::vector<std::string> parts;
    std::istringstream stream(text);
    for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
    return parts;
}

std::vector<Row> read_rows(const std::string& path) {
    const auto lines = split(read_file(path), '\n');
    const auto columns = split(lines.at(0), ',');
    std::vector<Row> rows;
    for (std::size_t k = 1; k < lines.size(); ++k) {
        const auto values = split(lines[k] + ",.", ',');  // keeps an empty last value
        EXPECT_EQ(values.size(), columns.size() + 1) << lines[k];
        rows.emplace_back();
        for (std::size_t c = 0; c < columns.size(); ++c) rows.back()[columns[c]] = values.at(c);
    }
    return rows;
}

class ClassifyTruth : public testing::Test {
protected:
    /// The one row of truth_summary.csv.
    Row truth(const std::string& scene, const std::string& options) const {
        const auto run =
            test::run_program("classify " + scene + " --truth --states-only -o " + folder_.path() + " " + options);
        EXPECT_EQ(run.code, 0) << run.error;
        const auto rows = read_rows(folder_ / "truth_summary.csv");
        EXPECT_EQ(rows.size(), 1u);
        return rows.at(0);
    }
    Row figure(int number, const std::string& options) const {
        return truth(COB_DATA "/figure" + std::to_string(number) + ".obj", options);
    }
    std::string scene(const std::string& text) const {
        write_file(folder_ / "scene.mtl", "newmtl grey\nKd .5 .5 .5\nnewmtl lamp\nKe 9 9 9\n");
        write_file(folder_ / "scene.obj", "mtllib scene.mtl\n" + text);
        return folder_ / "scene.obj";
    }

    test::TemporaryFolder folder_;
};

// A row for each element, and their verdicts add up to the summary; the same bytes for any number of threads.
TEST_F(ClassifyTruth, TablesFitEachOther) {
    const Row summary = figure(5, quarter + " --threads 1");
    const std::string table = read_file(folder_ / "truth.csv"), total = read_file(folder_ / "truth_summary.csv");
    EXPECT_EQ(table.substr(0, table.find('\n')), "box,state,lights,boundaries,sharp,hemisphere,verdict");
    EXPECT_EQ(total.substr(0, total.find('\n')),
              "scene,elements,sampled,lights,empty,close,occluded,boundary,sharp,refined_in_vain,sharp_missed,"
              "occluded_lit,occluded_lit_hemisphere,shut_out_together");
    std::map<std::string, int> states, verdicts;
    const auto states_table = read_rows(folder_ / "states.csv"), rows = read_rows(folder_ / "truth.csv");
    ASSERT_EQ(rows.size(), states_table.size());
    for (std::size_t k = 0; k < rows.size(); ++k) {
        EXPECT_EQ(rows[k].at("box"), states_table[k].at("box"));
        EXPECT_EQ(rows[k].at("state"), states_table[k].at("state"));
        ++states[rows[k].at("state")];
        ++verdicts[rows[k].at("verdict")];
    }
    for (const char* state : {"empty", "close", "occluded"})
        EXPECT_EQ(summary.at(state), std::to_string(states[state])) << state;
    EXPECT_EQ(summary.at("refined_in_vain"), std::to_string(verdicts["refined in vain"]));
    EXPECT_EQ(summary.at("occluded_lit"), std::to_string(verdicts["occluded but lit"]));
    EXPECT_EQ(summary.at("sampled"), std::to_string(rows.size()));

    figure(5, quarter + " --threads 2");
    EXPECT_EQ(read_file(folder_ / "truth.csv"), table);
    EXPECT_EQ(read_file(folder_ / "truth_summary.csv"), total);
    // Of more pairs than asked for, elements at equal distances.
    EXPECT_EQ(figure(5, quarter + " --truth-pairs 20").at("sampled"), "18");
    EXPECT_EQ(read_rows(folder_ / "truth.csv").at(1).at("box"), "3");
}

// Figure 2: the object casts one sharp shadow, on the element that it stands on.
TEST_F(ClassifyTruth, ObjectOnATable) {
    const Row summary = figure(2, quarter);
    EXPECT_EQ(summary.at("boundary"), "1");
    EXPECT_EQ(summary.at("sharp"), "1");
    EXPECT_EQ(summary.at("sharp_missed"), "0");
}

// Figure 3: along the common edge of two polygons that light falls on freely all elements are refined in vain.
TEST_F(ClassifyTruth, SharedEdge) {
    const Row summary = figure(3, quarter);
    EXPECT_EQ(summary.at("close"), "8");
    EXPECT_EQ(summary.at("refined_in_vain"), "8");
    EXPECT_EQ(summary.at("boundary"), "0");
}

// Figure 4: no light gets under the sheet, and the 12 elements around those 4 that it covers show its sharp shadow.
TEST_F(ClassifyTruth, TotalOcclusion) {
    const Row summary = figure(4, quarter);
    EXPECT_EQ(summary.at("occluded"), "20");  // 4 of the table, 16 of the sheet's lower side
    EXPECT_EQ(summary.at("occluded_lit"), "0");
    for (const char* column : {"close", "boundary", "sharp"}) EXPECT_EQ(summary.at(column), "12") << column;
    EXPECT_EQ(summary.at("sharp_missed"), "0");
    EXPECT_EQ(summary.at("refined_in_vain"), "0");
}

// Figure 5, the tangential case: all that is covered is lit from the side, under an angle that is known.
TEST_F(ClassifyTruth, TangentialLight) {
    const Row summary = figure(5, quarter);
    EXPECT_EQ(summary.at("occluded"), "20");
    EXPECT_EQ(summary.at("occluded_lit"), "20");
    // Most is lit what is nearest, at (3/4, 1/2): it sees all of the lamp, of 1 by 1/4 at distance 5/4.
    const double d = 1.25, a = 0.5, b = 0.25;
    const double share = 2 * std::atan(a * b / (d * std::sqrt(a * a + b * b + d * d))) / (2 * std::acos(-1.0));
    const double found = std::stod(summary.at("occluded_lit_hemisphere"));
    EXPECT_LT(found, share);
    EXPECT_GT(found, 0.98 * share);
}

// Figure 6, a light below the sheet: where its box holds the light an element is not occluded (SPEC 5); smaller boxes
// beside the light are, and are lit all the same.
TEST_F(ClassifyTruth, LightBelowTheSheet) {
    figure(6, quarter);
    int lit = 0;
    for (const Row& row : read_rows(folder_ / "truth.csv"))
        if (row.at("state") != "occluded" && std::stod(row.at("hemisphere")) > 0) ++lit;
    const Row large = read_rows(folder_ / "truth_summary.csv").at(0);
    EXPECT_EQ(large.at("occluded_lit"), "0");
    EXPECT_GE(lit, 4);
    const Row small = figure(6, eighth);
    EXPECT_EQ(small.at("occluded_lit"), "12");  // of the 4 by 4 under the sheet, all but the 4 under the lamp
}

// Figure 7: the detail's shadow is in one element; nothing beside it has any.
TEST_F(ClassifyTruth, DetailInACorner) {
    const Row summary = figure(7, quarter);
    EXPECT_EQ(summary.at("boundary"), "1");
    EXPECT_EQ(summary.at("sharp"), "1");
    EXPECT_EQ(read_rows(folder_ / "truth.csv").at(0).at("sharp"), "1");
}

// A sheet that ends over the elements' common side, with a light beyond: the shadow is sharp within 1/30 of that side.
TEST_F(ClassifyTruth, SharpShadowBesideASide) {
    const Row summary = truth(scene("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
                                    "v 0 0 .0625\nv .5 0 .0625\nv .5 1 .0625\nv 0 1 .0625\n"
                                    "v 0 .375 2\nv 0 .625 2\nv .25 .625 2\nv .25 .375 2\n"
                                    "usemtl grey\nf 1 2 3 4\nf 5 6 7 8\nusemtl lamp\nf 9 10 11 12\n"),
                              "--level 1");
    EXPECT_EQ(summary.at("sharp"), "2");
    EXPECT_EQ(summary.at("refined_in_vain"), "2");  // those wholly under it
}

// SPEC 5: "two half sheets shut an element out and neither covers: reports set this beside the truth".
TEST_F(ClassifyTruth, ShutOutBySeveralTogether) {
    const std::string text =
        "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
        "v -1 -1 .125\nv .5 -1 .125\nv .5 2 .125\nv -1 2 .125\nv 2 -1 .125\nv 2 2 .125\n"
        "v 0 0 4\nv 0 1 4\nv 1 1 4\nv 1 0 4\nusemtl lamp\nf 11 12 13 14\nusemtl grey\nf 1 2 3 4\nf 5 6 7 8\n";
    const Row both = truth(scene(text + "f 6 9 10 7\n"), "");
    EXPECT_EQ(both.at("shut_out_together"), "1");
    const auto rows = read_rows(folder_ / "truth.csv");
    EXPECT_EQ(rows.at(1).at("state"), "close");
    EXPECT_EQ(rows.at(1).at("verdict"), "refined in vain");
    EXPECT_EQ(truth(scene(text), "").at("shut_out_together"), "0");  // one of them lets light in
}

// A comma in the scene's name does not move the columns (RFC 4180).
TEST_F(ClassifyTruth, SceneNameIsQuoted) {
    write_file(folder_ / "a,\"b.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n");
    const auto run = test::run_program("classify '" + folder_ / "a,\"b.obj" + "' --truth -o " + folder_.path());
    ASSERT_EQ(run.code, 0) << run.error;
    const auto lines = split(read_file(folder_ / "truth_summary.csv"), '\n');
    EXPECT_EQ(lines.at(1), "\"a,\"\"b.obj\",1,1,0,1,0,0,0,0,0,0,0,0,0");
}

// Bad input: exit code 2 and no file.
TEST_F(ClassifyTruth, RefusesWithoutLeavingFiles) {
    const std::string out = folder_ / "out";
    for (const char* options : {"--truth-pairs x", "--truth-pairs -1", "--truth-pairs 0"}) {
        const auto run = test::run_program("classify " COB_DATA "/figure5.obj --truth -o " + out + " " + options);
        EXPECT_EQ(run.code, 2) << options;
        EXPECT_FALSE(run.error.empty()) << options;
        EXPECT_FALSE(std::filesystem::exists(out)) << options;
    }
}

// "A boundary where it is neither visible nor hidden": also where the strip of light is too narrow for samples.
TEST_F(ClassifyTruth, ABoundaryBetweenTheSamplesIsFound) {
    const Row row = truth(scene("usemtl grey\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n"
                                "v -1 -1 .01\nv .1 -1 .01\nv .1 2 .01\nv -1 2 .01\nf 5 6 7 8\n"
                                "v .15 -1 .01\nv 2 -1 .01\nv 2 2 .01\nv .15 2 .01\nf 9 10 11 12\n"
                                "usemtl lamp\nv .1 .4 1\nv .1 .6 1\nv .15 .6 1\nv .15 .4 1\nf 13 14 15 16\n"),
                          "");
    EXPECT_EQ(row.at("elements"), "4");
    EXPECT_GE(std::stoi(row.at("boundary")), 1);
    EXPECT_EQ(row.at("shut_out_together"), "0");
}

// SPEC 2: "straight angles are allowed", whichever corners they are at.
TEST_F(ClassifyTruth, TakesElementsWithStraightAngles) {
    EXPECT_EQ(truth(scene("usemtl grey\nv 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 2 0\nf 1 2 3 4\n"
                          "usemtl lamp\nv 0 0 1\nv 0 1 1\nv 1 1 1\nv 1 0 1\nf 5 6 7 8\n"),
                    "")
                  .at("boundary"),
              "0");
}

}  // namespace
}  // namespace cob
