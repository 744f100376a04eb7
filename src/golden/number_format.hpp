/// \file
/// Which numbers the questions of a set may consist of (`--grid`, `--float`).
#pragma once

#include "cob/arithmetic.hpp"
#include "cob/geometry.hpp"

#include <cmath>

namespace cob {

enum class NumberFormat : std::uint8_t { any, binary64, binary32 };

/// 2^exponent, also where binary64 has no such number.
inline Rational power_of_two(int exponent) {
    const Integer power = Integer(1) << static_cast<unsigned>(std::abs(exponent));
    return exponent < 0 ? Rational(Integer(1), power) : Rational(power);
}

constexpr int digits(NumberFormat format) {
    return format == NumberFormat::binary32 ? 24 : 53;
}

inline bool fits(double value, NumberFormat format) {
    return format != NumberFormat::binary32 || static_cast<double>(static_cast<float>(value)) == value;
}

inline bool fits(const ExactPoint& point, NumberFormat format) {
    if (format == NumberFormat::any) return true;
    const Point& p = point.nearest();
    return point.is_binary64() && fits(p.x, format) && fits(p.y, format) && fits(p.z, format);
}

inline bool fits(const Rational& value, NumberFormat format) {
    if (format == NumberFormat::any) return true;
    const auto number = to_binary64(value);
    return number && fits(*number, format);
}

inline bool fits(const BoxQuestion& question, NumberFormat format) {
    for (int k = 0; k < question.corners.count; ++k)
        if (!fits(question.corners.points[static_cast<std::size_t>(k)], format)) return false;
    return fits(question.u, format) && fits(question.margin, format) && fits(question.height, format);
}

/// The next number of the format above or below; of `any` that of binary64.
inline double neighbour(double value, double towards, NumberFormat format) {
    return format == NumberFormat::binary32
               ? static_cast<double>(std::nextafter(static_cast<float>(value), static_cast<float>(towards)))
               : std::nextafter(value, towards);
}

inline double rounded(double value, NumberFormat format) {
    return format == NumberFormat::binary32 ? static_cast<double>(static_cast<float>(value)) : value;
}

}  // namespace cob
