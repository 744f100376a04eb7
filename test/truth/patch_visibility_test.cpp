// Visibility between convex patches: exact relations on the ladder of degeneracy, certified bounds of the fraction.
#include "cob/patch_visibility.hpp"

#include "truth/rooms.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace cob {
namespace {

using test::EveryPolygon;
using test::RoomBuilder;

// Between the scene's polygons 0 and 1.
PatchAnswer between(const RoomBuilder& room, const PatchOptions& options = {}) {
    const Scene scene = room.build();
    const EveryPolygon everything(scene);
    return PatchVisibility(scene, everything)(patch_of(scene, scene.piece(0)), patch_of(scene, scene.piece(1)),
                                              options);
}

RoomBuilder two_squares() {
    return RoomBuilder().sheet(0, 0, 1, 1, 0, true).sheet(0, 0, 1, 1, 1, false);
}

// "visible: no piece meets the interior of the convex hull": what touches it from outside does not.
TEST(PatchVisibility, VisibleIsExact) {
    EXPECT_EQ(between(two_squares()).relation, PatchRelation::visible);
    EXPECT_EQ(between(two_squares().sheet(1, 0, 2, 1, 0.5, true)).relation, PatchRelation::visible);
    EXPECT_EQ(between(two_squares().sheet(-3, -3, 3, 3, 0, true)).relation, PatchRelation::visible);
    EXPECT_EQ(between(two_squares().sheet(-3, -3, 3, 3, 1, true)).relation, PatchRelation::visible);
    EXPECT_EQ(between(two_squares().polygon({{1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {1, 0, 1}})).relation,
              PatchRelation::visible);
    EXPECT_EQ(between(two_squares().polygon({{1, 1, 0.5}, {2, 1, 0.5}, {1, 2, 0.5}})).relation, PatchRelation::visible);
    // Touching an edge of the hull from outside, and past no one facet: only a plane through its side separates it.
    EXPECT_EQ(between(two_squares().polygon({{1.5, 0.5, 0.5}, {1.5, 1.5, 0.5}, {0.5, 1.5, 0.5}})).relation,
              PatchRelation::visible);
    const double inside = std::nextafter(1.0, 0.0);
    const PatchAnswer sliver = between(two_squares().sheet(inside, 0, 2, 1, 0.5, true), {0.3, 0, 500});
    EXPECT_NE(sliver.relation, PatchRelation::visible);
    EXPECT_NE(sliver.relation, PatchRelation::hidden);
    EXPECT_TRUE(sliver.clear.has_value());
}

// SPEC 2 allows straight angles: where the corners of a patch begin does not matter.
TEST(PatchVisibility, VisibleWhereverTheLoopBegins) {
    const auto tilted = [](std::vector<Point> corners) {
        for (Point& corner : corners) corner.z += corner.x + corner.y;
        return corners;
    };
    const std::vector<Point> floor{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};
    for (std::size_t first = 0; first < floor.size(); ++first) {
        std::vector<Point> loop = floor;
        std::rotate(loop.begin(), loop.begin() + static_cast<std::ptrdiff_t>(first), loop.end());
        const RoomBuilder room = RoomBuilder()
                                     .polygon(tilted(loop))
                                     .polygon(tilted({{0, 0, 2}, {0, 2, 2}, {2, 2, 2}, {2, 0, 2}}))
                                     .polygon(tilted({{1, 1, -0.01}, {1, 0.5, -1}, {1, 1.5, -1}}));  // behind the floor
        EXPECT_EQ(between(room).relation, PatchRelation::visible) << first;
    }
}

// "hidden: some one polygon lies across every segment"
TEST(PatchVisibility, HiddenIsExact) {
    EXPECT_EQ(between(two_squares().sheet(0, 0, 1, 1, 0.5, true)).relation, PatchRelation::hidden);
    EXPECT_EQ(between(two_squares().sheet(0, 0, 1, 1, 0.5, false)).blocker, 2);
    EXPECT_EQ(between(two_squares().sheet(0, 0, std::nextafter(1.0, 0.0), 1, 0.5, true), {0.3, 0, 500}).relation ==
                  PatchRelation::hidden,
              false);
    // An L of two triangles and more covers by its pieces together.
    const RoomBuilder el =
        two_squares().polygon({{-1, -1, 0.5}, {3, -1, 0.5}, {3, 2, 0.5}, {2, 2, 0.5}, {2, 1.5, 0.5}, {-1, 1.5, 0.5}});
    EXPECT_EQ(between(el).relation, PatchRelation::hidden);
    // Two half sheets hide everything, too, but no one does; the fraction says so.
    const PatchAnswer halves =
        between(two_squares().sheet(0, 0, 0.5, 1, 0.5, true).sheet(0.5, 0, 1, 1, 0.5, true), {0.2, 0, 3000});
    EXPECT_NE(halves.relation, PatchRelation::hidden);
    EXPECT_EQ(halves.lower, 0);
    EXPECT_LE(halves.upper, 0.4);
    EXPECT_FALSE(halves.clear.has_value());
}

// Pairs (p, q) with (p + q) / 2 in [1/4, 3/4]: 3/4 of them along each axis, so 7/16 of the segments pass.
TEST(PatchVisibility, BoundsHoldAndTighten) {
    double width = 1;
    for (std::uint64_t budget : {50, 500, 5000}) {
        const PatchAnswer answer = between(two_squares().sheet(0.25, 0.25, 0.75, 0.75, 0.5, true), {0, 0, budget});
        EXPECT_EQ(answer.relation, PatchRelation::partial);
        EXPECT_LE(answer.lower, 7.0 / 16);
        EXPECT_GE(answer.upper, 7.0 / 16);
        EXPECT_LT(answer.upper - answer.lower, width);
        width = answer.upper - answer.lower;
    }
    EXPECT_LT(width, 0.35);
}

TEST(PatchVisibility, WitnessesAreWhatTheySay) {
    const RoomBuilder room = two_squares().sheet(0.25, 0.25, 0.75, 0.75, 0.5, true);
    const Scene scene = room.build();
    const EveryPolygon everything(scene);
    const VisibilityOracle oracle(scene, everything);
    const PatchAnswer answer = between(room);
    ASSERT_TRUE(answer.clear && answer.blocked);
    EXPECT_EQ(oracle(*answer.clear), Visibility::clear);
    EXPECT_EQ(oracle(*answer.blocked), Visibility::blocked);
}

// Random triangles between two squares: witnesses are rechecked as exact segments, and the share of 100,000 exact
// segments between random points lies within the certified bounds, give or take five standard deviations.
TEST(PatchVisibility, RandomScenesHoldBoundsAndWitnesses) {
    std::mt19937_64 random(5);
    const auto number = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
    };
    int partial = 0, narrow = 0;
    for (int k = 0; k < 20; ++k) {
        RoomBuilder room = two_squares();
        for (int count = 1 + k % 4; count > 0; --count) {
            const auto corner = [&] { return Point{number(-0.5, 1.5), number(-0.5, 1.5), number(-0.1, 1.1)}; };
            room.polygon({corner(), corner(), corner()});
        }
        const Scene scene = room.build();
        const EveryPolygon everything(scene);
        const VisibilityOracle oracle(scene, everything);
        const PatchAnswer answer = PatchVisibility(scene, everything)(patch_of(scene, scene.piece(0)),
                                                                      patch_of(scene, scene.piece(1)), {0.05, 0, 1500});
        EXPECT_TRUE(!answer.clear || oracle(*answer.clear) == Visibility::clear) << k;
        EXPECT_TRUE(!answer.blocked || oracle(*answer.blocked) == Visibility::blocked) << k;
        if (answer.relation == PatchRelation::partial) {
            EXPECT_TRUE(answer.clear && answer.blocked) << k;
            ++partial;
        }
        narrow += answer.upper - answer.lower < 0.5;
        constexpr int samples = 20000;  // of each scene
        int seen = 0;
        for (int sample = 0; sample < samples; ++sample) {
            const Point from{number(0, 1), number(0, 1), 0}, to{number(0, 1), number(0, 1), 1};
            seen += oracle(Segment{from, to}) != Visibility::blocked;
        }
        const double share = static_cast<double>(seen) / samples, deviation = 2.5 / std::sqrt(double{samples});
        EXPECT_LE(answer.lower - deviation, share) << k;
        EXPECT_GE(answer.upper + deviation, share) << k;
    }
    EXPECT_GT(partial, 10);
    EXPECT_GT(narrow, 5);
}

// "Point lights are the one-point case": the half plate's shadow has its edge where the line of sight puts it.
TEST(PatchVisibility, PointLight) {
    const Scene scene = RoomBuilder().sheet(0, 0, 1, 1, 0, true).sheet(-1, -1, 0.5, 2, 0.5, true).build();
    const EveryPolygon everything(scene);
    const PatchVisibility visibility(scene, everything);
    const ConvexPatch floor = patch_of(scene, scene.piece(0));
    const PatchAnswer half = visibility(floor, patch_of(ExactPoint(Point{0.25, 0.5, 1})), {0.05, 0, 20000});
    EXPECT_EQ(half.relation, PatchRelation::partial);
    EXPECT_LE(half.lower, 0.25);
    EXPECT_GE(half.upper, 0.25);
    EXPECT_LE(half.upper - half.lower, 0.05);
    EXPECT_EQ(visibility(floor, patch_of(ExactPoint(Point{0, 0.5, 1}))).relation, PatchRelation::hidden);
    EXPECT_EQ(visibility(floor, patch_of(ExactPoint(Point{0.5, 0.5, 0.25}))).relation, PatchRelation::visible);
    EXPECT_FALSE(visibility(floor, patch_of(ExactPoint(Point{0.5, 0.5, -1}))).facing);
}

TEST(PatchVisibility, OnlyFacingPairsCount) {
    EXPECT_FALSE(between(RoomBuilder().sheet(0, 0, 1, 1, 0, true).sheet(0, 0, 1, 1, 1, true)).facing);
    EXPECT_FALSE(between(RoomBuilder().sheet(0, 0, 1, 1, 0, true).sheet(2, 0, 3, 1, 0, true)).facing);
    // A wall half below the floor: what is below does not count, and the floor itself hides nothing of the rest.
    EXPECT_EQ(between(RoomBuilder().sheet(0, 0, 1, 1, 0, true).polygon({{0, 0, -1}, {0, 1, -1}, {0, 1, 1}, {0, 0, 1}}))
                  .relation,
              PatchRelation::visible);
}

}  // namespace
}  // namespace cob
