#include "golden/exact_text.hpp"

#include <charconv>
#include <cmath>
#include <cstdint>

namespace cob {
namespace {

__extension__ using uint128 = unsigned __int128;
__extension__ using int128 = __int128;

constexpr int mantissa_bits = 53;
constexpr int wide_bits = 126;  // numerators and denominators handled without GMP stay below 2^126

int bit_length(uint128 value) {
    const auto high = static_cast<std::uint64_t>(value >> 64), low = static_cast<std::uint64_t>(value);
    return high != 0 ? 128 - __builtin_clzll(high) : low != 0 ? 64 - __builtin_clzll(low) : 0;
}

/// A decimal integer below 2^126; nothing for anything else.
std::optional<uint128> parse_wide(std::string_view digits) {
    if (digits.empty() || digits.size() > 37) return std::nullopt;
    uint128 value = 0;
    for (const char c : digits) {
        if (c < '0' || c > '9') return std::nullopt;
        value = 10 * value + static_cast<unsigned>(c - '0');
    }
    return value;  // 10^37 < 2^126
}

/// The pair of p / 2^k, where it exists.
std::optional<ExactNumber> split(bool negative, uint128 p, int k) {
    const int excess = bit_length(p) - mantissa_bits;
    ExactNumber number;
    if (excess <= 0) {
        number.nearest = std::ldexp(static_cast<double>(p), -k);
    } else {
        const uint128 half = uint128{1} << (excess - 1);
        uint128 kept = p >> excess;
        const uint128 dropped = p - (kept << excess);
        if (dropped > half || (dropped == half && (kept & 1) != 0)) ++kept;
        const int128 rest = static_cast<int128>(p) - static_cast<int128>(kept << excess);
        const uint128 size = static_cast<uint128>(rest < 0 ? -rest : rest);
        const double rounded = static_cast<double>(size);
        if (static_cast<uint128>(rounded) != size) return std::nullopt;
        number.nearest = std::ldexp(static_cast<double>(kept), excess - k);
        number.rest = std::ldexp(rest < 0 ? -rounded : rounded, -k);
    }
    if (negative) {
        number.nearest = -number.nearest;
        number.rest = -number.rest;
    }
    return number;
}

/// p/q with a power of two below the line, both of moderate size: the ordinary case (corners are dyadic).
std::optional<ExactNumber> parse_dyadic_fraction(std::string_view text, std::size_t slash) {
    const bool negative = text.front() == '-';
    const auto p = parse_wide(text.substr(negative, slash - negative));
    const auto q = parse_wide(text.substr(slash + 1));
    if (!p || !q || *q == 0 || (*q & (*q - 1)) != 0) return std::nullopt;
    return split(negative, *p, bit_length(*q) - 1);
}

ExactNumber from_rational(const Rational& value) {
    ExactNumber number;
    number.nearest = to_nearest(value);
    if (std::isfinite(number.nearest)) {
        const Rational rest = value - Rational(number.nearest);
        number.rest = to_nearest(rest);
        if (Rational(number.rest) == rest) return number;
    }
    number.fraction = value;
    return number;
}

void append_wide(std::string& text, uint128 value) {
    constexpr std::uint64_t chunk = 10'000'000'000'000'000'000u;  // 10^19: digits of 64 bits at a time
    char digits[24];
    if (value < chunk) {
        text.append(digits, std::to_chars(digits, digits + sizeof digits, static_cast<std::uint64_t>(value)).ptr);
        return;
    }
    append_wide(text, value / chunk);
    const char* end = std::to_chars(digits, digits + sizeof digits, static_cast<std::uint64_t>(value % chunk)).ptr;
    text.append(static_cast<std::size_t>(19 - (end - digits)), '0');
    text.append(static_cast<const char*>(digits), end);
}

/// value = mantissa 2^exponent with an odd mantissa. value is not 0.
struct Dyadic {
    std::int64_t mantissa;
    int exponent;
};

Dyadic to_dyadic(double value) {
    int exponent = 0;
    const auto mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(value, &exponent), mantissa_bits));
    const int zeros = __builtin_ctzll(static_cast<std::uint64_t>(mantissa));
    return {mantissa >> zeros, exponent - mantissa_bits + zeros};
}

/// nearest + rest, rest not 0, as p/q in lowest terms. The exponent of rest is the lower one, as a rest is at most
/// half a unit in the last place of nearest, so p is odd or q is 1.
bool append_dyadic_fraction(std::string& text, double nearest, double rest) {
    if (nearest == 0) return false;
    const Dyadic high = to_dyadic(nearest), low = to_dyadic(rest);
    const int shift = high.exponent - low.exponent;
    if (shift <= 0 || shift > wide_bits - mantissa_bits - 1 || low.exponent < -wide_bits || low.exponent > 0)
        return false;
    const int128 p = static_cast<int128>(high.mantissa) * (int128{1} << shift) + low.mantissa;
    if (p < 0) text += '-';
    append_wide(text, static_cast<uint128>(p < 0 ? -p : p));
    text += '/';
    append_wide(text, uint128{1} << -low.exponent);
    return true;
}

}  // namespace

std::optional<double> parse_number(std::string_view text) {
    double value = 0;
    const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error == std::errc{} && stop == text.data() + text.size() && std::isfinite(value)) return value;
    return parse_binary64(text);
}

std::optional<ExactNumber> parse_exact_number(std::string_view text) {
    const std::size_t slash = text.find('/');
    if (slash == std::string_view::npos) {
        const auto value = parse_number(text);
        return value ? std::optional<ExactNumber>(ExactNumber{*value, 0, {}}) : std::nullopt;
    }
    if (auto number = parse_dyadic_fraction(text, slash)) return number;
    const auto value = parse_exact(text);
    return value ? std::optional<ExactNumber>(from_rational(*value)) : std::nullopt;
}

ExactPoint to_point(const std::array<ExactNumber, 3>& c) {
    if (!c[0].fraction && !c[1].fraction && !c[2].fraction)
        return ExactPoint::from_pair({c[0].nearest, c[1].nearest, c[2].nearest}, {c[0].rest, c[1].rest, c[2].rest});
    RationalPoint point;
    for (int axis = 0; axis < 3; ++axis) {
        const ExactNumber& number = c[static_cast<std::size_t>(axis)];
        point[axis] = number.fraction ? *number.fraction : Rational(Rational(number.nearest) + Rational(number.rest));
    }
    return ExactPoint(point);
}

void append_number(std::string& text, double value) {
    if (value == 0) {
        text += '0';  // -0 and 0 are one number
        return;
    }
    char digits[32];
    text.append(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
}

void append_point(std::string& text, const Point& point) {
    for (int axis = 0; axis < 3; ++axis) {
        if (axis > 0) text += ',';
        append_number(text, point[axis]);
    }
}

void append_point(std::string& text, const ExactPoint& point) {
    if (point.is_binary64()) return append_point(text, point.nearest());
    std::optional<RationalPoint> rational;
    if (point.has_fraction()) rational = point.rational();
    for (int axis = 0; axis < 3; ++axis) {
        if (axis > 0) text += ',';
        const double nearest = point.nearest()[axis], rest = point.rest()[axis];
        if (rational)
            text += to_text((*rational)[axis]);
        else if (rest == 0)
            append_number(text, nearest);
        else if (!append_dyadic_fraction(text, nearest, rest))
            text += to_text(Rational(Rational(nearest) + Rational(rest)));
    }
}

}  // namespace cob
