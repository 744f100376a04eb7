/// \file
/// The plane of a piece.
#pragma once

#include "cob/scene.hpp"

#include <array>

namespace cob {

/// Three corners of a convex piece that are not on one line, in its order: counter-clockwise from its visible side.
std::array<Point, 3> plane_of(const Scene& scene, const Piece& piece);

}  // namespace cob
