// Where Embree is wrong: counted by kind, and the worst drawn; needs no Embree.
#include "report/disagreement_report.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace cob::report {
namespace {

/// A square at z = 0, and one at z = 1 far aside.
Scene squares() {
    Scene::Input input;
    input.materials.push_back({});
    for (const double z : {0.0, 1.0})
        for (const Point& p : {Point{0, 0, z}, Point{4, 0, z}, Point{4, 4, z}, Point{0, 4, z}})
            input.positions.push_back(z == 0 ? p : p + Point{100, 0, 0});
    input.faces = {{{0, 1, 2, 3}, 0, 0}, {{4, 5, 6, 7}, 0, 0}};
    return Scene::build(std::move(input));
}

/// Down through the square at (1, 2, 0), 1 beside its side x = 0, a quarter of the segment's length.
EmbreeDisagreement through_the_middle() {
    EmbreeDisagreement wrong;
    wrong.kind = "surface";
    wrong.segment = {Point{1, 2, 2}, Point{1, 2, -2}};
    wrong.blocked = true;
    wrong.piece = 0;
    wrong.parameter = 0.5;
    wrong.clearance = 1;
    wrong.across = {1, 0, 0};
    return wrong;
}

TEST(Disagreements, AreCountedByKind) {
    EmbreeDisagreement at_end = through_the_middle(), hit = through_the_middle();
    at_end.at_end = true;
    hit.kind = "edge-ulp", hit.blocked = false;
    const std::string table = disagreement_table(squares(), {through_the_middle(), at_end, at_end, hit});
    EXPECT_NE(table.find("surface                          2                    1               0\n"),
              std::string::npos)
        << table;
    EXPECT_NE(table.find("edge-ulp                         0                    0               1\n"),
              std::string::npos)
        << table;
    EXPECT_NE(table.find("from 1 2 2 to 1 2 -2: blocked by polygon 0, and Embree hits nothing"), std::string::npos)
        << table;
    EXPECT_EQ(disagreement_table(squares(), {}), "");
}

TEST(Disagreements, TheSectionShowsWhatStandsAtTheContact) {
    const Plot plot = disagreement_plot(squares(), through_the_middle());
    ASSERT_EQ(plot.curves.size(), 3u);  // the other square is far off
    EXPECT_EQ(plot.curves[0].title, "the segment");
    EXPECT_NEAR(plot.curves[0].points[0][0], -0.5, 1e-12);
    EXPECT_NEAR(plot.curves[0].points[1][0], 0.5, 1e-12);
    EXPECT_EQ(plot.curves[1].title, "what Embree is asked");
    EXPECT_NEAR(plot.curves[1].points[0][0], -0.5 + 1e-4, 1e-12);
    EXPECT_EQ(plot.curves[2].title, "polygon 0");
    for (const auto& [x, y] : plot.curves[2].points) EXPECT_NEAR(x, 0, 1e-12);
    // From the side at x = 0, a quarter of the length off, to the one at x = 4, three quarters off.
    const double a = plot.curves[2].points[0][1], b = plot.curves[2].points[1][1];
    EXPECT_NEAR(std::min(a, b), -0.25, 1e-12);
    EXPECT_NEAR(std::max(a, b), 0.75, 1e-12);
}

TEST(Disagreements, AtAnEndTheWindowShowsWhatEmbreeIsNotAsked) {
    EmbreeDisagreement wrong = through_the_middle();
    wrong.segment = {Point{1, 2, 0x1p-16}, Point{1, 2, -2}};
    wrong.parameter = 0x1p-16 / (2 + 0x1p-16);
    wrong.at_end = true;
    const Plot plot = disagreement_plot(squares(), wrong);
    ASSERT_EQ(plot.curves.size(), 3u);
    EXPECT_LT(plot.curves[0].points[0][0], 0);
    EXPECT_GT(plot.curves[1].points[0][0], 0);  // begins beyond the contact
}

}  // namespace
}  // namespace cob::report
