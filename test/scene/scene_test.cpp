// Polygons, planarity, convexity and pieces: SPEC section 2, sentence by sentence.
#include "cob/scene.hpp"

#include "cob/error.hpp"
#include "scene/scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace cob {
namespace {

using test::build_one;
using test::refusal;
using Triangle = std::array<Point, 3>;

std::vector<Triangle> triangles_of(const Scene& scene) {
    std::vector<Triangle> triangles;
    for (const Piece& piece : scene.pieces()) {
        const auto corners = scene.corners(piece);
        EXPECT_EQ(corners.size(), 3);
        triangles.push_back({scene.position(corners[0]), scene.position(corners[1]), scene.position(corners[2])});
    }
    return triangles;
}

// "Consecutive vertices at one position count once (last and first, too; the first of a run is kept)."
TEST(Loop, RepeatedPositionsCountOnce) {
    const Scene scene = build_one({{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 1, 0}, {0, 1, 0}, {-0.0, 0, 0}});
    ASSERT_TRUE(scene.invalid().empty());
    const auto loop = scene.loop(0);
    EXPECT_EQ(std::vector<VertexId>(loop.begin(), loop.end()), (std::vector<VertexId>{0, 2, 3, 5}));
}

// "along the coordinate axis where that normal is largest in absolute value (the first such axis), the visible side
// up"
TEST(View, LooksAlongTheLargestComponentOfTheNormal) {
    struct Row {
        std::vector<Point> loop;
        int axis, first, second;
    };
    const Row rows[] = {
        {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, 2, 0, 1},
        {{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}}, 2, 1, 0},
        {{{0, 0, 0}, {0, 1, 0}, {0, 0, 1}}, 0, 1, 2},
        {{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}}, 1, 2, 0},
        {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, 0, 1, 2},  // normal (1, 1, 1): the first such axis
        {{{0, 0, 0}, {1, 0, 0}, {0, 1, 1}}, 1, 0, 2},  // normal (0, -1, 1)
        {{{0, 0, 0}, {1e-300, 0, 0}, {0, 1e-300, 1e-301}}, 2, 0, 1},
        {{{0, 0, 0}, {1e300, 0, 0}, {0, 1e300, 1e300}}, 1, 0, 2},
        {{{0, 0, 0}, {5e-324, 0, 0}, {0, 5e-324, 0}}, 2, 0, 1},
    };
    for (const Row& row : rows) {
        const Scene scene = build_one(row.loop);
        ASSERT_EQ(refusal(scene), "");
        const View2 view = scene.polygon(0).view;
        EXPECT_EQ(view.axis, row.axis);
        EXPECT_EQ(view.first, row.first);
        EXPECT_EQ(view.second, row.second);
    }
}

// "Its normal is Newell's, exact, unnormalised, not zero." "no two sides cross; else the polygon is refused."
TEST(Refusal, NamesItsReason) {
    EXPECT_EQ(refusal(build_one({{0, 0, 0}, {1, 0, 0}})), "fewer than 3 distinct vertices");
    EXPECT_EQ(refusal(build_one({{0, 0, 0}, {1, 0, 0}, {0, 0, 0}, {1, 0, 0}})), "fewer than 3 distinct vertices");
    EXPECT_EQ(refusal(build_one({{0, 0, 0}, {1, 1, 1}, {3, 3, 3}})), "zero area");
    EXPECT_EQ(refusal(build_one({{0, 0, 0}, {4, 0, 0}, {4, 3, 0}, {1, -1, 0}})), "sides 1 and 3 cross");
    EXPECT_EQ(refusal(build_one({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}})), "");
    EXPECT_THROW(Scene::build(test::one_polygon({{0, 0, 0}, {1, 1, 1}, {3, 3, 3}})), InputError);
}

TEST(Refusal, OfNumbersIsNeverSkipped) {
    Scene::Input input = test::one_polygon({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    input.faces[0].corners[1] = 3;
    EXPECT_THROW(Scene::build(input, {true}), InputError);
    input.faces[0].corners[1] = 1;
    input.positions[2].z = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(Scene::build(input, {true}), InputError);
}

// "Convex (it never turns right nor back; straight angles are allowed), it is one piece"
TEST(Pieces, AConvexPolygonIsOne) {
    const Scene scene = build_one({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}});
    EXPECT_TRUE(scene.polygon(0).planar && scene.polygon(0).convex);
    ASSERT_EQ(scene.pieces().size(), 1u);
    EXPECT_EQ(scene.pieces()[0].corner_count, 5u);
}

// "The closed set of the points that its loop winds around": twice around is no more of it than once.
TEST(Pieces, ALoopThatWindsTwiceIsCoveredOnce) {
    const auto area = [](const Scene& scene) {
        double sum = 0;
        for (const Triangle& t : triangles_of(scene))
            sum += ((t[1].x - t[0].x) * (t[2].y - t[0].y) - (t[1].y - t[0].y) * (t[2].x - t[0].x)) / 2;
        return sum;
    };
    EXPECT_EQ(area(build_one({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}})),
              1);
    EXPECT_EQ(area(build_one({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 0}, {1, 0, 0}, {1, 1, 0}})), 1);
    // A spiral: the inner triangle is wound around twice, without a side run twice.
    EXPECT_EQ(area(build_one({{0, 4, 0}, {0, 0, 0}, {2, 1, 0}, {1, 2, 0}, {0, 0, 0}, {4, 0, 0}, {4, 4, 0}})), 16);
}

// One ulp out of the plane: "A polygon that is not planar is the union of triangles, its pieces".
TEST(Pieces, PlanarityIsExact) {
    const double z = std::nextafter(1.0, 2.0);
    const Scene scene = build_one({{0, 0, 1}, {1, 0, 1}, {1, 1, z}, {0, 1, 1}});
    EXPECT_FALSE(scene.polygon(0).planar);
    // The ear at the smallest position is (0, 0, 1).
    const std::vector<Triangle> expected{{Point{0, 1, 1}, {0, 0, 1}, {1, 0, 1}},
                                         {Point{1, 1, z}, {0, 1, 1}, {1, 0, 1}}};
    EXPECT_EQ(triangles_of(scene), expected);
}

// "so that both sides of a two-sided wall are cut alike"
TEST(Pieces, BothSidesOfAWallAreCutAlike) {
    std::vector<Point> loop{{0, 0, 0}, {3, 0, 0.25}, {4, 4, 0}, {1, 3, 0.5}};
    const auto front = triangles_of(build_one(loop));
    std::reverse(loop.begin(), loop.end());
    const auto back = triangles_of(build_one(loop));
    const auto as_sets = [](const std::vector<Triangle>& triangles) {
        std::set<std::set<Point>> sets;
        for (const Triangle& t : triangles) sets.insert({t[0], t[1], t[2]});
        return sets;
    };
    EXPECT_EQ(as_sets(front), as_sets(back));
}

}  // namespace
}  // namespace cob
