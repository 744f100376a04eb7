#include "arithmetic/lengths.hpp"

#include "arithmetic/wide_integer.hpp"

#include <cmath>
#include <type_traits>

namespace cob {
namespace {

// A squared length computed in binary64 carries at most 5 roundings (difference twice, product, two sums of positive
// terms): a relative error below 5.1 u, far from under- and overflow. The limits see to that.
constexpr double relative_error = 6 * 0x1p-53;
constexpr double least = 0x1p-900, greatest = 0x1p900;

double squared(const Point& a, const Point& b) {
    const Point d = b - a;
    return dot(d, d);
}

Rational exact_squared(const Point& a, const Point& b) {
    const RationalPoint d = to_rational(b) - to_rational(a);
    return dot(d, d);
}

bool is_safe(double value) {
    return value > least && value < greatest;
}

/// Sign of first - second, both squared lengths in binary64; false: undecided.
bool filtered(double first, double second, Sign& sign) {
    if (!is_safe(first) || !is_safe(second)) return false;
    const double difference = first - second, bound = 2 * relative_error * (first + second);
    sign = difference > 0 ? Sign::positive : Sign::negative;
    return std::abs(difference) > bound;
}

template <int Limbs>
WideInteger<Limbs> integer_squared(const Point& a, const Point& b, int unit) {
    WideInteger<Limbs> sum;
    for (int axis = 0; axis < 3; ++axis) {
        const WideInteger<Limbs> d = WideInteger<Limbs>(b[axis], unit) - WideInteger<Limbs>(a[axis], unit);
        sum = sum + d * d;
    }
    return sum;
}

/// Bits that hold any difference of two sums of three squared differences, and its sign.
int bits_of_squares(const BitSpan& span) {
    return 2 * (span.bits() + 1) + 2 + 1;
}

void add_bits(BitSpan& span, const Point& point) {
    for (int axis = 0; axis < 3; ++axis) span.add(point[axis]);
}

}  // namespace

Sign compare_lengths(const Point& a, const Point& b, const Point& c, const Point& d) {
    Sign sign;
    if (filtered(squared(a, b), squared(c, d), sign)) return sign;

    // Equal sides are the ordinary case: rectangles have them.
    BitSpan span;
    for (const Point* point : {&a, &b, &c, &d}) add_bits(span, *point);
    if (span.only_zeros()) return Sign::zero;
    const auto in_integers = [&](auto limbs) {
        constexpr int count = decltype(limbs)::value;
        return sign_of(integer_squared<count>(a, b, span.low) - integer_squared<count>(c, d, span.low));
    };
    if (bits_of_squares(span) <= 128) return in_integers(std::integral_constant<int, 2>{});
    if (bits_of_squares(span) <= 512) return in_integers(std::integral_constant<int, 8>{});
    return sign_of(Rational(exact_squared(a, b) - exact_squared(c, d)));
}

Sign compare_length(const Point& a, const Point& b, double length, int exponent) {
    Sign sign;
    const double scaled = std::ldexp(length, exponent);
    if (filtered(squared(a, b), scaled * scaled, sign)) return sign;

    if (std::isfinite(scaled) && std::ldexp(scaled, -exponent) == length) {
        BitSpan span;
        for (const Point* point : {&a, &b}) add_bits(span, *point);
        span.add(scaled);
        if (bits_of_squares(span) <= 512) {
            const WideInteger<8> wanted(scaled, span.low);
            return sign_of(integer_squared<8>(a, b, span.low) - wanted * wanted);
        }
    }
    Rational wanted(length);
    if (exponent >= 0)
        wanted *= Rational(Integer(1) << exponent);
    else
        wanted /= Rational(Integer(1) << -exponent);
    return sign_of(Rational(exact_squared(a, b) - wanted * wanted));
}

}  // namespace cob
