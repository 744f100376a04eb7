/// \file
/// Exact constructions with convex polygons in space: clipping by planes, and what of one lies outside another.
#pragma once

#include "cob/geometry.hpp"

#include <vector>

namespace cob {

/// Corners in order around; in one plane; with an inside unless empty.
using ConvexPolygon = std::vector<RationalPoint>;

/// The points p with normal . (p - origin) > 0.
struct OpenHalfSpace {
    RationalPoint normal, origin;

    Rational height(const RationalPoint& point) const { return dot(normal, point - origin); }
    OpenHalfSpace opposite() const { return {-normal, origin}; }
};

/// The corners of a piece or an element, straight ones too.
ConvexPolygon polygon_of(const Scene& scene, const Piece& piece);
ConvexPolygon polygon_of(const Corners& corners);
/// Where the polygon is visible from.
OpenHalfSpace front_of(const ConvexPolygon& polygon);
/// One for each side: together they hold what lies straight over and under the polygon.
std::vector<OpenHalfSpace> sides_of(const ConvexPolygon& polygon);
/// What of the polygon lies in the half-space, its border added; empty where that has no area.
ConvexPolygon clip(const ConvexPolygon& polygon, const OpenHalfSpace& half_space);
/// Replaces polygons of one plane by what of them lies outside another of that plane, as convex parts.
void subtract(std::vector<ConvexPolygon>& polygons, const ConvexPolygon& hole);
/// Normal of twice the polygon's area as length, whichever corners are straight.
template <class Number>
Vector3<Number> area_vector(const std::vector<Vector3<Number>>& polygon) {
    Vector3<Number> sum{};
    for (std::size_t k = 2; k < polygon.size(); ++k)
        sum = sum + cross(polygon[k - 1] - polygon[0], polygon[k] - polygon[0]);
    return sum;
}
/// The largest component in absolute value.
Rational largest_component(const RationalPoint& vector);
/// Area in binary64, within a few units in the last place.
double area(const ConvexPolygon& polygon);

}  // namespace cob
