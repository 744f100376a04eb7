/// \file
/// The box whose frame is parallel to the coordinate axes, as exact binary64 numbers: what integers are made from
/// without fractions. Most boxes of most scenes are of this kind.
#pragma once

#include "arithmetic/wide_integer.hpp"
#include "cob/geometry.hpp"

#include <array>
#include <optional>

namespace cob {

/// Frame coordinate k is the coordinate axis[k], negated where negative[k]; o is the world's origin.
struct AlignedBox {
    /// The exact sum of two binary64 numbers.
    struct Pair {
        double nearest = 0, rest = 0;
    };

    std::array<int, 3> axis{};
    std::array<bool, 3> negative{};
    std::array<Pair, 2> low, high;         ///< The element's extents, not widened, along a and b.
    Pair base;                             ///< The element's plane along z.
    double margin = 0, height = 0;         ///< Exactly those of the question.
    int margin_bits = 0, height_bits = 0;  ///< margin 2^margin_bits is an integer; so for the height.
    int unit = 0;  ///< low, high, base, the widened extents and the height are multiples of 2^unit.

    /// Nothing where the box is not parallel to the axes, or not made of binary64 numbers.
    static std::optional<AlignedBox> of(const BoxQuestion& question);
};

}  // namespace cob
