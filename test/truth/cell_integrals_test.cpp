// What is integrated over a cell in closed form, and what may be hidden of it at most.
#include "radiosity/cell_flux.hpp"
#include "radiosity/cell_view.hpp"
#include "radiosity/nearby_sides.hpp"
#include "radiosity/penumbra.hpp"
#include "radiosity/triangle_rule.hpp"
#include "truth/cell_rooms.hpp"

#include <gtest/gtest.h>

namespace cob::radiosity {
namespace {

using test::CellViews;
using test::Room;
using test::RoomBuilder;

// One or two small triangles low over the floor, or on it, and cells around them.
class LowOccluders : public CellViews {
protected:
    RoomBuilder low_room() {
        RoomBuilder result;
        result.sheet(0, 0, 1, 1, 0, true);
        if (random_() % 2)
            result.sheet(-4, -4, 5, 5, 0.8, false);
        else
            result.polygon({{0, 0, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1}});
        for (std::uint64_t count = 1 + random_() % 2; count > 0; --count) {
            const double height = random_() % 4 == 0 ? 0 : 0.1 * number();
            const auto point = [&](double z) { return Point{0.3 + 0.2 * number(), 0.3 + 0.2 * number(), z}; };
            result.polygon({point(height), point(height + 0.05 * number()), point(0.01 + height)});
        }
        return result;
    }
    Vector3<double> point_of(const Corners3D& triangle) {
        const double f = number(), g = number();
        return (1 - f) * triangle[0] + f * ((1 - g) * triangle[1] + g * triangle[2]);
    }
    Triangle2D cell_around() {
        const double size = std::ldexp(1, -static_cast<int>(random_() % 5)), s = 0.3 + 0.2 * number() - size / 2,
                     t = 0.3 + 0.2 * number() - size / 2;
        const auto at = [&](double from) { return std::clamp(from + size * number(), 0.0, 1.0); };
        const auto corner = [&] { return Point2D{at(s), at(t)}; };
        return {corner(), corner(), corner()};
    }
};

// By the rule of 9 x 9 points on 4^depth parts.
template <class F>
double integral(const Triangle2D& t, const F& f, int depth) {
    double sum = 0;
    if (depth > 0) {
        for (const Triangle2D& part : cut(t, std::nullopt)) sum += integral(part, f, depth - 1);
        return sum;
    }
    const auto& rule = triangle_rule<9>();
    for (std::size_t k = 0; k < 81; ++k) sum += rule.weight[k] * f(rule.point(t, k));
    return area(t) * sum;
}

// The parts of a contour are the contour: closed forms over whole sides that come near, and the others' values.
TEST_F(LowOccluders, NearbySidesInClosedForm) {
    int light_sides = 0, occluder_sides = 0, rough = 0;
    for (int k = 0; k < 3000; ++k) {
        const Room room(low_room());
        const Triangle2D cell = cell_around();
        CellView view(room.shapes, cell);
        Contour contour;
        try {
            contour = view.visible_contour(room.lights, view.between(room.lights, room.occluders));
        } catch (const UndecidedSign&) {
            continue;
        }
        const auto corner = [&](VertexId v) { return room.shapes.bounded_corner(v).value; };
        const SplitContour split = split_off_nearby_sides(contour, cell, corner, 1e-12);
        light_sides += split.over_light_sides.value != 0;
        occluder_sides += split.over_occluder_sides.value != 0;
        rough += !split.rough.empty();
        const auto nearby = [&](const Point2D& p) {
            return form_factor_at(room.shapes, p, contour) - form_factor_at(room.shapes, p, split.others);
        };
        Integral sum = split.over_light_sides;
        sum += split.over_occluder_sides;
        EXPECT_NEAR(sum.value, integral(cell, nearby, 2), 2e-4 * area(cell) + sum.error) << k;
        const auto of_light = [&](const Point2D& p) { return form_factor_at(room.shapes, p, split.light_sides); };
        EXPECT_NEAR(split.over_light_sides.value, integral(cell, of_light, 2), 2e-4 * area(cell)) << k;
    }
    EXPECT_GT(light_sides, 30);
    EXPECT_GT(occluder_sides, 30);
    EXPECT_GT(rough, 30);
}

// Whatever stands between, what is seen over a cell is in its range; and outside the penumbrae all is seen.
TEST_F(LowOccluders, WhatIsSeenIsInTheRange) {
    int narrow = 0;
    for (int k = 0; k < 150; ++k) {
        const Room room(low_room());
        const Triangle2D cell = cell_around();
        const PossibleShadows shadows(room.shapes, room.lights, room.loops);
        const FluxRange range = shadows.range(cell, room.occluders, 1e-9), free = shadows.range(cell, {}, 1e-9);
        const double seen = integral(
            cell, [&](const Point2D& p) { return room.visible_from(p); }, 0);
        const double rule = 0.02 * free.high;  // of 81 points across shadows
        EXPECT_GE(seen, range.low - rule) << k;
        EXPECT_LE(seen, range.high + rule) << k;
        EXPECT_EQ(range.high, free.high) << k;
        EXPECT_NEAR(free.low, free.high, 1e-8) << k;
        narrow += range.low > 0.1 * range.high;
    }
    EXPECT_GT(narrow, 8);
}

// From outside the penumbra no segment to the light meets the occluder.
TEST_F(LowOccluders, PenumbraeHoldAllShadows) {
    int small = 0;
    for (int k = 0; k < 2000; ++k) {
        const auto point = [&](double low, double high) {
            return Vector3<double>{number(), number(), low + (high - low) * number()};
        };
        const Corners3D light{point(0.5, 1), point(0.5, 1), point(0.5, 1)},
            occluder{point(0, 0.5), point(0, 0.5), point(0, 0.5)};
        const auto shadow = penumbra(light, occluder);
        ASSERT_TRUE(shadow);
        // A shadow of a point of one, cast from a point of the other, lies inside.
        const Vector3<double> from = point_of(light), p = point_of(occluder);
        const Vector3<double> x = from + from.z / (from.z - p.z) * (p - from);
        for (std::size_t i = 0; i < shadow->size(); ++i)
            EXPECT_GE(turn({(*shadow)[i], (*shadow)[(i + 1) % shadow->size()], Point2D{x.x, x.y}}), -1e-12) << k;
        small += area(*shadow) < 1;
    }
    EXPECT_GT(small, 100);
    EXPECT_FALSE(penumbra({{0, 0, 1}, {1, 0, 1}, {0, 1, 0.5}}, {{0, 0, 0.2}, {1, 0, 0.5}, {0, 1, 0.2}}));
    EXPECT_FALSE(penumbra({{0, 0, 0}, {1, 0, 1}, {0, 1, 1}}, {{0, 0, 0}, {1, 0, 0.5}, {0, 1, 0.2}})) << "both at 0";
}

// The same where an occluder's corners come as near to the light's plane as rounding leaves them: the hull reaches far
// away and must be right here, or there is none.
TEST_F(LowOccluders, PenumbraeUnderALightNearlyTouchedHoldAllShadows) {
    int held = 0, without = 0;
    for (int k = 0; k < 100000; ++k) {
        const double high = 1 - std::ldexp(1, -(k % 54));
        const auto point = [&](double z) { return Vector3<double>{number(), number(), z}; };
        const Corners3D light{point(1), point(1), point(1)},
            occluder{point(high), point(k % 2 ? high : 0.5 * number()), point(0.5 * number())};
        const auto shadow = penumbra(light, occluder);
        without += !shadow;
        if (!shadow) continue;
        const Vector3<double> from = point_of(light), p = point_of(occluder);
        const Vector3<double> x = from + 1 / (1 - p.z) * (p - from);
        if (!(std::hypot(x.x, x.y) < 4)) continue;
        const double e = 1e-3;
        const Triangle2D around{Point2D{x.x - e, x.y - e}, {x.x + e, x.y - e}, {x.x, x.y + e}};
        EXPECT_GT(area(common_part(around, *shadow)), 0) << k;
        ++held;
    }
    EXPECT_GT(held, 10000);
    EXPECT_GT(without, 10000);
}

// The parts of a triangle in and beside a convex polygon are all of it.
TEST_F(LowOccluders, CommonParts) {
    int cut_off = 0;
    for (int k = 0; k < 500; ++k) {
        const Triangle2D one = cell_around(), other = cell_around();
        if (area(one) < 1e-9 || area(other) < 1e-9) continue;
        const Polygon2D part = common_part(one, left_around(other)), same = common_part(other, left_around(one));
        EXPECT_NEAR(area(part), area(same), 1e-12) << k;
        double beside = 0;
        for (const Triangle2D& quarter : cut(one, std::nullopt))
            beside += area(common_part(quarter, left_around(other)));
        EXPECT_NEAR(area(part), beside, 1e-12) << k;
        cut_off += area(part) > 0 && area(part) < 0.9 * area(one);
    }
    EXPECT_GT(cut_off, 50);
}

}  // namespace
}  // namespace cob::radiosity
