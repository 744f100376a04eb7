/// \file
/// Certified integrals of the form factor to what is seen of a light over a triangle of the receiver, where the
/// visible region has one structure: Lambert's sum over its contour as a Taylor polynomial with Lagrange's remainder,
/// both in interval arithmetic.
#pragma once

#include "radiosity/cell_view.hpp"

namespace cob::radiosity {

/// Integral over the cell of the form factor from its points to the contour's inside. Unknown where the cell comes too
/// near to a side of the contour. Slivers are not paid for.
Interval flux_over_cell(const PairShapes& shapes, const Triangle2D& cell, const Contour& contour);

/// The range of the form factor over the cell, in [0, 1].
Interval range_over_cell(const PairShapes& shapes, const Triangle2D& cell, const Contour& contour);

/// The form factor from a point of the cell in binary64, not certified.
double form_factor_at(const PairShapes& shapes, const Point2D& where, const Contour& contour);

/// At most how much the form factor to what is seen changes per length, wherever in the cell: the border of what is
/// seen, as directions, moves by at most 1 / distance, and a side's part of it is as long as the angle under which the
/// side is seen. Whatever the structure is.
struct Motion {
    double of_all_sides = 0;
    double of_one_side = 0;    ///< The most that one of them contributes.
    double of_directions = 0;  ///< In radians per length, the most by which one of them moves.
};
Motion motion_over_cell(const PairShapes& shapes, const Triangle2D& cell, const std::vector<CornerLoop>& lights,
                        const std::vector<const CornerLoop*>& occluders);

}  // namespace cob::radiosity
