/// \file
/// Triangles of a receiver and how they are cut.
#pragma once

#include "radiosity/cell_signs.hpp"

#include <vector>

namespace cob::radiosity {

/// Twice the signed area.
double turn(const Triangle2D& t);
/// Not below the true area, unless that is lost in the corners' rounding.
double area(const Triangle2D& t);
Point2D mix(const Point2D& a, const Point2D& b, double f);
Point2D centroid(const Triangle2D& t);
/// The largest distance of a corner from the centroid, rounded up.
double reach(const Triangle2D& t);

/// Along the line or the chord of the conic on which an undecided determinant vanishes, where that cuts the triangle
/// once; else in four.
std::vector<Triangle2D> cut(const Triangle2D& t, const std::optional<UndecidedSign>& event);
/// At most the area by which the parts and the whole may differ, for the new corners are rounded.
double misfit_of_cut(const Triangle2D& t);

}  // namespace cob::radiosity
