/// \file
/// Vectors and numbers in binary64 that carry a bound of their own error: the filter of the exact predicates
/// around a viewpoint. Where a bound cannot tell a sign, fractions decide.
///
/// u = 2^-53. The constants count the roundings of each formula and are rounded up; 1e-300 pays for underflow.
/// Overflow makes a value or its bound infinite or NaN, and no comparison with those is ever certain.
#pragma once

#include "cob/arithmetic.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace cob::radiosity {

inline constexpr double unit_roundoff = 0x1p-53;
inline constexpr double underflow = 1e-300;

/// A number within `error` of the true one.
struct BoundedNumber {
    double value = 0, error = 0;

    /// The true number's sign, where it is certain. Zero only where value and error are.
    std::optional<Sign> sign() const {
        if (value > error) return Sign::positive;
        if (value < -error) return Sign::negative;
        if (value == 0 && error == 0) return Sign::zero;
        return std::nullopt;
    }
};

/// A vector each of whose components is within `error` of the true one.
struct BoundedVector {
    Vector3<double> value;
    double error = 0;

    double size() const { return std::max({std::abs(value.x), std::abs(value.y), std::abs(value.z)}); }
    BoundedVector operator-() const { return {-value, error}; }
};

inline BoundedVector operator-(const BoundedVector& a, const BoundedVector& b) {
    BoundedVector result{a.value - b.value, 0};
    result.error = (a.error + b.error + unit_roundoff * result.size()) * (1 + 8 * unit_roundoff);
    return result;
}

/// How far products of components of a and b can be off, each.
inline double product_error(const BoundedVector& a, const BoundedVector& b) {
    return a.size() * b.error + b.size() * a.error + a.error * b.error;
}

inline BoundedVector cross(const BoundedVector& a, const BoundedVector& b) {
    const double roundings = 4 * unit_roundoff * a.size() * b.size();
    return {cob::cross(a.value, b.value), (2 * product_error(a, b) + roundings) * (1 + 8 * unit_roundoff) + underflow};
}

inline BoundedNumber dot(const BoundedVector& a, const BoundedVector& b) {
    const double roundings = 10 * unit_roundoff * a.size() * b.size();
    return {cob::dot(a.value, b.value), (3 * product_error(a, b) + roundings) * (1 + 8 * unit_roundoff) + underflow};
}

/// p a - q b.
inline BoundedVector combine(const BoundedNumber& p, const BoundedVector& a, const BoundedNumber& q,
                             const BoundedVector& b) {
    const double pa = std::abs(p.value) * a.size(), qb = std::abs(q.value) * b.size();
    const double carried = std::abs(p.value) * a.error + p.error * (a.size() + a.error) + std::abs(q.value) * b.error +
                           q.error * (b.size() + b.error);
    return {p.value * a.value - q.value * b.value,
            (carried + 3 * unit_roundoff * (pa + qb)) * (1 + 8 * unit_roundoff) + underflow};
}

}  // namespace cob::radiosity
