// Integers of fixed width against GMP: every sign, carries through every limb, both ends of every range.
#include "arithmetic/wide_integer.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <vector>

namespace cob {
namespace {

template <int Limbs>
void agrees_with_integers() {
    std::mt19937_64 random(Limbs);
    for (int round = 0; round < 500; ++round) {
        const double a = std::ldexp(static_cast<double>(random() >> 11) - 0x1p52, static_cast<int>(random() % 20));
        const double b = std::ldexp(static_cast<double>(random() >> 11) - 0x1p52, static_cast<int>(random() % 20));
        const Integer wide = (Integer(a) << 20) - Integer(b), other = Integer(b) + 7;
        if (msb(Integer(abs(wide) * abs(other))) + 2 >= 64 * Limbs) continue;
        using Wide = WideInteger<Limbs>;
        const Wide x = Wide(a, -20) - Wide(b, 0), y = Wide(b, 0) + Wide(7);
        ASSERT_EQ(x * y, Wide(Integer(wide * other), 0));
        ASSERT_EQ(-(x * y), Wide(Integer(-wide * other), 0));
        ASSERT_EQ(x < y, wide < other);
        ASSERT_EQ(x > y, wide > other);
        ASSERT_EQ(sign_of(x - y), sign_of(Integer(wide - other)));
        ASSERT_EQ(sign_of(x - x), Sign::zero);
    }
}

TEST(WideInteger, AgreesWithGmp) {
    agrees_with_integers<2>();
    agrees_with_integers<4>();
    agrees_with_integers<8>();
    agrees_with_integers<16>();
}

TEST(WideInteger, CountsBits) {
    BitSpan span;
    span.add(0);
    EXPECT_TRUE(span.only_zeros());
    span.add(-6);
    EXPECT_EQ(span.low, 1);
    EXPECT_EQ(span.high, 3);
    span.add(0x1p-1074);
    EXPECT_EQ(span.low, -1074);
    EXPECT_EQ(span.bits(), 1077);
}

/// Integers that fit `limbs` limbs: the ends of the range, those around every limb's end, and random ones.
std::vector<Integer> integers_of(int limbs, std::mt19937_64& random) {
    const Integer beyond = Integer(1) << (64 * limbs - 1);
    std::vector<Integer> found{0, 1, -1, beyond - 1, 1 - beyond, -beyond};
    for (int limb = 1; limb < limbs; ++limb)
        for (const int offset : {-1, 0, 1})
            for (const int sign : {-1, 1}) found.push_back(sign * ((Integer(1) << (64 * limb)) + offset));
    for (int round = 0; round < 40; ++round) {
        Integer value = 0;
        for (int limb = 0; limb < limbs; ++limb) value = (value << 64) + Integer(random());
        value >>= 1 + static_cast<int>(random() % static_cast<unsigned>(64 * limbs - 1));
        found.push_back(random() % 2 == 0 ? value : Integer(-value));
    }
    return found;
}

template <int n, int m>
void widens(std::map<Sign, int>& seen) {
    std::mt19937_64 random(100 * n + m);
    const std::vector<Integer> left = integers_of(n, random), right = integers_of(m, random);
    for (const Integer& a : left)
        for (const Integer& b : right) {
            const WideInteger<n + m> product = widening_product(WideInteger<n>(a, 0), WideInteger<m>(b, 0));
            const Integer truth = a * b;
            ASSERT_EQ(product, WideInteger<n + m>(truth, 0)) << a << " * " << b;
            ASSERT_EQ(product.sign(), sign_of(truth)) << a << " * " << b;
            ++seen[product.sign()];
        }
}

// Every pair of widths that the signs of visibility multiply (limbs 1, 2, 4), and some that they do not.
TEST(WideInteger, WideningProductNeverWraps) {
    std::map<Sign, int> seen;
    widens<1, 1>(seen);
    widens<2, 2>(seen);
    widens<4, 4>(seen);
    widens<1, 2>(seen);
    widens<2, 4>(seen);
    widens<4, 8>(seen);
    widens<3, 3>(seen);
    widens<6, 6>(seen);
    widens<12, 12>(seen);
    widens<3, 1>(seen);
    EXPECT_GT(seen[Sign::negative], 1000);
    EXPECT_GT(seen[Sign::zero], 1000);
    EXPECT_GT(seen[Sign::positive], 1000);
}

template <int limbs>
void sums_agree() {
    std::mt19937_64 random(limbs);
    const std::vector<Integer> values = integers_of(limbs, random);
    const Integer beyond = Integer(1) << (64 * limbs - 1);
    const auto fits = [&beyond](const Integer& value) { return value >= -beyond && value < beyond; };
    int sums = 0, differences = 0;
    for (const Integer& a : values)
        for (const Integer& b : values) {
            const WideInteger<limbs> x(a, 0), y(b, 0);
            const Integer sum = a + b, difference = a - b;
            if (fits(sum)) {
                ASSERT_EQ((x + y).sign(), sign_of(sum)) << a << " + " << b;
                ASSERT_EQ(x + y, WideInteger<limbs>(sum, 0)) << a << " + " << b;
                ++sums;
            }
            if (fits(difference)) {
                ASSERT_EQ((x - y).sign(), sign_of(difference)) << a << " - " << b;
                ASSERT_EQ(x - y, WideInteger<limbs>(difference, 0)) << a << " - " << b;
                ++differences;
            }
        }
    EXPECT_GT(sums, 1000);
    EXPECT_GT(differences, 1000);
}

TEST(WideInteger, CarriesAndBorrows) {
    sums_agree<1>();
    sums_agree<2>();
    sums_agree<3>();
    sums_agree<4>();
    sums_agree<12>();
    sums_agree<24>();
}

template <int limbs>
void places_every_double() {
    // The widest number of 53 bits, and one of a single bit, in every position that fits, the sign bit left free.
    for (const double mantissa : {0x1.fffffffffffffp52, 1.0})
        for (int shift = 0; std::ilogb(mantissa) + shift < 64 * limbs - 1; ++shift)
            for (const double value : {mantissa, -mantissa})
                // Both ends of the exponents: the least unit there is, and one that makes the value huge.
                for (const int unit : {-1074, 0, 900 - 64 * limbs}) {
                    const double scaled = std::ldexp(value, shift + unit);
                    ASSERT_EQ(std::ldexp(scaled, -(shift + unit)), value);
                    ASSERT_EQ(WideInteger<limbs>(scaled, unit), WideInteger<limbs>(Integer(value) << shift, 0))
                        << value << " * 2^" << shift << ", unit " << unit;
                }
    EXPECT_EQ(WideInteger<limbs>(-0.0, 0).sign(), Sign::zero);
    EXPECT_EQ(WideInteger<limbs>(std::numeric_limits<double>::denorm_min(), -1074), WideInteger<limbs>(1));
}

TEST(WideInteger, PlacesEveryDouble) {
    places_every_double<1>();
    places_every_double<2>();
    places_every_double<4>();
}

}  // namespace
}  // namespace cob
