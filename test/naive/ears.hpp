/// \file
/// The naive twin's ear cutting, word for word as in SPEC 2.
#pragma once

#include "cob/arithmetic.hpp"

#include <array>
#include <vector>

namespace cob::naive {

/// A position as seen (SPEC 2).
struct Seen {
    Rational s, t;
    friend bool operator==(const Seen& a, const Seen& b) { return a.s == b.s && a.t == b.t; }
};

/// A side as seen.
struct Side {
    Seen from, to;
};

/// Twice the signed area of (a, b, c): positive where the way a, b, c turns left at b.
Rational turn(const Seen& a, const Seen& b, const Seen& c);
/// (b - a) . (c - b): negative where a way without a turn goes back at b.
Rational ahead(const Seen& a, const Seen& b, const Seen& c);
/// Some point of the closed side lies strictly inside the counter-clockwise triangle.
bool meets_open_triangle(const Side& side, const std::array<Seen, 3>& triangle);

/// Triangles cut off a loop, as indices into it.
struct Ears {
    std::vector<std::array<std::size_t, 3>> triangles;  ///< (before, ear, after), in the order they are cut.
    bool complete = true;                               ///< False: the loop got stuck and is refused.
};

/// Cuts a loop, given by its positions in space and as seen.
Ears cut_ears(const std::vector<RationalPoint>& loop, const std::vector<Seen>& seen);

}  // namespace cob::naive
