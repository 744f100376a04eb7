/// \file
/// What a receiver, a light and what stands between them are to the cubatures over the receiver.
#pragma once

#include "arithmetic/interval.hpp"
#include "geometry/convex_polygon.hpp"
#include "radiosity/cone.hpp"
#include "radiosity/receiver_frame.hpp"

#include <array>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace cob::radiosity {

using IntervalPoint = Vector3<Interval>;

/// Tables by sides and corners are kept up to this size; beyond, among hundreds of occluders, they are sparse.
inline constexpr std::size_t most_in_table = std::size_t(1) << 16;

/// A convex polygon by the numbers of its corners, as seen counter-clockwise, and those of its sides.
struct CornerLoop {
    std::size_t number = 0;  ///< Among those of the shapes.
    std::vector<VertexId> corners;
    std::vector<PlaneRef> sides;  ///< From corner k to the next; flipped where the side runs the other way.
};

/// A receiver's plane, the light before it and what stands between, all convex and in front of both planes: exactly,
/// and in the receiver's right-angled coordinates (s, t, h).
class PairShapes {
public:
    /// Lengths are multiplied by `scale`. The origin is the receiver's first corner.
    PairShapes(const ConvexPolygon& receiver, double scale);

    /// Straight corners are left out. Corners at one place have one number.
    CornerLoop add(const ConvexPolygon& polygon);
    IntervalPoint local(const RationalPoint& point) const;

    std::size_t corner_count() const { return corners_.size(); }
    const IntervalPoint& corner(VertexId v) const { return corners_[static_cast<std::size_t>(v)]; }
    const BoundedVector& bounded_corner(VertexId v) const { return bounded_[static_cast<std::size_t>(v)]; }
    std::size_t side_count() const { return sides_.size(); }
    /// Its ends, the lower number first.
    const std::array<VertexId, 2>& side(std::int32_t k) const { return sides_[static_cast<std::size_t>(k)]; }

    /// With the side ab, [a - x, b - x, v - x] vanishes for every x of the plane; exact.
    bool always_in_plane(std::int32_t side, VertexId v) const;
    /// The side of the polygon whose plane through x is also that of another side for every x, if there is one.
    std::optional<std::size_t> common_side(std::int32_t side, const CornerLoop& loop) const;
    /// The planes through x and three sides have a line in common for every x of the plane; exact.
    bool always_in_line(std::array<std::int32_t, 3> sides) const;

private:
    PlaneRef side_between(VertexId a, VertexId b);

    ConvexPolygon receiver_;
    std::array<RationalPoint, 3> span_;  ///< Three of its corners, not on one line.
    std::array<BoundedVector, 3> bounded_span_;
    double scale_;
    std::array<IntervalPoint, 3> axes_;
    std::vector<RationalPoint> exact_;
    std::vector<IntervalPoint> corners_;
    std::vector<BoundedVector> bounded_;
    std::vector<std::array<VertexId, 2>> sides_;
    std::map<RationalPoint, VertexId> known_;
    std::map<std::array<VertexId, 2>, std::int32_t> known_sides_;
    std::size_t loops_ = 0;
    mutable std::map<std::pair<std::int32_t, VertexId>, bool> in_plane_;  ///< Where it took exact arithmetic.
    mutable std::vector<std::int32_t> common_;  ///< By side and polygon, where that many can be kept.
    mutable std::map<std::array<std::int32_t, 3>, bool> in_line_;
};

}  // namespace cob::radiosity
