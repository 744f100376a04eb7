/// \file
/// Sheets in one plane (SPEC 8, choice 9): which polygons lie on top of which.
#pragma once

#include "cob/candidates.hpp"
#include "cob/scene.hpp"

#include <array>
#include <vector>

namespace cob::radiosity {

/// The planar polygons that lie in the same plane as the given one, face the same way, have bounds that meet its
/// own, and are smaller in area, or equal and higher in number: what they cover of it neither sends nor receives.
/// Ascending. None where the polygon is not planar.
std::vector<PolygonId> sheets_on_top(const Scene& scene, PolygonId polygon, const CandidateSource& candidates);

/// xmin, ymin, zmin, xmax, ymax, zmax.
std::array<double, 6> bounds_of_polygon(const Scene& scene, PolygonId polygon);

}  // namespace cob::radiosity
