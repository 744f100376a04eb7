/// \file
/// The convex hull of two convex patches, and exactly what meets it (SPEC 6 lifted from segments to patches).
#pragma once

#include "cob/arithmetic.hpp"
#include "cob/patch_visibility.hpp"
#include "cob/scene.hpp"

#include <array>
#include <vector>

namespace cob {

/// Hull of two patches, each on the closed visible side of the other's plane.
class Shaft {
public:
    Shaft(const ConvexPatch& a, const ConvexPatch& b);
    Shaft(const Shaft&) = delete;
    Shaft& operator=(const Shaft&) = delete;

    /// The hull has no inside: the patches lie in one plane.
    bool is_flat() const { return facets_.empty(); }
    /// The piece meets the open inside of the hull.
    bool meets(const Scene& scene, const Piece& piece) const;
    /// Contains the hull, rounded outward: xmin, ymin, zmin, xmax, ymax, zmax.
    const std::array<double, 6>& bounds() const { return bounds_; }

private:
    /// A plane through three points that has the hull on its closed `inner` side.
    struct Facet {
        std::array<const ExactPoint*, 3> plane;
        Sign inner;
    };
    void add_facet(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c);
    bool separated_by_own_facet(const std::vector<ExactPoint>& corners) const;
    bool separated_by_side(const std::vector<ExactPoint>& corners) const;

    std::vector<ExactPoint> points_;
    std::vector<Facet> facets_;
    std::array<double, 6> bounds_{};
};

/// The piece lies across every segment from patch to patch: all of them cross it from one side to the other, but
/// for those through its sides and from its plane, which have measure zero.
bool lies_across(const Scene& scene, const Piece& piece, const ConvexPatch& a, const ConvexPatch& b);
/// The same of a planar polygon of any number of pieces, all of them together.
bool planar_polygon_lies_across(const Scene& scene, PolygonId polygon, const ConvexPatch& a, const ConvexPatch& b);

}  // namespace cob
