/// \file
/// What box and segment cases share: how a family places lattice loops in space.
#pragma once

#include "naive/cases.hpp"
#include "naive/shapes.hpp"

namespace cob::naive {

/// The family's map from the lattice to space; always invertible.
Placement placement_of(Dice& dice, Family family);
/// A loop's corners in space, perturbed where that is what the family is about.
std::vector<Point> place(Dice& dice, Family family, const Placement& placement, const LatticeLoop& loop);
/// A shape in any lattice plane near the cube from 0 to 4, one in five with a corner off its plane.
LatticeLoop spatial_shape(Dice& dice);

}  // namespace cob::naive
