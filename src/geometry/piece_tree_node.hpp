/// \file
/// The nodes of the tree of pieces, and the test of a segment against the bounds of a node's children.
#pragma once

#include "geometry/bounds.hpp"
#include "geometry/lanes.hpp"
#include "geometry/normalisation.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace cob {

/// Up to eight children and their bounds, in two cache lines. Everything is in a normalised scene.
struct alignas(64) PieceTreeNode {
    /// What a child is: a node, or ~ of an outline.
    using Child = std::int32_t;

    Lanes origin{}, step{};                               ///< By axis: bounds are origin + number * step.
    std::array<std::array<std::uint8_t, 8>, 6> bounds{};  ///< Low x, y, z, then high x, y, z; rounded outward.
    std::array<Child, 8> children{};
    unsigned filled = 0;  ///< Bit k: there is a child k.

    /// How much wider than a child its bounds have to be, beside what its coordinates are off: see NodeSegment.
    static constexpr double margin = 0x1p-19;
    /// Of as many children as there are bounds, eight at most, none of them empty.
    void set_bounds(const std::vector<Bounds>& of_children);
};

/// A segment, prepared for the bounds of nodes.
///
/// With e the ends' error, the segment from o in direction d, o in binary32 and d in binary64, is nowhere farther from
/// the exact one than 2^-23 + 3 e in any coordinate. It meets a bound b = origin + number * step at
///     t = number * (step / d) + (origin - o) / d.
/// Where coordinates are known to 2^-20, bounds lie in [-1.1, 1.1], o in [-4, 4], and the roundings of both products,
/// of the difference, its product, and the sum move b by less than 2^-24 (2.2 + 2.2 + 5.1 + 5.1 + 7.3) < 1.4 2^-20,
/// which with 2^-23 leaves room in the margin of 2^-19; where they are not, the bounds are wider by more. The rounding
/// of 1 / d and the comparison's are relative to t: 8 2^-24 between two parameters.
struct NodeSegment {
    Lanes origin{}, inverse{};                ///< By axis.
    std::array<std::size_t, 3> enter, leave;  ///< Which bounds are met first and last, by axis.

    explicit NodeSegment(const NormalSegment& segment);
};

/// Bit k: the segment may meet the bounds of child k.
using ChildrenMet = unsigned (*)(const PieceTreeNode& node, const NodeSegment& segment);
/// On any machine.
unsigned children_met(const PieceTreeNode& node, const NodeSegment& segment);
/// The same bits by AVX2; none where this processor has it not.
ChildrenMet children_met_of_processor();

}  // namespace cob
