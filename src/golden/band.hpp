/// \file
/// How near a question is to one with another answer (the column band of tags.csv).
///
/// Box: the smallest k of 8 to 52 such that no row of its answers changes when the box, element and all, is scaled
/// about its centre by any factor from 1 - 2^-k to 1 + 2^-k. The centre is that of the widened rectangle, raised by
/// half the height, which is rounded to a binary64 multiple of the normal as long as twice the element's area.
///
/// Segment: the smallest k of 8 to 52 such that its visibility stays the same when both ends are moved by e and f, -e
/// and -f, e' and -f', -e' and f'. An end that lies on a polygon moves within its plane: e and e' are the first two
/// sides of its piece, times the power of two that brings them to at most 2^-k, and more than half of that, of the
/// segment's length; a free end moves as far along the two axes along which the segment is shorter. Found by
/// bisection, as if what holds for k held for all greater k.
///
/// 52 says that a switch is as near as 2^-51 of the size, or that the question is on one: a relation of boundary,
/// coplanar or base, grazing visibility. Moves beyond 2^-8 are not tried: nobody computes that badly.
#pragma once

#include "cob/classification.hpp"
#include "cob/visibility.hpp"
#include "geometry/bounds.hpp"

namespace cob {

inline constexpr int lowest_band = 8, highest_band = 52;

/// Classifies boxes together with their bands. One thread each.
class BoxBands {
public:
    /// All must outlive it; the bounds are those of the polygons.
    BoxBands(const Scene& scene, const CandidateSource& candidates, const std::vector<Bounds>& bounds)
        : scene_(scene), source_(candidates), bounds_(bounds), classifier_(scene), moved_(scene) {}

    /// Fills the classification, as BoxClassifier::from_scene() does; returns the band.
    int operator()(const BoxQuestion& question, Classification& result);

private:
    const Scene& scene_;
    const CandidateSource& source_;
    const std::vector<Bounds>& bounds_;
    BoxClassifier classifier_, moved_;
    std::vector<PolygonId> near_, candidates_;
    Classification scratch_;
};

/// Sets the visibility of a segment; returns its band.
int segment_band(const Scene& scene, const VisibilityOracle& oracle, const Segment& segment, Visibility& visibility);

}  // namespace cob
