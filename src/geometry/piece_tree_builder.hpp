/// \file
/// Builds the tree of pieces top down by the surface area heuristic: of all ways to part the pieces of a node in two,
/// by planes between sixteen equal slices along each axis, the one with the least sum of (surface of the bounds) x
/// (number of pieces), that is the least expected number of pieces that a random line has to be held against.
///
/// CGAL's AABB tree parts into halves of equal number; over the same pieces it makes a line visit about twice the
/// nodes.
#pragma once

#include "geometry/bounds.hpp"
#include "geometry/large_pages.hpp"
#include "geometry/piece_outline.hpp"
#include "geometry/piece_tree_node.hpp"

#include <cstddef>
#include <utility>
#include <vector>

namespace cob {

class PieceTreeBuilder {
public:
    /// Below the 24th, nodes are parted into halves of equal number, which ends after at most 31 further levels.
    static constexpr int most_heuristic_levels = 24, most_levels = most_heuristic_levels + 31;

    PieceTreeBuilder(const Scene& scene, const Normalisation& normalise, LargeVector<PieceTreeNode>& nodes,
                     LargeVector<PieceOutline>& outlines);
    void build();

private:
    /// Some of the pieces, side by side in pieces_.
    struct Part {
        std::size_t first, beyond;
        Bounds bounds;
        std::size_t size() const { return beyond - first; }
    };
    struct Entry {
        PieceId piece;
        Bounds bounds;  ///< In the normalised scene, with the margin.
    };

    Part part(std::size_t first, std::size_t beyond) const;
    std::pair<Part, Part> halves(const Part& whole);
    std::pair<Part, Part> best_split(const Part& whole);
    /// The node's children, and all that is below.
    void fill(std::size_t node, const Part& all, int level);

    const Scene& scene_;
    const Normalisation& normalise_;
    LargeVector<PieceTreeNode>& nodes_;
    LargeVector<PieceOutline>& outlines_;
    std::vector<Entry> pieces_;
};

}  // namespace cob
