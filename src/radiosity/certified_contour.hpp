/// \file
/// contour.hpp's double contour integral, certified: the outer integral by Taylor polynomials with Lagrange's remainder
/// over panels, bisected towards where sides come near to each other.
#pragma once

#include "radiosity/pair_shapes.hpp"

#include <vector>

namespace cob::radiosity {

/// Encloses A_a F_ab of two polygons, each wholly in front of the other; touching is fine. Not much wider than `width`
/// where rounding, about 1e-12 for a size and distance of 1, permits.
Interval certified_mutual_flux(const std::vector<IntervalPoint>& a, const std::vector<IntervalPoint>& b, double width);

}  // namespace cob::radiosity
