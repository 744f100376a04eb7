#include "radiosity/plane_sheets.hpp"

#include "arithmetic/orientation.hpp"
#include "geometry/convex_polygon.hpp"
#include "scene/piece_plane.hpp"

#include <algorithm>

namespace cob::radiosity {
namespace {

/// Twice the area seen along an axis, exactly: of the points that the loop winds around, once each and either way.
Rational doubled_area(const Scene& scene, PolygonId polygon, int axis) {
    Rational sum = 0;
    for (const Piece& piece : scene.pieces_of(polygon)) sum += abs(area_vector(polygon_of(scene, piece))[axis]);
    return sum;
}

bool lies_in(const Scene& scene, PolygonId polygon, const std::array<Point, 3>& plane) {
    const View<VertexId> loop = scene.loop(polygon);
    return std::all_of(loop.begin(), loop.end(), [&](VertexId v) {
        return orientation(plane[0], plane[1], plane[2], scene.position(v)) == Sign::zero;
    });
}

}  // namespace

std::array<double, 6> bounds_of_polygon(const Scene& scene, PolygonId polygon) {
    std::array<double, 6> bounds{};
    bool first = true;
    for (VertexId v : scene.loop(polygon)) {
        const Point& p = scene.position(v);
        for (int axis = 0; axis < 3; ++axis) {
            bounds[axis] = first ? p[axis] : std::min(bounds[axis], p[axis]);
            bounds[axis + 3] = first ? p[axis] : std::max(bounds[axis + 3], p[axis]);
        }
        first = false;
    }
    return bounds;
}

std::vector<PolygonId> sheets_on_top(const Scene& scene, PolygonId polygon, const CandidateSource& candidates) {
    const Polygon& shape = scene.polygon(polygon);
    if (!shape.valid || !shape.planar) return {};
    struct Search {
        const Scene& scene;
        PolygonId polygon;
        std::vector<PolygonId> found;
    } search{scene, polygon, {}};
    candidates.polygons_in(
        bounds_of_polygon(scene, polygon),
        {&search, [](void* context, std::int32_t id) {
             auto& s = *static_cast<Search*>(context);
             const Polygon &p = s.scene.polygon(s.polygon), &q = s.scene.polygon(id);
             // In one plane and facing one way they are seen alike.
             if (id != s.polygon && q.planar && q.view.axis == p.view.axis && q.view.first == p.view.first)
                 s.found.push_back(id);
             return true;
         }});
    std::vector<PolygonId> result;
    const std::array<Point, 3> plane = plane_of(scene, scene.pieces_of(polygon).front());
    std::optional<Rational> area;
    for (PolygonId other : search.found) {
        if (!lies_in(scene, other, plane)) continue;
        if (!area) area = doubled_area(scene, polygon, shape.view.axis);
        const Rational others = doubled_area(scene, other, shape.view.axis);
        if (others < *area || (others == *area && other > polygon)) result.push_back(other);
    }
    std::sort(result.begin(), result.end());
    return result;
}

}  // namespace cob::radiosity
