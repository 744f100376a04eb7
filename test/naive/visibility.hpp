/// \file
/// The naive twin of SPEC 6: every contact as an exact point, and closing around it by testing directions.
#pragma once

#include "naive/polygon.hpp"

namespace cob::naive {

enum class Visibility { clear, grazing, blocked };
const char* to_text(Visibility visibility);

/// The open segment from x to y, x != y, against the union of all closed pieces.
Visibility visibility(const std::vector<const Polygon*>& scene, const RationalPoint& x, const RationalPoint& y);

/// The point is one of the closed piece.
bool lies_on(const RationalPoint& point, const Piece& piece);

}  // namespace cob::naive
