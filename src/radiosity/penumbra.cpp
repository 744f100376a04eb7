#include "radiosity/penumbra.hpp"

#include <algorithm>
#include <cmath>

namespace cob::radiosity {
namespace {

/// Twice the signed area of a triangle.
double turn(const Point2D& a, const Point2D& b, const Point2D& c) {
    return (b.s - a.s) * (c.t - a.t) - (c.s - a.s) * (b.t - a.t);
}

/// Andrew's monotone chain.
Polygon2D hull_of(Polygon2D points) {
    std::sort(points.begin(), points.end(),
              [](const Point2D& a, const Point2D& b) { return a.s < b.s || (a.s == b.s && a.t < b.t); });
    Polygon2D hull;
    for (int chain = 0; chain < 2; ++chain) {
        const std::size_t first = hull.size();
        for (const Point2D& p : points) {
            while (hull.size() >= first + 2 && !(turn(hull[hull.size() - 2], hull.back(), p) > 0)) hull.pop_back();
            hull.push_back(p);
        }
        hull.pop_back();  // where the other chain begins
        std::reverse(points.begin(), points.end());
    }
    return hull;
}

}  // namespace

std::optional<Polygon2D> penumbra(const std::vector<Vector3<double>>& light,
                                  const std::vector<Vector3<double>>& occluder) {
    Polygon2D shadows;
    for (const Vector3<double>& from : light)
        for (const Vector3<double>& p : occluder) {
            const double f = from.z / (from.z - p.z);
            if (!(p.z < from.z) || !std::isfinite(f)) return std::nullopt;
            shadows.push_back({from.x + f * (p.x - from.x), from.y + f * (p.y - from.y)});
        }
    return hull_of(std::move(shadows));
}

Polygon2D left_around(const Triangle2D& triangle) {
    const auto& [a, b, c] = triangle;
    return turn(a, b, c) < 0 ? Polygon2D{a, c, b} : Polygon2D{a, b, c};
}

double area(const Polygon2D& convex) {
    double doubled = 0;
    for (std::size_t k = 2; k < convex.size(); ++k) doubled += turn(convex[0], convex[k - 1], convex[k]);
    return doubled / 2;
}

Polygon2D common_part(const Triangle2D& triangle, const Polygon2D& convex) {
    Polygon2D part = left_around(triangle);
    for (std::size_t k = 0; k < convex.size() && !part.empty(); ++k) {
        const Point2D &a = convex[k], &b = convex[(k + 1) % convex.size()];
        Polygon2D left;
        for (std::size_t i = 0; i < part.size(); ++i) {
            const Point2D &p = part[i], &q = part[(i + 1) % part.size()];
            const double side_p = turn(a, b, p), side_q = turn(a, b, q);
            if (side_p >= 0) left.push_back(p);
            if ((side_p > 0 && side_q < 0) || (side_p < 0 && side_q > 0)) {
                const double f = side_p / (side_p - side_q);
                left.push_back({p.s + f * (q.s - p.s), p.t + f * (q.t - p.t)});
            }
        }
        part = std::move(left);
    }
    return part;
}

}  // namespace cob::radiosity
