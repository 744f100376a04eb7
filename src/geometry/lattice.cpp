// Lattice points in 128-bit integers: the coordinates of a root's corners, brought to one power of two, times the
// integer weights of the lattice, are summed without rounding and then split in two binary64 numbers. What does not
// fit goes through fractions.
#include "geometry/lattice.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace cob {
namespace {

__extension__ using Wide = __int128;

/// mantissa 2^exponent, the mantissa odd or zero.
struct Binary {
    std::int64_t mantissa = 0;
    int exponent = 0;
};

Binary split(double value) {
    std::uint64_t bits;
    std::memcpy(&bits, &value, sizeof bits);
    const int biased = static_cast<int>(bits >> 52 & 0x7FF);
    std::uint64_t mantissa = bits & ((std::uint64_t{1} << 52) - 1);
    if (biased != 0) mantissa |= std::uint64_t{1} << 52;
    if (mantissa == 0) return {};
    const int zeros = __builtin_ctzll(mantissa);
    const auto magnitude = static_cast<std::int64_t>(mantissa >> zeros);
    return {value < 0 ? -magnitude : magnitude, std::max(biased, 1) - 1075 + zeros};
}

int bit_length(std::int64_t value) {
    const auto magnitude = static_cast<std::uint64_t>(value < 0 ? -value : value);
    return magnitude == 0 ? 0 : 64 - __builtin_clzll(magnitude);
}

/// value 2^exponent, without rounding.
double scaled(double value, int exponent) {
    if (exponent < -1022 || exponent > 1023) return std::ldexp(value, exponent);
    const std::uint64_t bits = static_cast<std::uint64_t>(exponent + 1023) << 52;
    double power;
    std::memcpy(&power, &bits, sizeof power);
    return value * power;
}

/// Integer weights over a common power of two; their sum is 2^bits.
struct Weights {
    std::array<std::int64_t, 4> of{};
    int count = 0, bits = 0;
};

constexpr int most_weight_bits = 62;

std::optional<Weights> quadrilateral_weights(Dyadic u, Dyadic v) {
    if (u.bits + v.bits > most_weight_bits) return std::nullopt;
    const std::int64_t up = u.numerator, vp = v.numerator;
    const std::int64_t uq = (std::int64_t{1} << u.bits) - up, vq = (std::int64_t{1} << v.bits) - vp;
    return Weights{{uq * vq, up * vq, up * vp, uq * vp}, 4, u.bits + v.bits};
}

std::optional<Weights> triangle_weights(Dyadic u, Dyadic v) {
    const int bits = std::max(u.bits, v.bits);
    if (bits > most_weight_bits - 1) return std::nullopt;
    const std::int64_t first = u.numerator << (bits - u.bits), second = v.numerator << (bits - v.bits);
    return Weights{{(std::int64_t{1} << bits) - first - second, first, second, 0}, 3, bits};
}

struct Pair {
    double nearest = 0, rest = 0;
};

/// Sum of weight times value over 2^bits as a pair; nothing where it does not fit.
std::optional<Pair> weighted_sum(const Weights& weights, const std::array<double, 4>& values) {
    // Equal values are common (planes across an axis), and the weights sum to one.
    bool equal = true;
    for (int k = 1; k < weights.count; ++k) equal = equal && values[k] == values[0];
    if (equal) return Pair{values[0], 0};

    std::array<Binary, 4> parts;
    int lowest = std::numeric_limits<int>::max();
    for (int k = 0; k < weights.count; ++k) {
        parts[k] = split(values[k]);
        if (parts[k].mantissa != 0) lowest = std::min(lowest, parts[k].exponent);
    }
    Wide sum = 0;
    for (int k = 0; k < weights.count; ++k) {
        if (parts[k].mantissa == 0 || weights.of[k] == 0) continue;
        const int shift = parts[k].exponent - lowest;
        constexpr int room = 124;  // three bits for the sign and the sum of four
        if (bit_length(parts[k].mantissa) + bit_length(weights.of[k]) + shift > room) return std::nullopt;
        sum += static_cast<Wide>(parts[k].mantissa) * weights.of[k] * (Wide{1} << shift);
    }
    const int exponent = lowest - weights.bits;
    constexpr int least_exponent = -1074;
    if (exponent < least_exponent) return std::nullopt;
    const auto nearest = static_cast<double>(sum);
    const Wide remainder = sum - static_cast<Wide>(nearest);
    const auto rest = static_cast<double>(remainder);
    if (static_cast<Wide>(rest) != remainder) return std::nullopt;
    return Pair{scaled(nearest, exponent), scaled(rest, exponent)};
}

const Point& corner(const Scene& scene, const Root& root, int k) {
    return scene.position(root.corners[static_cast<std::size_t>(k)]);
}

}  // namespace

std::optional<Dyadic> dyadic_sum(std::uint32_t base, int base_bits, int step, double fraction) {
    const Binary part = split(fraction);
    if (part.mantissa == 0) return Dyadic{base, base_bits};
    const int bits = std::max(-part.exponent, 0), left = std::max(part.exponent, 0);
    if (base_bits + bits + left > most_weight_bits - 1 || bit_length(part.mantissa) + left > most_weight_bits - 1)
        return std::nullopt;
    const std::int64_t numerator = (part.mantissa << left) * step + (std::int64_t{base} << bits);
    return Dyadic{numerator, base_bits + bits};
}

ExactPoint lattice_point(const Scene& scene, const Root& root, Dyadic u, Dyadic v) {
    const int count = root.corner_count();
    if (const auto weights = count == 4 ? quadrilateral_weights(u, v) : triangle_weights(u, v)) {
        Point nearest, rest;
        bool fits = true;
        for (int axis = 0; axis < 3 && fits; ++axis) {
            std::array<double, 4> values{};
            for (int k = 0; k < count; ++k) values[k] = corner(scene, root, k)[axis];
            const auto pair = weighted_sum(*weights, values);
            fits = pair.has_value();
            if (fits) {
                nearest[axis] = pair->nearest;
                rest[axis] = pair->rest;
            }
        }
        if (fits) return ExactPoint::from_pair(nearest, rest);
    }
    const auto fraction = [](Dyadic d) { return Rational(Integer(d.numerator), Integer(1) << d.bits); };
    return lattice_point(scene, root, fraction(u), fraction(v));
}

ExactPoint lattice_point(const Scene& scene, const Root& root, const Rational& u, const Rational& v) {
    const auto at = [&](int k) { return to_rational(corner(scene, root, k)); };
    const RationalPoint origin = at(0);
    if (root.corner_count() == 3) return ExactPoint(origin + u * (at(1) - origin) + v * (at(2) - origin));
    const RationalPoint bottom = origin + u * (at(1) - origin), top = at(3) + u * (at(2) - at(3));
    return ExactPoint(bottom + v * (top - bottom));
}

}  // namespace cob
