/// \file
/// Lambert's formula: what a Lambertian receiver sees of a cone (Lambert 1760; SPEC 8).
///
///   F = 1/(2 pi) sum over the sides k of theta_k (n . m_k / |m_k|)
///
/// with n the receiver's unit normal, m_k the inward normal of the plane through the viewpoint and side k, and
/// theta_k the angle of the side. One template for all number types.
#pragma once

#include "cob/arithmetic.hpp"

#include <boost/math/constants/constants.hpp>

#include <cmath>
#include <vector>

namespace cob::radiosity {

/// A cone in numbers: side k spans ray k - 1 to ray k; nothing is normalised.
template <class T>
struct ConeInNumbers {
    std::vector<Vector3<T>> inward, rays;
};

template <class T>
T length(const Vector3<T>& v) {
    using std::sqrt;
    return sqrt(dot(v, v));
}

/// The angle between two directions, in [0, pi].
template <class T>
T angle(const Vector3<T>& a, const Vector3<T>& b) {
    using std::atan2;
    return atan2(length(cross(a, b)), dot(a, b));
}

/// Form factor from the viewpoint to the cone, which lies in front of the receiver.
template <class T>
T lambert(const Vector3<T>& normal, const ConeInNumbers<T>& cone) {
    const std::size_t n = cone.rays.size();
    T sum = 0;
    for (std::size_t k = 0; k < n; ++k)
        sum += angle(cone.rays[(k + n - 1) % n], cone.rays[k]) * dot(normal, cone.inward[k]) / length(cone.inward[k]);
    return sum / (2 * boost::math::constants::pi<T>() * length(normal));
}

/// Solid angle of the cone: its spherical excess, by triangles (Van Oosterom and Strackee 1983).
template <class T>
T solid_angle(const ConeInNumbers<T>& cone) {
    using std::atan2;
    T sum = 0;
    for (std::size_t k = 2; k < cone.rays.size(); ++k) {
        const Vector3<T>&a = cone.rays[0], &b = cone.rays[k - 1], &c = cone.rays[k];
        const T la = length(a), lb = length(b), lc = length(c);
        sum += 2 * atan2(dot(a, cross(b, c)), la * lb * lc + dot(a, b) * lc + dot(a, c) * lb + dot(b, c) * la);
    }
    return sum;
}

}  // namespace cob::radiosity
