// The whole matrix where nothing is known in closed form but much else holds: closed rooms, parts and sums, both sides
// (SPEC 8: "error estimates the distance to the true value").
#include "cob/form_factors.hpp"

#include "truth/rooms.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>

namespace cob {
namespace {

using test::EveryPolygon;
using test::RoomBuilder;
using Loop = std::vector<Point>;

FormFactorResult matrix_of(const RoomBuilder& room, const FormFactorOptions& options,
                           const std::vector<std::pair<PolygonId, PolygonId>>& pairs = {}) {
    const Scene scene = room.build();
    const EveryPolygon everything(scene);
    FormFactorMatrix matrix(scene, everything, options);
    const FormFactorPlan plan = matrix.plan(pairs);
    const FormFactorResult result = matrix.compute();
    // What it would take was said beforehand; of little, not so well.
    if (result.evaluations > 20000) {
        EXPECT_LT(plan.evaluations, 4 * static_cast<double>(result.evaluations));
        EXPECT_GT(plan.evaluations, static_cast<double>(result.evaluations) / 4);
    }
    return result;
}

// Value and error of one form factor; zero with no error where it has no row.
PolygonFormFactor value_of(const RoomBuilder& room, PolygonId from, PolygonId to, const FormFactorOptions& options) {
    for (const PolygonFormFactor& value : matrix_of(room, options, {{from, to}}).values)
        if (value.from == from && value.to == to) return value;
    return {from, to, 0, 0};
}

// The unit cube from inside.
RoomBuilder cube() {
    RoomBuilder room = RoomBuilder().sheet(0, 0, 1, 1, 0, true).sheet(0, 0, 1, 1, 1, false);
    const double loop[][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    for (int k = 0; k < 4; ++k) {
        const double *a = loop[k], *b = loop[(k + 1) % 4];
        room.polygon({{a[0], a[1], 0}, {a[0], a[1], 1}, {b[0], b[1], 1}, {b[0], b[1], 0}});
    }
    return room;
}

void add_two_sided(RoomBuilder& room, const Loop& loop) {
    room.polygon(loop).polygon(Loop(loop.rbegin(), loop.rend()));
}

// Whatever stands in a closed room, from both sides, every polygon's light arrives: rows sum to 1.
void expect_rows_of_one(const RoomBuilder& room, double tolerance) {
    FormFactorOptions options;
    options.tolerance = tolerance;
    std::map<PolygonId, std::pair<double, double>> rows;
    for (const PolygonFormFactor& value : matrix_of(room, options).values) {
        rows[value.from].first += value.value, rows[value.from].second += value.error;
        EXPECT_LE(value.error, tolerance) << value.from << ' ' << value.to;
    }
    ASSERT_EQ(rows.size(), static_cast<std::size_t>(room.build().polygon_count()));
    for (const auto& [polygon, row] : rows) EXPECT_LE(std::abs(row.first - 1), row.second) << polygon;
}

TEST(ObstructedRooms, RowsSumToOneAroundOneSheet) {
    RoomBuilder room = cube();
    add_two_sided(room, {{0.2, 0.3, 0.4}, {0.8, 0.2, 0.7}, {0.5, 0.9, 0.3}});
    expect_rows_of_one(room, 1e-6);
}

// The quadrilateral is bent, sees itself from one side, and is crossed by the triangle (SPEC 2: "both sides of a
// two-sided wall are cut alike").
TEST(ObstructedRooms, RowsSumToOneAroundCrossingAndBentPolygons) {
    RoomBuilder room = cube();
    add_two_sided(room, {{0.25, 0.25, 0.25}, {0.75, 0.25, 0.5}, {0.75, 0.75, 0.25}, {0.25, 0.75, 0.625}});
    add_two_sided(room, {{0.5, 0.125, 0.125}, {0.625, 0.875, 0.25}, {0.375, 0.5, 0.75}});
    expect_rows_of_one(room, 1e-5);
}

// A box that floats, beside a sheet that touches a wall.
TEST(ObstructedRooms, RowsSumToOneAroundABox) {
    RoomBuilder room = cube();
    const double base[][2] = {{0.25, 0.375}, {0.625, 0.25}, {0.75, 0.625}, {0.375, 0.75}};
    Loop top, bottom;
    for (int k = 0; k < 4; ++k) {
        const double *a = base[k], *b = base[(k + 1) % 4];
        room.polygon({{a[0], a[1], 0.25}, {b[0], b[1], 0.25}, {b[0], b[1], 0.625}, {a[0], a[1], 0.625}});
        top.push_back({a[0], a[1], 0.625}), bottom.insert(bottom.begin(), {a[0], a[1], 0.25});
    }
    room.polygon(top).polygon(bottom);
    add_two_sided(room, {{0, 0.25, 0.5}, {0.25, 0.25, 0.75}, {0, 0.5, 0.75}});
    expect_rows_of_one(room, 1e-6);
}

// An L that stands on the floor and leans on no wall.
TEST(ObstructedRooms, RowsSumToOneAroundAnL) {
    RoomBuilder room = cube();
    add_two_sided(
        room,
        {{0.25, 0.5, 0}, {0.75, 0.5, 0}, {0.75, 0.5, 0.25}, {0.5, 0.5, 0.25}, {0.5, 0.5, 0.75}, {0.25, 0.5, 0.75}});
    expect_rows_of_one(room, 1e-6);
}

// Occluders within a thousandth of a plane, crossing it: from both sides the same. Found by a sweep over random scenes;
// errors taken from differences of two rules were 1.7 and 1.2 times too small here.
TEST(ObstructedRooms, NarrowPenumbraeAreTheSameFromBothSides) {
    const std::vector<std::vector<Loop>> scenes = {{{{0.4999631575303436, 0.7927532091835433, 0.0014763722278293633},
                                                     {0.8040201535069128, 0.8888925893420508, -0.001073131230036258},
                                                     {0.7090320750893463, 0.6454341976363808, -0.00040505925538390146}},
                                                    {{0.4115958520267721, 0.2627068615505783, 1.0000952481067915},
                                                     {0.42321806417616203, 0.2822734564363099, 1.0001403884740285},
                                                     {0.3488333808329588, 0.385025249934306, 1.0001833477705666}}},
                                                   {{{0.5840880839850924, 0.5251433947633066, 1.0005970416109642},
                                                     {0.6711302889965369, 0.45852548858399894, 0.9997112022293839},
                                                     {0.4979107862396983, 0.6159882417202686, 1.0006582150478465}}}};
    for (const std::vector<Loop>& occluders : scenes) {
        RoomBuilder room = RoomBuilder().sheet(0, 0, 1, 1, 0, true).sheet(0, 0, 1, 1, 1, false);
        for (const Loop& occluder : occluders) room.polygon(occluder);
        FormFactorOptions options;
        options.both_sides = true;
        options.tolerance = 1e-8;
        const FormFactorResult result = matrix_of(room, options, {{0, 1}});
        ASSERT_EQ(result.values.size(), 2);
        EXPECT_LE(result.reciprocity_in_errors, 1);
        EXPECT_LE(result.above_goal, 0);
    }
}

// Behind eight occluders in general position, too, the goal is reached; from both sides alike.
TEST(ObstructedRooms, ManyGenericOccluders) {
    std::mt19937_64 random(3);
    const auto number = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
    };
    RoomBuilder room = RoomBuilder().sheet(0, 0, 1, 1, 0, true).sheet(0, 0, 1, 1, 1, false);
    for (int k = 0; k < 8; ++k) {
        const Point centre{number(0, 1), number(0, 1), number(0.1, 0.9)};
        const auto corner = [&] { return centre + Point{number(-0.15, 0.15), number(-0.15, 0.15), number(-0.1, 0.1)}; };
        const Point a = corner(), b = corner(), c = corner();
        room.polygon({a, b, c});
    }
    FormFactorOptions options;
    options.both_sides = true;
#ifndef COB_LONG_TESTS
    options.tolerance = 4e-6;
#endif
    const FormFactorResult result = matrix_of(room, options, {{0, 1}});
    ASSERT_EQ(result.values.size(), 2);
    EXPECT_LE(result.reciprocity_in_errors, 1);
    EXPECT_EQ(result.above_goal, 0);
    EXPECT_GT(result.values[0].value, 0.02);
    EXPECT_LT(result.values[0].value, 0.195);
}

// F_AB = F_AB' + F_AB'' for parts of B, A F_AB = A' F_A'B + A'' F_A''B for parts of A, and a cut occluder shades as the
// whole one, within the stated errors at 1e-6.
TEST(ObstructedRooms, PartsAddUp) {
    std::mt19937_64 random(7);
    const auto number = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
    };
    int partly = 0;
    for (int k = 0; k < 3; ++k) {
        const auto point = [&] { return Point{number(-0.25, 1.25), number(-0.25, 1.25), number(-0.125, 1.125)}; };
        const Loop a{point(), point(), point()}, b{point(), point(), point()};
        const Point middle = 0.5 * (b[0] + b[1]);
        const double cut = number(0.2, 0.8);
        const auto floor = [](double x0, double x1) { return RoomBuilder().sheet(x0, 0, x1, 1, 0, true); };
        const auto value = [&](double x0, double x1, double y0, double y1, bool parts) {
            RoomBuilder room = floor(x0, x1).sheet(0, y0, 1, y1, 1, false);
            if (k < 2) room.polygon(a);
            if (parts)
                room.polygon({b[0], middle, b[2]}).polygon({middle, b[1], b[2]});
            else
                room.polygon(b);
            return value_of(room, 0, 1, {});
        };
        const PolygonFormFactor whole = value(0, 1, 0, 1, false), cut_occluder = value(0, 1, 0, 1, true);
        const PolygonFormFactor to_low = value(0, 1, 0, cut, false), to_high = value(0, 1, cut, 1, false);
        const PolygonFormFactor from_low = value(0, cut, 0, 1, false), from_high = value(cut, 1, 0, 1, false);
        EXPECT_LE(std::abs(whole.value - cut_occluder.value), whole.error + cut_occluder.error) << k;
        EXPECT_LE(std::abs(whole.value - to_low.value - to_high.value), whole.error + to_low.error + to_high.error)
            << k;
        EXPECT_LE(std::abs(whole.value - cut * from_low.value - (1 - cut) * from_high.value),
                  whole.error + cut * from_low.error + (1 - cut) * from_high.error)
            << k;
        partly += whole.value > 0.01 && whole.value < 0.19;
    }
    EXPECT_EQ(partly, 3);
}

}  // namespace
}  // namespace cob
