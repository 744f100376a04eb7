/// \file
/// A flat tree of bounds over packets of pieces, four children to a node, in the coordinates of a normalised scene.
#pragma once

#include "geometry/large_pages.hpp"
#include "geometry/piece_packets.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace cob {

/// Bounds of four children, side by side.
struct alignas(64) PieceTreeNode {
    static constexpr std::int32_t nothing = INT32_MAX;

    std::array<Lanes, 6> bounds;           ///< Low x, y, z, then high x, y, z; rounded outward. Empty: never met.
    std::array<std::int32_t, 4> children;  ///< A node, or ~ of a packet.

    PieceTreeNode();
    void set(std::size_t lane, const Bounds& of, const Normalisation& normalise, std::int32_t child);
};

/// The pieces of a scene. Thread-safe once built.
class PieceTree {
public:
    const Normalisation& normalisation() const { return normalisation_; }
    const LargeVector<PiecePacket>& packets() const { return packets_; }
    std::size_t memory() const;

    /// Pieces whose bounds may meet the segment; see CandidateSource::pieces_along().
    void walk(const Point& from, const Point& to, CandidateSource::PieceCallback callback) const;

private:
    friend PieceTree build_piece_tree(const Scene& scene);
    explicit PieceTree(const Scene& scene);

    const Scene* scene_;
    Normalisation normalisation_;
    LargeVector<PieceTreeNode> nodes_;  ///< The first is the root; none where there are no pieces.
    LargeVector<PiecePacket> packets_;
};

/// In the order that CGAL's AABB tree finds.
PieceTree build_piece_tree(const Scene& scene);

/// Every piece whose bounds may meet the segment, one after the other: for segments that no tree takes.
void walk_all_pieces(const Scene& scene, const Point& from, const Point& to, CandidateSource::PieceCallback callback);

}  // namespace cob
