#include "arithmetic/interval_functions.hpp"

#include <cmath>

namespace cob {
namespace {

constexpr int terms = 14;  ///< The rest of either series is below 3e-20 of its sum.

/// Sum of z^k / (2 k + 1), by signs alternating or not, for 0 <= z <= 0.04.
Interval odd_series(const Interval& z, bool alternating) {
    // What follows the last term is at most a geometric series: 1 / ((2 terms + 1) (1 - z)) times z^terms.
    const double rest = 1.05 / (2 * terms + 1);
    Interval sum = alternating ? Interval(-rest, rest) : Interval(0, rest);
    for (int k = terms - 1; k >= 0; --k) {
        const Interval term = Interval(1) / Interval(2 * k + 1);
        sum = term + (alternating ? -(z * sum) : z * sum);
    }
    return sum;
}

/// Of a finite number above zero: m 2^e with t = (m - 1) / (m + 1), |t| < 0.1716, and ln m = 2 artanh t.
Interval log_of(double x) {
    const Interval ln2{0x1.62e42fefa39efp-1, 0x1.62e42fefa39f0p-1};
    int exponent = 0;
    double m = std::frexp(x, &exponent);
    if (m < 0.70710678) m *= 2, --exponent;
    const Interval t = (Interval(m) - Interval(1)) / (Interval(m) + Interval(1));
    return Interval(2) * t * odd_series(square(t), false) + Interval(exponent) * ln2;
}

/// Of 0 <= x <= infinity, in [0, pi / 2]. The half of the half of the angle has a tangent below 0.2.
Interval arctangent(double x) {
    const Interval half_pi = pi_interval() * Interval(0.5);
    if (std::isinf(x)) return half_pi;
    Interval tangent = x > 1 ? Interval(1) / Interval(x) : Interval(x);
    for (int halving = 0; halving < 2; ++halving)
        tangent = tangent / (Interval(1) + sqrt(Interval(1) + square(tangent)));
    const Interval angle = Interval(4) * tangent * odd_series(square(tangent), true);
    return x > 1 ? half_pi - angle : angle;
}

Interval arctangent(const Interval& x) {
    const auto of = [](double end) { return end < 0 ? -arctangent(-end) : arctangent(end); };
    return {of(x.low()).low(), of(x.high()).high()};
}

}  // namespace

Interval log(const Interval& x) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (!(x.high() > 0) || !x.is_bounded()) return Interval::unknown();
    return {x.low() > 0 ? log_of(x.low()).low() : -infinity, log_of(x.high()).high()};
}

Interval atan2(const Interval& y, const Interval& x) {
    const Interval half_pi = pi_interval() * Interval(0.5);
    if (x.low() > 0) return arctangent(y / x);
    if (y.low() > 0) return half_pi - arctangent(x / y);
    if (y.high() < 0) return -half_pi - arctangent(x / y);
    return {-pi_interval().high(), pi_interval().high()};
}

}  // namespace cob
