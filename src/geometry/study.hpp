/// \file
/// Relation and covers of SPEC 5 with one kernel alone, without stages: the other arithmetics of relate(), and
/// what benchmarks compare the product with.
#pragma once

#include "arithmetic/interval.hpp"
#include "cob/geometry.hpp"
#include "geometry/covers.hpp"
#include "geometry/separating_axes.hpp"

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <optional>
#include <type_traits>
#include <vector>

namespace cob {

inline Relation relation_of(const Findings& findings) {
    return findings.apart       ? Relation::disjoint
           : findings.only_base ? Relation::base
           : findings.touches   ? Relation::boundary
                                : Relation::crossing;
}

/// Relation of one piece, corners in the frame; undecided (only with intervals): nothing.
template <class Kernel>
std::optional<Relation> relate_piece(const Kernel& kernel, const FrameBox<typename Kernel::Number>& box,
                                     const FramePiece<typename Kernel::Number>& piece) {
    Findings findings;
    separate(kernel, box, piece, AllAxes{}, findings);
    return findings.decided() ? std::optional<Relation>(relation_of(findings)) : std::nullopt;
}

/// to_frame: from a vertex to the frame's coordinates.
template <class Kernel, class ToFrame>
BoxAnswer relate_with(const Kernel& kernel, const FrameBox<typename Kernel::Number>& box, const Scene& scene,
                      PolygonId polygon, const ToFrame& to_frame) {
    using Number = typename Kernel::Number;
    using SmallCorners = boost::container::small_vector<Vector3<Number>, 8>;
    const auto corners_of = [&](const Piece& piece) {
        SmallCorners corners;
        for (const VertexId vertex : scene.corners(piece)) corners.push_back(to_frame(scene.position(vertex)));
        return corners;
    };
    const auto frame_piece = [](const SmallCorners& corners) {
        return FramePiece<Number>(corners.data(), static_cast<int>(corners.size()));
    };
    const View<Piece> pieces = scene.pieces_of(polygon);
    BoxAnswer answer;

    // 1. The strongest relation of a piece; a single piece's cover at once.
    for (const Piece& piece : pieces) {
        const SmallCorners corners = corners_of(piece);
        const std::optional<Relation> relation = relate_piece(kernel, box, frame_piece(corners));
        if (relation)
            answer.relation = std::max(answer.relation, *relation);
        else
            answer.decided = false;
        if (pieces.size() == 1 && is_close(answer.relation)) {
            const UncertainBool covers = meets_all_box_edges(kernel, box, frame_piece(corners));
            answer.covers = covers == UncertainBool::yes;
            answer.decided = answer.decided && covers != UncertainBool::undecided;
        }
    }
    if (pieces.size() == 1 && is_close(answer.relation)) return answer;
    if (answer.relation == Relation::crossing) answer.decided = true;

    // 2. In the element's plane, or only touching its base?
    if (answer.relation == Relation::base) {
        bool in_plane = true;
        for (const Piece& piece : pieces)
            for (const Vector3<Number>& q : corners_of(piece)) {
                const UncertainSign sign = kernel.base(box.low.z - q.z);
                in_plane = in_plane && sign == UncertainSign::zero;
                answer.decided = answer.decided && sign != UncertainSign::undecided;
            }
        if (in_plane) answer.relation = Relation::coplanar;
    }

    // 3. Cover by several pieces.
    if (is_close(answer.relation)) {
        if constexpr (std::is_same_v<Number, Interval>) {
            answer.decided = false;  // cutting needs decisions
        } else {
            std::vector<FrameCorners<Number>> all;
            for (const Piece& piece : pieces) {
                const SmallCorners corners = corners_of(piece);
                all.emplace_back(corners.begin(), corners.end());
            }
            answer.covers = pieces_cover(kernel, box, all);
        }
    }
    return answer;
}

}  // namespace cob
