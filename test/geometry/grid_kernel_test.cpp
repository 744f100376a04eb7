// The arithmetic that geometry/grid_kernel.hpp claims to be exact, at the limits of the claim, against integers of any
// size.
#include "geometry/grid_kernel.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace cob {
namespace {

/// In [1/2, 1); 1/2 for powers of two.
double mantissa(double value) {
    int exponent;
    return std::frexp(value, &exponent);
}

TEST(GridKernel, StepIsTheFinestOfWhichTheLargestCoordinateIsLessThan24Bits) {
    for (const double largest : {1.0, 1.5, std::nextafter(2.0, 0.0), 2.0, 0x1p24, 0x1p24 - 1, 0x1p-150, 1e90}) {
        const double step = grid_step(largest);
        EXPECT_LT(largest, 0x1p24 * step) << largest;
        EXPECT_GE(largest, 0x1p23 * step) << largest;
        EXPECT_EQ(mantissa(step), 0.5);
    }
}

TEST(GridKernel, OnGridMeansEveryCoordinateIsAMultiple) {
    for (const double step : {1.0, 0x1p-40, 0x1p90}) {
        for (const double steps : {0.0, 1.0, -1.0, 0x1p24 - 1, -0x1p24 + 1, 0x1p51 - 1, -0x1p51 + 1, 0x1p50})
            for (int axis = 0; axis < 3; ++axis) {
                Point p{3 * step, -5 * step, 0};
                p[axis] = steps * step;
                EXPECT_TRUE(on_grid(p, step)) << steps;
                // As little beside it as its bits allow, at most half a step.
                for (const double way : {-1.0, 1.0}) {
                    Point beside = p;
                    beside[axis] = std::nextafter(p[axis], way * std::numeric_limits<double>::infinity());
                    EXPECT_FALSE(on_grid(beside, step)) << steps;
                    beside[axis] = p[axis] + way * step / 2;
                    EXPECT_FALSE(on_grid(beside, step)) << steps;
                }
            }
    }
}

Sign exact_sign(const Vector3<double>& d, const Vector3<double>& c) {
    const auto integer = [](double value) { return Integer(static_cast<std::int64_t>(value)); };
    return sign_of(Integer(integer(d.x) * integer(c.x) + integer(d.y) * integer(c.y) + integer(d.z) * integer(c.z)));
}

// Products of up to 2^76 that cancel to a few units, which binary64 alone gets wrong.
TEST(GridKernel, GapsAlongTheNormalAreExact) {
    std::mt19937_64 random(1);
    const auto within = [&](std::int64_t limit) {
        return static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(2 * limit + 1)) - limit;
    };
    std::array<int, 3> seen{};
    int plain_wrong = 0;
    for (int k = 0; k < 100000; ++k) {
        // d = t (c.y, -c.x) cancels in full; the third product is what is left, and d is moved by a few units.
        const std::int64_t cx = within(1 << 25), cy = within(1 << 25), t = within(1 << 26);
        Vector3<double> d{static_cast<double>(cy * t + within(1)), static_cast<double>(-cx * t + within(1)),
                          static_cast<double>(within(k % 2 == 0 ? 2 : 1 << 26))};
        Vector3<double> c{static_cast<double>(cx), static_cast<double>(cy), static_cast<double>(within(1))};
        if (std::abs(d.x) > 0x1p51 || std::abs(d.y) > 0x1p51) continue;
        const int axis = k % 3;  // each pair of products
        std::swap(d[axis], d.z);
        std::swap(c[axis], c.z);
        const Sign expected = exact_sign(d, c);
        plain_wrong += sign_of(dot(d, c)) != expected;
        ++seen[static_cast<std::size_t>(static_cast<int>(expected) + 1)];
        // At the ends of the range of steps, too, where powers of three of the step must not under- or overflow.
        for (const double step : {1.0, 0x1p-174, 0x1p276}) {
            const Vector3<double> scaled_d = step * step * d, scaled_c = step * c;
            const GridKernel kernel(step);
            ASSERT_EQ(kernel.plane(
                          dot(scaled_d, scaled_c), scaled_d, [&] { return scaled_c; }, false),
                      uncertain(expected))
                << "case " << k << " step " << step;
        }
    }
    for (const int times : seen) EXPECT_GT(times, 1000);
    EXPECT_GT(plain_wrong, 100) << "no case needed the split";
}

}  // namespace
}  // namespace cob
