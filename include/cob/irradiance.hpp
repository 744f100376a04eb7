/// \file
/// Irradiance at a point from polygonal lights behind any occluders, without sampling (SPEC 8).
///
/// The part of a light that is seen is found exactly: the light's pieces, as cones over the point, minus the
/// shadows of all other pieces, by predicates without error. Only its form factor, by Lambert's closed form, is
/// rounded, to 1e-14 of the unobstructed value.
#pragma once

#include "cob/arithmetic.hpp"
#include "cob/candidates.hpp"
#include "cob/scene.hpp"

#include <memory>
#include <vector>

namespace cob {

/// A light as a point with a normal sees it.
struct LightAtPoint {
    double unobstructed = 0;  ///< Form factor from the point to the light, nothing in between, in [0, 1].
    double visible = 0;       ///< Form factor to what of the light is seen, in [0, unobstructed].
    double solid_angle = 0;   ///< Of what is seen, in steradians, in [0, 2 pi]; to about 1e-12.
    int parts = 0;            ///< Convex parts that the visible region was cut into.
};

/// Answers questions about one scene; thread-safe after construction. Scene and source must outlive it.
///
/// Counts what lies strictly in front of the point's plane, of the pieces in front of whose planes the point
/// lies. Obstructed is what is seen through any closed piece strictly between the point and the light: contact at
/// the point or at the light does not count (SPEC 6), so a point on a polygon sees over all of it. What sheets in
/// the light's own plane hide of it does not count as visible (choice 9).
class IrradianceOracle {
public:
    IrradianceOracle(const Scene& scene, const CandidateSource& candidates);
    ~IrradianceOracle();

    /// The normal may have any length but zero. Throws InputError where it is zero.
    LightAtPoint operator()(const ExactPoint& point, const RationalPoint& normal, PolygonId light) const;

    /// The lights of the scene, ascending.
    const std::vector<PolygonId>& lights() const;

private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

}  // namespace cob
