#include "geometry/convex_polygon.hpp"

#include <cmath>

namespace cob {

ConvexPolygon polygon_of(const Scene& scene, const Piece& piece) {
    ConvexPolygon polygon;
    for (VertexId corner : scene.corners(piece)) polygon.push_back(to_rational(scene.position(corner)));
    return polygon;
}

ConvexPolygon polygon_of(const Corners& corners) {
    ConvexPolygon polygon;
    for (int k = 0; k < corners.count; ++k) polygon.push_back(corners.points[static_cast<std::size_t>(k)].rational());
    return polygon;
}

OpenHalfSpace front_of(const ConvexPolygon& polygon) {
    return {area_vector(polygon), polygon[0]};
}

ConvexPolygon clip(const ConvexPolygon& polygon, const OpenHalfSpace& half_space) {
    const std::size_t n = polygon.size();
    std::vector<Rational> heights;
    bool inside = false, outside = false;
    for (const RationalPoint& corner : polygon) {
        heights.push_back(half_space.height(corner));
        inside = inside || heights.back() > 0;
        outside = outside || heights.back() < 0;
    }
    if (!inside) return {};
    if (!outside) return polygon;
    ConvexPolygon result;
    for (std::size_t k = 0; k < n; ++k) {
        const std::size_t next = (k + 1) % n;
        if (heights[k] >= 0) result.push_back(polygon[k]);
        if ((heights[k] > 0 && heights[next] < 0) || (heights[k] < 0 && heights[next] > 0))
            result.push_back(polygon[k] +
                             Rational(heights[k] / (heights[k] - heights[next])) * (polygon[next] - polygon[k]));
    }
    return result;
}

std::vector<OpenHalfSpace> sides_of(const ConvexPolygon& polygon) {
    const RationalPoint normal = area_vector(polygon);
    std::vector<OpenHalfSpace> sides;
    for (std::size_t k = 0; k < polygon.size(); ++k)
        sides.push_back({cross(normal, polygon[(k + 1) % polygon.size()] - polygon[k]), polygon[k]});
    return sides;
}

void subtract(std::vector<ConvexPolygon>& polygons, const ConvexPolygon& hole) {
    const std::vector<OpenHalfSpace> sides = sides_of(hole);
    std::vector<ConvexPolygon> rest;
    for (ConvexPolygon& polygon : polygons) {
        std::vector<ConvexPolygon> outside;
        ConvexPolygon inside = polygon;
        for (std::size_t k = 0; k < sides.size() && !inside.empty(); ++k) {
            ConvexPolygon part = clip(inside, sides[k].opposite());
            if (!part.empty()) outside.push_back(std::move(part));
            inside = clip(inside, sides[k]);
        }
        if (inside.empty())
            rest.push_back(std::move(polygon));  // the hole takes nothing of it
        else
            std::move(outside.begin(), outside.end(), std::back_inserter(rest));
    }
    polygons = std::move(rest);
}

Rational largest_component(const RationalPoint& vector) {
    return std::max({Rational(abs(vector.x)), Rational(abs(vector.y)), Rational(abs(vector.z))});
}

double area(const ConvexPolygon& polygon) {
    const RationalPoint vector = area_vector(polygon);
    const Rational size = largest_component(vector);
    if (size == 0) return 0;
    const double x = to_nearest(Rational(vector.x / size)), y = to_nearest(Rational(vector.y / size)),
                 z = to_nearest(Rational(vector.z / size));
    return to_nearest(size) * std::sqrt(x * x + y * y + z * z) / 2;
}

}  // namespace cob
