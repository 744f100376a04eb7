#include "geometry/aligned_box.hpp"

#include "arithmetic/orientation.hpp"

#include <algorithm>
#include <utility>

namespace cob {
namespace {

AlignedBox::Pair coordinate(const ExactPoint& p, int axis, bool negative) {
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

/// The fraction as a binary64 number, where it is one: mostly without rounding a quotient.
std::optional<double> binary64(const Rational& value) {
    const double truncated = mpq_get_d(value.backend().data());
    return Rational(truncated) == value ? std::optional<double>(truncated) : std::nullopt;
}

int fraction_bits(double value) {
    return std::max(0, -BinaryParts(value).exponent);
}

}  // namespace

std::optional<AlignedBox> AlignedBox::of(const BoxQuestion& question) {
    const Corners& corners = question.corners;
    if (question.u.has_fraction()) return std::nullopt;
    for (int i = 0; i < corners.count; ++i)
        if (corners.points[static_cast<std::size_t>(i)].has_fraction()) return std::nullopt;
    const std::optional<int> u_axis = parallel_axis(question.u), n_axis = flat_axis(corners);
    const std::optional<double> margin = binary64(question.margin), height = binary64(question.height);
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

    // Extents.
    BitSpan bits;
    const auto add = [&bits](const Pair& pair) { bits.add(pair.nearest), bits.add(pair.rest); };
    for (std::size_t k = 0; k < 2; ++k) {
        box.low[k] = box.high[k] = coordinate(corners.points[0], box.axis[k], box.negative[k]);
        for (int i = 1; i < corners.count; ++i) {
            const Pair c = coordinate(corners.points[static_cast<std::size_t>(i)], box.axis[k], box.negative[k]);
            if (less(c, box.low[k])) box.low[k] = c;
            if (less(box.high[k], c)) box.high[k] = c;
        }
        add(box.low[k]);
        add(box.high[k]);
    }
    box.base = coordinate(corners.points[0], box.axis[2], box.negative[2]);
    add(box.base);

    box.margin = *margin;
    box.height = *height;
    box.margin_bits = fraction_bits(box.margin);
    box.height_bits = fraction_bits(box.height);
    box.unit = bits.low - box.margin_bits - box.height_bits;
    return box;
}

}  // namespace cob
