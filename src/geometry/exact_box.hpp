/// \file
/// The box in fractions (SPEC 4): what the exact stages start from and what explanations print.
#pragma once

#include "cob/geometry.hpp"
#include "geometry/frame.hpp"

#include <array>
#include <optional>

namespace cob {

/// The frame's exact directions, as primitive integer vectors, and the box in its coordinates.
struct ExactBox {
    Point origin;                                ///< o, a binary64 point near the element.
    std::array<Vector3<Integer>, 3> directions;  ///< u, w, n: perpendicular, of different lengths.
    FrameBox<Rational> frame;                    ///< high.z: see FrameBox.
    Rational height_squared;                     ///< Of h in units of z: (h |n|)^2.
    std::optional<Rational> height;              ///< h |n|, where that is rational.

    /// Throws InputError where SPEC 4 refuses the box.
    explicit ExactBox(const BoxQuestion& question);

    /// What RationalKernel needs: zero where frame.high.z is the top.
    Rational rise_squared() const { return height ? Rational(0) : height_squared; }

    Vector3<Rational> to_frame(const RationalPoint& p) const;
};

/// The same box in integers: coordinate k of the frame times denominator[k], in units of 2^exponent[k].
struct IntegerBox {
    std::array<Vector3<Integer>, 3> directions;  ///< u, w, n, each times its denominator.
    std::array<int, 3> direction_bits{};         ///< Of the largest component.
    Vector3<Integer> low, high;                  ///< high.z: see FrameBox.
    Vector3<int> exponent;
    Integer rise;  ///< The irrational height lies in (rise, rise + 1) 2^rise_exponent; 0: rational.
    int rise_exponent = 0;
    std::array<int, 3> limit_exponent{};  ///< Coordinates of the box, top included, are less than 2^this.
    int unit = 0;                         ///< The least of all exponents.

    explicit IntegerBox(const ExactBox& box);
};

}  // namespace cob
