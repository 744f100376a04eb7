/// \file
/// Segments aimed at the degenerate. By kind:
///   edge        from a sample point through a point on a polygon's side
///   corner      from a sample point through a polygon's vertex
///   edge-ulp    as edge, ends rounded, one of them an ulp aside
///   corner-ulp  as corner, ends rounded, one of them an ulp aside
///   seam        along a polygon's side, from vertex to vertex or beyond both
///   plane       within a polygon's plane, through it and out on both sides
///   vertices    from a vertex of one polygon to one of another
///   far         as edge, the ends 2^k times as far away, k up to 40
///   small       as edge, the ends 2^k times as near
/// A kind that cannot be made here (in a snapped set) gives way to `vertices`.
#pragma once

#include "golden/questions.hpp"

namespace cob {

/// Names of the kinds.
std::vector<std::string> hard_segment_kinds();
/// A question of the kind of this index.
SegmentTask hard_segment(const Questions& questions, std::size_t kind, Dice dice);

}  // namespace cob
