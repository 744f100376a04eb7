/// \file
/// contour.hpp's double contour integral, certified: the outer integral by Taylor polynomials with Lagrange's remainder
/// over panels, bisected towards where sides come near to each other.
#pragma once

#include "radiosity/cell_view.hpp"

#include <vector>

namespace cob::radiosity {

/// Encloses A_a F_ab of two polygons, each wholly in front of the other; touching is fine. To about 1e-12 where their
/// size and distance are about 1.
Interval certified_mutual_flux(const std::vector<IntervalPoint>& a, const std::vector<IntervalPoint>& b);

}  // namespace cob::radiosity
