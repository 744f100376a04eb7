/// \file
/// Where on a receiver's plane occluders may hide some of a light, and what they may hide there at most; in binary64.
#pragma once

#include "radiosity/cells.hpp"
#include "radiosity/contour.hpp"
#include "radiosity/pair_shapes.hpp"

#include <optional>
#include <vector>

namespace cob::radiosity {

/// Corners as (s, t, h).
using Corners3D = std::vector<Vector3<double>>;

double area(const Polygon2D& convex);
/// What of a triangle lies in a convex polygon.
Polygon2D common_part(const Triangle2D& triangle, const Polygon2D& convex);

/// The penumbra of a convex occluder on the plane h = 0: the hull of the shadows that its corners cast from the light's
/// corners. From outside all of the light is seen past it. Nothing where it has no end, for the occluder reaches as
/// high as the light, or so nearly as high that binary64 cannot tell where it ends.
std::optional<Polygon2D> penumbra(const Corners3D& light, const Corners3D& occluder);

/// Between two integrals of the form factor.
struct FluxRange {
    double low = 0, high = 0;
};

/// What a light's convex parts send to triangles of the receiver's plane, whatever the occluders hide of it.
class PossibleShadows {
public:
    PossibleShadows(const PairShapes& shapes, const std::vector<CornerLoop>& lights,
                    const std::vector<CornerLoop>& occluders);

    /// Between all of the given occluders' penumbrae dark and nothing hidden. Closed forms may be off by the last one.
    FluxRange range(const Triangle2D& t, const std::vector<const CornerLoop*>& occluders, double may_be_off) const;

private:
    Integral unobstructed(const Polygon2D& polygon, double may_be_off) const;
    double hidden_at_most(const Triangle2D& t, const std::vector<const CornerLoop*>& occluders,
                          double may_be_off) const;

    std::vector<Corners3D> lights_;
    std::vector<std::optional<Polygon2D>> penumbrae_;  ///< By the occluders' numbers.
};

}  // namespace cob::radiosity
