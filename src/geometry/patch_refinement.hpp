/// \file
/// Two facing patches cut into smaller and smaller pairs until each is certainly clear or certainly blocked.
#pragma once

#include "geometry/convex_polygon.hpp"
#include "geometry/shaft.hpp"

#include <cstdint>
#include <functional>
#include <vector>

namespace cob {

/// A value certainly within these.
struct Range {
    double low = 0, high = 0;
};

/// Two triangles (or points), one in front of the other, and how much of the whole they are.
struct PatchPair {
    ConvexPatch a, b;
    Range measure;
    std::vector<PieceId> between;  ///< The pieces that meet the shaft.
};

enum class PairState : std::uint8_t { clear, blocked, open };

/// Decides a pair as far as single pieces do, exactly; narrows `between` to what meets its shaft. The pulse, if any, is
/// called for each piece.
PairState decide(const Scene& scene, PatchPair& pair, const std::function<void()>& pulse = {});

struct RefinementOptions {
    double width = 0;                ///< Stop when what is open measures at most that;
    std::uint64_t max_pairs = 1000;  ///< or when so many pairs were looked at;
    double seconds = 0;              ///< or after that time; 0: no limit.
    std::function<void()> pulse{};   ///< Called now and then, if any; may throw to end the work.
};

/// What is known about refined pairs.
struct RefinedPairs {
    Range clear;      ///< Sum of the measures of the pairs that are clear.
    double open = 0;  ///< Sum of the upper measures of those that are not decided.
    std::uint64_t pairs = 0;
};

/// Refines the pairs, those that measure most first. `measure` gives the range of a part of a pair, and `decided`
/// is told each pair that has become clear or blocked, and each that is looked at and is not; it may be empty.
RefinedPairs refine(const Scene& scene, std::vector<PatchPair> pairs,
                    const std::function<Range(const PatchPair& part, const PatchPair& whole)>& measure,
                    const std::function<void(const PatchPair&, PairState)>& decided, const RefinementOptions& options);

/// A convex polygon as triangles.
std::vector<ConvexPatch> triangles_of(const ConvexPolygon& polygon);

}  // namespace cob
