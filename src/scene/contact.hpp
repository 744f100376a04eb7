/// \file
/// How parts of polygons touch in space, exactly.
#pragma once

#include "arithmetic/orientation.hpp"
#include "cob/scene.hpp"

#include <array>
#include <vector>

namespace cob {

/// Strictly between two different points, on the line through them.
bool is_between(const Point& point, const Point& from, const Point& to);

/// How two pieces overlap in one plane.
enum class Overlap : std::uint8_t { none, same_facing, opposite_facing };

/// A piece prepared to be compared with others.
class Sheet {
public:
    Sheet(const Scene& scene, const Piece& piece);

    /// Whether another piece lies in the same plane and overlaps in an area.
    Overlap overlap(const Scene& scene, const Piece& other) const;

private:
    View2 view_;
    std::vector<Point2> seen_;      ///< Counter-clockwise.
    std::array<Point, 3> corners_;  ///< Three that are not on one line, in the order of the loop.
};

/// The loops visit the same positions in the same cyclic order, in either direction.
bool is_duplicate(const Scene& scene, PolygonId first, PolygonId second);

}  // namespace cob
