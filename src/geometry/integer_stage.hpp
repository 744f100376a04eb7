/// \file
/// The second stage: what the filter left open, in integers of 2, 4, 8 or 16 limbs. How many, the bits of the
/// coordinates say; where 16 are too few there is no answer, and fractions follow.
#pragma once

#include "geometry/prepared_box.hpp"
#include "geometry/separating_axes.hpp"

namespace cob {

/// A piece and a box within the filter's range.
struct IntegerQuery {
    const Box::Prepared& box;
    View<Point> corners;                ///< Of the piece, in order.
    const FramePiece<double>& rounded;  ///< The same in the filter's frame.
};

/// Looks at the axes in `open`; what it cannot decide stays in findings.undecided. False: cannot tell anything.
bool separate_in_integers(const IntegerQuery& query, AxisSet open, Findings& findings);

UncertainBool covers_in_integers(const IntegerQuery& query);

}  // namespace cob
