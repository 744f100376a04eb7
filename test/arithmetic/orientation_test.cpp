// The orientation predicates against fractions: every stage must occur, every sign must occur in every stage.
#include "arithmetic/orientation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>
#include <set>

namespace cob {
namespace {

Sign rational_2d(const RationalPoint& a, const RationalPoint& b, const RationalPoint& c, int i, int j) {
    return sign_of(Rational((b[i] - a[i]) * (c[j] - a[j]) - (b[j] - a[j]) * (c[i] - a[i])));
}

Sign rational_3d(const RationalPoint& a, const RationalPoint& b, const RationalPoint& c, const RationalPoint& d) {
    return sign_of(dot(cross(b - a, c - a), d - a));
}

/// A coordinate of one of several kinds: small integers (ties), one ulp from them, full 53 bits, huge and tiny.
double coordinate(std::mt19937_64& random, int kind) {
    const double small = static_cast<double>(random() % 9) - 4;
    switch (kind) {
        case 0:
            return small;
        case 1:
            return random() % 3 == 0 ? std::nextafter(small, 10.0) : small;
        case 2:
            return std::ldexp(static_cast<double>(random() >> 11), -53) - 0.5;
        case 3:
            return small * 0x1p-1070;
        case 4:
            return std::ldexp(small, static_cast<int>(random() % 400) - 200);
        default:
            return std::ldexp(small, random() % 2 ? 1000 : -1060);
    }
}

TEST(Orientation, AgreesWithFractionsInEveryStage) {
    std::map<Stage, std::set<Sign>> seen;
    for (std::uint64_t index = 0; index < 30000; ++index) {
        std::mt19937_64 random(index);
        const int kind = static_cast<int>(index % 6);
        Point p[4];
        for (Point& point : p) point = {coordinate(random, kind), coordinate(random, kind), coordinate(random, kind)};
        if (random() % 4 == 0) {  // coplanar by construction, exactly where the sum is exact
            p[3] = p[1] + p[2] - p[0];
        }
        Stage stage;
        const Sign sign = orientation(p[0], p[1], p[2], p[3], &stage);
        ASSERT_EQ(sign, rational_3d(to_rational(p[0]), to_rational(p[1]), to_rational(p[2]), to_rational(p[3])))
            << index;
        seen[stage].insert(sign);
        ASSERT_EQ(orientation(Point2{p[0].y, p[0].z}, Point2{p[1].y, p[1].z}, Point2{p[2].y, p[2].z}),
                  rational_2d(to_rational(p[0]), to_rational(p[1]), to_rational(p[2]), 1, 2))
            << index;
    }
    for (const Stage stage : {Stage::filter, Stage::integer, Stage::rational})
        EXPECT_EQ(seen[stage].size(), 3u) << static_cast<int>(stage);
}

TEST(Orientation, TakesExactPointsOfAnyProvenance) {
    std::map<Stage, std::set<Sign>> seen;
    for (std::uint64_t index = 0; index < 6000; ++index) {
        std::mt19937_64 random(index);
        RationalPoint q[4];
        for (RationalPoint& point : q)
            for (int axis = 0; axis < 3; ++axis) {
                const int kind = static_cast<int>(index % 3);
                point[axis] = Rational(coordinate(random, kind)) + Rational(coordinate(random, 0)) * Rational(0x1p-70);
                if (index % 5 == 0) point[axis] += Rational(static_cast<int>(random() % 3), 3);
            }
        if (random() % 3 == 0) q[3] = q[1] + q[2] - q[0];
        const ExactPoint p[4] = {ExactPoint(q[0]), ExactPoint(q[1]), ExactPoint(q[2]), ExactPoint(q[3])};
        Stage stage;
        const Sign sign = orientation(p[0], p[1], p[2], p[3], &stage);
        ASSERT_EQ(sign, rational_3d(q[0], q[1], q[2], q[3])) << index;
        ASSERT_EQ(sign, orientation(q[0], q[1], q[2], q[3])) << index;
        ASSERT_EQ(orientation_seen(p[0], p[1], p[2], 2, 0), rational_2d(q[0], q[1], q[2], 2, 0)) << index;
        seen[stage].insert(sign);
    }
    EXPECT_GE(seen[Stage::filter].size(), 2u);
    EXPECT_EQ(seen[Stage::integer].size(), 3u);
    EXPECT_EQ(seen[Stage::rational].size(), 3u);
}

TEST(Orientation, OfDirectionsIsTheSignOfTheDeterminant) {
    std::map<Sign, int> seen;
    int level = 0;
    for (std::uint64_t index = 0; index < 6000; ++index) {
        std::mt19937_64 random(index);
        RationalPoint q[4];  // three points and a direction
        const int flat = static_cast<int>(random() % 4);
        for (RationalPoint& point : q)
            for (int axis = 0; axis < 3; ++axis) {
                point[axis] = Rational(static_cast<int>(random() % 5) - 2);
                if (index % 3 == 1) point[axis] += Rational(static_cast<int>(random() % 3)) * Rational(0x1p-70);
                if (index % 3 == 2) point[axis] += Rational(static_cast<int>(random() % 3), 3);
                if (axis == flat) point[axis] = &point == q + 3 ? Rational(0) : q[0][axis];
            }
        const auto e = q[1] - q[0], f = q[2] - q[0], d = q[3];
        const Rational determinant =
            e.x * (f.y * d.z - f.z * d.y) - e.y * (f.x * d.z - f.z * d.x) + e.z * (f.x * d.y - f.y * d.x);
        const Sign expected = determinant > 0 ? Sign::positive : determinant < 0 ? Sign::negative : Sign::zero;
        ASSERT_EQ(orientation_of_direction(ExactPoint(q[0]), ExactPoint(q[1]), ExactPoint(q[2]), ExactPoint(q[3])),
                  expected)
            << index;
        ++seen[expected];
        level += flat < 3;
    }
    for (const Sign sign : {Sign::negative, Sign::positive}) EXPECT_GT(seen[sign], 300);
    EXPECT_GT(seen[Sign::zero], level);  // also where no axis says so
    EXPECT_GT(level, 3000);
}

// What binary64 holds of a fraction is rounded relative to the fraction, not to how near another one is.
TEST(Orientation, FractionsNearerThanAnUlpAreExact) {
    for (int k = 1; k < 200; ++k) {
        const Rational third(1, 3), step = Rational(k, 21) * Rational(0x1p-108);
        const RationalPoint a{0, 0, third}, b{1, 0, third}, c{0, 1, third + step}, d{1, 2, third + 2 * step};
        EXPECT_EQ(orientation(ExactPoint(a), ExactPoint(b), ExactPoint(c), ExactPoint(d)), Sign::zero) << k;
        EXPECT_EQ(orientation(ExactPoint(a), ExactPoint(b), ExactPoint(c), ExactPoint(d + (d - c))),
                  rational_3d(a, b, c, d + (d - c)))
            << k;
    }
}

}  // namespace
}  // namespace cob
