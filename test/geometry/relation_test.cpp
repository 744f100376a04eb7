// Relation and covers of SPEC 5, up the ladder of degeneracy; the box of SPEC 4.
#include "scenes.hpp"

#include "cob/error.hpp"

#include <gtest/gtest.h>

#include <cfloat>
#include <cmath>

namespace cob::test {
namespace {

constexpr double ulp = 0x1p-52;

struct Case {
    const char* name;
    Loop polygon;
    Relation relation;
    bool covers;
};

std::ostream& operator<<(std::ostream& out, const Case& row) {
    return out << row.name;
}

class AgainstTheUnitCube : public testing::TestWithParam<Case> {};

TEST_P(AgainstTheUnitCube, HasTheRelation) {
    const Case& row = GetParam();
    // Whatever corner the loop begins with and whichever way it runs, the answer is the same.
    for (std::size_t first = 0; first < row.polygon.size(); ++first) {
        Loop loop = row.polygon;
        std::rotate(loop.begin(), loop.begin() + static_cast<std::ptrdiff_t>(first), loop.end());
        for (int way = 0; way < 2; ++way) {
            const BoxAnswer answer = answer_of(loop, unit_box());
            EXPECT_STREQ(to_text(answer.relation), to_text(row.relation));
            EXPECT_EQ(answer.covers, row.covers);
            std::reverse(loop.begin(), loop.end());
        }
    }
}

Loop sheet(double z, double low = -1, double high = 2) {
    return {{low, low, z}, {high, low, z}, {high, high, z}, {low, high, z}};
}

const Case ladder[] = {
    {"apart", sheet(2), Relation::disjoint, false},
    {"apart_but_not_along_a_box_axis", {{3, -.5, .5}, {-.5, 3, .5}, {3, 3, .5}}, Relation::disjoint, false},
    {"below", sheet(-1), Relation::disjoint, false},
    {"an_ulp_above_the_top", sheet(1 + ulp), Relation::disjoint, false},
    {"an_ulp_below_the_base", sheet(-0x1p-1074), Relation::disjoint, false},
    {"top_exactly_at_h", sheet(1), Relation::boundary, true},
    {"an_ulp_below_the_top", sheet(1 - ulp / 2), Relation::crossing, true},
    {"an_ulp_above_the_base", sheet(0x1p-1074), Relation::crossing, true},
    {"in_the_plane_over_the_base", sheet(0), Relation::coplanar, false},
    {"in_the_plane_touching_the_base_at_a_corner", sheet(0, 1, 2), Relation::coplanar, false},
    {"in_the_plane_beside_the_base", sheet(0, 1 + ulp, 2), Relation::disjoint, false},
    {"stands_on_the_base_from_below", {{.2, .2, 0}, {.8, .2, 0}, {.5, .2, -1}}, Relation::base, false},
    {"tip_touches_the_base_from_below", {{.5, .5, 0}, {2, .5, -1}, {2, 1, -1}}, Relation::base, false},
    {"passes_up_through_the_base", {{.5, .5, -1}, {.6, .5, 1}, {.5, .6, 1}}, Relation::crossing, false},
    {"side_touches_a_side_of_the_base", {{1, -1, 0}, {1, 2, 0}, {2, 0, 1}}, Relation::base, false},
    {"leans_over_a_side_of_the_base", {{1, 0, 0}, {1, 1, 0}, {.5, 0, .5}}, Relation::crossing, false},
    {"stands_on_a_side_of_the_base", {{1, 0, 0}, {1, 1, 0}, {1, 0, .5}}, Relation::boundary, false},
    {"stands_beside_a_corner_of_the_base", {{1, 1, 0}, {2, 2, 0}, {2, 2, 1}}, Relation::base, false},
    {"upright_edge_on_a_box_edge", {{1, 1, -1}, {2, 2, 0}, {1, 1, .5}}, Relation::boundary, false},
    {"upright_edge_ends_at_the_base_corner", {{1, 1, -1}, {2, 2, 0}, {1, 1, 0}}, Relation::base, false},
    {"in_the_plane_of_a_side", {{1, -1, -1}, {1, 2, -1}, {1, .5, 3}}, Relation::boundary, false},
    {"in_the_plane_of_a_side_below", {{1, -1, -1}, {1, 2, -1}, {1, .5, 0}}, Relation::base, false},
    {"touches_a_box_edge_with_its_inside",
     {
         {2, 0, .5},
         {0, 2, .5},
         {1, 1, 2},
     },
     Relation::boundary,
     false},
    {"touches_a_top_corner_with_its_inside", {{3, 0, 0}, {0, 3, 0}, {0, 0, 3}}, Relation::boundary, false},
    {"touches_a_base_corner_with_its_inside",
     {
         {2, 0, 0},
         {0, 2, 0},
         {1, 1, -5},
     },
     Relation::base,
     false},
    {"touches_a_base_side_with_its_inside",
     {{1, -3, -1}, {3, .5, 1}, {1, 4, -1}, {-1, .5, -1}},
     Relation::disjoint,
     false},
    {"vertex_on_a_side", {{1, .5, .5}, {2, .5, .5}, {2, .6, .5}}, Relation::boundary, false},
    {"vertex_inside", {{.5, .5, .5}, {2, .5, .5}, {2, .6, .5}}, Relation::crossing, false},
    {"all_inside", {{.4, .4, .5}, {.6, .4, .5}, {.5, .6, .6}}, Relation::crossing, false},
    {"covers_tilted", {{-1, -1, .25}, {2, -1, .25}, {2, 2, .5}, {-1, 2, .5}}, Relation::crossing, true},
    {"covers_exactly", sheet(.5, 0, 1), Relation::crossing, true},
    {"a_little_too_small_to_cover", sheet(.5, ulp, 1), Relation::crossing, false},
    {"covers_from_the_base_corner_on", {{0, 0, 0}, {1, 0, 0}, {1, 1, .5}, {0, 1, .5}}, Relation::crossing, false},
    {"steep_up_to_the_top", {{0, 0, ulp}, {1, 0, ulp}, {1, 1, 1}, {0, 1, 1}}, Relation::crossing, true},
    {"steep_over_the_top", {{0, 0, .5}, {1, 0, .5}, {1, 1, 1.5}, {0, 1, 1.5}}, Relation::crossing, false},
    {"frame_meets_all_edges_but_does_not_cover",
     {{-1, -1, .5},
      {2, -1, .5},
      {2, 2, .5},
      {-1, 2, .5},
      {-1, -1, .5},
      {.3, .3, .5},
      {.3, .7, .5},
      {.7, .7, .5},
      {.7, .3, .5},
      {.3, .3, .5}},
     Relation::crossing,
     false},
    {"concave_sheet_that_covers",
     {{-1, -1, .5}, {3, -1, .5}, {3, 3, .5}, {2, 1.5, .5}, {-1, 3, .5}},
     Relation::crossing,
     true},
    {"concave_sheet_whose_notch_touches_the_rectangle",
     {{-1, -1, .5}, {2, -1, .5}, {2, 2, .5}, {.5, 1, .5}, {-1, 2, .5}},
     Relation::crossing,
     true},
    {"concave_sheet_whose_notch_enters_the_rectangle",
     {{-1, -1, .5}, {2, -1, .5}, {2, 2, .5}, {.5, 1 - ulp, .5}, {-1, 2, .5}},
     Relation::crossing,
     false},
    {"bent_sheet_that_covers", {{-1, -1, .5}, {2, -1, .5}, {2, 2, .75}, {-1, 2, .5}}, Relation::crossing, true},
    {"sheet_with_straight_angles_first",
     {{-1, -1, .5}, {0, -1, .5}, {2, -1, .5}, {2, 2, .5}, {-1, 2, .5}},
     Relation::crossing,
     true},
    {"box_in_a_huge_triangle", {{-1e9, -1e9, .5}, {1e9, -1e9, .5}, {0, 1e9, .5}}, Relation::crossing, true},
};

INSTANTIATE_TEST_SUITE_P(Ladder, AgainstTheUnitCube, testing::ValuesIn(ladder),
                         [](const auto& row) { return std::string(row.param.name); });

/// Tolerance and rounding aside, every arithmetic gives the answer; interval either that or none.
TEST(Arithmetics, AgreeWhereNothingIsRounded) {
    int undecided = 0;
    for (const Case& row : ladder) {
        bool safe = true;  // no coordinate an ulp from another
        for (const Point& p : row.polygon)
            for (int axis = 0; axis < 3; ++axis) safe = safe && p[axis] == std::round(p[axis] * 1024) / 1024;
        if (!safe || std::string(row.name) == "box_in_a_huge_triangle") continue;
        const Scene scene = scene_of({row.polygon});
        for (const Arithmetic arithmetic : {Arithmetic::exact, Arithmetic::binary32, Arithmetic::binary64,
                                            Arithmetic::epsilon, Arithmetic::interval, Arithmetic::rational}) {
            const BoxAnswer answer = relate(scene, 0, unit_box(), arithmetic);
            if (!answer.decided) {
                EXPECT_EQ(arithmetic, Arithmetic::interval);
                ++undecided;
                continue;
            }
            EXPECT_STREQ(to_text(answer.relation), to_text(row.relation))
                << row.name << " in arithmetic " << static_cast<int>(arithmetic);
            EXPECT_EQ(answer.covers, row.covers) << row.name << " in arithmetic " << static_cast<int>(arithmetic);
        }
    }
    EXPECT_GT(undecided, 0);
}

// "Two half sheets shut an element out and neither covers": two pieces of different polygons never add up.
TEST(Covers, IsAskedOfOnePolygon) {
    const Scene scene = scene_of(
        {{{-1, -1, .5}, {.5, -1, .5}, {.5, 2, .5}, {-1, 2, .5}}, {{.5, -1, .5}, {2, -1, .5}, {2, 2, .5}, {.5, 2, .5}}});
    for (PolygonId polygon = 0; polygon < 2; ++polygon) {
        const BoxAnswer answer = relate(scene, polygon, unit_box());
        EXPECT_EQ(answer.relation, Relation::crossing);
        EXPECT_FALSE(answer.covers);
    }
}

// h is "in general irrational; comparing with it is exact all the same": h = sqrt(2) over the square of side
// sqrt(2) that stands on its corner.
// SPEC 1: coordinates of any size beside each other; none is taken for zero.
TEST(Range, TheLeastHeightBesideAHugeElement) {
    for (const double side : {0x1p840, 0x1p866, 0x1p902, 0x1p903, 0x1p940, 0x1p1000}) {
        const Box box(question_of({{0, 0, 0}, {side, 0, 0}, {side, side, 0}, {0, side, 0}}, 0, 1));
        for (const double above : {-0x1p-1074, 0x1p-1074, -0x1p-200, 0x1p-200}) {
            const Loop leaning = {{-side, 0, 0}, {-side, side, 0}, {side / 2, side / 2, above}};
            EXPECT_STREQ(to_text(answer_of(leaning, box).relation),
                         to_text(above < 0 ? Relation::disjoint : Relation::crossing))
                << "side " << side << ", height " << above;
        }
    }
}

TEST(Height, IsComparedExactlyWhereIrrational) {
    const Box box(question_of({{1, 0, 0}, {2, 1, 0}, {1, 2, 0}, {0, 1, 0}}, 0, 1));
    const double above = std::sqrt(2.0), below = std::nextafter(above, 0.0);
    ASSERT_LT(Rational(below) * Rational(below), Rational(2));
    ASSERT_GT(Rational(above) * Rational(above), Rational(2));
    EXPECT_EQ(answer_of(sheet(below, -9, 9), box).relation, Relation::crossing);
    EXPECT_TRUE(answer_of(sheet(below, -9, 9), box).covers);
    EXPECT_EQ(answer_of(sheet(above, -9, 9), box).relation, Relation::disjoint);
    // Steep: passes the top's side between the two.
    EXPECT_EQ(answer_of({{2, -5, below}, {2, 5, below}, {2, 0, 9}}, box).relation, Relation::boundary);
    EXPECT_EQ(answer_of({{2, -5, above}, {2, 5, above}, {2, 0, 9}}, box).relation, Relation::disjoint);
}

// "h = height x (the shorter of the two widened extents)", rational over an axis-aligned element.
TEST(Height, IsOfTheShorterWidenedExtent) {
    const Box box(question_of({{0, 0, 0}, {4, 0, 0}, {4, 1, 0}, {0, 1, 0}}, Rational(1, 2), Rational(1, 4)));
    EXPECT_EQ(answer_of(sheet(.5, -9, 9), box).relation, Relation::boundary);
    EXPECT_EQ(answer_of(sheet(.5 + ulp, -9, 9), box).relation, Relation::disjoint);
    // Widened by half of 4 and half of 1.
    EXPECT_EQ(answer_of(sheet(.25, -9, -2), box).relation, Relation::disjoint);
    EXPECT_EQ(answer_of({{-9, -9, .25}, {-2, -9, .25}, {-2, 9, .25}, {-9, 9, .25}}, box).relation, Relation::boundary);
    EXPECT_EQ(answer_of({{-9, 1.5, .25}, {9, 1.5, .25}, {9, 9, .25}, {-9, 9, .25}}, box).relation, Relation::boundary);
}

// A margin or height may be any fraction (SPEC 7), also one that no binary64 number is near.
TEST(Height, AndMarginMayBeBeyondBinary64) {
    const Rational huge = boost::multiprecision::pow(Integer(10), 400);
    const Loop square = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    const Loop slanted = {{1, 0, 0}, {2, 1, 0}, {1, 2, 0}, {0, 1, 0}};
    for (const Loop& corners : {square, slanted}) {
        EXPECT_EQ(answer_of(sheet(DBL_MAX, -9, 9), Box(question_of(corners, 0, huge))).relation, Relation::crossing);
        EXPECT_EQ(answer_of(sheet(.5, 1e300, 2e300), Box(question_of(corners, huge, 1))).relation, Relation::crossing);
        EXPECT_EQ(answer_of(sheet(0x1p-1074, -9, 9), Box(question_of(corners, 0, 1 / huge))).relation,
                  Relation::disjoint);
    }
}

TEST(Box, RefusesWhatSpec4Refuses) {
    const Loop bent = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0x1p-1074}, {0, 1, 0}};
    EXPECT_THROW(Box(question_of(bent)), InputError);
    const Loop dart = {{0, 0, 0}, {2, 0, 0}, {.5, .5, 0}, {0, 2, 0}};
    EXPECT_THROW(Box(question_of(dart)), InputError);
    const Loop crossed = {{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}};
    EXPECT_THROW(Box(question_of(crossed)), InputError);
    const Loop flat = {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}};
    EXPECT_THROW(Box(question_of(flat)), InputError);
    const Loop square = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    EXPECT_THROW(Box(question_of(square, Rational(-1, 8))), InputError);
    EXPECT_THROW(Box(question_of(square, Rational(1, 8), 0)), InputError);
    BoxQuestion tilted = question_of(square);
    tilted.u = Point{1, 0, 0x1p-1074};
    EXPECT_THROW(Box{tilted}, InputError);
    tilted.u = Point{0, 0, 0};
    EXPECT_THROW(Box{tilted}, InputError);
    EXPECT_NO_THROW(Box(question_of(square)));
}

}  // namespace
}  // namespace cob::test
