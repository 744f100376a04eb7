/// \file
/// Form factor from a point to a polygon in closed form (Lambert 1760), on what lies in front of both.
#pragma once

#include "cob/arithmetic.hpp"

namespace cob {

/// A form factor in [0, 1] and a bound of its distance to the true value.
struct FormFactor {
    double value = 0;
    double error = 0;  ///< Absolute; infinite where binary64 had not the range.
};

/// Share of the hemisphere over a differential receiver that a planar polygon fills, weighted by the cosine at the
/// receiver: the irradiance there, by Lambert's sum over the polygon's sides, is this times the polygon's exitance.
/// Only the part strictly in front of the receiver's plane counts, and nothing where the receiver does not lie in
/// front of the polygon (its loop runs counter-clockwise as seen from there). Nothing obstructs.
///
/// \param receiver  A point; not on the polygon's sides.
/// \param normal    Of the receiver, any length but zero.
/// \param polygon   At least 3 corners; any simple loop.
/// Evaluated in binary64; the error stays near 1e-15, which is much of a far or grazing polygon's form factor.
FormFactor form_factor(const Point& receiver, const Point& normal, View<Point> polygon);

/// The same within a relative error of 1e-12 (SPEC 8, photometric tables), however far, thin or grazing the
/// polygon: the sum is repeated with 50, 200 and 800 decimal digits until its error bound says so.
FormFactor precise_form_factor(const Point& receiver, const Point& normal, View<Point> polygon);

}  // namespace cob
