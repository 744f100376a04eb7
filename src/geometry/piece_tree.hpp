/// \file
/// A flat tree of bounds over outlines of pieces, eight children to a node, in the coordinates of a normalised scene.
#pragma once

#include "geometry/large_pages.hpp"
#include "geometry/normalisation.hpp"
#include "geometry/piece_outline.hpp"
#include "geometry/piece_tree_node.hpp"

#include <cstddef>

namespace cob {

/// The pieces of a scene. Thread-safe once built.
class PieceTree {
public:
    explicit PieceTree(const Scene& scene);

    const Normalisation& normalisation() const { return normalisation_; }
    const LargeVector<PieceOutline>& outlines() const { return outlines_; }
    std::size_t memory() const;

    /// Pieces that may meet the segment; see CandidateSource::pieces_along().
    void walk(const Point& from, const Point& to, CandidateSource::PieceCallback callback) const;

private:
    const Scene* scene_;
    Normalisation normalisation_;
    ChildrenMet children_met_;
    LargeVector<PieceTreeNode> nodes_;  ///< The first is the root; none where there are no pieces.
    LargeVector<PieceOutline> outlines_;
};

/// Every piece whose bounds may meet the segment, one after the other: for segments that no tree takes.
void walk_all_pieces(const Scene& scene, const Point& from, const Point& to, CandidateSource::PieceCallback callback);

}  // namespace cob
