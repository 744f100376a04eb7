/// \file
/// Triangles of a receiver and how they are cut.
#pragma once

#include "radiosity/cell_signs.hpp"

#include <vector>

namespace cob::radiosity {

/// Counter-clockwise, convex.
using Polygon2D = std::vector<Point2D>;

/// The triangle, its corners counter-clockwise.
Polygon2D left_around(const Triangle2D& t);
/// Its corners in space, as (s, t, h).
std::vector<Vector3<double>> in_space(const Polygon2D& polygon);
/// Twice the signed area.
double turn(const Triangle2D& t);
/// Not below the true area, unless that is lost in the corners' rounding.
double area(const Triangle2D& t);
Point2D mix(const Point2D& a, const Point2D& b, double f);
Point2D centroid(const Triangle2D& t);
/// The largest distance of a corner from the centroid, rounded up.
double reach(const Triangle2D& t);
double distance(const Point2D& a, const Point2D& b);
/// The point of a triangle that is nearest to another.
Point2D nearest_in(const Triangle2D& t, const Point2D& p);
/// The point of the side from a to b that is nearest to p, in space.
Vector3<double> nearest_on_side(const Vector3<double>& a, const Vector3<double>& b, const Vector3<double>& p);

/// Along the line or the chord of the conic on which an undecided determinant vanishes, where that cuts the triangle
/// once; else in four.
std::vector<Triangle2D> cut(const Triangle2D& t, const std::optional<UndecidedSign>& event);
/// At most the area by which the parts and the whole may differ, for the new corners are rounded.
double misfit_of_cut(const Triangle2D& t);

}  // namespace cob::radiosity
