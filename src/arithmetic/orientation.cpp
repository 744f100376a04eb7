#include "arithmetic/orientation.hpp"

#include <algorithm>
#include <cmath>

namespace cob {
namespace {

// Filters. With u = 2^-53, x, y and z the largest differences along an axis, and every difference rounded once: a
// term of the determinant of order two carries at most 4 roundings, one of order three 8 (three differences, two
// products, three sums), so that the computed determinants are off by at most 4 u (2 x y) and 8 u (6 x y z), up to
// terms of order u^2, which the bounds below leave room for. The limits keep every product far from overflow, and
// what underflow loses far below the bound.
constexpr double unit = 0x1p-53;
constexpr double bound2 = 8.5 * unit, bound3 = 49 * unit;
constexpr double least2 = 0x1p-450, greatest2 = 0x1p500;
constexpr double least3 = 0x1p-300, greatest3 = 0x1p330;

Sign exact_orientation(const Point2& a, const Point2& b, const Point2& c) {
    const Rational ax(a.x), ay(a.y);
    return sign_of(Rational((Rational(b.x) - ax) * (Rational(c.y) - ay) - (Rational(b.y) - ay) * (Rational(c.x) - ax)));
}

Sign exact_orientation(const Point& a, const Point& b, const Point& c, const Point& d) {
    const RationalPoint origin = to_rational(a);
    return sign_of(dot(cross(to_rational(b) - origin, to_rational(c) - origin), to_rational(d) - origin));
}

}  // namespace

Sign orientation(const Point2& a, const Point2& b, const Point2& c) {
    const double bx = b.x - a.x, by = b.y - a.y, cx = c.x - a.x, cy = c.y - a.y;
    const double x = std::max(std::abs(bx), std::abs(cx)), y = std::max(std::abs(by), std::abs(cy));
    if (x == 0 || y == 0) return Sign::zero;
    if (std::min(x, y) > least2 && std::max(x, y) < greatest2) {
        const double determinant = bx * cy - by * cx, bound = bound2 * x * y;
        if (determinant > bound) return Sign::positive;
        if (determinant < -bound) return Sign::negative;
    }
    return exact_orientation(a, b, c);
}

Sign orientation(const Point& a, const Point& b, const Point& c, const Point& d) {
    const Point p = b - a, q = c - a, r = d - a;
    const auto largest = [&](int axis) { return std::max({std::abs(p[axis]), std::abs(q[axis]), std::abs(r[axis])}); };
    const double x = largest(0), y = largest(1), z = largest(2);
    if (x == 0 || y == 0 || z == 0) return Sign::zero;
    if (std::min({x, y, z}) > least3 && std::max({x, y, z}) < greatest3) {
        const double determinant = dot(cross(p, q), r), bound = bound3 * x * y * z;
        if (determinant > bound) return Sign::positive;
        if (determinant < -bound) return Sign::negative;
    }
    return exact_orientation(a, b, c, d);
}

}  // namespace cob
