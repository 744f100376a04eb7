/// \file
/// Exact facts about all pairs of polygons of a scene, found by a tree in about n log n steps.
#pragma once

#include "cob/geometry.hpp"
#include "cob/omissions.hpp"
#include "cob/scene.hpp"

#include <string>

namespace cob {

/// A fact, and the reason for it or against it.
struct Fact {
    bool holds = false;
    std::string reason;
};

/// No piece reaches strictly behind the plane of another. Then a segment between two of them that leaves the one in
/// front and arrives at the other's front meets a third piece at its ends at most: a point of its inside that is on a
/// plane would put both ends on it, and with them, all being in front, both pieces.
Fact find_convex(const Scene& scene);

/// The bounds of the box over every root are met by no other polygon. Boxes of elements lie within.
Fact find_apart(const Scene& scene, const Roots& roots, const OmissionOptions& options);

}  // namespace cob
