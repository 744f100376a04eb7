// Which polygons lie across every segment between two patches.
#include "arithmetic/orientation.hpp"
#include "geometry/convex_polygon.hpp"
#include "geometry/shaft.hpp"
#include "scene/piece_plane.hpp"

#include <algorithm>

namespace cob {
namespace {

/// The sides of a piece's plane on which the corners of a patch lie.
struct Sides {
    std::vector<Sign> of_corner;

    bool all(Sign allowed) const {
        return std::all_of(of_corner.begin(), of_corner.end(), [&](Sign s) { return s == allowed || s == Sign::zero; });
    }
    bool none_off() const {
        return std::all_of(of_corner.begin(), of_corner.end(), [](Sign s) { return s == Sign::zero; });
    }
};

Sides sides_of(const std::array<Point, 3>& plane, const ConvexPatch& patch) {
    Sides sides;
    for (const ExactPoint& corner : patch.corners)
        sides.of_corner.push_back(
            orientation(ExactPoint(plane[0]), ExactPoint(plane[1]), ExactPoint(plane[2]), corner));
    return sides;
}

/// The plane of the piece has the patches on its two sides. Tells on which the first is.
std::optional<Sign> opposite_sides(const Sides& a, const Sides& b) {
    if (a.none_off() || b.none_off()) return std::nullopt;
    for (Sign side : {Sign::positive, Sign::negative})
        if (a.all(side) && b.all(-side)) return side;
    return std::nullopt;
}

/// A point of the piece's plane lies in the closed piece.
bool holds(const Scene& scene, const Piece& piece, const ExactPoint& point) {
    const View2 view = scene.polygon(piece.polygon).view;
    const View<VertexId> loop = scene.corners(piece);
    for (std::size_t k = 0; k < loop.size(); ++k)
        if (orientation_seen(ExactPoint(scene.position(loop[k])),
                             ExactPoint(scene.position(loop[(k + 1) % loop.size()])), point, view.first,
                             view.second) == Sign::negative)
            return false;
    return true;
}

/// Where the segments between corners cross the plane: their convex hull is where all segments cross it. Nothing
/// where a segment runs within the plane.
std::optional<std::vector<RationalPoint>> crossings(const ConvexPatch& a, const ConvexPatch& b,
                                                    const OpenHalfSpace& plane) {
    std::vector<RationalPoint> points;
    for (const ExactPoint& from : a.corners)
        for (const ExactPoint& to : b.corners) {
            const RationalPoint p = from.rational(), q = to.rational();
            const Rational hp = plane.height(p), hq = plane.height(q);
            if (hp == hq) return std::nullopt;
            points.push_back(p + Rational(hp / (hp - hq)) * (q - p));
        }
    return points;
}

/// Convex hull of points in one plane, counter-clockwise as seen; empty where it has no area.
ConvexPolygon hull_of(std::vector<RationalPoint> points, const View2& view) {
    const auto before = [&](const RationalPoint& p, const RationalPoint& q) {
        return p[view.first] != q[view.first] ? p[view.first] < q[view.first] : p[view.second] < q[view.second];
    };
    std::sort(points.begin(), points.end(), before);
    points.erase(std::unique(points.begin(), points.end()), points.end());
    const auto left = [&](const RationalPoint& a, const RationalPoint& b, const RationalPoint& c) {
        return (b[view.first] - a[view.first]) * (c[view.second] - a[view.second]) >
               (b[view.second] - a[view.second]) * (c[view.first] - a[view.first]);
    };
    ConvexPolygon hull;
    const auto run = [&](auto begin, auto end) {
        const std::size_t start = hull.size();
        for (auto point = begin; point != end; ++point) {
            while (hull.size() >= start + 2 && !left(hull[hull.size() - 2], hull.back(), *point)) hull.pop_back();
            hull.push_back(*point);
        }
        hull.pop_back();
    };
    run(points.begin(), points.end());
    run(points.rbegin(), points.rend());
    if (hull.size() < 3) hull.clear();
    return hull;
}

}  // namespace

bool lies_across(const Scene& scene, const Piece& piece, const ConvexPatch& a, const ConvexPatch& b) {
    const std::array<Point, 3> plane = plane_of(scene, piece);
    const Sides sides_a = sides_of(plane, a), sides_b = sides_of(plane, b);
    const std::optional<Sign> first = opposite_sides(sides_a, sides_b);
    if (!first) return false;
    // Where all segments between corners cross the piece, all between the patches do: a crossing point of such a
    // one is a convex combination of theirs.
    const View<VertexId> loop = scene.corners(piece);
    for (std::size_t i = 0; i < a.corners.size(); ++i)
        for (std::size_t j = 0; j < b.corners.size(); ++j) {
            const ExactPoint &from = a.corners[i], &to = b.corners[j];
            if (sides_a.of_corner[i] == Sign::zero && sides_b.of_corner[j] == Sign::zero) {
                if (!holds(scene, piece, from) || !holds(scene, piece, to)) return false;
                continue;
            }
            for (std::size_t k = 0; k < loop.size(); ++k)
                if (orientation(from, to, ExactPoint(scene.position(loop[k])),
                                ExactPoint(scene.position(loop[(k + 1) % loop.size()]))) == *first)
                    return false;
        }
    return true;
}

bool planar_polygon_lies_across(const Scene& scene, PolygonId polygon, const ConvexPatch& a, const ConvexPatch& b) {
    const View<Piece> pieces = scene.pieces_of(polygon);
    if (!scene.polygon(polygon).planar || pieces.empty()) return false;
    const std::array<Point, 3> plane = plane_of(scene, pieces.front());
    if (!opposite_sides(sides_of(plane, a), sides_of(plane, b))) return false;
    const auto points = crossings(a, b, front_of(polygon_of(scene, pieces.front())));
    if (!points) return false;
    std::vector<ConvexPolygon> open{hull_of(*points, scene.polygon(polygon).view)};
    if (open.front().empty()) return false;  // a point against a segment seen edge-on: nothing to cover
    for (const Piece& piece : pieces) subtract(open, polygon_of(scene, piece));
    return open.empty();
}

}  // namespace cob
