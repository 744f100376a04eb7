// Enclosures of elementary functions, against 50 decimal digits; Taylor polynomials against what they stand for.
#include "arithmetic/interval_functions.hpp"
#include "radiosity/taylor.hpp"

#include <gtest/gtest.h>
#include <boost/multiprecision/cpp_bin_float.hpp>

#include <random>

namespace cob {
namespace {

using Digits = boost::multiprecision::cpp_bin_float_50;

void expect_encloses(const Interval& interval, const Digits& truth, double relative) {
    EXPECT_LE(Digits(interval.low()), truth);
    EXPECT_GE(Digits(interval.high()), truth);
    EXPECT_LE(interval.width(), relative * std::max(interval.magnitude(), 0x1p-500));
}

TEST(IntervalFunctions, EncloseAndAreNarrow) {
    std::mt19937_64 random(1);
    for (int k = 0; k < 3000; ++k) {
        const int most = k % 3 == 0 ? 450 : k % 3 == 1 ? 40 : 1;
        const auto number = [&] {
            const int exponent = static_cast<int>(random() % (2 * static_cast<unsigned>(most) + 1)) - most;
            return std::ldexp(1 + static_cast<double>(random() >> 12) * 0x1p-52, exponent);
        };
        const double x = number(), y = number();
        const Digits lx(x);
        const Interval logarithm = log(Interval(x));
        EXPECT_LE(Digits(logarithm.low()), log(lx));
        EXPECT_GE(Digits(logarithm.high()), log(lx));
        EXPECT_LE(logarithm.width(), 4e-15 * std::max(1.0, logarithm.magnitude()));
        expect_encloses(sqrt(Interval(x)), sqrt(lx), 1e-15);
        for (const double sx : {x, -x})
            for (const double sy : {y, -y}) {
                if (sx < 0 && std::abs(sy) < 1e-12 * std::abs(sx)) continue;
                const Interval angle = atan2(Interval(sy), Interval(sx));
                const Digits truth = atan2(Digits(sy), Digits(sx));
                EXPECT_LE(Digits(angle.low()), truth);
                EXPECT_GE(Digits(angle.high()), truth);
                EXPECT_LE(angle.width(), 2e-14);
            }
    }
    EXPECT_FALSE(log(Interval(-1, 1)).is_bounded());
    EXPECT_FALSE((Interval(1) / Interval(-1, 1)).is_bounded());
    EXPECT_EQ(atan2(Interval(-1, 1), Interval(-1, 1)).high(), pi_interval().high());
}

// f(u, v) = atan2(sqrt(1 + u v), 2 + u) / (3 - v) + log(1 + u / 2): the remainder over the square encloses it.
TEST(Taylor, RemainderHolds) {
    constexpr int order = 5;
    using Series = radiosity::Taylor<2, order>;
    const auto f = [](const auto& u, const auto& v) {
        using T = std::decay_t<decltype(u)>;
        using std::atan2;
        using std::log;
        using std::sqrt;
        return atan2(sqrt(T(1.0) + u * v), T(2.0) + u) / (T(3.0) - v) + log(T(1.0) + u * T(0.5));
    };
    const auto series = [&](const Interval& at_u, const Interval& at_v) {
        Series u(at_u), v(at_v);
        u.set(1, 0, Interval(1)), v.set(1, 1, Interval(1));
        return f(u, v);
    };
    const Series middle = series(0.0, 0.0), all = series(Interval(-0.25, 0.25), Interval(-0.25, 0.25));
    std::mt19937_64 random(2);
    for (int k = 0; k < 500; ++k) {
        const double u = static_cast<double>(random() >> 11) * 0x1p-54 - 0.25,
                     v = static_cast<double>(random() >> 11) * 0x1p-54 - 0.25;
        Interval sum = 0;
        for (int degree = 0; degree <= order; ++degree)
            for (int j = 0; j <= degree; ++j) {
                Interval term = (degree < order ? middle : all).at(degree, j);
                for (int i = 0; i < degree; ++i) term = term * Interval(i < j ? v : u);
                sum += term;
            }
        const Digits truth = f(Digits(u), Digits(v));
        EXPECT_LE(Digits(sum.low()), truth);
        EXPECT_GE(Digits(sum.high()), truth);
        EXPECT_LE(sum.width(), 0.01);
    }
}

}  // namespace
}  // namespace cob
