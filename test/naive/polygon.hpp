/// \file
/// The naive twin of SPEC 2: one face line becomes exact convex pieces. Everything here is plain fractions, written
/// from SPEC alone and by other methods than the library, which it judges; it shares nothing with the library but
/// the number types. Slow and obviously right.
#pragma once

#include "cob/arithmetic.hpp"

#include <string>
#include <vector>

namespace cob::naive {

using Loop = std::vector<RationalPoint>;  ///< A closed loop of corners.

/// A convex planar part of a polygon, counter-clockwise as seen from its visible side, of positive area.
struct Piece {
    Loop corners;
    RationalPoint normal;  ///< Newell's.
};

/// A polygon, ready for questions.
struct Polygon {
    std::string refused;        ///< Why SPEC 2 refuses it; empty: it does not, and the rest is valid.
    Loop loop;                  ///< Consecutive vertices at one position count once.
    RationalPoint normal;       ///< Newell's, exact, unnormalised.
    int first = 0, second = 1;  ///< The axes of the view, such that the visible side is up.
    bool planar = false;        ///< All corners lie in one plane.
    /// Of a planar polygon: itself where it is convex, else trapezoids that make up the points it winds around; of
    /// another: SPEC 2's ears.
    std::vector<Piece> pieces;
};

/// SPEC 2, from the loop as its face line gives it.
Polygon prepare(const std::vector<Point>& corners);

/// Newell's normal of a loop.
RationalPoint newell(const Loop& loop);

}  // namespace cob::naive
