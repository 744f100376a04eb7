/// \file
/// What photometry in binary64 can hold.
#pragma once

#include "cob/scene.hpp"

namespace cob::radiosity {

/// Refuses, with an InputError that names file and line, what leaves binary64's range once light is multiplied by
/// areas: a light above 1e300 W/m2, and a polygon whose area, in square units (mesh.hpp), is below 1e-280.
void check_photometric_range(const Scene& scene);

/// The second of these alone: `area` is the polygon's, in units in which the scene is about 1 in size.
void refuse_too_small(const Scene& scene, PolygonId polygon, double area);

/// Refuses what no radiosity is computed of: the same, no light at all, and a material that reflects everything.
void check_solvable(const Scene& scene);

}  // namespace cob::radiosity
