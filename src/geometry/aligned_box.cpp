#include "geometry/aligned_box.hpp"

#include "arithmetic/orientation.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace cob {
namespace {

AlignedBox::Pair pair_of(const ExactPoint& p, int axis, bool negative) {
    const double n = p.nearest()[axis], r = p.rest()[axis];
    return negative ? AlignedBox::Pair{-n, -r} : AlignedBox::Pair{n, r};
}

/// Pairs are unique: nearest is the sum, rounded.
bool less(const AlignedBox::Pair& a, const AlignedBox::Pair& b) {
    return a.nearest != b.nearest ? a.nearest < b.nearest : a.rest < b.rest;
}

std::optional<int> parallel_axis(const ExactPoint& v) {
    std::optional<int> found;
    for (int axis = 0; axis < 3; ++axis) {
        if (v.nearest()[axis] == 0) continue;
        if (found) return std::nullopt;
        found = axis;
    }
    return found;
}

/// The coordinate axis along which all corners agree.
std::optional<int> flat_axis(const Corners& corners) {
    for (int axis = 0; axis < 3; ++axis) {
        bool flat = true;
        for (int i = 1; i < corners.count; ++i) {
            const ExactPoint& p = corners.points[static_cast<std::size_t>(i)];
            flat = flat && p.nearest()[axis] == corners.points[0].nearest()[axis] &&
                   p.rest()[axis] == corners.points[0].rest()[axis];
        }
        if (flat) return axis;
    }
    return std::nullopt;
}

using Number = WideInteger<6>;

/// value 2^unit as its first 53 bits and the 53 after them; nothing where it has more, or is out of range.
std::optional<AlignedBox::Pair> to_pair(const Number& value, int unit) {
    const bool negative = less_than_zero(value);
    const Number magnitude = negative ? -value : value;
    const int first = std::max(0, magnitude.bit_length() - 53), second = std::max(0, first - 53);
    const auto part = [&](int from, int count) {
        const double number = std::ldexp(static_cast<double>(magnitude.bits_from(from, count)), from + unit);
        return negative ? -number : number;
    };
    const AlignedBox::Pair pair{part(first, 53), part(second, first - second)};
    if (!std::isfinite(pair.nearest)) return std::nullopt;
    for (const double number : {pair.nearest, pair.rest})
        if (number != 0 && BinaryParts(number).exponent < unit) return std::nullopt;
    if (Number(pair.nearest, unit) + Number(pair.rest, unit) != value) return std::nullopt;
    return pair;
}

}  // namespace

std::optional<AlignedBox> AlignedBox::of(const BoxQuestion& question) {
    const Corners& corners = question.corners;
    if (question.u.has_fraction()) return std::nullopt;
    for (int i = 0; i < corners.count; ++i)
        if (corners.points[static_cast<std::size_t>(i)].has_fraction()) return std::nullopt;
    const std::optional<int> u_axis = parallel_axis(question.u), n_axis = flat_axis(corners);
    const std::optional<double> margin = to_binary64(question.margin), height = to_binary64(question.height);
    if (!u_axis || !n_axis || *u_axis == *n_axis || !margin || !height) return std::nullopt;

    // Directions: n by the turn of the corners, w = n x u.
    AlignedBox box;
    const int first = (*n_axis + 1) % 3, second = (*n_axis + 2) % 3;
    const auto turn = [&](std::size_t i) {
        return orientation_seen(corners.points[0], corners.points[i], corners.points[i + 1], first, second);
    };
    const Sign side = turn(1) != Sign::zero || corners.count == 3 ? turn(1) : turn(2);
    if (side == Sign::zero) return std::nullopt;
    box.axis = {*u_axis, 3 - *u_axis - *n_axis, *n_axis};
    box.negative[0] = question.u.nearest()[*u_axis] < 0;
    box.negative[2] = side == Sign::negative;
    // n x u is the third axis where u follows n cyclically, else its opposite.
    const bool cyclic = (*n_axis + 1) % 3 == *u_axis;
    box.negative[1] = (box.negative[0] != box.negative[2]) == cyclic;

    box.base = pair_of(corners.points[0], box.axis[2], box.negative[2]);
    box.find_sides(corners, *margin, *height);
    return box;
}

void AlignedBox::find_sides(const Corners& corners, double margin, double height) {
    // 1. The element's extents, in units small enough for margins and height.
    std::array<Pair, 2> low, high;
    BitSpan bits;
    const auto add = [&bits](const Pair& pair) { bits.add(pair.nearest), bits.add(pair.rest); };
    for (std::size_t k = 0; k < 2; ++k) {
        low[k] = high[k] = pair_of(corners.points[0], axis[k], negative[k]);
        for (int i = 1; i < corners.count; ++i) {
            const Pair c = pair_of(corners.points[static_cast<std::size_t>(i)], axis[k], negative[k]);
            if (less(c, low[k])) low[k] = c;
            if (less(high[k], c)) high[k] = c;
        }
        add(low[k]);
        add(high[k]);
    }
    add(base);
    const BinaryParts m(margin), h(height);
    const int margin_bits = std::max(0, -m.exponent), height_bits = std::max(0, -h.exponent);
    const auto length = [](const BinaryParts& parts) { return 54 + std::max(0, parts.exponent); };
    // Widths have a bit more than coordinates, times 1 + 2 margin, times the height, and a sum.
    if (bits.bits() + 2 + length(m) + margin_bits + length(h) + height_bits + 2 >= Number::bits) return;
    const int fine = bits.low - margin_bits - height_bits;

    // 2. Widened by margin x extent: margin = n / 2^margin_bits, so the extent is taken in coarser units.
    const Number n(margin, -margin_bits);
    const auto in = [](const Pair& pair, int unit_) { return Number(pair.nearest, unit_) + Number(pair.rest, unit_); };
    const int coarse = fine + margin_bits;
    std::array<std::array<Number, 2>, 3> exact;
    for (std::size_t k = 0; k < 2; ++k) {
        const Number widening = n * (in(high[k], coarse) - in(low[k], coarse));
        exact[k] = {in(low[k], fine) - widening, in(high[k], fine) + widening};
    }

    // 3. h = height (1 + 2 margin) x the shorter extent.
    const int coarser = coarse + height_bits;
    const Number shorter =
        lesser(in(high[0], coarser) - in(low[0], coarser), in(high[1], coarser) - in(low[1], coarser));
    const Number widened = Number(1.0, -margin_bits) + n + n;
    exact[2] = {in(base, fine), in(base, fine) + Number(height, -height_bits) * (widened * shorter)};

    // 4. As pairs.
    std::array<std::array<Pair, 2>, 3> pairs;
    BitSpan used;
    for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t end = 0; end < 2; ++end) {
            const std::optional<Pair> pair = to_pair(exact[k][end], fine);
            if (!pair) return;
            pairs[k][end] = *pair;
            used.add(pair->nearest);
            used.add(pair->rest);
        }
    sides = pairs;
    unit = used.low;
}

}  // namespace cob
