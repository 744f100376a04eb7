// Text and numbers: SPEC section 1, "the binary64 number nearest to its text".
#include "arithmetic/text.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <random>

namespace cob {
namespace {

double from_bits(std::uint64_t bits) {
    double value;
    std::memcpy(&value, &bits, sizeof value);
    return value;
}

// Decimals near the middle of two binary64 numbers, subnormals and the ends of the range: glibc's strtod is the
// witness, and it rounds correctly.
TEST(ParseBinary64, HardDecimalsAgreeWithStrtod) {
    std::mt19937_64 engine(1);
    int compared = 0;
    for (int k = 0; k < 20000; ++k) {
        const double value = from_bits(engine());
        if (!std::isfinite(value)) continue;
        const double next = std::nextafter(value, INFINITY);
        if (!std::isfinite(next)) continue;
        // The exact middle, then a digit above and below it.
        const Rational middle = (Rational(value) + Rational(next)) / 2;
        Integer p = numerator(middle), q = denominator(middle);
        const unsigned twos = q == 1 ? 0 : static_cast<unsigned>(msb(q));
        if (twos > 1000) continue;
        p *= boost::multiprecision::pow(Integer(5), twos);  // middle = p / 10^twos
        for (const int nudge : {-1, 0, 1}) {
            const std::string text = Integer(p * 10 + nudge).str() + "e-" + std::to_string(twos + 1);
            ASSERT_EQ(parse_binary64(text), std::strtod(text.c_str(), nullptr)) << text;
            ++compared;
        }
    }
    EXPECT_GT(compared, 20000);
}

TEST(ParseBinary64, NamedCases) {
    struct Row {
        const char* text;
        std::optional<double> value;
    };
    const Row rows[] = {
        {"0.1", 0.1},
        {"-1e-400", -0.0},
        {"4.9406564584124654e-324", 4.9406564584124654e-324},
        {"2.4703282292062327e-324", 0.0},
        {"2.4703282292062328e-324", 4.9406564584124654e-324},
        {"1.7976931348623157e308", 1.7976931348623157e308},
        {"1.7976931348623159e308", std::nullopt},
        {"1e309", std::nullopt},
        {"0x1.8p1", 3.0},
        {"-0X1P-1074", -4.9406564584124654e-324},
        {"0x10", 16.0},
        {"+.5", 0.5},
        {"5.", 5.0},
        {"", std::nullopt},
        {"-", std::nullopt},
        {"+-1", std::nullopt},
        {"1e", std::nullopt},
        {"nan", std::nullopt},
        {"-inf", std::nullopt},
        {"1,5", std::nullopt},
        {" 1", std::nullopt},
        {"1 ", std::nullopt},
    };
    for (const Row& row : rows) EXPECT_EQ(parse_binary64(row.text), row.value) << row.text;
}

TEST(ParseExact, FractionsAreExact) {
    EXPECT_EQ(parse_exact("1/3"), Rational(1, 3));
    EXPECT_EQ(parse_exact("-6/4"), Rational(-3, 2));
    EXPECT_EQ(parse_exact("0.1"), Rational(0.1));
    EXPECT_EQ(parse_exact("010/3"), Rational(10, 3));  // decimal, whatever stands in front
    EXPECT_EQ(parse_exact("-09/012"), Rational(-3, 4));
    EXPECT_EQ(parse_exact("+00/08"), Rational(0));
    for (const char* text : {"1/0", "1/-2", "1.5/2", "/2", "1/", "1/2/3"}) EXPECT_EQ(parse_exact(text), std::nullopt);
}

TEST(ToText, ReadsBackAndIsShort) {
    EXPECT_EQ(to_text(0.1), "0.1");
    EXPECT_EQ(to_text(-0.0), "0");
    EXPECT_EQ(to_text(Rational(1, 3)), "1/3");
    EXPECT_EQ(to_text(Rational(3, 2)), "1.5");
    EXPECT_EQ(to_text(Rational(9007199254740993)), "9007199254740993/1");  // 2^53 + 1: no binary64 number
    std::mt19937_64 engine(2);
    for (int k = 0; k < 10000; ++k) {
        const double value = from_bits(engine());
        if (std::isfinite(value)) {
            ASSERT_EQ(parse_binary64(to_text(value)), value);
        }
    }
}

TEST(ToNearest, RoundsToNearestEven) {
    std::mt19937_64 engine(3);
    for (int k = 0; k < 10000; ++k) {
        const double value = from_bits(engine()), next = std::nextafter(value, INFINITY);
        if (!std::isfinite(value) || !std::isfinite(next)) continue;
        const Rational middle = (Rational(value) + Rational(next)) / 2, tiny = (Rational(next) - Rational(value)) / 8;
        const bool even = (std::llabs(static_cast<long long>([&] {
                               std::uint64_t bits;
                               std::memcpy(&bits, &value, sizeof bits);
                               return bits & 1;
                           }())) == 0);
        ASSERT_EQ(to_nearest(middle), even ? value : next);
        ASSERT_EQ(to_nearest(middle - tiny), value);
        ASSERT_EQ(to_nearest(middle + tiny), next);
        ASSERT_EQ(to_nearest(Rational(value)), value);
    }
}

TEST(Binary64, IsWhatAFractionEqualsOrNothing) {
    const auto over = [](long long p, int power) { return Rational(Integer(p), Integer(1) << power); };
    const long long most = (1LL << 53) - 1;
    EXPECT_EQ(to_binary64(Rational(0)), 0.0);
    EXPECT_EQ(to_binary64(Rational(-1, 8)), -0.125);
    for (const int power : {0, 1, 52, 63, 64, 1074}) {
        EXPECT_EQ(to_binary64(over(1, power)), std::ldexp(1.0, -power)) << power;
        EXPECT_EQ(to_binary64(over(-3, power)), std::ldexp(-3.0, -power)) << power;
    }
    for (const int power : {0, 1, 52, 63, 64, 1021}) {
        EXPECT_EQ(to_binary64(over(-most, power)), -std::ldexp(static_cast<double>(most), -power)) << power;
        EXPECT_EQ(to_binary64(over(most + 1, power)), std::ldexp(1.0, 53 - power)) << power;
        EXPECT_EQ(to_binary64(over(2 * most + 3, power)), std::nullopt) << power;  // 54 bits, the last of them set
    }
    EXPECT_EQ(to_binary64(over(1, 1075)), std::nullopt);
    EXPECT_EQ(to_binary64(Rational(1, 3)), std::nullopt);
    EXPECT_EQ(to_binary64(Rational(1, 10)), std::nullopt);
    EXPECT_EQ(to_binary64(Rational(Integer(1) << 1023)), 0x1p1023);
    EXPECT_EQ(to_binary64(Rational(Integer(1) << 1024)), std::nullopt);
}

TEST(ExactPoint, IsExactWhateverItsProvenance) {
    const RationalPoint thirds{Rational(1, 3), Rational(2), Rational(-5, 7)};
    EXPECT_TRUE(ExactPoint(thirds).has_fraction());
    EXPECT_EQ(ExactPoint(thirds).rational(), thirds);
    const RationalPoint dyadic{Rational(1) + Rational(1) / Rational(Integer(1) << 70), Rational(0), Rational(1, 2)};
    const ExactPoint pair(dyadic);
    EXPECT_FALSE(pair.has_fraction());
    EXPECT_FALSE(pair.is_binary64());
    EXPECT_EQ(pair.rational(), dyadic);
    EXPECT_TRUE(ExactPoint(Point{1, 2, 3}).is_binary64());
}

// Reports name squares and areas that binary64 does not hold.
TEST(RoundedText, BeyondBinary64) {
    const Rational large = Rational(Integer(1) << 2000), small = 1 / large;
    EXPECT_EQ(rounded_text(Rational(1, 3), 6), "0.333333");
    EXPECT_EQ(rounded_text(0, 6), "0");
    EXPECT_EQ(rounded_text(large, 6), "1.14813e+602");
    EXPECT_EQ(rounded_text(-small, 6), "-8.70981e-603");
    EXPECT_EQ(rounded_root_text(2, 6), "1.41421");
    EXPECT_EQ(rounded_root_text(large, 6), "1.07151e+301");
    EXPECT_EQ(rounded_root_text(small, 6), "9.33264e-302");
    EXPECT_EQ(scaled_text(0.75, 1), "1.5");
    EXPECT_EQ(scaled_text(0, 2000), "0");
    EXPECT_EQ(scaled_text(1, 2000), "1.1481306952742545e+602");
    EXPECT_EQ(scaled_text(-1, -2000), "-8.7098098162172167e-603");
}

}  // namespace
}  // namespace cob
