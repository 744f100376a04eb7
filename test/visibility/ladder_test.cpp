// The ladder of degeneracy: SPEC section 6, row by row.
#include "visibility/scenes.hpp"

#include "cob/error.hpp"

#include <gtest/gtest.h>

namespace cob::test {
namespace {

constexpr Visibility clear = Visibility::clear, grazing = Visibility::grazing, blocked = Visibility::blocked;

struct Row {
    const char* name;
    std::vector<Loop> loops;
    Point from, to;
    Visibility answer;
};

const Loop square{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};
const Loop left_half{{0, 0, 0}, {1, 0, 0}, {1, 2, 0}, {0, 2, 0}};
const Loop right_half{{1, 0, 0}, {2, 0, 0}, {2, 2, 0}, {1, 2, 0}};
const Loop right_lower{{1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}};
const Loop right_upper{{1, 1, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}};

const Row rows[] = {
    // One piece.
    {"passes by", {square}, {3, 1, 1}, {3, 1, -1}, clear},
    {"ends before", {square}, {1, 1, 2}, {1, 1, 1}, clear},
    {"crosses inside", {square}, {1, 1, 1}, {1, 1, -1}, blocked},
    {"crosses from behind", {square}, {1, 1, -1}, {1, 1, 1}, blocked},
    {"crosses a free side", {square}, {2, 1, 1}, {2, 1, -1}, grazing},
    {"crosses a free corner", {square}, {2, 2, 1}, {2, 2, -1}, grazing},
    {"crosses the line of a side beyond it", {square}, {3, 2, 1}, {3, 2, -1}, clear},
    {"ends inside", {square}, {1, 1, 1}, {1, 1, 0}, clear},
    {"begins at a corner", {square}, {0, 0, 0}, {1, 1, 1}, clear},
    // Within the plane.
    {"in the plane, through", {square}, {-1, 1, 0}, {3, 1, 0}, grazing},
    {"in the plane, inside", {square}, {0.5, 1, 0}, {1.5, 1, 0}, grazing},
    {"in the plane, along a side", {square}, {0.5, 0, 0}, {1.5, 0, 0}, grazing},
    {"in the plane, a whole side", {square}, {0, 0, 0}, {2, 0, 0}, grazing},
    {"in the plane, past a corner", {square}, {-1, 1, 0}, {1, -1, 0}, grazing},
    {"in the plane, ends on a side from outside", {square}, {-1, 1, 0}, {0, 1, 0}, clear},
    {"in the plane, ends on a corner from outside", {square}, {-1, -1, 0}, {0, 0, 0}, clear},
    {"in the plane, in line with a side, ends on its corner", {square}, {-1, 0, 0}, {0, 0, 0}, clear},
    {"in the plane, in line with a side, beyond", {square}, {3, 0, 0}, {4, 0, 0}, clear},
    {"in the plane, parallel beside", {square}, {0, 3, 0}, {2, 3, 0}, clear},
    // Seams.
    {"seam of coplanar halves", {left_half, right_half}, {1, 1, 1}, {1, 1, -1}, blocked},
    {"seam of coplanar halves, slanted", {left_half, right_half}, {0, 0.5, 1}, {2, 1.5, -1}, blocked},
    {"end of that seam", {left_half, right_half}, {1, 0, 1}, {1, 0, -1}, grazing},
    {"T-junction", {left_half, right_lower, right_upper}, {1, 1, 1}, {1, 1, -1}, blocked},
    {"T-junction, one arm missing", {left_half, right_upper}, {1, 1, 1}, {1, 1, -1}, grazing},
    {"two sheets on one side of a line",
     {left_half, {{0, 0, 0}, {1, 0, 0}, {1, 2, 0}, {0, 2, 0}}},
     {1, 1, 1},
     {1, 1, -1},
     grazing},
    {"ridge seen from the side: silhouette",
     {{{0, 0, 0}, {0, 2, 0}, {-1, 2, -1}, {-1, 0, -1}}, {{0, 0, 0}, {-1, 0, 1}, {-1, 2, 1}, {0, 2, 0}}},
     {0, 1, 1},
     {0, 1, -1},
     grazing},
    {"ridge seen from above: closed",
     {{{0, 0, 0}, {0, 2, 0}, {-1, 2, -1}, {-1, 0, -1}}, {{0, 0, 0}, {1, 0, -1}, {1, 2, -1}, {0, 2, 0}}},
     {0, 1, 1},
     {0, 1, -1},
     blocked},
    {"overlapping sheets cover a side",
     {{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}}, right_half},
     {1, 1, 1},
     {1, 1, -1},
     blocked},
    // Corners.
    {"fan of four",
     {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
      {{0, 0, 0}, {0, 1, 0}, {-1, 0, 0}},
      {{0, 0, 0}, {-1, 0, 0}, {0, -1, 0}},
      {{0, 0, 0}, {0, -1, 0}, {1, 0, 0}}},
     {0, 0, 1},
     {0, 0, -1},
     blocked},
    {"fan of four, folded",
     {{{0, 0, 0}, {1, 0, 1}, {0, 1, 2}},
      {{0, 0, 0}, {0, 1, 2}, {-1, 0, -1}},
      {{0, 0, 0}, {-1, 0, -1}, {0, -1, 5}},
      {{0, 0, 0}, {0, -1, 5}, {1, 0, 1}}},
     {0, 0, 1},
     {0, 0, -1},
     blocked},
    // A side whose direction is that of a seam, farther along the segment, opens nothing (found by adding polygons).
    {"fan of four and a side behind its seam",
     {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
      {{0, 0, 0}, {0, 1, 0}, {-1, 0, 0}},
      {{0, 0, 0}, {-1, 0, 0}, {0, -1, 0}},
      {{0, 0, 0}, {0, -1, 0}, {1, 0, 0}},
      {{0, 0, 0}, {1, 0, 3}, {1, -1, 0}}},
     {0, 0, 1},
     {0, 0, -1},
     blocked},
    {"fan with a gap",
     {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 0, 0}, {0, 1, 0}, {-1, 0, 0}}, {{0, 0, 0}, {-1, 0, 0}, {0, -1, 0}}},
     {0, 0, 1},
     {0, 0, -1},
     grazing},
    {"fan in which only projections match: a pinhole",
     {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
      {{0, 0, 0}, {0, 1, 0}, {-1, 0, 0}},
      {{0, 0, 0}, {-1, 0, 0}, {0, -1, 0}},
      {{0, 0, 0}, {0, -1, 0}, {1, 0, 1}}},
     {0, 0, 1},
     {0, 0, -1},
     grazing},
    {"fan that overlaps itself",
     {{{0, 0, 0}, {2, -1, 1}, {-1, 2, 0}}, {{0, 0, 0}, {0, 1, 3}, {-2, -1, 0}}, {{0, 0, 0}, {-1, 0, 0}, {4, -1, 7}}},
     {0, 0, 1},
     {0, 0, -1},
     blocked},
    {"two corners tip to tip",
     {{{0, 0, 0}, {1, -1, 0}, {1, 1, 0}}, {{0, 0, 0}, {-1, 1, 0}, {-1, -1, 0}}},
     {0, 0, 1},
     {0, 0, -1},
     grazing},
    {"two points of contact, each half closed",
     {left_half, {{1, 0, -1}, {2, 0, -1}, {2, 2, -1}, {1, 2, -1}}},
     {1, 1, 1},
     {1, 1, -2},
     grazing},
    // Straight corners and loops that wind twice.
    {"straight corner, inside",
     {{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}}},
     {1, 1, 1},
     {1, 1, -1},
     blocked},
    {"straight corner, at it",
     {{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}}},
     {1, 0, 1},
     {1, 0, -1},
     grazing},
    {"straight corner against a side",
     {{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}}, {{2, 0, 0}, {0, 0, 0}, {1, -2, 0}}},
     {1, 0, 1},
     {1, 0, -1},
     blocked},
    {"corner beside straight ones",
     {{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {2, 2, 0}, {0, 2, 0}}},
     {2, 0, 1},
     {2, 0, -1},
     grazing},
    {"wound twice, inside",
     {{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 0}, {2, 0, 0}, {0, 2, 0}}},
     {0.5, 0.5, 1},
     {0.5, 0.5, -1},
     blocked},
    {"wound twice, on a side",
     {{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 0}, {2, 0, 0}, {0, 2, 0}}},
     {1, 1, 1},
     {1, 1, -1},
     grazing},
    {"wound twice, at a corner",
     {{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 0}, {2, 0, 0}, {0, 2, 0}}},
     {0, 0, 1},
     {0, 0, -1},
     grazing},
    // A stair seen along its riser: cautious.
    {"stair along its riser",
     {{{-1, 0, 0}, {0, 0, 0}, {0, 2, 0}, {-1, 2, 0}},
      {{0, 0, 0}, {0, 0, -1}, {0, 2, -1}, {0, 2, 0}},
      {{0, 0, -1}, {1, 0, -1}, {1, 2, -1}, {0, 2, -1}}},
     {0, 1, 1},
     {0, 1, -2},
     grazing},
    // A tunnel whose walls are seen in line.
    {"non-convex polygon, at its reflex corner",
     {{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {1, 1, 0}, {0, 2, 0}}},
     {1, 1, 1},
     {1, 1, -1},
     grazing},
    {"non-convex polygon, on whatever diagonal",
     {{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {2, 2, 0}, {0, 4, 0}}},
     {2, 1, 1},
     {2, 1, -1},
     blocked},
};

/// The same question under a map of space.
template <class Map>
void check(const Row& row, Map map, const char* how, Source source) {
    std::vector<Loop> loops = row.loops;
    for (Loop& loop : loops)
        for (Point& point : loop) point = map(point);
    const Asked asked(loops, source);
    EXPECT_EQ(asked(map(row.from), map(row.to)), row.answer) << row.name << ", " << how;
    EXPECT_EQ(asked(map(row.to), map(row.from)), row.answer) << row.name << ", reversed, " << how;
    EXPECT_EQ(asked.oracle.explain({map(row.from), map(row.to)}).visibility, row.answer) << row.name << ", " << how;
}

// "open segment against the union of all closed pieces": every row, and its images under maps that change nothing.
TEST(VisibilityLadder, EveryRowWhicheverWayItIsAsked) {
    for (const Row& row : rows)
        for (const Source source : sources()) {
            check(
                row, [](Point p) { return p; }, "as it is", source);
            check(
                row,
                [](Point p) {
                    return Point{p.y, p.z, p.x};
                },
                "axes turned", source);
            check(
                row,
                [](Point p) {
                    return Point{-p.x, p.y, p.z};
                },
                "mirrored", source);
            check(
                row,
                [](Point p) {
                    return Point{p.x + 1e9, p.y - 1e9, p.z + 3e9};
                },
                "far away", source);
            check(
                row,
                [](Point p) {
                    return Point{2 * p.x - 3 * p.y + p.z, p.x + p.y + 5 * p.z, 7 * p.x - p.z};
                },
                "sheared", source);
            for (const int k : {-1070, -1000, -300, 300, 1000, 1019})
                check(
                    row,
                    [k](Point p) {
                        return Point{std::ldexp(p.x, k), std::ldexp(p.y, k), std::ldexp(p.z, k)};
                    },
                    "scaled by a power of two", source);
        }
}

// "x and y differ, else refused"
TEST(VisibilityLadder, APointIsRefused) {
    const Asked asked({square});
    EXPECT_THROW(asked(Point{1, 1, 1}, Point{1, 1, 1}), InputError);
    EXPECT_THROW(asked(Point{0, 1, 1}, Point{-0.0, 1, 1}), InputError);
}

}  // namespace
}  // namespace cob::test
