/// \file
/// What may stand between a shooter and a patch: names too many pieces, never too few.
///
/// Three facts leave a piece out: it lies wholly behind the shooter or the receiver; its plane has both on one side;
/// or it misses the shaft between their bounding boxes.
#pragma once

#include "radiosity/planes.hpp"
#include "radiosity/shaft.hpp"
#include "scene/box_tree.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace cob::radiosity {

/// A patch where it lies: its piece, and its corners in units (mesh.hpp).
struct PatchShape {
    PieceId piece = -1;
    std::array<Point, 4> corners{};
    int corner_count = 0;
    Bounds bounds{};
};

/// A piece that may stand between, and the side of its plane that shooter and receiver are on, strictly and with every
/// point, where that is known.
struct Obstacle {
    PieceId piece = -1;
    std::optional<Sign> shooter, receiver;
};

class Between {
public:
    /// Scene and planes must outlive it.
    Between(const Scene& scene, const Planes& planes);

    /// One lies wholly behind the other's plane, exactly: nothing passes.
    bool apart(PieceId a, PieceId b) const;
    /// Ascending by piece. The lists are the caller's, to be used again.
    void find(const PatchShape& shooter, const PatchShape& receiver, std::vector<Obstacle>& out) const;

private:
    /// Square matrix of bits by piece.
    class Bits {
    public:
        void resize(std::size_t count);
        bool empty() const { return words_.empty(); }
        std::size_t words_per_row() const { return per_row_; }
        const std::uint64_t* row(PieceId id) const { return &words_[static_cast<std::size_t>(id) * per_row_]; }
        bool at(PieceId row_id, PieceId column) const { return (row(row_id)[column / 64] >> (column % 64) & 1) != 0; }
        void set(PieceId row_id, PieceId column) {
            words_[static_cast<std::size_t>(row_id) * per_row_ + static_cast<std::size_t>(column / 64)] |=
                std::uint64_t(1) << (column % 64);
        }
        Bits transposed(std::size_t count) const;

    private:
        std::vector<std::uint64_t> words_;
        std::size_t per_row_ = 0;
    };

    bool behind(PieceId piece, PieceId plane) const;
    /// Adds the piece unless its plane or the shaft leave it out.
    void consider(PieceId piece, const Shaft& shaft, const PatchShape& shooter, const PatchShape& receiver,
                  std::vector<Obstacle>& out) const;

    const Scene& scene_;
    const Planes& planes_;
    // Small scenes: which pieces lie wholly behind a plane (by plane), and behind or before which planes a piece lies.
    Bits behind_, behind_of_, before_of_;
    // Large ones: a tree.
    std::optional<BoxTree> tree_;
};

}  // namespace cob::radiosity
