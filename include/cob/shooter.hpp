/// \file
/// The ray-cast shooter: exact sample points inside elements, and what of them a point sees, by counting.
#pragma once

#include "cob/visibility.hpp"

#include <vector>

namespace cob {

/// An exact point strictly inside an element, with the piece that it lies on.
struct SamplePoint {
    ExactPoint point;
    PieceId piece = -1;
};

/// Stratified points: the element cut into per_side * per_side cells alike, one point in the middle of each (of a
/// triangle's cells at their centroids, rounded to a binary grid finer than 1/500 of the cell). Cells ascend along
/// corner 0 to 1, then along corner 0 to the last; a triangle's cells by their first corner, upright before
/// inverted. Powers of two give the shortest numbers. Throws InputError unless 1 <= per_side <= 64.
std::vector<SamplePoint> sample_points(const Scene& scene, const Root& root, const Element& element, int per_side);

/// Share of the samples that the point sees, in [0, 1]. Only blocked counts as not seen: grazing is what a limit of
/// clear segments may be. A sample that is the point itself is not counted; without any that count the share is 0.
/// Which way anything faces does not matter here.
double visible_fraction(const VisibilityOracle& oracle, const SamplePoint& receiver,
                        const std::vector<SamplePoint>& samples, PredicateCounters* counters = nullptr);

/// How many threads work; the results do not depend on it. 0: as many as the machine has.
struct Threads {
    int count = 0;
};

/// visible_fraction() of each receiver.
std::vector<double> visible_fractions(const VisibilityOracle& oracle, const std::vector<SamplePoint>& receivers,
                                      const std::vector<SamplePoint>& samples, Threads threads = {});
/// The answer for each segment.
std::vector<Visibility> visibilities(const VisibilityOracle& oracle, const std::vector<Segment>& segments,
                                     Threads threads = {});

}  // namespace cob
