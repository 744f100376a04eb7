// A receiver, a light and what stands between, at random, and triangles of the receiver.
#pragma once

#include "radiosity/cells.hpp"
#include "radiosity/pair_shapes.hpp"
#include "radiosity/visible_light.hpp"
#include "truth/rooms.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace cob::radiosity::test {

using cob::test::RoomBuilder;

// The unit square on the floor receives, polygon 1 sends, the others stand between.
struct Room {
    explicit Room(const RoomBuilder& builder)
        : scene(builder.build()), pieces(scene), receiver(polygon(0)), shapes(receiver, 1) {
        lights.push_back(shapes.add(clip(polygon(1), front_of(receiver))));
        for (PieceId piece = 2; piece < static_cast<PieceId>(scene.pieces().size()); ++piece) {
            ConvexPolygon part = clip(polygon(piece), front_of(receiver));
            if (!part.empty()) part = clip(part, front_of(polygon(1)));
            if (part.empty()) continue;
            loops.push_back(shapes.add(part));
            numbers.push_back(piece);
        }
        for (const CornerLoop& loop : loops) occluders.push_back(&loop);
    }
    ConvexPolygon polygon(PieceId piece) const { return polygon_of(scene, scene.piece(piece)); }

    // By exact cones over the point.
    double visible_from(const Point2D& point) const {
        return view_light(Viewpoint(pieces, ExactPoint(Point{point.s, point.t, 0})), ReceiverNormal({0, 0, 1}),
                          {{1}, {}}, numbers, Precision::certain)
            .visible;
    }

    Scene scene;
    PreparedPieces pieces;
    ConvexPolygon receiver;
    PairShapes shapes;
    std::vector<CornerLoop> lights, loops;
    std::vector<PieceId> numbers;
    std::vector<const CornerLoop*> occluders;
};

class CellViews : public ::testing::Test {
protected:
    double number() { return static_cast<double>(random_() >> 11) * 0x1p-53; }
    double on_grid() { return static_cast<double>(random_() % 5) / 4; }

    // Random triangles, or on a grid, where they touch, cross and share lines; or a box on the floor.
    RoomBuilder room(int kind) {
        RoomBuilder result;
        result.sheet(0, 0, 1, 1, 0, true);
        if (random_() % 2)
            result.sheet(0, 0, 1, 1, 1, false);
        else
            result.polygon({{0, 0, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1}});  // with a common edge
        if (kind == 2) {
            const double x = 0.25 * number(), y = 0.25 * number(), u = 0.25 + 0.25 * number(), v = 0.25 * number(),
                         z = random_() % 2 ? 0.25 : 0;
            const std::vector<Point> base{{x + v, y, z}, {x + v + u, y + v, z}, {x + u, y + u + v, z}, {x, y + u, z}};
            const auto at = [&](std::size_t k, double height) { return base[k % 4] + Point{0, 0, height}; };
            for (std::size_t k = 0; k < 4; ++k) result.polygon({at(k, 0), at(k + 1, 0), at(k + 1, 0.5), at(k, 0.5)});
            result.polygon({at(0, 0.5), at(1, 0.5), at(2, 0.5), at(3, 0.5)});
            return result;
        }
        for (std::uint64_t count = 2 + random_() % 4; count > 0; --count) {
            const auto point = [&] {
                if (kind == 1) return Point{on_grid(), on_grid(), on_grid()};
                return Point{number(), number(), number()};
            };
            const Point a = point(), b = point(), c = point();
            if (!(cross(b - a, c - a) == Point{})) result.polygon({a, b, c});
        }
        return result;
    }
    Triangle2D cell() {
        const Point2D corner{number(), number()};
        const double size = std::ldexp(1, -static_cast<int>(random_() % 7));
        const auto inside = [&](double at) { return std::min(1.0, at + size * number()); };
        return {corner, {inside(corner.s), inside(corner.t)}, {inside(corner.s), inside(corner.t)}};
    }
    Point2D point_in(const Triangle2D& t) { return mix(t[0], mix(t[1], t[2], number()), 0.02 + 0.96 * number()); }

    std::mt19937_64 random_{11};
};

}  // namespace cob::radiosity::test
