/// \file
/// Where on a receiver's plane an occluder may hide some of a light, in binary64.
#pragma once

#include "radiosity/receiver_frame.hpp"

#include <optional>
#include <vector>

namespace cob::radiosity {

/// Counter-clockwise, convex.
using Polygon2D = std::vector<Point2D>;

/// The penumbra of a convex occluder: the hull of the shadows that its corners cast from the light's corners, all in
/// front of the plane as (s, t, h). From outside all of the light is seen past it. Nothing where it has no end, for the
/// occluder reaches as high as the light.
std::optional<Polygon2D> penumbra(const std::vector<Vector3<double>>& light,
                                  const std::vector<Vector3<double>>& occluder);

/// The triangle, its corners counter-clockwise.
Polygon2D left_around(const Triangle2D& triangle);
double area(const Polygon2D& convex);

/// What of a triangle lies in a convex polygon.
Polygon2D common_part(const Triangle2D& triangle, const Polygon2D& convex);

}  // namespace cob::radiosity
