#include "arithmetic/lengths.hpp"

#include <cmath>

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

}  // namespace

Sign compare_lengths(const Point& a, const Point& b, const Point& c, const Point& d) {
    const double first = squared(a, b), second = squared(c, d);
    if (is_safe(first) && is_safe(second)) {
        const double difference = first - second, bound = 2 * relative_error * (first + second);
        if (difference > bound) return Sign::positive;
        if (difference < -bound) return Sign::negative;
    }
    return sign_of(Rational(exact_squared(a, b) - exact_squared(c, d)));
}

Sign compare_length(const Point& a, const Point& b, double length, int exponent) {
    const double first = squared(a, b), scaled = std::ldexp(length, exponent), second = scaled * scaled;
    if (is_safe(first) && is_safe(second)) {
        const double difference = first - second, bound = 2 * relative_error * (first + second);
        if (difference > bound) return Sign::positive;
        if (difference < -bound) return Sign::negative;
    }
    Rational wanted(length);
    if (exponent >= 0)
        wanted *= Rational(Integer(1) << exponent);
    else
        wanted /= Rational(Integer(1) << -exponent);
    return sign_of(Rational(exact_squared(a, b) - wanted * wanted));
}

}  // namespace cob
