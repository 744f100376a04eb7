// Exact irradiance at points: SPEC 8 ("form factor from the point to the light without and with obstruction") and
// SPEC 6 (what blocks), against Lambert's closed form for rectangles.
#include "cob/irradiance.hpp"

#include "cob/error.hpp"
#include "truth/rooms.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace cob {
namespace {

using test::EveryPolygon;
using test::RoomBuilder;

const double pi = std::acos(-1.0);
const RationalPoint up{0, 0, 1};

// Form factor from the origin, normal +z, to the rectangle [0,a]x[0,b] at height 1 that faces it; odd in a and b.
// (The textbook formula for a parallel rectangle with a corner over the point.)
double over_corner(double a, double b) {
    const double p = std::sqrt(1 + a * a), q = std::sqrt(1 + b * b);
    return (a / p * std::atan(b / p) + b / q * std::atan(a / q)) / (2 * pi);
}

// The rectangle [x0,x1]x[y0,y1] at height h over the point (x, y, 0).
double over(double x0, double y0, double x1, double y1, double h, double x, double y) {
    if (x1 <= x0 || y1 <= y0) return 0;
    const auto f = [&](double a, double b) { return over_corner((a - x) / h, (b - y) / h); };
    return f(x1, y1) - f(x0, y1) - f(x1, y0) + f(x0, y0);
}

LightAtPoint look(const Scene& scene, const Point& point, const RationalPoint& normal = up, PolygonId light = 0) {
    const EveryPolygon everything(scene);
    return IrradianceOracle(scene, everything)(point, normal, light);
}

TEST(Irradiance, FreeRectangleIsLambertsClosedForm) {
    const Scene scene = RoomBuilder().sheet(-1, -2, 3, 1.5, 2, false).build();
    for (const Point& p : {Point{0, 0, 0}, Point{5, 1, 0}, Point{-1, -2, 0}, Point{0.1, 0.3, 1.875}, Point{3, 9, 1}}) {
        const LightAtPoint seen = look(scene, p);
        EXPECT_NEAR(seen.unobstructed, over(-1, -2, 3, 1.5, 2 - p.z, p.x, p.y), 1e-15);
        EXPECT_EQ(seen.visible, seen.unobstructed);
    }
}

// "Only what lies in front of both": below its plane, and from behind the light, nothing is received.
TEST(Irradiance, OnlyWhatIsInFrontOfBoth) {
    const Scene scene = RoomBuilder().sheet(-1, -1, 1, 1, 2, false).build();
    EXPECT_EQ(look(scene, {0, 0, 3}, -up).unobstructed, 0);
    EXPECT_EQ(look(scene, {0, 0, 2}, -up).unobstructed, 0);
    EXPECT_EQ(look(scene, {0, 0, 0}, -up).unobstructed, 0);
    // Half of it in front of a wall: by symmetry of the cosine about the wall, a closed form of its own.
    const Scene floor = RoomBuilder().polygon({{0, -1, -1}, {0, 1, -1}, {0, 1, 1}, {0, -1, 1}}).build();
    const double far = 4;
    const double whole = look(floor, {far, 0, 0}, {-1, 0, 0}).unobstructed;
    EXPECT_NEAR(whole, 4 * over_corner(1 / far, 1 / far), 1e-15);
    const double half = look(floor, {far, 0, 0}, up).unobstructed;
    // Perpendicular rectangle [-1,1]x[0,1] at distance d: (1/2pi)(2 atan(1/d) - 2 atan(1/sqrt(d2+1)) d/sqrt(d2+1)).
    const double q = std::sqrt(far * far + 1);
    EXPECT_NEAR(half, (std::atan(1 / far) - far / q * std::atan(1 / q)) / pi, 1e-15);
}

TEST(Irradiance, ShadowOfASheetIsItsProjection) {
    std::mt19937_64 random(1);
    int part = 0, none = 0, all = 0;
    for (int k = 0; k < 300; ++k) {
        const auto number = [&](int range) {
            return static_cast<double>(static_cast<int>(random() % (2 * range + 1)) - range) / 4;
        };
        double x0 = number(12), x1 = number(12), y0 = number(12), y1 = number(12);
        if (x0 == x1 || y0 == y1) continue;
        if (x0 > x1) std::swap(x0, x1);
        if (y0 > y1) std::swap(y0, y1);
        const Point p{number(16), number(16), 0};
        const Scene scene = RoomBuilder().sheet(-2, -2, 2, 2, 2, false).sheet(x0, y0, x1, y1, 1, k % 2 == 0).build();
        const auto shadow = [](double c, double at) { return std::clamp(at + 2 * (c - at), -2.0, 2.0); };
        const double whole = over(-2, -2, 2, 2, 2, p.x, p.y);
        const double hidden = over(shadow(x0, p.x), shadow(y0, p.y), shadow(x1, p.x), shadow(y1, p.y), 2, p.x, p.y);
        const LightAtPoint seen = look(scene, p);
        EXPECT_NEAR(seen.unobstructed, whole, 2e-15);
        EXPECT_NEAR(seen.visible, whole - hidden, 4e-15) << k;
        if (hidden == 0) {
            EXPECT_EQ(seen.visible, seen.unobstructed);
            ++all;
        } else if (seen.parts == 0) {
            EXPECT_EQ(seen.visible, 0);
            ++none;
        } else {
            ++part;
        }
    }
    EXPECT_GT(part, 50);
    EXPECT_GT(none, 5);
    EXPECT_GT(all, 20);
}

// SPEC 6: the open segment; what touches the point or the light, or lies beyond, does not block.
TEST(Irradiance, ContactAtTheEndsDoesNotBlock) {
    const auto room = [] { return RoomBuilder().sheet(-1, -1, 1, 1, 1, false); };
    const double free = 4 * over_corner(1, 1);
    EXPECT_NEAR(look(room().sheet(-9, -9, 9, 9, 0, true).build(), {0, 0, 0}).visible, free, 1e-15);
    EXPECT_NEAR(look(room().sheet(-9, -9, 9, 9, 1, true).build(), {0, 0, 0}).visible, free, 1e-15);
    EXPECT_NEAR(look(room().sheet(-9, -9, 9, 9, 1.5, true).build(), {0, 0, 0}).visible, free, 1e-15);
    EXPECT_NEAR(look(room().sheet(-9, -9, 9, 9, -0.5, true).build(), {0, 0, 0}).visible, free, 1e-15);
    EXPECT_EQ(look(room().sheet(-9, -9, 9, 9, 0.5, true).build(), {0, 0, 0}).visible, 0);
    EXPECT_EQ(look(room().sheet(-9, -9, 9, 9, 0x1p-1074, true).build(), {0, 0, 0}).visible, 0);
    EXPECT_EQ(look(room().sheet(-9, -9, 9, 9, std::nextafter(1.0, 0.0), true).build(), {0, 0, 0}).visible, 0);
}

// An occluder that passes through the light's plane, and one that passes through the plane of the point parallel to
// it: only what lies between counts, exactly the same as when it is cut off there.
TEST(Irradiance, OccludersAreCutAtTheLight) {
    const auto wall = [](double bottom, double top) {
        return RoomBuilder()
            .sheet(-1, -1, 1, 1, 1, false)
            .polygon({{0.25, -5, bottom}, {0.25, 5, bottom}, {0.25, 5, top}, {0.25, -5, top}});
    };
    const double cut = look(wall(0.5, 1).build(), {0, 0, 0}).visible;
    EXPECT_NEAR(cut, over(-1, -1, 0.25, 1, 1, 0, 0) + over(0.5, -1, 1, 1, 1, 0, 0), 1e-15);
    EXPECT_NEAR(look(wall(0.5, 7).build(), {0, 0, 0}).visible, cut, 1e-15);
    EXPECT_NEAR(look(wall(-3, 7).build(), {0, 0, 0}).visible, over(-1, -1, 0.25, 1, 1, 0, 0), 1e-15);
    EXPECT_NEAR(look(wall(-3, 0.5).build(), {0, 0, 0}).visible, over(-1, -1, 0.5, 1, 1, 0, 0), 1e-15);
    // Tilted through the light's plane along x = 0.5, the hidden part begins there.
    const Scene tilted =
        RoomBuilder().sheet(-1, -1, 1, 1, 1, false).polygon({{0, -9, 2}, {0, 9, 2}, {1, 9, 0}, {1, -9, 0}}).build();
    EXPECT_NEAR(look(tilted, {0, 0, 0}).visible, over(-1, -1, 0.5, 1, 1, 0, 0), 1e-15);
}

// No answer depends on how an occluder is cut, in which order they come, or on their number.
TEST(Irradiance, SplittingAnOccluderChangesNothing) {
    const double whole =
        look(RoomBuilder().sheet(-2, -2, 2, 2, 2, false).sheet(-0.5, -1, 0.75, 0.5, 1, true).build(), {0.25, 0, 0})
            .visible;
    for (int n : {2, 3, 7}) {
        RoomBuilder room;
        room.sheet(-2, -2, 2, 2, 2, false);
        for (int i = 0; i < n; ++i)
            for (int j = 0; j < n; ++j) {
                const auto x = [&](int k) { return k == n ? 0.75 : -0.5 + k * 1.25 / n; };
                const auto y = [&](int k) { return k == n ? 0.5 : -1 + k * 1.5 / n; };
                room.polygon({{x(i), y(j), 1}, {x(i + 1), y(j), 1}, {x(i + 1), y(j + 1), 1}});
                room.polygon({{x(i), y(j), 1}, {x(i), y(j + 1), 1}, {x(i + 1), y(j + 1), 1}});
            }
        const Scene scene = room.build();
        EXPECT_NEAR(look(scene, {0.25, 0, 0}).visible, whole, 1e-14) << n;
    }
}

// Two half sheets that meet in a seam leave no light through.
TEST(Irradiance, NoLightLeaksThroughASeam) {
    const Scene scene = RoomBuilder()
                            .sheet(-1, -1, 1, 1, 2, false)
                            .sheet(-9, -9, 1.0 / 3, 9, 1, true)
                            .sheet(1.0 / 3, -9, 9, 9, 1, false)
                            .build();
    for (double x : {0.0, 1.0 / 3, 0.125, -2.0}) EXPECT_EQ(look(scene, {x, 0, 0}).parts, 0);
}

// "the smaller in area lies on top (of equals the higher number), and what it hides neither receives nor sends"
TEST(Irradiance, SheetsInTheLightsPlaneHideIt) {
    const double whole = over(-1, -1, 1, 1, 1, 0, 0), small = over(0, 0, 0.5, 0.5, 1, 0, 0);
    const Scene facing = RoomBuilder().sheet(-1, -1, 1, 1, 1, false).sheet(0, 0, 0.5, 0.5, 1, false).build();
    EXPECT_NEAR(look(facing, {0, 0, 0}).unobstructed, whole, 1e-15);
    EXPECT_NEAR(look(facing, {0, 0, 0}).visible, whole - small, 1e-15);
    EXPECT_NEAR(look(facing, {0, 0, 0}, up, 1).visible, small, 1e-15);
    const Scene away = RoomBuilder().sheet(-1, -1, 1, 1, 1, false).sheet(0, 0, 0.5, 0.5, 1, true).build();
    EXPECT_NEAR(look(away, {0, 0, 0}).visible, whole, 1e-15);
    const Scene twins = RoomBuilder().sheet(-1, -1, 1, 1, 1, false).sheet(-1, -1, 1, 1, 1, false).build();
    EXPECT_EQ(look(twins, {0, 0, 0}).visible, 0);
    EXPECT_NEAR(look(twins, {0, 0, 0}, up, 1).visible, whole, 1e-15);
}

// Powers of two change no form factor; "for any finite input: 1e-300, 1e300 and subnormals included".
// "The closed set of the points that its loop winds around" (SPEC 2): twice around sends no more than once.
TEST(Irradiance, LightsThatWindTwiceSendOnce) {
    const std::vector<Point> once{{0, 0, 1}, {0, 1, 1}, {1, 1, 1}, {1, 0, 1}};
    std::vector<Point> twice = once;
    twice.insert(twice.end(), once.begin(), once.end());
    const Point point{0.5, 0.5, 0};
    EXPECT_NEAR(look(RoomBuilder().polygon(twice).build(), point).visible,
                look(RoomBuilder().polygon(once).build(), point).visible, 1e-14);
}

// "The smaller in area lies on top" (choice 9), the area that of the set, whichever way parts of the loop turn.
TEST(Irradiance, AreasOfSheetsAreThoseOfTheirSets) {
    // Squares of area 4 and 1 that the loop runs around opposite ways, and a square of 4 in the first.
    const RoomBuilder room =
        RoomBuilder()
            .polygon({{0, 0, 1}, {0, 2, 1}, {2, 2, 1}, {3, 2, 1}, {3, 3, 1}, {2, 3, 1}, {2, 2, 1}, {2, 0, 1}})
            .polygon({{0, 0, 1}, {0, 2, 1}, {2, 2, 1}, {2, 0, 1}});
    const Scene scene = room.build();
    EXPECT_NEAR(look(scene, {1, 1, 0}, up, 1).visible, over(0, 0, 2, 2, 1, 1, 1), 1e-14);
    EXPECT_LT(look(scene, {1, 1, 0}, up, 0).visible, 0.02);
}

TEST(Irradiance, ScaleDoesNotMatter) {
    const auto scene = [](double s) {
        return RoomBuilder()
            .sheet(-1 * s, -1 * s, 1 * s, 1 * s, 1 * s, false)
            .sheet(0.25 * s, 0, 5 * s, 9 * s, 0.5 * s, true)
            .build();
    };
    const LightAtPoint one = look(scene(1), {0.125, 0.25, 0});
    for (int k : {-1000, -500, 3, 500, 1000}) {
        const double s = std::ldexp(1.0, k);
        const LightAtPoint seen = look(scene(s), {0.125 * s, 0.25 * s, 0});
        EXPECT_DOUBLE_EQ(seen.unobstructed, one.unobstructed);
        EXPECT_DOUBLE_EQ(seen.visible, one.visible);
    }
}

// "error below 1e-13 of the unobstructed value" where binary64 alone cancels: far, tiny and tangential lights.
TEST(Irradiance, SmallAndTangentialLightsKeepTheirDigits) {
    for (double distance : {1e3, 1e6, 1e12, 1e100}) {
        const Scene scene =
            RoomBuilder().sheet(-1, -1, 1, 1, distance, false).sheet(0, -1, 1, 1, distance / 2, true).build();
        const double d2 = distance * distance;
        // The rectangle's series in 1/d, first terms: A/(pi d2) (1 - 4/(3 d2)); the shadow's edge is at x = 0.
        const LightAtPoint seen = look(scene, {0, 0, 0});
        EXPECT_NEAR(seen.unobstructed * pi * d2 / 4, 1 - 4 / (3 * d2), 4 / (d2 * d2) + 2e-15);
        EXPECT_NEAR(seen.visible / seen.unobstructed, 0.5, 1e-15);
    }
    // Height eps over a wall's foot, seen from d: to first order eps2 / (pi d2) w; here the ratio of two heights.
    const auto low = [](double eps) {
        const Scene scene = RoomBuilder().polygon({{1, 1, 0}, {1, -1, 0}, {1, -1, eps}, {1, 1, eps}}).build();
        return look(scene, {0, 0, 0}).unobstructed;
    };
    for (double eps : {0x1p-20, 0x1p-40, 0x1p-200}) EXPECT_NEAR(low(eps) / low(eps / 2), 4, 1e-9);
}

TEST(Irradiance, ZeroNormalIsRefused) {
    const Scene scene = RoomBuilder().sheet(-1, -1, 1, 1, 1, false).build();
    EXPECT_THROW(look(scene, {0, 0, 0}, {0, 0, 0}), InputError);
}

}  // namespace
}  // namespace cob
