/// \file
/// Convex polygons cut by lines and planes, exactly.
#pragma once

#include "cob/arithmetic.hpp"

#include <vector>

namespace cob::naive {

/// A convex polygon, segment or point as its corners in order, each perhaps repeated; empty: nothing.
using Corners = std::vector<RationalPoint>;

/// Sutherland and Hodgman (Reentrant polygon clipping, 1974): the part in the closed half-space where the affine
/// function is not negative. What only touches it leaves the points that touch.
template <class Function>
Corners clip(const Corners& polygon, Function value) {
    Corners kept;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const RationalPoint &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
        const Rational at_a = value(a), at_b = value(b);
        if (at_a >= 0) kept.push_back(a);
        if ((at_a > 0 && at_b < 0) || (at_a < 0 && at_b > 0))
            kept.push_back(a + Rational(at_a / (at_a - at_b)) * (b - a));
    }
    return kept;
}

/// What the convex `taken` leaves of a convex polygon, both in the plane z = 0: convex polygons of positive area.
std::vector<Corners> subtract(const Corners& from, const Corners& taken);
/// What all of these leave.
std::vector<Corners> subtract_all(const Corners& from, const std::vector<Corners>& taken);

}  // namespace cob::naive
