/// \file
/// Boxes aimed at the degenerate. By kind:
///   seam      margin 0 over a whole root: the sides stand on the polygon's sides, and so do its neighbours
///   plane     over a root without own polygon, either side up: the polygon itself lies in the base's plane
///   side      the margin puts a side exactly through a vertex of a polygon nearby (a fraction where it must)
///   side-ulp  the margin nearest to that from below or above
///   top       the height puts the top exactly through such a vertex (where that height is rational)
///   top-ulp   the height nearest to that from below or above
///   far       over the root blown up 2^k times about a corner, k up to 40: corners far from the origin
///   small     over the root shrunk 2^k times about a corner
/// A kind that cannot be made here (in a snapped set, or where nothing is near) gives way to `plane`.
#pragma once

#include "golden/questions.hpp"

namespace cob {

/// Names of the kinds.
std::vector<std::string> hard_box_kinds();
/// A question of the kind of this index.
BoxTask hard_box(const Questions& questions, std::size_t kind, Dice dice);

}  // namespace cob
