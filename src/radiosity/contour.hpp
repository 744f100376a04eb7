/// \file
/// Unobstructed form factor between two polygons in closed form but for one integral over their sides:
///
///   A_a F_ab = 1/(2 pi) sum over sides of a and b of (contour a)(contour b) ln r dx . dx'
///
/// (Stokes; Sparrow 1963, Schroeder and Hanrahan 1993). The inner integral along a side is elementary; the outer
/// one is analytic but for its ends where sides touch, and is bisected towards those.
#pragma once

#include "cob/arithmetic.hpp"

#include <vector>

namespace cob::radiosity {

/// An integral and how far it may be off.
struct Integral {
    double value = 0, error = 0;
};

/// A_a F_ab of two convex polygons, each wholly in front of the other (touching is fine), corners counter-clockwise
/// as seen, relative to a common origin near them. In squared units of length.
Integral mutual_flux(const std::vector<Vector3<double>>& a, const std::vector<Vector3<double>>& b);

}  // namespace cob::radiosity
