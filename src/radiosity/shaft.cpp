#include "radiosity/shaft.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cob::radiosity {
namespace {

/// Far above what rounding does to sums of products of numbers up to 2, far below what matters.
constexpr double slack = 0x1p-44;
constexpr double coordinate_slack = 0x1p-49;

}  // namespace

Bounds bounds_of(const Point* points, int count) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Bounds bounds{infinity, infinity, infinity, -infinity, -infinity, -infinity};
    for (int k = 0; k < count; ++k)
        for (int axis = 0; axis < 3; ++axis) {
            const auto i = static_cast<std::size_t>(axis);
            bounds[i] = std::min(bounds[i], points[k][axis] - coordinate_slack);
            bounds[i + 3] = std::max(bounds[i + 3], points[k][axis] + coordinate_slack);
        }
    return bounds;
}

Shaft::Shaft(const Bounds& a, const Bounds& b) {
    for (std::size_t i = 0; i < 3; ++i) {
        both_[i] = std::min(a[i], b[i]);
        both_[i + 3] = std::max(a[i + 3], b[i + 3]);
    }
    // Seen along each axis, the hull of two rectangles: a line joins their corners of one kind (low or high along
    // either axis) wherever one box reaches farther along the first axis and the other along the second.
    constexpr int axes[3][2] = {{0, 1}, {1, 2}, {2, 0}};
    for (const auto& pair : axes)
        for (const bool high_first : {false, true})
            for (const bool high_second : {false, true}) {
                const std::size_t f = static_cast<std::size_t>(pair[0]) + (high_first ? 3 : 0);
                const std::size_t s = static_cast<std::size_t>(pair[1]) + (high_second ? 3 : 0);
                const double to_first = high_first ? 1 : -1, to_second = high_second ? 1 : -1;
                const double first = to_first * (b[f] - a[f]), second = to_second * (b[s] - a[s]);
                if (!((first > 0 && second < 0) || (first < 0 && second > 0))) continue;
                // Normal of the joining line, towards the corner's kind.
                const double n_first = to_first * std::abs(second), n_second = to_second * std::abs(first);
                sides_[static_cast<std::size_t>(side_count_++)] = {pair[0], pair[1], n_first, n_second,
                                                                   n_first * a[f] + n_second * a[s] + slack};
            }
}

bool Shaft::may_meet(const Bounds3& box) const {
    for (int axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<std::size_t>(axis);
        if (box.low[axis] > both_[i + 3] || box.high[axis] < both_[i]) return false;
    }
    for (int k = 0; k < side_count_; ++k) {
        // The corner that lies least far out.
        const Side& side = sides_[static_cast<std::size_t>(k)];
        const double first = side.a > 0 ? box.low[side.first] : box.high[side.first];
        const double second = side.b > 0 ? box.low[side.second] : box.high[side.second];
        if (side.a * first + side.b * second > side.c) return false;
    }
    return true;
}

bool Shaft::may_meet(const Bounds& bounds, const std::vector<Point>& corners) const {
    for (std::size_t i = 0; i < 3; ++i)
        if (bounds[i] > both_[i + 3] || bounds[i + 3] < both_[i]) return false;
    for (int k = 0; k < side_count_; ++k) {
        const Side& side = sides_[static_cast<std::size_t>(k)];
        const bool outside = std::all_of(corners.begin(), corners.end(), [&](const Point& p) {
            return side.a * p[side.first] + side.b * p[side.second] > side.c;
        });
        if (outside) return false;
    }
    return true;
}

}  // namespace cob::radiosity
