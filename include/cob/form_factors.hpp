/// \file
/// The obstructed form factor matrix from polygon to polygon, with an error for each value (SPEC 8).
///
/// F_ij is the share of the flux leaving polygon i, uniformly and Lambertian, that arrives at j through whatever
/// stands between. Only what lies in front of both counts; of sheets in one plane that face the same way only what
/// is on top (choice 9), while the areas are those of the whole polygons. F_ii is not zero where a polygon that is
/// not planar sees itself.
#pragma once

#include "cob/candidates.hpp"
#include "cob/progress.hpp"
#include "cob/scene.hpp"

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace cob {

struct FormFactorOptions {
    /// Goal of the error of each form factor, absolute; reached unless max_evaluations end it first.
    double tolerance = 1e-6;
    /// Certified bounds instead of an estimate: the value is the middle, the error half the width, and the true
    /// value lies between. The subdivision stops at a width of 2 tolerance or at max_subdivisions.
    bool certified = false;
    /// Exact point values for one pair of pieces; as many again, received at the other, where the goal is not reached.
    std::uint64_t max_evaluations = 1000000;
    std::uint64_t max_subdivisions = 4000;  ///< The same, of triangles of the receiver, certified only.
    /// Both triangles of the matrix on their own, so that reciprocity can be checked; else the larger polygon's
    /// value follows from the smaller's.
    bool both_sides = false;
    int threads = 0;  ///< 0: all cores. The result does not depend on it.
};

struct PolygonFormFactor {
    PolygonId from = 0, to = 0;
    double value = 0;  ///< F_from,to, in (0, 1].
    double error = 0;  ///< At least the distance to the true value; guaranteed where certified.
};

/// Which pairs need what, and what that will cost.
struct FormFactorPlan {
    std::uint64_t pairs = 0;         ///< Pairs of polygons asked for, {i, j} once.
    std::uint64_t not_facing = 0;    ///< No part of one in front of the other.
    std::uint64_t hidden = 0;        ///< Some one polygon lies across everything between.
    std::uint64_t unobstructed = 0;  ///< Nothing meets the shaft: closed form.
    std::uint64_t obstructed = 0;    ///< Cubature.
    double occluders = 0;            ///< Pieces in the shaft of an obstructed pair, on average.
    double evaluations = 0;          ///< Estimated for all obstructed pairs: a few are begun.
    double seconds = 0;              ///< The same, on one core.
};

struct FormFactorResult {
    std::vector<PolygonFormFactor> values;  ///< All that are not zero, ascending by from, then to.
    std::uint64_t evaluations = 0;          ///< Exact point values, or triangles of the receiver where certified.
    std::uint64_t above_goal = 0;           ///< Values whose error stayed above the tolerance.
    /// With both_sides: the largest |A_i F_ij - A_j F_ji| / min(A_i, A_j), and the largest share of it in the sum
    /// of both errors so weighted (at most 1 where the errors hold).
    double reciprocity = 0, reciprocity_in_errors = 0;
};

/// Computes form factors of one scene, which must outlive it, as must the source.
class FormFactorMatrix {
public:
    FormFactorMatrix(const Scene& scene, const CandidateSource& candidates, const FormFactorOptions& options);
    ~FormFactorMatrix();

    /// Decides exactly which pairs are obstructed. Empty: all pairs; else those given, in either order. Throws
    /// InputError for a polygon that is none.
    FormFactorPlan plan(const std::vector<std::pair<PolygonId, PolygonId>>& pairs, const Progress& progress = {});
    /// Carries the plan out.
    FormFactorResult compute(const Progress& progress = {}) const;

private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

}  // namespace cob
