// Properties of pieces that hold whatever the polygon is: areas, overlaps, and what may not change an answer.
#include "arithmetic/orientation.hpp"
#include "scene/scenes.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <set>
#include <string>
#include <vector>

namespace cob {
namespace {

using test::build_one;
using test::refusal;
using Loop = std::vector<Point>;

/// The same cases on every machine and day.
bool holds(const std::string& description, const std::function<void()>& property) {
    ::setenv("RC_PARAMS", "seed=20241122 max_success=400", 0);
    return rc::check(description, property);
}

/// A number of [from, to), whatever the size of the case.
int number(int from, int to) {
    return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(from, to));
}

/// A loop that is star-shaped around the origin and thus simple: at most one corner in each of 16 directions, heights
/// of at most `relief`.
Loop star_loop(int relief) {
    const std::pair<int, int> directions[] = {{1, 0},  {2, 1},  {1, 1},  {1, 2},   {0, 1},   {-1, 2},
                                              {-1, 1}, {-2, 1}, {-1, 0}, {-2, -1}, {-1, -1}, {-1, -2},
                                              {0, -1}, {1, -2}, {1, -1}, {2, -1}};
    Loop loop;
    for (std::size_t k = 0; k < std::size(directions); ++k) {
        const int distance = number(k % 4 == 0 ? 1 : -4, 6);  // the four axes are always there
        if (distance <= 0) continue;
        const auto [x, y] = directions[k];
        loop.push_back({double(distance * x), double(distance * y), double(number(-relief, relief + 1))});
    }
    return loop;
}

Scene accepted(const Loop& loop) {
    Scene scene = build_one(loop);
    RC_ASSERT(refusal(scene).empty());
    return scene;
}

std::vector<Loop> pieces_of(const Scene& scene) {
    std::vector<Loop> pieces;
    for (const Piece& piece : scene.pieces()) {
        pieces.emplace_back();
        for (const VertexId corner : scene.corners(piece)) pieces.back().push_back(scene.position(corner));
    }
    return pieces;
}

std::set<std::set<Point>> as_sets(const std::vector<Loop>& pieces) {
    std::set<std::set<Point>> sets;
    for (const Loop& piece : pieces) sets.insert(std::set<Point>(piece.begin(), piece.end()));
    return sets;
}

/// Twice the signed area in the x-y plane; exact, the numbers being small integers.
double doubled_area(const Loop& loop) {
    double sum = 0;
    for (std::size_t k = 0; k < loop.size(); ++k) {
        const Point &a = loop[k], &b = loop[(k + 1) % loop.size()];
        sum += a.x * b.y - a.y * b.x;
    }
    return sum;
}

bool interiors_meet(const Loop& a, const Loop& b) {
    const auto separated = [](const Loop& p, const Loop& q) {
        for (std::size_t k = 0; k < p.size(); ++k) {
            const Point &from = p[k], &to = p[(k + 1) % p.size()];
            if (std::all_of(q.begin(), q.end(), [&](const Point& c) {
                    return orientation(Point2{from.x, from.y}, Point2{to.x, to.y}, Point2{c.x, c.y}) != Sign::positive;
                }))
                return true;
        }
        return false;
    };
    return !separated(a, b) && !separated(b, a);
}

TEST(PieceProperties, AreasSumUpAndPiecesDoNotOverlap) {
    EXPECT_TRUE(holds("pieces of a simple polygon tile it as seen", [] {
        const Loop loop = star_loop(number(0, 2));
        const Scene scene = accepted(loop);
        RC_PRE(scene.polygon(0).view.axis == 2);
        RC_CLASSIFY(scene.polygon(0).planar, "planar");
        RC_CLASSIFY(scene.polygon(0).convex, "convex");
        const auto pieces = pieces_of(scene);
        double sum = 0;
        for (std::size_t a = 0; a < pieces.size(); ++a) {
            RC_ASSERT(doubled_area(pieces[a]) > 0);
            sum += doubled_area(pieces[a]);
            for (std::size_t b = 0; b < a; ++b) RC_ASSERT(!interiors_meet(pieces[a], pieces[b]));
        }
        RC_ASSERT(sum == doubled_area(loop));
    }));
}

// "so that both sides of a two-sided wall are cut alike"; nor does it matter where the loop begins.
TEST(PieceProperties, NeitherDirectionNorBeginningMatters) {
    EXPECT_TRUE(holds("pieces are the same from both sides and from any first corner", [] {
        Loop loop = star_loop(1);
        const auto pieces = as_sets(pieces_of(accepted(loop)));
        std::rotate(loop.begin(), loop.begin() + number(0, static_cast<int>(loop.size())), loop.end());
        RC_ASSERT(as_sets(pieces_of(accepted(loop))) == pieces);
        std::reverse(loop.begin(), loop.end());
        RC_ASSERT(as_sets(pieces_of(accepted(loop))) == pieces);
    }));
}

// SPEC 1: "for any finite input: 1e-300, 1e300 and subnormals included".
TEST(PieceProperties, PowersOfTwoDoNotMatter) {
    EXPECT_TRUE(holds("scaling by powers of two changes nothing but the scale", [] {
        const Loop loop = star_loop(2);
        const double scale = std::ldexp(1.0, number(-1074, 1015));
        const Scene scene = build_one(loop);
        RC_PRE(refusal(scene) == "");  // steep ones are seen along another axis and may cross themselves there
        Loop scaled;
        for (const Point& p : loop) scaled.push_back(scale * p);
        const Scene other = accepted(scaled);
        const Polygon &a = scene.polygon(0), &b = other.polygon(0);
        RC_ASSERT(a.planar == b.planar && a.convex == b.convex);
        RC_ASSERT(a.view.axis == b.view.axis && a.view.first == b.view.first);
        auto pieces = pieces_of(scene);
        for (Loop& piece : pieces)
            for (Point& p : piece) p = scale * p;
        RC_ASSERT(pieces == pieces_of(other));
    }));
}

TEST(PieceProperties, AxesAreAlike) {
    EXPECT_TRUE(holds("permuting the axes keeps planarity, convexity and validity", [] {
        const Loop loop = star_loop(number(0, 4));
        const Polygon polygon = accepted(loop).polygon(0);
        Loop turned;
        for (const Point& p : loop) turned.push_back({p.y, p.z, p.x});
        const Scene other = build_one(turned);
        RC_PRE(other.polygon(0).view.axis == (polygon.view.axis + 2) % 3);  // not where two axes tie
        RC_ASSERT(refusal(other) == "");
        RC_ASSERT(other.polygon(0).planar == polygon.planar && other.polygon(0).convex == polygon.convex);
        RC_ASSERT(other.polygon(0).view.first == (polygon.view.first + 2) % 3);
    }));
}

// Large coordinates far from the origin and slivers: a shear and a shift that binary64 carries exactly.
TEST(PieceProperties, OffsetsDoNotMatter) {
    EXPECT_TRUE(holds("an exact shift changes nothing but the place", [] {
        const Loop loop = star_loop(1);
        const Point shift{double(number(-5, 6)) * 0x1p48, 0x1p49, -0x1p46};
        Loop shifted;
        for (const Point& p : loop) shifted.push_back(p + shift);
        auto pieces = pieces_of(accepted(loop));
        for (Loop& piece : pieces)
            for (Point& p : piece) p = p + shift;
        RC_ASSERT(pieces == pieces_of(accepted(shifted)));
    }));
}

}  // namespace
}  // namespace cob
