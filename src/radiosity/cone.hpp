/// \file
/// Convex cones over a viewpoint, cut and subtracted exactly.
///
/// Seen from a point x, a convex piece is a convex cone: the directions d with m . d > 0 for the planes m through x
/// and its sides. Shadows, lights and what is left of them are all of this kind, and no plane is ever constructed
/// from constructed points: each passes through x and an original edge, or is the receiver's plane, or separates
/// what lies before one piece's plane from what lies behind it. So every predicate is the sign of
/// m . (m' x m'') of three original planes, however often a region was cut (the reason why this is used instead
/// of Boolean operations on polygons in the light's plane; besides, nothing here projects to infinity).
#pragma once

#include "cob/geometry.hpp"
#include "radiosity/viewpoint.hpp"

#include <unordered_map>
#include <vector>

namespace cob::radiosity {

/// A plane through the viewpoint by number, or the same plane with its sides exchanged.
struct PlaneRef {
    std::int32_t index = -1;
    bool flipped = false;

    PlaneRef operator-() const { return {index, !flipped}; }
    friend bool operator==(PlaneRef a, PlaneRef b) { return a.index == b.index && a.flipped == b.flipped; }
};

/// The ray in which two planes meet.
struct Ray {
    PlaneRef first, second;
    VertexId vertex = -1;   ///< Its line runs through this vertex; -1: through none that is known.
    bool opposite = false;  ///< It points away from the vertex.
    BoundedVector direction;
};

/// The directions on the positive sides of all planes; rays[k] is where planes[k] and the next one meet. Planes in
/// the order in which the first ray turns into the second to the left, seen along the cone. Never empty inside.
struct Cone {
    std::vector<PlaneRef> planes;
    std::vector<Ray> rays;
};

/// The planes through one viewpoint, each kept once, and the exact predicates and constructions over them.
class PlanesThroughPoint {
public:
    explicit PlanesThroughPoint(const Viewpoint& viewpoint) : viewpoint_(&viewpoint) {}

    const Viewpoint& viewpoint() const { return *viewpoint_; }

    /// Positive where (a - x) x (b - x) points.
    PlaneRef through_edge(VertexId a, VertexId b);
    /// Positive on the side of this normal, not zero; `bounded` is a positive multiple of it.
    PlaneRef perpendicular_to(const RationalPoint& normal, const BoundedVector& bounded);
    /// Among the directions that meet both pieces' planes: positive where `near` is met strictly before `far`.
    /// x lies on neither plane, and they are not parallel.
    PlaneRef before(PieceId near, PieceId far);

    BoundedVector normal(PlaneRef plane) const;
    RationalPoint exact_normal(PlaneRef plane) const;
    RationalPoint exact_direction(const Ray& ray) const;

    /// It is the plane of a side that ends at the vertex.
    bool contains(PlaneRef plane, VertexId vertex) const { return at(plane).a == vertex || at(plane).b == vertex; }
    Ray meet(PlaneRef first, PlaneRef second) const;
    /// The side of the plane to which the ray points, exactly.
    Sign side(PlaneRef plane, const Ray& ray) const;

    /// The cone over a piece: nothing where x lies in its plane.
    std::optional<Cone> over(PieceId piece);

private:
    struct Plane {
        BoundedVector normal;
        VertexId a = -1, b = -1;                  ///< Of an edge.
        PieceId near_piece = -1, far_piece = -1;  ///< Of an order of depth.
        RationalPoint exact;                      ///< Where is_exact.
        bool is_exact = false;
    };
    const Plane& at(PlaneRef ref) const { return planes_[static_cast<std::size_t>(ref.index)]; }
    PlaneRef add(Plane plane);
    RationalPoint exact_before(PieceId near, PieceId far) const;

    const Viewpoint* viewpoint_;
    mutable std::vector<Plane> planes_;
    std::unordered_map<std::uint64_t, std::int32_t> edges_;
};

}  // namespace cob::radiosity
