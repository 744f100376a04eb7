/// \file
/// Relation and covers of SPEC 5 with one kernel alone, without stages: the other arithmetics of relate(), and
/// what benchmarks compare the product with.
#pragma once

#include "arithmetic/interval.hpp"
#include "cob/geometry.hpp"
#include "geometry/covers.hpp"
#include "geometry/separating_axes.hpp"

#include <type_traits>
#include <vector>

namespace cob {

inline Relation relation_of(const Findings& findings) {
    return findings.apart       ? Relation::disjoint
           : findings.only_base ? Relation::base
           : findings.touches   ? Relation::boundary
                                : Relation::crossing;
}

/// to_frame: from a vertex to the frame's coordinates.
template <class Kernel, class ToFrame>
BoxAnswer relate_with(const Kernel& kernel, const FrameBox<typename Kernel::Number>& box, const Scene& scene,
                      PolygonId polygon, const ToFrame& to_frame) {
    using Number = typename Kernel::Number;
    constexpr bool may_be_undecided = std::is_same_v<Number, Interval>;
    BoxAnswer answer;
    std::vector<FrameCorners<Number>> pieces;
    const auto frame_piece = [](const FrameCorners<Number>& corners) {
        return FramePiece<Number>(corners.data(), static_cast<int>(corners.size()));
    };

    // 1. The strongest relation of a piece.
    for (const Piece& piece : scene.pieces_of(polygon)) {
        pieces.emplace_back();
        for (const VertexId vertex : scene.corners(piece)) pieces.back().push_back(to_frame(scene.position(vertex)));
        Findings findings;
        separate(kernel, box, frame_piece(pieces.back()), AllAxes{}, findings);
        if (findings.decided())
            answer.relation = std::max(answer.relation, relation_of(findings));
        else
            answer.decided = false;
    }
    if (answer.relation == Relation::crossing) answer.decided = true;

    // 2. In the element's plane, or only touching its base?
    if (answer.relation == Relation::base) {
        bool in_plane = true;
        for (const auto& piece : pieces)
            for (const Vector3<Number>& q : piece) {
                const UncertainSign sign = kernel.base(box.low.z - q.z);
                in_plane = in_plane && sign == UncertainSign::zero;
                if (sign == UncertainSign::undecided) answer.decided = false;
            }
        if (in_plane) answer.relation = Relation::coplanar;
    }

    // 3. Cover.
    if (!is_close(answer.relation)) return answer;
    if (pieces.size() == 1) {
        const UncertainBool covers = meets_all_box_edges(kernel, box, frame_piece(pieces.front()));
        answer.covers = covers == UncertainBool::yes;
        if (covers == UncertainBool::undecided) answer.decided = false;
    } else if constexpr (may_be_undecided) {
        answer.decided = false;  // cutting needs decisions
    } else {
        answer.covers = pieces_cover(kernel, box, pieces);
    }
    return answer;
}

}  // namespace cob
