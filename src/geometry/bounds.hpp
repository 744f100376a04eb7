/// \file
/// Axis-aligned bounds of polygons and pieces, and the tests against them that trees are walked by. Exact or cautious:
/// they may say yes too often, never no too often.
#pragma once

#include "cob/scene.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace cob {

/// Closed bounds; the corners are binary64 numbers, so these are exact. Empty where low > high.
struct Bounds {
    static constexpr double infinity = std::numeric_limits<double>::infinity();
    std::array<double, 3> low{infinity, infinity, infinity}, high{-infinity, -infinity, -infinity};

    void add(const Point& point) {
        for (int axis = 0; axis < 3; ++axis) {
            low[axis] = std::min(low[axis], point[axis]);
            high[axis] = std::max(high[axis], point[axis]);
        }
    }
    void add(const Bounds& other) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            low[axis] = std::min(low[axis], other.low[axis]);
            high[axis] = std::max(high[axis], other.high[axis]);
        }
    }
    bool meets(const Bounds& other) const {
        for (std::size_t axis = 0; axis < 3; ++axis)
            if (high[axis] < other.low[axis] || other.high[axis] < low[axis]) return false;
        return true;
    }
    /// Halved first, so that the widest bounds of binary64 do not overflow.
    double middle(std::size_t axis) const { return low[axis] / 2 + high[axis] / 2; }
    /// Half of it, for the same reason.
    double half_extent(std::size_t axis) const { return high[axis] / 2 - low[axis] / 2; }
    std::size_t longest_axis() const {
        std::size_t longest = 0;
        for (std::size_t axis = 1; axis < 3; ++axis)
            if (half_extent(axis) > half_extent(longest)) longest = axis;
        return longest;
    }
};

inline Bounds bounds_of(const Scene& scene, View<VertexId> corners) {
    Bounds bounds;
    for (const VertexId corner : corners) bounds.add(scene.position(corner));
    return bounds;
}

/// Of all pieces: a vertex that no valid polygon uses does not count.
inline Bounds bounds_of(const Scene& scene) {
    Bounds bounds;
    for (const Piece& piece : scene.pieces()) bounds.add(bounds_of(scene, scene.corners(piece)));
    return bounds;
}

/// Length of the longest side: 0 of empty bounds, at most the largest binary64 number.
inline double longest_extent(const Bounds& bounds) {
    double longest = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) longest = std::max(longest, bounds.high[axis] - bounds.low[axis]);
    return std::min(longest, std::numeric_limits<double>::max());
}

/// A segment prepared for slab tests. Each end is off the exact one by at most half an ulp in each coordinate.
class SlabSegment {
public:
    SlabSegment(const Point& from, const Point& to) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double x = from[static_cast<int>(axis)], y = to[static_cast<int>(axis)];
            // Four half ulps: both ends' own, and the rounding of these sums.
            const double pad = std::max(std::abs(x), std::abs(y)) * 0x1p-51 + std::numeric_limits<double>::denorm_min();
            low_[axis] = std::min(x, y) - pad;
            high_[axis] = std::max(x, y) + pad;
            const double length = y - x;
            sloped_[axis] = std::abs(length) > least_length && std::abs(length) < greatest_length;
            inverse_[axis] = sloped_[axis] ? 1 / length : 0;
            // Where a slab is entered and left: moved against and along the segment, by the pad.
            enter_[axis] = length > 0 ? x + pad : x - pad;
            leave_[axis] = length > 0 ? x - pad : x + pad;
        }
    }

    /// False only where the exact segment misses the bounds. NaN and infinities, of ends beyond the range, are met.
    bool may_meet(const Bounds& bounds) const {
        double first = 0, last = 1;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            if (bounds.high[axis] < low_[axis] || high_[axis] < bounds.low[axis]) return false;
            if (!sloped_[axis]) continue;
            const bool up = inverse_[axis] > 0;
            const double in = ((up ? bounds.low[axis] : bounds.high[axis]) - enter_[axis]) * inverse_[axis];
            const double out = ((up ? bounds.high[axis] : bounds.low[axis]) - leave_[axis]) * inverse_[axis];
            first = in > first ? in : first;
            last = out < last ? out : last;
        }
        // Four roundings in each parameter: 8 * 2^-53 between the two, and as much to spare.
        return !(first > last * (1 + 0x1p-49) + std::numeric_limits<double>::min());
    }

private:
    /// Between these, reciprocals and products of them neither overflow nor lose places.
    static constexpr double least_length = 0x1p-900, greatest_length = 0x1p900;
    std::array<double, 3> low_{}, high_{}, inverse_{}, enter_{}, leave_{};
    std::array<bool, 3> sloped_{};
};

}  // namespace cob
