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

    Integral& operator+=(const Integral& other) {
        value += other.value, error += other.error;
        return *this;
    }
    Integral& operator-=(const Integral& other) {
        value -= other.value, error += other.error;
        return *this;
    }
};

/// A_a F_ab of two convex polygons, each wholly in front of the other (touching is fine), corners counter-clockwise
/// as seen, relative to a common origin near them. In squared units of length. To rounding, or where less will do until
/// the error is below `may_be_off`.
Integral mutual_flux(const std::vector<Vector3<double>>& a, const std::vector<Vector3<double>>& b,
                     double may_be_off = 0);

/// The share of the same that the side of b from p to q has: the integral over a of the angle that the side subtends
/// times the cosine between the receiver's normal and that of the side's plane, over 2 pi.
Integral mutual_flux_of_side(const std::vector<Vector3<double>>& a, const Vector3<double>& p, const Vector3<double>& q,
                             double may_be_off = 0);

}  // namespace cob::radiosity
