#include "radiosity/cell_view.hpp"

#include "radiosity/cone_algebra.hpp"

#include <algorithm>
#include <cmath>

namespace cob::radiosity {
namespace {

constexpr double negligible = 0x1p-34;  ///< What is below it, against the largest, is a sliver beside a rounded cut.

Interval enclosure(const Rational& value) {
    const double nearest = to_nearest(value);
    if (value == Rational(nearest)) return nearest;
    return {std::nextafter(nearest, -HUGE_VAL), std::nextafter(nearest, HUGE_VAL)};
}

IntervalPoint enclosure(const RationalPoint& point) {
    return {enclosure(point.x), enclosure(point.y), enclosure(point.z)};
}

/// To a length of 1, whatever its length.
IntervalPoint unit(const RationalPoint& v) {
    const IntervalPoint scaled = enclosure(Rational(1 / largest_component(v)) * v);
    return (Interval(1) / sqrt(square(scaled.x) + square(scaled.y) + square(scaled.z))) * scaled;
}

Interval determinant(const IntervalPoint& a, const IntervalPoint& b, const IntervalPoint& c) {
    return dot(cross(a, b), c);
}

bool zero_inside(const Interval& value) {
    return value.low() <= 0 && value.high() >= 0;
}

/// The sign of a polynomial on a triangle from its Bernstein coefficients, those at the corners first, all but a
/// sliver: where a corner's is p and none is below -q, the polynomial is negative only where l^degree p < q, l the
/// corner's barycentric coordinate.
template <std::size_t n>
std::optional<Sign> sign_of_coefficients(const std::array<Interval, n>& c, double& sliver) {
    for (const Sign sign : {Sign::positive, Sign::negative}) {
        const auto low = [&](std::size_t k) { return sign == Sign::positive ? c[k].low() : -c[k].high(); };
        double p = 0, q = 0;
        for (std::size_t k = 0; k < n; ++k) {
            if (k < 3) p = std::max(p, low(k));
            q = std::max(q, -low(k));
            if (!(low(k) >= -HUGE_VAL)) return std::nullopt;
        }
        if (q > 0 && !(q <= negligible * p)) continue;
        if (q == 0 && p == 0 && std::all_of(c.begin(), c.end(), zero_inside)) return std::nullopt;
        // The strip 0 <= l < e has a share of at most 2 e.
        if (q > 0) sliver += 2.01 * (n == 3 ? q / p : std::sqrt(q / p));
        return sign;
    }
    return std::nullopt;
}

}  // namespace

// ------------------------------------------------------------------------------------------------- the shapes

PairShapes::PairShapes(const ConvexPolygon& receiver, double scale) : receiver_(receiver), scale_(scale) {
    const RationalPoint normal = area_vector(receiver), side = receiver[1] - receiver[0];
    axes_ = {unit(side), unit(cob::cross(normal, side)), unit(normal)};
    std::size_t third = 2;
    while (cob::cross(side, receiver[third] - receiver[0]) == RationalPoint{}) ++third;
    span_ = {receiver[0], receiver[1], receiver[third]};
}

IntervalPoint PairShapes::local(const RationalPoint& point) const {
    const RationalPoint offset = Rational(scale_) * (point - receiver_[0]);
    const IntervalPoint relative = enclosure(offset);
    IntervalPoint result{dot(relative, axes_[0]), dot(relative, axes_[1]), dot(relative, axes_[2])};
    // What lies in the plane does so exactly.
    if (cob::dot(area_vector(receiver_), offset) == 0) result.z = Interval(0);
    return result;
}

CornerLoop PairShapes::add(const ConvexPolygon& polygon) {
    CornerLoop loop;
    const std::size_t n = polygon.size();
    for (std::size_t k = 0; k < n; ++k) {
        const RationalPoint &before = polygon[(k + n - 1) % n], &corner = polygon[k], &after = polygon[(k + 1) % n];
        if (cob::cross(corner - before, after - corner) == RationalPoint{}) continue;
        const auto [known, is_new] = known_.try_emplace(corner, static_cast<VertexId>(exact_.size()));
        if (is_new) exact_.push_back(corner), corners_.push_back(local(corner));
        loop.push_back(known->second);
    }
    return loop;
}

bool PairShapes::always_in_plane(VertexId a, VertexId b, VertexId v) const {
    std::array<VertexId, 6> key{a, b, v, -1, -1, -1};
    std::sort(key.begin(), key.begin() + 3);
    const auto [known, is_new] = degenerate_.try_emplace(key, true);
    if (!is_new) return known->second;
    const auto at = [&](VertexId id) { return exact_[static_cast<std::size_t>(id)]; };
    // Linear: three points that span the plane decide.
    for (const RationalPoint& x : span_)
        if (cob::dot(cob::cross(at(a) - x, at(b) - x), at(v) - x) != 0) known->second = false;
    return known->second;
}

bool PairShapes::always_in_line(const std::array<VertexId, 6>& sides) const {
    const auto [known, is_new] = degenerate_.try_emplace(sides, true);
    if (!is_new) return known->second;
    // Quadratic: six points decide, the corners and the middles of the sides of a triangle.
    for (std::size_t i = 0; i < 3 && known->second; ++i)
        for (std::size_t j = i; j < 3 && known->second; ++j) {
            const RationalPoint x = Rational(1, 2) * (span_[i] + span_[j]);
            const auto normal = [&](std::size_t k) {
                return cob::cross(exact_[static_cast<std::size_t>(sides[2 * k])] - x,
                                  exact_[static_cast<std::size_t>(sides[2 * k + 1])] - x);
            };
            if (cob::dot(normal(0), cob::cross(normal(1), normal(2))) != 0) known->second = false;
        }
    return known->second;
}

// ------------------------------------------------------------------------------------------------- the planes

IntervalPoint PlanesOverCell::towards(VertexId v, const Interval& s, const Interval& t) const {
    const IntervalPoint& corner = shapes_->corner(v);
    return {corner.x - s, corner.y - t, corner.z};
}

Sign PlanesOverCell::linear_sign(VertexId a, VertexId b, VertexId v, const IntervalPoint* normals) const {
    std::array<Interval, 3> values;
    for (std::size_t k = 0; k < 3; ++k)
        values[k] = dot(normals[k], towards(v, Interval(cell_[k].s), Interval(cell_[k].t)));
    if (const auto sign = sign_of_coefficients(values, sliver_)) return *sign;
    if (std::all_of(values.begin(), values.end(), zero_inside) && shapes_->always_in_plane(a, b, v)) return Sign::zero;
    throw UndecidedSign{true, {values[0].middle(), values[1].middle(), values[2].middle()}};
}

Sign PlanesOverCell::linear_sign(VertexId a, VertexId b, VertexId v) const {
    std::array<IntervalPoint, 3> normals;
    for (std::size_t k = 0; k < 3; ++k) normals[k] = normal(a, b, Interval(cell_[k].s), Interval(cell_[k].t));
    return linear_sign(a, b, v, normals.data());
}

Sign PlanesOverCell::quadratic_sign(std::int32_t p, std::int32_t q, std::int32_t r) const {
    std::array<Interval, 6> values;
    for (std::size_t k = 0; k < 6; ++k) values[k] = determinant(at(p).normals[k], at(q).normals[k], at(r).normals[k]);
    for (std::size_t k = 0; k < 3; ++k)
        values[k + 3] = Interval(2) * values[k + 3] - Interval(0.5) * (values[k] + values[(k + 1) % 3]);
    if (const auto sign = sign_of_coefficients(values, sliver_)) return *sign;
    if (std::all_of(values.begin(), values.end(), zero_inside)) {
        const auto &e = edge(p), &f = edge(q), &g = edge(r);
        if (shapes_->always_in_line({e[0], e[1], f[0], f[1], g[0], g[1]})) return Sign::zero;
    }
    throw UndecidedSign{false, {values[0].middle(), values[1].middle(), values[2].middle()}};
}

PlaneRef PlanesOverCell::through_edge(VertexId a, VertexId b) {
    const bool flipped = a > b;
    if (flipped) std::swap(a, b);
    const auto [known, is_new] = known_.try_emplace({a, b}, plane_count());
    if (is_new) {
        Plane plane{{a, b}, {}};
        for (std::size_t k = 0; k < 3; ++k) {
            const Point2D &x = cell_[k], &y = cell_[(k + 1) % 3];
            plane.normals[k] = normal(a, b, Interval(x.s), Interval(x.t));
            plane.normals[k + 3] = normal(a, b, Interval(0.5) * (Interval(x.s) + Interval(y.s)),
                                          Interval(0.5) * (Interval(x.t) + Interval(y.t)));
        }
        planes_.push_back(plane);
    }
    return {known->second, flipped};
}

Ray PlanesOverCell::meet(PlaneRef first, PlaneRef second) const {
    Ray ray;
    ray.first = first, ray.second = second;
    const auto &e = edge(first.index), &f = edge(second.index);
    for (std::size_t i = 0; i < 2; ++i)
        for (std::size_t j = 0; j < 2; ++j)
            if (e[i] == f[j]) {
                ray.vertex = e[i];
                // (u x v) x (u' x v) = [u, u', v] v, and each plane may have v first or be flipped.
                bool opposite = linear_sign(e[1 - i], f[1 - j], e[i]) == Sign::negative;
                for (bool turn : {i == 0, j == 0, first.flipped, second.flipped}) opposite = opposite != turn;
                ray.opposite = opposite;
            }
    return ray;
}

Sign PlanesOverCell::side(PlaneRef plane, const Ray& ray) const {
    if (ray.first.index == plane.index || ray.second.index == plane.index) return Sign::zero;
    if (ray.vertex >= 0) {
        if (contains(plane, ray.vertex)) return Sign::zero;
        const auto& [a, b] = edge(plane.index);
        const Sign sign = linear_sign(a, b, ray.vertex, at(plane.index).normals.data());
        return plane.flipped != ray.opposite ? -sign : sign;
    }
    const Sign sign = quadratic_sign(plane.index, ray.first.index, ray.second.index);
    return (plane.flipped != ray.first.flipped) != ray.second.flipped ? -sign : sign;
}

bool PlanesOverCell::not_positive(PlaneRef plane, const Ray& ray) const {
    const double before = sliver_;
    try {
        return side(plane, ray) != Sign::positive;
    } catch (const UndecidedSign&) {
        sliver_ = before;
        return false;
    }
}

std::optional<Cone> PlanesOverCell::over(const CornerLoop& loop) {
    const Sign side = linear_sign(loop[0], loop[1], loop[2]);  // positive behind the polygon
    if (side == Sign::zero) return std::nullopt;
    const std::size_t n = loop.size();
    const auto corner = [&](std::size_t k) { return side == Sign::positive ? loop[k % n] : loop[n - 1 - k % n]; };
    Cone cone;
    for (std::size_t k = 0; k < n; ++k) cone.planes.push_back(through_edge(corner(k), corner(k + 1)));
    for (std::size_t k = 0; k < n; ++k)
        cone.rays.push_back({cone.planes[k], cone.planes[(k + 1) % n], corner(k + 1), false, {}});
    return cone;
}

/// The side of the plane through x and ab on which all of the other lies, if it is one.
std::optional<Sign> PlanesOverCell::outside_of(VertexId a, VertexId b, const CornerLoop& other) const {
    std::optional<Sign> common;
    for (VertexId v : other) {
        if (v == a || v == b) continue;
        const Sign sign = linear_sign(a, b, v);
        if (sign == Sign::zero) continue;
        if (common && *common != sign) return std::nullopt;
        common = sign;
    }
    return common;
}

bool PlanesOverCell::apart(const CornerLoop& one, const CornerLoop& other) {
    // A plane through x and a side that has the two on different sides.
    const double before = sliver_;
    for (const auto& [loop, against] : {std::pair{&one, &other}, std::pair{&other, &one}})
        for (std::size_t k = 0; k < loop->size(); ++k) {
            try {
                const VertexId a = (*loop)[k], b = (*loop)[(k + 1) % loop->size()];
                const auto own = outside_of(a, b, *loop);
                const auto others = own ? outside_of(a, b, *against) : std::nullopt;
                // No slivers: this is handed down to the cell's parts.
                if (own && others && *own != *others && sliver_ == before) return true;
            } catch (const UndecidedSign&) {
            }
            sliver_ = before;
        }
    return false;
}

// ------------------------------------------------------------------------------------------------ the contour

namespace {

/// A ray's name: its vertex, or the planes in which it lies.
std::array<std::int32_t, 3> name_of(const Ray& ray) {
    if (ray.vertex >= 0) return {ray.vertex, -1, -1};
    return {-1, std::min(ray.first.index, ray.second.index), std::max(ray.first.index, ray.second.index)};
}

/// Arcs of neighbouring cones on their common plane cancel: what is left are the ends.
struct Ends {
    std::map<std::array<std::int32_t, 3>, std::pair<Ray, int>> of_plane;

    void add(const Ray& ray, int count) {
        auto& end = of_plane.try_emplace(name_of(ray), ray, 0).first->second;
        end.second += count;
    }
};

}  // namespace

Contour visible_contour(const PairShapes& shapes, const Triangle2D& cell, const std::vector<CornerLoop>& lights,
                        const std::vector<const CornerLoop*>& occluders) {
    PlanesOverCell planes(shapes, cell);
    std::vector<Cone> shadows, visible;
    for (const CornerLoop* occluder : occluders)
        if (auto shadow = planes.over(*occluder)) shadows.push_back(std::move(*shadow));
    std::vector<const Cone*> pointers;
    for (const Cone& shadow : shadows) pointers.push_back(&shadow);
    for (const CornerLoop& light : lights)
        if (const auto cone = planes.over(light)) subtract(planes, *cone, pointers, visible);

    std::map<std::int32_t, Ends> ends;
    for (const Cone& cone : visible)
        for (std::size_t k = 0, n = cone.rays.size(); k < n; ++k) {
            Ends& of_plane = ends[cone.planes[k].index];
            of_plane.add(cone.rays[(k + n - 1) % n], -1);
            of_plane.add(cone.rays[k], 1);
        }
    Contour contour;
    for (auto& [plane, of_plane] : ends) {
        std::vector<Ray> from, to;
        for (const auto& [name, end] : of_plane.of_plane)
            (end.second < 0 ? from : to).insert((end.second < 0 ? from : to).end(), std::abs(end.second), end.first);
        if (from.empty()) continue;
        contour.planes.push_back({planes.edge(plane), {}});
        for (std::size_t k = 0; k < from.size(); ++k) contour.planes.back().arcs.push_back({from[k], to[k]});
    }
    for (std::int32_t plane = 0; plane < planes.plane_count(); ++plane) contour.edges.push_back(planes.edge(plane));
    contour.sliver = planes.sliver();
    return contour;
}

std::vector<const CornerLoop*> between(const PairShapes& shapes, const Triangle2D& cell,
                                       const std::vector<CornerLoop>& lights,
                                       const std::vector<const CornerLoop*>& occluders) {
    PlanesOverCell planes(shapes, cell);
    std::vector<const CornerLoop*> result;
    for (const CornerLoop* occluder : occluders)
        if (!std::all_of(lights.begin(), lights.end(),
                         [&](const CornerLoop& light) { return planes.apart(light, *occluder); }))
            result.push_back(occluder);
    return result;
}

}  // namespace cob::radiosity
