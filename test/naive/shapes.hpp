/// \file
/// Loops on the integer lattice, the awkward ones of real scenes above all, and their placement in space.
#pragma once

#include "naive/dice.hpp"

#include "cob/arithmetic.hpp"

#include <vector>

namespace cob::naive {

using Lattice = Vector3<std::int64_t>;  ///< A point of the integer lattice.
using LatticeLoop = std::vector<Lattice>;

/// A loop in the plane z = 0, in the square from 0 to 4: triangles, rectangles, angular letters, frames with a hole on
/// a bridge, pinches, spikes, straight angles, repeated vertices, loops run twice, and random ones (which may cross
/// themselves, and be refused).
LatticeLoop flat_shape(Dice& dice);
/// A random closed way over few lattice points: many repeat, touch, turn back or cross.
LatticeLoop random_way(Dice& dice);

/// Puts a shape into space: s and t run along e1 and e2 from origin.
LatticeLoop embed(const LatticeLoop& shape, const Lattice& origin, const Lattice& e1, const Lattice& e2);
LatticeLoop reversed(LatticeLoop loop);

/// An exact affine map from the lattice to binary64 points: 2^exponent (matrix p + offset).
struct Placement {
    Lattice rows[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    Lattice offset{0, 0, 0};
    int exponent = 0;

    Point operator()(const Lattice& point) const;
    RationalPoint operator()(const RationalPoint& point) const;
};

/// Permutes and reflects the axes.
Placement axis_placement(Dice& dice);
/// A rotation by a rational angle about a rational axis, times its denominator (Euler and Rodrigues, from an integer
/// quaternion): lengths keep their proportions, and nothing is rounded.
Placement rotated_placement(Dice& dice);
/// Any invertible small integer matrix: straight lines and planes stay so, lengths and angles do not.
Placement sheared_placement(Dice& dice);

/// Some coordinates moved to a neighbouring binary64 number, each with a chance of 1 in `rarity`.
void nudge(Dice& dice, std::vector<Point>& points, int rarity);

}  // namespace cob::naive
