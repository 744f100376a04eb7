#include "cob/form_factor.hpp"

#include "radiosity/lambert_sum.hpp"

#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>

#include <algorithm>
#include <vector>

namespace cob {
namespace {

using radiosity::LambertSum;

constexpr double wanted_relative_error = 1e-12;

/// Binary exponent that brings every coordinate below 1 in absolute value.
int exponent_of(const Point& receiver, View<Point> polygon) {
    double largest = 0;
    const auto take = [&](const Point& p) {
        largest = std::max({largest, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
    };
    take(receiver);
    for (const Point& p : polygon) take(p);
    return largest > 0 ? std::ilogb(largest) + 1 : 0;
}

Point scaled(const Point& p, int exponent) {
    return {std::scalbn(p.x, -exponent), std::scalbn(p.y, -exponent), std::scalbn(p.z, -exponent)};
}

template <class T>
Vector3<T> unit(const Point& direction) {
    using std::sqrt;
    const int exponent = std::ilogb(std::max({std::fabs(direction.x), std::fabs(direction.y), std::fabs(direction.z)}));
    const Point safe = scaled(direction, exponent);
    const Vector3<T> d{T(safe.x), T(safe.y), T(safe.z)};
    return (T(1) / sqrt(dot(d, d))) * d;
}

/// The sum over the part in front of the receiver, in the number type T. The coordinates come scaled.
template <class T>
LambertSum<T> sum_in_front(const Vector3<T>& receiver, const Vector3<T>& n, View<Point> polygon, int exponent) {
    const int count = static_cast<int>(polygon.size());
    std::vector<Vector3<T>> r, clipped(2 * polygon.size());
    r.reserve(polygon.size());
    for (const Point& corner : polygon) {
        const Point s = scaled(corner, exponent);
        r.push_back(Vector3<T>{T(s.x), T(s.y), T(s.z)} - receiver);
    }
    const int kept = radiosity::clip_to_horizon(n, r.data(), count, clipped.data());
    return radiosity::lambert_sum(n, clipped.data(), kept);
}

template <class T>
FormFactor evaluate(const Point& receiver, const Point& normal, View<Point> polygon) {
    const int exponent = exponent_of(receiver, polygon);
    const Point x = scaled(receiver, exponent);
    const LambertSum<T> sum = sum_in_front(Vector3<T>{T(x.x), T(x.y), T(x.z)}, unit<T>(normal), polygon, exponent);
    const T pi2 = 2 * boost::math::constants::pi<T>();
    const T value = sum.value / pi2, error = radiosity::lambert_error<T>() * sum.condition / pi2;
    // Behind the polygon the sum is negative and nothing is seen.
    if (value < -error) return {0, 0};
    return {static_cast<double>(value > 0 ? value : T(0)), static_cast<double>(error)};
}

bool good(const FormFactor& result) {
    return result.error <= wanted_relative_error / 2 * result.value;
}

template <unsigned digits>
using Digits =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<digits>, boost::multiprecision::et_off>;

}  // namespace

FormFactor form_factor(const Point& receiver, const Point& normal, View<Point> polygon) {
    FormFactor result = evaluate<double>(receiver, normal, polygon);
    if (!(result.error >= 0)) result.error = std::numeric_limits<double>::infinity();  // a NaN says nothing
    result.value = std::isfinite(result.value) ? std::min(result.value, 1.0) : 0.0;
    return result;
}

FormFactor precise_form_factor(const Point& receiver, const Point& normal, View<Point> polygon) {
    FormFactor result = form_factor(receiver, normal, polygon);
    if (!good(result)) result = evaluate<Digits<50>>(receiver, normal, polygon);
    if (!good(result)) result = evaluate<Digits<200>>(receiver, normal, polygon);
    if (!good(result)) result = evaluate<Digits<800>>(receiver, normal, polygon);
    // Still undecided: zero, the receiver lies in the polygon's plane.
    if (!good(result)) return {0.0, std::max(result.value, result.error)};
    result.error += result.value * std::numeric_limits<double>::epsilon();  // of the conversion to binary64
    return result;
}

}  // namespace cob
