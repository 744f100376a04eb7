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

void subtract(std::vector<ConvexPolygon>& polygons, const ConvexPolygon& hole) {
    const RationalPoint normal = area_vector(hole);
    std::vector<OpenHalfSpace> sides;
    for (std::size_t k = 0; k < hole.size(); ++k) {
        const RationalPoint& next = hole[(k + 1) % hole.size()];
        sides.push_back({cross(normal, next - hole[k]), hole[k]});
    }
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

double area(const ConvexPolygon& polygon) {
    const RationalPoint vector = area_vector(polygon);
    Rational size = 0;
    for (int axis = 0; axis < 3; ++axis) size = std::max<Rational>(size, abs(vector[axis]));
    if (size == 0) return 0;
    const double x = to_nearest(Rational(vector.x / size)), y = to_nearest(Rational(vector.y / size)),
                 z = to_nearest(Rational(vector.z / size));
    return to_nearest(size) * std::sqrt(x * x + y * y + z * z) / 2;
}

}  // namespace cob
