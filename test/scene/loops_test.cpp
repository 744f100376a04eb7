// Random loops on small lattices, where sides touch, coincide and turn back all the time, against the naive twin.
#include "cob/scene.hpp"
#include "scene/naive_loop.hpp"
#include "scene/scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>

namespace cob {
namespace {

using test::build_one;
using test::refusal;

#ifdef COB_LONG_TESTS
constexpr int rounds = 4000000;
#else
constexpr int rounds = 60000;
#endif

naive::Number integer(double value) {
    return static_cast<naive::Number>(value);
}

/// Without consecutive repeats (SPEC 2), as small integers.
naive::Loop naive_loop(const std::vector<Point>& points) {
    naive::Loop loop;
    for (const Point& p : points) {
        naive::Corner corner;
        corner.space = {integer(p.x), integer(p.y), integer(p.z)};
        if (loop.empty() || loop.back().space != corner.space) loop.push_back(corner);
    }
    while (loop.size() > 1 && loop.back().space == loop.front().space) loop.pop_back();
    return loop;
}

std::vector<std::vector<Point>> pieces_of(const Scene& scene) {
    std::vector<std::vector<Point>> pieces;
    for (const Piece& piece : scene.pieces()) {
        pieces.emplace_back();
        for (const VertexId corner : scene.corners(piece)) pieces.back().push_back(scene.position(corner));
    }
    return pieces;
}

Point to_point(const naive::Corner& corner) {
    const auto& p = corner.space;
    return {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
}

/// A closed walk over a lattice of width^2, heights below `heights`; every third one keeps to short steps, which
/// makes simple loops likelier, and every fourth one runs a part of its way back.
std::vector<Point> random_loop(std::mt19937_64& engine, int count, int width, int heights) {
    const auto below = [&](int n) { return static_cast<int>(engine() % static_cast<unsigned>(n)); };
    const bool short_steps = below(3) == 0;
    std::vector<Point> loop;
    Point at{double(below(width)), double(below(width)), double(below(heights))};
    for (int k = 0; k < count; ++k) {
        loop.push_back(at);
        const auto step = [&](double x) {
            return short_steps ? std::clamp(x + below(3) - 1, 0.0, width - 1.0) : double(below(width));
        };
        at = {step(at.x), step(at.y), double(below(heights))};
    }
    if (below(4) == 0) {
        const auto from = loop.size() - 2;
        for (std::size_t k = 0; k < 1 + engine() % 3 && k < from; ++k) loop.push_back(loop[from - k]);
    }
    // Any of the three axes may be the one that is seen along.
    const int turn = below(3);
    for (Point& p : loop) p = turn == 0 ? p : turn == 1 ? Point{p.y, p.z, p.x} : Point{p.z, p.x, p.y};
    return loop;
}

/// "A planar polygon is the closed set of the points that its loop winds around": points between the lattice lines
/// are in one piece where the loop winds around them, however often and either way.
void expect_same_set(const naive::Loop& loop, const Scene& scene, int width, int& wound_backwards) {
    constexpr naive::Number scale = 7 * 11;
    const View2 view = scene.polygon(0).view;
    for (naive::Number x = 3; x < scale * width; x += scale / 3)
        for (naive::Number y = 5; y < scale * width; y += scale / 3) {
            int pieces = 0;
            bool on_side = false;
            for (const Piece& piece : scene.pieces()) {
                naive::Loop corners;
                for (const VertexId id : scene.corners(piece)) {
                    naive::Corner corner;
                    const Point& p = scene.position(id);
                    corner.seen = {scale * integer(p[view.first]), scale * integer(p[view.second])};
                    corners.push_back(corner);
                }
                naive::Corner point;
                point.seen = {x, y};
                bool inside = true;
                for (std::size_t k = 0; k < corners.size(); ++k) {
                    const auto side = naive::cross(corners[k], corners[(k + 1) % corners.size()], point);
                    inside = inside && side > 0;
                    on_side = on_side || side == 0;
                }
                pieces += inside ? 1 : 0;
            }
            if (on_side) continue;
            const int turns = naive::winding(loop, scale, {x, y});
            ASSERT_EQ(pieces, turns != 0 ? 1 : 0);
            if (turns < 0) ++wound_backwards;
        }
}

/// Twice the area of triangles, as seen.
naive::Number doubled_area(const std::vector<naive::Triangle>& triangles) {
    naive::Number sum = 0;
    for (const naive::Triangle& t : triangles) sum += naive::cross(t[0], t[1], t[2]);
    return sum;
}

/// The same of all pieces of a scene of one polygon.
naive::Number doubled_area(const Scene& scene) {
    const View2 view = scene.polygon(0).view;
    std::vector<naive::Triangle> triangles;
    for (const Piece& piece : scene.pieces()) {
        triangles.emplace_back();
        for (std::size_t k = 0; k < 3; ++k) {
            const Point& p = scene.position(scene.corners(piece)[static_cast<std::ptrdiff_t>(k)]);
            triangles.back()[k].seen = {integer(p[view.first]), integer(p[view.second])};
        }
    }
    return doubled_area(triangles);
}

TEST(RandomLoops, AgreeWithTheNaiveTwin) {
    std::mt19937_64 engine(21);
    std::map<std::string, int> seen;
    int wound_backwards = 0;
    for (int round = 0; round < rounds; ++round) {
        const int width = 2 + round % 4, heights = round % 2 == 0 ? 1 : 2 + round % 3;
        const std::vector<Point> points = random_loop(engine, 3 + static_cast<int>(engine() % 9), width, heights);
        const Scene scene = build_one(points);
        naive::Loop loop = naive_loop(points);
        const std::string reason = refusal(scene);
        SCOPED_TRACE("round " + std::to_string(round));

        if (loop.size() < 3 || !naive::see(loop)) {
            ASSERT_TRUE(reason == "fewer than 3 distinct vertices" || reason == "zero area") << reason;
            ++seen[reason];
            continue;
        }
        if (naive::sides_cross(loop)) {
            ASSERT_NE(reason.find("cross"), std::string::npos) << reason;
            ++seen["crossing"];
            continue;
        }
        const Polygon& polygon = scene.polygon(0);
        const auto expected = naive::cut(loop);
        if (!expected && !polygon.planar) {
            ASSERT_EQ(reason, "no triangle can be cut off");
            ++seen["stuck"];
            continue;
        }
        ASSERT_EQ(reason, "");
        if (polygon.convex) {
            ASSERT_EQ(scene.pieces().size(), 1u);
            expect_same_set(loop, scene, width, wound_backwards);
            ++seen["convex"];
        } else if (expected) {
            const auto actual = pieces_of(scene);
            if (polygon.planar) expect_same_set(loop, scene, width, wound_backwards);
            if (polygon.planar && doubled_area(scene) < doubled_area(*expected)) {
                ++seen["planar, wound twice"];  // ears would lie on each other
                continue;
            }
            ASSERT_EQ(actual.size(), expected->size());
            for (std::size_t k = 0; k < actual.size(); ++k)
                for (std::size_t c = 0; c < 3; ++c) ASSERT_EQ(actual[k][c], to_point((*expected)[k][c]));
            ++seen[polygon.planar ? "planar" : "not planar"];
        } else {
            expect_same_set(loop, scene, width, wound_backwards);
            ++seen["planar, no ears"];
        }
    }
    for (const char* kind :
         {"zero area", "crossing", "stuck", "convex", "planar", "not planar", "planar, no ears", "planar, wound twice"})
        EXPECT_GT(seen[kind], rounds / 2000) << kind;
    EXPECT_GT(wound_backwards, 100);
    for (const auto& [kind, count] : seen) RecordProperty(kind, count), std::printf("%s: %d\n", kind.c_str(), count);
}

}  // namespace
}  // namespace cob
