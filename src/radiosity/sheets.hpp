/// \file
/// Sheets in one plane (SPEC 8, choice 9): where polygons of one plane that face the same way overlap, the smaller in
/// area lies on top (of equals the higher number), and what it hides neither receives nor sends. Decided exactly.
#pragma once

#include "cob/candidates.hpp"
#include "cob/geometry.hpp"
#include "cob/scene.hpp"

#include <vector>

namespace cob::radiosity {

/// How much of an element lies free of sheets on top of it.
struct Cover {
    enum class Kind : std::uint8_t { free, partly, wholly };
    Kind kind = Kind::free;
    double visible_share = 1;  ///< Of its area; exact decisions, rounded once.
};

class Sheets {
public:
    Sheets(const Scene& scene, const CandidateSource& candidates);

    /// The polygons that lie on top of one, where they overlap it.
    const std::vector<PolygonId>& above(PolygonId polygon) const { return above_[static_cast<std::size_t>(polygon)]; }
    Cover cover(const Root& root, const Element& element) const;
    /// A point of a polygon's plane lies under a sheet on top of that polygon.
    bool hides(PolygonId polygon, const ExactPoint& point) const;

private:
    const Scene& scene_;
    std::vector<std::vector<PolygonId>> above_;
};

}  // namespace cob::radiosity
