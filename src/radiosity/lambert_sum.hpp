/// \file
/// Lambert's sum over the sides of a polygon: one formula for every number type.
///
/// Letters: r_k from the receiver to corner k; n the receiver's unit normal; theta_k the angle between r_k and
/// r_(k+1); c_k = r_(k+1) x r_k, normal of the plane through receiver and side.
///     F = 1/(2 pi) sum_k theta_k n.c_k / |c_k|
#pragma once

#include "cob/arithmetic.hpp"

#include <cmath>
#include <limits>

namespace cob::radiosity {

/// 2 pi F, positive where the loop runs counter-clockwise as seen from the receiver, and what its error grows with:
/// the value is within condition * lambert_error<T>() of the truth.
template <class T>
struct LambertSum {
    T value{0};
    T condition{0};
};

/// A side's term is off by at most 40 units of rounding times theta / sin(theta): c_k has an absolute error of 6
/// units times |r_k||r_(k+1)|, so its direction one of 6 sqrt(3) / sin(theta) and the angle one of about 10; the
/// differences r_k add 2 more each. (A small angle brings theta / sin(theta) near 1, not near 0: the bound is
/// absolute, and far polygons lose relative accuracy.)
template <class T>
T lambert_error() {
    return T(40) * (std::numeric_limits<T>::epsilon() / 2);
}

/// Clips the loop r to n.r > 0 into out (room for 2 count corners); returns how many remain. Where the horizon is
/// crossed the integrand is zero, so the rounding of the crossing point does not matter to first order.
template <class T>
int clip_to_horizon(const Vector3<T>& n, const Vector3<T>* r, int count, Vector3<T>* out) {
    int kept = 0;
    Vector3<T> before = r[count - 1];
    T height_before = dot(n, before);
    for (int k = 0; k < count; ++k) {
        const T height = dot(n, r[k]);
        if ((height > 0) != (height_before > 0)) {
            const T t = height_before / (height_before - height);
            out[kept++] = before + t * (r[k] - before);
        }
        if (height > 0) out[kept++] = r[k];
        before = r[k];
        height_before = height;
    }
    return kept;
}

template <class T>
LambertSum<T> lambert_sum(const Vector3<T>& n, const Vector3<T>* r, int count) {
    using std::atan2;
    using std::sqrt;
    LambertSum<T> sum;
    for (int k = 0; k < count; ++k) {
        const Vector3<T>& a = r[k];
        const Vector3<T>& b = r[k + 1 < count ? k + 1 : 0];
        const Vector3<T> c = cross(b, a);  // towards the receiver's front where the loop runs counter-clockwise
        const T sine = sqrt(dot(c, c)), cosine = dot(a, b);  // both times |a||b|
        if (!(sine > 0)) {
            // A side seen end on adds nothing; one that runs through the receiver has no normal.
            if (cosine < 0) sum.condition = std::numeric_limits<T>::infinity();
            continue;
        }
        const T theta = atan2(sine, cosine);
        sum.value += theta * dot(n, c) / sine;
        sum.condition += theta * sqrt(dot(a, a) * dot(b, b)) / sine;
    }
    return sum;
}

}  // namespace cob::radiosity
