#include "radiosity/cell_flux.hpp"

#include "radiosity/cells.hpp"
#include "radiosity/taylor.hpp"

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace cob::radiosity {
namespace {

constexpr int order = 4;

/// Coordinates (u, v) on a triangle: centroid + u (corner 1 - corner 0) + v (corner 2 - corner 0).
template <class T>
struct Place {
    T s, t;
};

Interval side_of(double from, double to) {
    return Interval(to) - Interval(from);
}

/// The point as a polynomial in (u, v) around the centroid or around any point of the cell.
template <int degree>
Place<Taylor<2, degree>> place_in(const Triangle2D& c, bool anywhere) {
    const auto base = [&](double a, double b, double d) {
        if (anywhere) return Interval(std::min({a, b, d}), std::max({a, b, d}));
        return (Interval(a) + Interval(b) + Interval(d)) / Interval(3);
    };
    Place<Taylor<2, degree>> place{base(c[0].s, c[1].s, c[2].s), base(c[0].t, c[1].t, c[2].t)};
    if constexpr (degree > 0)
        for (int j = 0; j < 2; ++j) {
            const Point2D& to = c[static_cast<std::size_t>(j + 1)];
            place.s.set(1, j, side_of(c[0].s, to.s));
            place.t.set(1, j, side_of(c[0].t, to.t));
        }
    return place;
}

template <class T>
T number(const Interval& value) {
    if constexpr (std::is_floating_point_v<T>)
        return value.middle();
    else
        return T(value);
}

/// By a power of two near 1 in size where products of several would underflow.
template <class T>
Vector3<T> without_underflow(const Vector3<T>& v) {
    if constexpr (std::is_floating_point_v<T>) {
        const T size = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
        if (size > 0 && size < T(0x1p-100)) return std::ldexp(T(1), -std::max(std::ilogb(size), -1000)) * v;
    }
    return v;
}

/// Lambert's sum (lambert.hpp) over the contour; arcs are angles with a sign, so that they may shrink to nothing.
template <class T>
T form_factor_of(const PairShapes& shapes, const Contour& contour, const Place<T>& place) {
    using std::atan2, std::sqrt;
    using Vector = Vector3<T>;
    const auto towards = [&](VertexId v) {
        const IntervalPoint& corner = shapes.corner(v);
        return Vector{number<T>(corner.x) - place.s, number<T>(corner.y) - place.t, number<T>(corner.z)};
    };
    boost::container::small_vector<Vector, std::is_floating_point_v<T> ? 24 : 1> normals;
    for (const auto& [a, b] : contour.sides) normals.push_back(without_underflow(cross(towards(a), towards(b))));
    const auto normal = [&](std::int32_t side) -> const Vector& { return normals[static_cast<std::size_t>(side)]; };
    const auto direction = [&](const ContourRay& ray) {
        if (ray.vertex >= 0) return towards(ray.vertex);
        const Vector d = cross(normal(ray.first.index), normal(ray.second.index));
        return ray.first.flipped != ray.second.flipped ? -d : d;
    };
    T sum(0.0);
    for (const ContourArc& arc : contour.arcs) {
        const Vector &m = normal(arc.side), a = direction(arc.from), b = direction(arc.to);
        const T length = sqrt(dot(m, m));
        if constexpr (std::is_floating_point_v<T>)
            if (!(length > 0)) continue;  // a side seen end on
        sum = sum + m.z / length * atan2(dot(m, cross(a, b)) / length, dot(a, b));
    }
    return sum / number<T>(Interval(2) * pi_interval());
}

/// Integral of u^p v^q over the triangle in (u, v), whose area is 1/2; exact.
Rational moment(int p, int q) {
    const auto factorial = [](int n) {
        Rational f = 1;
        for (int k = 2; k <= n; ++k) f *= k;
        return f;
    };
    const auto term = [&](int n, int i) {  // of (l - 1/3)^n at l^i
        Rational c = factorial(n) / (factorial(i) * factorial(n - i));
        for (int k = i; k < n; ++k) c *= Rational(-1, 3);
        return c;
    };
    Rational sum = 0;
    for (int i = 0; i <= p; ++i)
        for (int j = 0; j <= q; ++j)
            sum += term(p, i) * term(q, j) * factorial(i) * factorial(j) / factorial(i + j + 2);
    return sum;
}

struct Moments {
    Taylor<2, order> of;            ///< Integrals of u^p v^q,
    Taylor<2, order> of_magnitude;  ///< and, of the highest degree, bounds of those of |u^p v^q|.

    Moments() {
        for (int k = 0; k <= order; ++k)
            for (int j = 0; j <= k; ++j) of.set(k, j, Interval(to_nearest(moment(k - j, j))) * around_one);
        for (int j = 0; j <= order; ++j)  // Cauchy and Schwarz
            of_magnitude.set(order, j,
                             sqrt(Interval(to_nearest(moment(2 * (order - j), 0))) * around_one *
                                  Interval(to_nearest(moment(0, 2 * j))) * around_one));
    }

private:
    static inline const Interval around_one{1 - 0x1p-52, 1 + 0x1p-52};
};

}  // namespace

Interval flux_over_cell(const PairShapes& shapes, const Triangle2D& cell, const Contour& contour) {
    if (contour.arcs.empty()) return 0;
    static const Moments moments;
    const auto middle = form_factor_of(shapes, contour, place_in<order>(cell, false));
    const auto all = form_factor_of(shapes, contour, place_in<order>(cell, true));
    Interval sum = 0;
    for (int k = 0; k < order; ++k)
        for (int j = 0; j <= k; ++j) sum += middle.at(k, j) * moments.of.at(k, j);
    for (int j = 0; j <= order; ++j) {
        const Interval& c = all.at(order, j);
        const double centre = c.middle();
        const Interval off = c - Interval(centre);
        sum += Interval(centre) * moments.of.at(order, j) +
               Interval(-1, 1) * Interval(off.magnitude()) * moments.of_magnitude.at(order, j);
    }
    const Interval doubled_area = side_of(cell[0].s, cell[1].s) * side_of(cell[0].t, cell[2].t) -
                                  side_of(cell[0].s, cell[2].s) * side_of(cell[0].t, cell[1].t);
    const Interval flux = sum * (doubled_area.middle() < 0 ? -doubled_area : doubled_area);
    return flux.is_bounded() ? flux : Interval::unknown();
}

Interval range_over_cell(const PairShapes& shapes, const Triangle2D& cell, const Contour& contour) {
    if (contour.arcs.empty()) return 0;
    const Interval range = form_factor_of(shapes, contour, place_in<0>(cell, true)).at(0);
    if (!range.is_bounded()) return {0, 1};
    return {std::clamp(range.low(), 0.0, 1.0), std::clamp(range.high(), 0.0, 1.0)};
}

double form_factor_at(const PairShapes& shapes, const Point2D& where, const Contour& contour) {
    return form_factor_of<double>(shapes, contour, {where.s, where.t});
}

Motion motion_over_cell(const PairShapes& shapes, const Triangle2D& cell, const std::vector<CornerLoop>& lights,
                        const std::vector<const CornerLoop*>& occluders) {
    constexpr double up = 1 + 1e-9;  // pays for all roundings here
    const Point2D centre = centroid(cell);
    const double radius = reach(cell);
    Motion motion;
    const auto add = [&](const CornerLoop& loop) {
        for (std::size_t k = 0; k < loop.corners.size(); ++k) {
            const auto at = [&](VertexId v) {
                const IntervalPoint& p = shapes.corner(v);
                return Vector3<double>{p.x.middle() - centre.s, p.y.middle() - centre.t, p.z.middle()};
            };
            const Vector3<double> a = at(loop.corners[k]), b = at(loop.corners[(k + 1) % loop.corners.size()]),
                                  d = b - a;
            const double length = std::sqrt(dot(d, d));
            const Vector3<double> nearest = nearest_on_side(a, b, {0, 0, 0});
            const double distance = (std::sqrt(dot(nearest, nearest)) - 1e-12) / up - radius;
            if (!(distance > 0)) {
                motion = {HUGE_VAL, HUGE_VAL, HUGE_VAL};
                return;
            }
            const double angle = std::min(pi_low * up, length * up / distance);
            const double cosine = std::min(1.0, (std::max(a.z, b.z) + 1e-12) * up / distance);
            const double change = angle * cosine / distance / pi_low * up;
            motion.of_all_sides += change * up;
            motion.of_one_side = std::max(motion.of_one_side, change);
            motion.of_directions = std::max(motion.of_directions, up / distance);
        }
    };
    for (const CornerLoop& light : lights) add(light);
    for (const CornerLoop* occluder : occluders) add(*occluder);
    return motion;
}

}  // namespace cob::radiosity
