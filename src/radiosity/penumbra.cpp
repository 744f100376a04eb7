#include "radiosity/penumbra.hpp"

#include <algorithm>
#include <cmath>

namespace cob::radiosity {
namespace {

/// From that many times the light's height, rounding would move the hull's sides near the receiver.
constexpr double most_magnified = 0x1p20;

/// Andrew's monotone chain.
Polygon2D hull_of(Polygon2D points) {
    std::sort(points.begin(), points.end(),
              [](const Point2D& a, const Point2D& b) { return a.s < b.s || (a.s == b.s && a.t < b.t); });
    Polygon2D hull;
    for (int chain = 0; chain < 2; ++chain) {
        const std::size_t first = hull.size();
        for (const Point2D& p : points) {
            while (hull.size() >= first + 2 && !(turn({hull[hull.size() - 2], hull.back(), p}) > 0)) hull.pop_back();
            hull.push_back(p);
        }
        hull.pop_back();  // where the other chain begins
        std::reverse(points.begin(), points.end());
    }
    return hull;
}

}  // namespace

std::optional<Polygon2D> penumbra(const Corners3D& light, const Corners3D& occluder) {
    Polygon2D shadows;
    for (const Vector3<double>& from : light)
        for (const Vector3<double>& p : occluder) {
            const double f = from.z / (from.z - p.z);
            if (!(p.z < from.z) || !(f > 0 && f < most_magnified)) return std::nullopt;
            shadows.push_back({from.x + f * (p.x - from.x), from.y + f * (p.y - from.y)});
        }
    return hull_of(std::move(shadows));
}

double area(const Polygon2D& convex) {
    double doubled = 0;
    for (std::size_t k = 2; k < convex.size(); ++k) doubled += turn({convex[0], convex[k - 1], convex[k]});
    return doubled / 2;
}

Polygon2D common_part(const Triangle2D& triangle, const Polygon2D& convex) {
    Polygon2D part = left_around(triangle);
    for (std::size_t k = 0; k < convex.size() && !part.empty(); ++k) {
        const Point2D &a = convex[k], &b = convex[(k + 1) % convex.size()];
        Polygon2D left;
        for (std::size_t i = 0; i < part.size(); ++i) {
            const Point2D &p = part[i], &q = part[(i + 1) % part.size()];
            const double side_p = turn({a, b, p}), side_q = turn({a, b, q});
            if (side_p >= 0) left.push_back(p);
            if ((side_p > 0 && side_q < 0) || (side_p < 0 && side_q > 0))
                left.push_back(mix(p, q, side_p / (side_p - side_q)));
        }
        part = std::move(left);
    }
    return part;
}

PossibleShadows::PossibleShadows(const PairShapes& shapes, const std::vector<CornerLoop>& lights,
                                 const std::vector<CornerLoop>& occluders) {
    const auto corners_of = [&](const CornerLoop& loop) {
        Corners3D corners;
        for (const VertexId v : loop.corners) corners.push_back(shapes.bounded_corner(v).value);
        return corners;
    };
    Corners3D all_lights;
    for (const CornerLoop& light : lights) {
        lights_.push_back(corners_of(light));
        all_lights.insert(all_lights.end(), lights_.back().begin(), lights_.back().end());
    }
    for (const CornerLoop& occluder : occluders) {
        if (penumbrae_.size() <= occluder.number) penumbrae_.resize(occluder.number + 1);
        penumbrae_[occluder.number] = penumbra(all_lights, corners_of(occluder));
    }
}

Integral PossibleShadows::unobstructed(const Polygon2D& polygon, double may_be_off) const {
    const Corners3D corners = in_space(polygon);
    Integral sum;
    for (const Corners3D& light : lights_) sum += mutual_flux(corners, light, may_be_off);
    return sum;
}

double PossibleShadows::hidden_at_most(const Triangle2D& t, const std::vector<const CornerLoop*>& occluders,
                                       double may_be_off) const {
    std::vector<Polygon2D> dark;
    double dark_area = 0;
    for (const CornerLoop* occluder : occluders) {
        const std::optional<Polygon2D>& shadow = penumbrae_[occluder->number];
        dark.push_back(shadow ? common_part(t, *shadow) : left_around(t));
        dark_area += area(dark.back());
        if (dark_area >= area(t)) return HUGE_VAL;  // closed forms would cost more than they tell
    }
    double sum = 0;
    for (const Polygon2D& part : dark) {
        if (!(area(part) > 0)) continue;
        const Integral flux = unobstructed(part, may_be_off);
        sum += flux.value + flux.error;
    }
    return sum;
}

FluxRange PossibleShadows::range(const Triangle2D& t, const std::vector<const CornerLoop*>& occluders,
                                 double may_be_off) const {
    const Integral all = unobstructed(left_around(t), may_be_off);
    const double hidden = std::min(all.value, hidden_at_most(t, occluders, may_be_off));
    return {std::max(0.0, all.value - hidden - all.error), std::min(area(t), all.value + all.error)};
}

}  // namespace cob::radiosity
