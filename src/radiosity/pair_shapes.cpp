#include "radiosity/pair_shapes.hpp"

#include <algorithm>
#include <cmath>

namespace cob::radiosity {
namespace {

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

BoundedVector bounded(const IntervalPoint& p) {
    return {{p.x.middle(), p.y.middle(), p.z.middle()}, std::max({p.x.width(), p.y.width(), p.z.width()})};
}

}  // namespace

PairShapes::PairShapes(const ConvexPolygon& receiver, double scale) : receiver_(receiver), scale_(scale) {
    const RationalPoint normal = area_vector(receiver), side = receiver[1] - receiver[0];
    axes_ = {unit(side), unit(cob::cross(normal, side)), unit(normal)};
    std::size_t third = 2;
    while (cob::cross(side, receiver[third] - receiver[0]) == RationalPoint{}) ++third;
    span_ = {receiver[0], receiver[1], receiver[third]};
    for (std::size_t k = 0; k < 3; ++k) bounded_span_[k] = bounded(local(span_[k]));
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
    loop.number = loops_++;
    common_.clear();
    const std::size_t n = polygon.size();
    for (std::size_t k = 0; k < n; ++k) {
        const RationalPoint &before = polygon[(k + n - 1) % n], &corner = polygon[k], &after = polygon[(k + 1) % n];
        if (cob::cross(corner - before, after - corner) == RationalPoint{}) continue;
        const auto [known, is_new] = known_.try_emplace(corner, static_cast<VertexId>(exact_.size()));
        if (is_new) {
            exact_.push_back(corner);
            corners_.push_back(local(corner));
            bounded_.push_back(bounded(corners_.back()));
        }
        loop.corners.push_back(known->second);
    }
    for (std::size_t k = 0; k < loop.corners.size(); ++k)
        loop.sides.push_back(side_between(loop.corners[k], loop.corners[(k + 1) % loop.corners.size()]));
    return loop;
}

PlaneRef PairShapes::side_between(VertexId a, VertexId b) {
    const bool flipped = a > b;
    if (flipped) std::swap(a, b);
    const auto [known, is_new] = known_sides_.try_emplace({a, b}, static_cast<std::int32_t>(sides_.size()));
    if (is_new) sides_.push_back({a, b});
    return {known->second, flipped};
}

bool PairShapes::always_in_plane(std::int32_t k, VertexId v) const {
    // Linear: three points that span the plane decide.
    const auto& [a, b] = side(k);
    for (const BoundedVector& x : bounded_span_) {
        const auto at = [&](VertexId id) { return bounded_corner(id) - x; };
        const auto sign = dot(cross(at(a), at(b)), at(v)).sign();
        if (sign && *sign != Sign::zero) return false;
    }
    const auto [known, is_new] = in_plane_.try_emplace({k, v}, true);
    if (is_new)
        for (const RationalPoint& x : span_) {
            const auto at = [&](VertexId id) { return exact_[static_cast<std::size_t>(id)] - x; };
            if (cob::dot(cob::cross(at(a), at(b)), at(v)) != 0) known->second = false;
        }
    return known->second;
}

std::optional<std::size_t> PairShapes::common_side(std::int32_t side, const CornerLoop& loop) const {
    constexpr std::int32_t not_asked = -2, none = -1;
    const auto find = [&] {
        for (std::size_t k = 0, n = loop.corners.size(); k < n; ++k)
            if (always_in_plane(side, loop.corners[k]) && always_in_plane(side, loop.corners[(k + 1) % n]))
                return static_cast<std::int32_t>(k);
        return none;
    };
    std::int32_t found = not_asked;
    if (sides_.size() * loops_ > most_in_table) {
        found = find();
    } else {
        common_.resize(sides_.size() * loops_, not_asked);
        std::int32_t& known = common_[static_cast<std::size_t>(side) * loops_ + loop.number];
        if (known == not_asked) known = find();
        found = known;
    }
    return found == none ? std::nullopt : std::optional(static_cast<std::size_t>(found));
}

bool PairShapes::always_in_line(std::array<std::int32_t, 3> sides) const {
    std::sort(sides.begin(), sides.end());
    const auto [known, is_new] = in_line_.try_emplace(sides, true);
    if (!is_new) return known->second;
    // Quadratic: six points decide, the corners and the middles of the sides of a triangle.
    for (std::size_t i = 0; i < 3 && known->second; ++i)
        for (std::size_t j = i; j < 3 && known->second; ++j) {
            const RationalPoint x = Rational(1, 2) * (span_[i] + span_[j]);
            const auto normal = [&](std::size_t k) {
                const auto& [a, b] = side(sides[k]);
                return cob::cross(exact_[static_cast<std::size_t>(a)] - x, exact_[static_cast<std::size_t>(b)] - x);
            };
            if (cob::dot(normal(0), cob::cross(normal(1), normal(2))) != 0) known->second = false;
        }
    return known->second;
}

}  // namespace cob::radiosity
