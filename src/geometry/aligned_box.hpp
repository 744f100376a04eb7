/// \file
/// The box whose frame is parallel to the coordinate axes, as exact binary64 numbers: what integers are made from
/// without fractions, and what corners are compared with without rounding. Most boxes of most scenes are of this kind.
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
    Pair base;  ///< The element's plane along z.
    /// Where the box begins (0) and ends (1) along a, b and z, widened and with its height; nothing where some
    /// side has too many bits for a pair. rest has the sign of nearest and is less than its last bit.
    std::optional<std::array<std::array<Pair, 2>, 3>> sides;
    int unit = 0;  ///< All of sides are multiples of 2^unit.

    /// Of a point, exactly.
    double coordinate(const Point& p, int k) const {
        const auto i = static_cast<std::size_t>(k);
        return negative[i] ? -p[axis[i]] : p[axis[i]];
    }
    /// Sign of a coordinate minus that of a side, exactly; sides must be there.
    Sign compare(double value, int k, int end) const {
        const Pair& side = (*sides)[static_cast<std::size_t>(k)][static_cast<std::size_t>(end)];
        return value != side.nearest ? sign_of(value - side.nearest) : -sign_of(side.rest);
    }

    /// Nothing where the box is not parallel to the axes, or not made of binary64 numbers.
    static std::optional<AlignedBox> of(const BoxQuestion& question);

private:
    void find_sides(const Corners& corners, double margin, double height);
};

}  // namespace cob
