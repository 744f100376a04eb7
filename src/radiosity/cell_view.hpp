/// \file
/// What is seen of a convex light behind convex occluders from every point of a triangle at once.
///
/// Cones over a viewpoint x are cut by the signs of two kinds of determinants (cone.hpp), of which one is linear in x
/// over the receiver's plane: [a - x, b - x, v - x] for a side ab and a corner v; and the other,
/// [m, m', m''] for the planes through x and three sides, quadratic: it vanishes where x lies on the quadric of the
/// lines that meet all three. A polynomial has one sign on a triangle where its Bernstein coefficients have (Farin
/// 2002). So the structure of the visible region is certified for a whole cell, in interval arithmetic, or the
/// determinant that is not decided is named: where it vanishes, the region changes its shape.
#pragma once

#include "arithmetic/interval.hpp"
#include "geometry/convex_polygon.hpp"
#include "radiosity/cone.hpp"
#include "radiosity/receiver_frame.hpp"

#include <array>
#include <map>
#include <optional>
#include <vector>

namespace cob::radiosity {

using IntervalPoint = Vector3<Interval>;

/// Convex polygons by the numbers of their corners, as seen counter-clockwise.
using CornerLoop = std::vector<VertexId>;

/// A receiver's plane, the light before it and what stands between, all convex and in front of both planes: exactly,
/// and in the receiver's right-angled coordinates (s, t, h).
class PairShapes {
public:
    /// Lengths are multiplied by `scale`. The origin is the receiver's first corner.
    PairShapes(const ConvexPolygon& receiver, double scale);

    /// Straight corners are left out. Corners at one place have one number.
    CornerLoop add(const ConvexPolygon& polygon);
    IntervalPoint local(const RationalPoint& point) const;
    const IntervalPoint& corner(VertexId v) const { return corners_[static_cast<std::size_t>(v)]; }

    /// [a - x, b - x, v - x] vanishes for every x of the plane; exact.
    bool always_in_plane(VertexId a, VertexId b, VertexId v) const;
    /// The planes through x and three sides have a line in common for every x of the plane; exact.
    bool always_in_line(const std::array<VertexId, 6>& sides) const;

private:
    ConvexPolygon receiver_;
    std::array<RationalPoint, 3> span_;  ///< Three of its corners, not on one line.
    double scale_;
    std::array<IntervalPoint, 3> axes_;
    std::vector<RationalPoint> exact_;
    std::vector<IntervalPoint> corners_;
    std::map<RationalPoint, VertexId> known_;
    mutable std::map<std::array<VertexId, 6>, bool> degenerate_;
};

/// A determinant whose sign over a cell is not known.
struct UndecidedSign {
    bool linear = false;
    std::array<double, 3> at_corners{};  ///< Its values there, about.
};

/// The planes through x and sides of polygons, for all x of a triangle at once. Its functions throw UndecidedSign.
class PlanesOverCell {
public:
    PlanesOverCell(const PairShapes& shapes, const Triangle2D& cell) : shapes_(&shapes), cell_(cell) {}

    PlaneRef through_edge(VertexId a, VertexId b);
    Ray meet(PlaneRef first, PlaneRef second) const;
    Sign side(PlaneRef plane, const Ray& ray) const;
    bool not_positive(PlaneRef plane, const Ray& ray) const;
    /// The cone over a polygon; nothing where the receiver lies in its plane.
    std::optional<Cone> over(const CornerLoop& polygon);
    /// Certainly, the cones of both have no common inside. May say no.
    bool apart(const CornerLoop& one, const CornerLoop& other);

    std::int32_t plane_count() const { return static_cast<std::int32_t>(planes_.size()); }
    const std::array<VertexId, 2>& edge(std::int32_t plane) const { return at(plane).edge; }
    /// Share of the cell's area, at most, on which some sign is another: slivers along cuts that are rounded.
    double sliver() const { return sliver_; }

private:
    struct Plane {
        std::array<VertexId, 2> edge;
        std::array<IntervalPoint, 6> normals;  ///< At the cell's corners and the middles of its sides.
    };
    const Plane& at(std::int32_t plane) const { return planes_[static_cast<std::size_t>(plane)]; }
    IntervalPoint towards(VertexId v, const Interval& s, const Interval& t) const;
    IntervalPoint normal(VertexId a, VertexId b, const Interval& s, const Interval& t) const {
        return cross(towards(a, s, t), towards(b, s, t));
    }
    bool contains(PlaneRef plane, VertexId v) const { return edge(plane.index)[0] == v || edge(plane.index)[1] == v; }
    /// The sign of [a - x, b - x, v - x]; normals: of the plane through a and b at the corners.
    Sign linear_sign(VertexId a, VertexId b, VertexId v, const IntervalPoint* normals) const;
    Sign linear_sign(VertexId a, VertexId b, VertexId v) const;
    Sign quadratic_sign(std::int32_t p, std::int32_t q, std::int32_t r) const;
    std::optional<Sign> outside_of(VertexId a, VertexId b, const CornerLoop& other) const;

    const PairShapes* shapes_;
    Triangle2D cell_;
    std::vector<Plane> planes_;
    std::map<std::array<VertexId, 2>, std::int32_t> known_;
    mutable double sliver_ = 0;
};

/// The border of a visible region: on the plane through x and the side ab, arcs from ray to ray, counted positive
/// around (a - x) x (b - x).
struct ContourPlane {
    std::array<VertexId, 2> edge;
    std::vector<std::array<Ray, 2>> arcs;
};
struct Contour {
    std::vector<ContourPlane> planes;
    std::vector<std::array<VertexId, 2>> edges;  ///< By the numbers that rays name.
    double sliver = 0;                           ///< See PlanesOverCell.
};

/// The border of what is seen of the lights together, for every x of the cell; throws UndecidedSign.
Contour visible_contour(const PairShapes& shapes, const Triangle2D& cell, const std::vector<CornerLoop>& lights,
                        const std::vector<const CornerLoop*>& occluders);

/// Those of the occluders whose cones may meet a light's from some point of the cell.
std::vector<const CornerLoop*> between(const PairShapes& shapes, const Triangle2D& cell,
                                       const std::vector<CornerLoop>& lights,
                                       const std::vector<const CornerLoop*>& occluders);

}  // namespace cob::radiosity
