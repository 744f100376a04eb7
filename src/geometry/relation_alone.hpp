/// \file
/// The relation of a polygon to a box without the cover test, to see what that test costs.
#pragma once

#include "cob/geometry.hpp"

namespace cob {

Relation relation_alone(const Scene& scene, PolygonId polygon, const Box& box);

}  // namespace cob
