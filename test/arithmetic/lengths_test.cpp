// Comparisons of lengths, exact for any finite coordinates (SPEC 1), against fractions.
#include "arithmetic/lengths.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace cob {
namespace {

Rational squared(const Point& a, const Point& b) {
    const RationalPoint d = to_rational(b) - to_rational(a);
    return dot(d, d);
}

struct Range {
    unsigned bits;
    int exponent;
};
const Range ranges[] = {{3, 0}, {20, -10}, {53, -52}, {53, 900}, {3, -1074}, {53, -1074}, {4, 1019}, {53, -600}};

double random_number(std::mt19937_64& engine, const Range& range) {
    const auto integer = static_cast<double>(engine() >> (64 - range.bits));
    return std::ldexp(engine() & 1 ? integer : -integer, range.exponent);
}

Point random_point(std::mt19937_64& engine, const Range& range) {
    return {random_number(engine, range), random_number(engine, range), random_number(engine, range)};
}

TEST(CompareLengths, AgreesWithFractions) {
    std::mt19937_64 engine(41);
    int equal = 0, less = 0, more = 0;
    for (const Range& range : ranges)
        for (int round = 0; round < 400; ++round) {
            const Point a = random_point(engine, range), b = random_point(engine, range);
            Point c = random_point(engine, range), d = random_point(engine, range);
            // Every other time a side of the same length, or one that differs by an ulp.
            if (round % 2 == 0) c = {b.y, b.z, b.x}, d = {a.y, a.z, a.x};
            if (round % 4 == 0) d.x = std::nextafter(d.x, 1);
            const Sign expected = sign_of(Rational(squared(a, b) - squared(c, d)));
            ASSERT_EQ(compare_lengths(a, b, c, d), expected);
            ++(expected == Sign::zero ? equal : expected == Sign::negative ? less : more);
        }
    EXPECT_GT(equal, 500);
    EXPECT_GT(less, 500);
    EXPECT_GT(more, 500);
}

TEST(CompareLength, AgreesWithFractions) {
    std::mt19937_64 engine(42);
    int equal = 0, less = 0, more = 0;
    for (const Range& range : ranges)
        for (int round = 0; round < 400; ++round) {
            Point a = random_point(engine, range), b = random_point(engine, range);
            const int exponent = static_cast<int>(engine() % 32);
            // 3-4-12 triples have whole lengths.
            const double unit = std::ldexp(1.0, range.exponent), thirteen = 13 * unit;
            if (round % 3 == 0) a = {unit, -unit, unit}, b = {4 * unit, 3 * unit, 13 * unit};
            double length = round % 3 == 0 ? std::ldexp(thirteen, -exponent) : std::abs(random_number(engine, range));
            if (round % 6 == 0) length = std::nextafter(length, 0);
            if (!(length > 0) || !std::isfinite(b.z)) continue;
            const Rational scaled = Rational(length) * Rational(Integer(1) << exponent);
            const Sign expected = sign_of(Rational(squared(a, b) - scaled * scaled));
            ASSERT_EQ(compare_length(a, b, length, exponent), expected);
            ++(expected == Sign::zero ? equal : expected == Sign::negative ? less : more);
        }
    EXPECT_GT(equal, 200);
    EXPECT_GT(less, 200);
    EXPECT_GT(more, 200);
}

}  // namespace
}  // namespace cob
