// Lattice points in 128-bit integers: the coordinates of a root's corners, brought to one power of two, times the
// integer weights of the lattice, are summed without rounding and then split in two binary64 numbers. What does not
// fit goes through fractions.
#include "geometry/lattice.hpp"

#include "arithmetic/wide_integer.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace cob {
namespace {

int bit_length(std::uint64_t value) {
    return value == 0 ? 0 : 64 - __builtin_clzll(value);
}
int bit_length(DoubleLimb value) {
    const auto high = static_cast<std::uint64_t>(value >> 64), low = static_cast<std::uint64_t>(value);
    return high != 0 ? 64 + bit_length(high) : bit_length(low);
}
int trailing_zeros(DoubleLimb value) {
    const auto low = static_cast<std::uint64_t>(value);
    return low != 0 ? __builtin_ctzll(low) : 64 + __builtin_ctzll(static_cast<std::uint64_t>(value >> 64));
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

/// An integer times 2^exponent as the nearest binary64 number, half to even, and the rest; nothing where the rest has
/// more bits than one such number.
std::optional<Pair> split_in_two(DoubleLimb magnitude, bool negative, int exponent) {
    constexpr int bits = std::numeric_limits<double>::digits;
    const double sign = negative ? -1 : 1;
    const int excess = bit_length(magnitude) - bits;
    if (excess <= 0)
        return Pair{sign * scaled(static_cast<double>(static_cast<std::uint64_t>(magnitude)), exponent), 0};

    const DoubleLimb one = 1, dropped = magnitude & ((one << excess) - 1), half = one << (excess - 1);
    const auto kept = static_cast<std::uint64_t>(magnitude >> excess);
    const bool up = dropped > half || (dropped == half && (kept & 1) != 0);
    const double nearest = sign * scaled(static_cast<double>(kept + (up ? 1 : 0)), exponent + excess);
    if (dropped == 0) return Pair{nearest, 0};
    const DoubleLimb rest = up ? (one << excess) - dropped : dropped;
    const int zeros = trailing_zeros(rest);
    if (bit_length(rest) - zeros > bits) return std::nullopt;
    const auto digits = static_cast<double>(static_cast<std::uint64_t>(rest >> zeros));
    return Pair{nearest, (up ? -sign : sign) * scaled(digits, exponent + zeros)};
}

/// Sum of weight times value over 2^bits as a pair; nothing where it does not fit.
std::optional<Pair> weighted_sum(const Weights& weights, const std::array<double, 4>& values) {
    // Equal values are common (planes across an axis), and the weights sum to one.
    bool equal = true;
    for (int k = 1; k < weights.count; ++k) equal = equal && values[k] == values[0];
    if (equal) return Pair{values[0], 0};

    const std::array<BinaryParts, 4> parts{BinaryParts(values[0]), BinaryParts(values[1]), BinaryParts(values[2]),
                                           BinaryParts(values[3])};
    int lowest = std::numeric_limits<int>::max();
    for (int k = 0; k < weights.count; ++k)
        if (parts[k].magnitude != 0) lowest = std::min(lowest, parts[k].exponent);

    DoubleLimb sum = 0;  // two's complement
    for (int k = 0; k < weights.count; ++k) {
        if (parts[k].magnitude == 0 || weights.of[k] == 0) continue;
        const bool negative = parts[k].negative != (weights.of[k] < 0);
        const auto weight = static_cast<std::uint64_t>(weights.of[k] < 0 ? -weights.of[k] : weights.of[k]);
        const int shift = parts[k].exponent - lowest;
        constexpr int room = 124;  // the rest is for the sign and the sum of four
        if (bit_length(parts[k].magnitude) + bit_length(weight) + shift > room) return std::nullopt;
        const DoubleLimb term = DoubleLimb{parts[k].magnitude} * weight << shift;
        sum += negative ? -term : term;
    }
    const int exponent = lowest - weights.bits;
    constexpr int least_exponent = -1074;
    if (exponent < least_exponent) return std::nullopt;
    const bool negative = sum >> 127 != 0;
    return split_in_two(negative ? -sum : sum, negative, exponent);
}

const Point& corner(const Scene& scene, const Root& root, int k) {
    return scene.position(root.corners[static_cast<std::size_t>(k)]);
}

}  // namespace

std::optional<Dyadic> dyadic_sum(std::uint32_t base, int base_bits, int step, double fraction) {
    const BinaryParts part(fraction);
    if (part.magnitude == 0) return Dyadic{base, base_bits};
    const int bits = std::max(-part.exponent, 0), left = std::max(part.exponent, 0);
    if (base_bits + bits + left > most_weight_bits - 1 || bit_length(part.magnitude) + left > most_weight_bits - 1)
        return std::nullopt;
    const auto magnitude = static_cast<std::int64_t>(part.magnitude << left);
    const std::int64_t numerator = (part.negative ? -magnitude : magnitude) * step + (std::int64_t{base} << bits);
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
