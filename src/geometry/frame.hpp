/// \file
/// Box and piece in the coordinates of the box's frame, over any number type.
///
/// The frame (SPEC 4): a = u.(p - o), b = w.(p - o), z = n.(p - o), with o near the element, n its normal, u its
/// base-edge direction and w = n x u. The three directions may have any lengths: that is an affine change of
/// coordinates, in which the box stays parallel to the axes and every question of SPEC 5 keeps its answer.
#pragma once

#include "cob/arithmetic.hpp"

#include <array>
#include <type_traits>

namespace cob {

// What a number type may do in its own way (wide integers look at one bit, intervals may not know).
template <class Number>
Number lesser(const Number& a, const Number& b) {
    return b < a ? b : a;
}
template <class Number>
Number greater(const Number& a, const Number& b) {
    return a < b ? b : a;
}
template <class Number>
bool greater_than_zero(const Number& a) {
    return a > 0;
}
template <class Number>
bool less_than_zero(const Number& a) {
    return a < 0;
}
/// The end of [low, high] where d x is least.
template <class Number>
const Number& first_along(const Number& d, const Number& low, const Number& high) {
    return greater_than_zero(d) ? low : high;
}
/// d times that end. Rounding keeps order, so that binary numbers need no branch, which would be taken at random.
template <class Number>
Number least_along(const Number& d, const Number& low, const Number& high) {
    if constexpr (std::is_floating_point_v<Number>)
        return lesser(Number(d * low), Number(d * high));
    else
        return d * first_along(d, low, high);
}
/// The value, or its opposite.
template <class Number>
Number signed_by(bool positive, const Number& value) {
    if constexpr (std::is_floating_point_v<Number>) {
        constexpr std::array<Number, 2> signs{-1, 1};
        return signs[positive ? 1 : 0] * value;
    } else {
        return positive ? value : -value;
    }
}

/// The box [low, high] of the frame's coordinates a, b, z; low.z is the element's plane. Where the height is
/// irrational (exact kernels only), high.z repeats low.z and the kernel knows what to add.
template <class Number>
struct FrameBox {
    Vector3<Number> low, high;
};

/// A convex planar piece with its corners in order, counter-clockwise as seen against its normal.
template <class Number>
struct FramePiece {
    const Vector3<Number>* corners = nullptr;
    int count = 0;
    Vector3<Number> low, high;  ///< Extents of the corners.

    FramePiece(const Vector3<Number>* corners_, int count_) : corners(corners_), count(count_) {
        low = high = corners[0];
        for (int i = 1; i < count; ++i)
            for (int axis = 0; axis < 3; ++axis) {
                low[axis] = lesser(low[axis], corners[i][axis]);
                high[axis] = greater(high[axis], corners[i][axis]);
            }
    }

    const Vector3<Number>& corner(int i) const { return corners[i]; }
    const Vector3<Number>& next(int i) const { return corners[i + 1 == count ? 0 : i + 1]; }

    /// Along its normal, of any length and never zero: of a convex polygon the sum of a fan's normals is exact
    /// and not zero even where the first corners are on one line.
    Vector3<Number> normal() const {
        if (count == 4) return cross(corners[2] - corners[0], corners[3] - corners[1]);
        Vector3<Number> sum = cross(corners[1] - corners[0], corners[2] - corners[0]);
        for (int i = 2; i + 1 < count; ++i) sum = sum + cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
        return sum;
    }
};

}  // namespace cob
