/// \file
/// Visibility between two convex patches, exact where it can be and bounded where not (SPEC 6, from points to
/// patches).
///
/// Only facing pairs of points count: those of which each lies strictly in front of the other's patch. The visible
/// fraction is the share of them, by area on both patches, whose open segment is not blocked.
#pragma once

#include "cob/arithmetic.hpp"
#include "cob/candidates.hpp"
#include "cob/geometry.hpp"
#include "cob/scene.hpp"
#include "cob/visibility.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace cob {

/// A convex planar patch: its corners, at least three, counter-clockwise as seen; or one point, a light that sends
/// all around.
struct ConvexPatch {
    std::vector<ExactPoint> corners;

    bool is_point() const { return corners.size() == 1; }
};

ConvexPatch patch_of(const Corners& corners);
ConvexPatch patch_of(const Scene& scene, const Piece& piece);
ConvexPatch patch_of(const ExactPoint& light);

enum class PatchRelation : std::uint8_t {
    visible,   ///< No piece meets the open convex hull of the facing parts. Exact.
    hidden,    ///< Some one planar polygon, or one piece, lies across every segment between them. Exact.
    partial,   ///< Neither: `clear` and `blocked` are two witnesses.
    undecided  ///< Neither, but one of the witnesses was not found within the budget.
};
const char* to_text(PatchRelation relation);

struct PatchOptions {
    double width = 0.01;              ///< Refine until upper - lower is at most that, in [0, 1]; 1: only the relation.
    double seconds = 0;               ///< Or until that time has passed; 0: no limit. Bounds hold wherever it ends.
    std::uint64_t max_pairs = 20000;  ///< Or until so many pairs of sub-patches were looked at.
    std::function<void()> pulse{};    ///< Called now and then, if any; may throw to end the work.
};

struct PatchAnswer {
    PatchRelation relation = PatchRelation::undecided;
    bool facing = true;              ///< False: no facing pairs; the relation is hidden, the fraction 0.
    PolygonId blocker = no_polygon;  ///< Where hidden: the polygon.
    double lower = 0, upper = 1;     ///< The visible fraction lies between, certainly.
    std::optional<Segment> clear;    ///< A segment from the first to the second patch that meets no piece.
    std::optional<Segment> blocked;  ///< One that is blocked.
    std::uint64_t pairs = 0;         ///< Pairs of sub-patches looked at.
};

/// Answers questions about one scene; thread-safe after construction. Scene and source must outlive it.
class PatchVisibility {
public:
    PatchVisibility(const Scene& scene, const CandidateSource& candidates);
    ~PatchVisibility();

    PatchAnswer operator()(const ConvexPatch& a, const ConvexPatch& b, const PatchOptions& options = {}) const;

private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

}  // namespace cob
