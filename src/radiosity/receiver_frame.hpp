/// \file
/// A receiver's own coordinates: (s, t) in its plane, h over it, in a unit that makes the scene about 1 in size.
#pragma once

#include "cob/arithmetic.hpp"
#include "geometry/convex_polygon.hpp"

#include <array>

namespace cob::radiosity {

struct Point2D {
    double s = 0, t = 0;
};
using Triangle2D = std::array<Point2D, 3>;

/// Right-handed: seen from the receiver's visible side, s turns left into t.
class ReceiverFrame {
public:
    /// The plane of a convex polygon; lengths are multiplied by `scale`, a power of two.
    ReceiverFrame(const ConvexPolygon& receiver, double scale);

    /// Relative to the frame's origin, in space but scaled.
    Vector3<double> relative(const RationalPoint& point) const;
    /// As (s, t, h).
    Vector3<double> local(const RationalPoint& point) const { return turned(relative(point)); }
    /// The point at (s, t), rounded to binary64 or, far from the origin, to a pair of binary64.
    ExactPoint point_at(const Point2D& where) const;
    const Vector3<double>& normal() const { return normal_; }
    /// The same, relative as above.
    Vector3<double> relative_at(const Point2D& where) const { return where.s * s_ + where.t * t_; }

private:
    Vector3<double> turned(const Vector3<double>& v) const { return {dot(v, s_), dot(v, t_), dot(v, normal_)}; }

    RationalPoint origin_;
    Point nearest_origin_;
    Vector3<double> s_, t_, normal_;
    double scale_;
    bool offset_ = false;  ///< The scene is small against its distance from the origin of coordinates.
};

}  // namespace cob::radiosity
