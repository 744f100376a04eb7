/// \file
/// One segment's visibility in words: what it meets, where, and why the answer follows (SPEC 6).
#pragma once

#include "cob/visibility.hpp"

#include <string>

namespace cob {

struct SegmentReport {
    const Scene& scene;
    const Segment& segment;
    const Explanation& explanation;
    PolygonId nearest_blocker = no_polygon;
};

/// Several lines, each ended.
std::string segment_text(const SegmentReport& report);

}  // namespace cob
