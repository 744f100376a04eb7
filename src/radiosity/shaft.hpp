/// \file
/// The shaft between two bounding boxes (Haines and Wallace 1991): what does not meet the hull of both cannot stand
/// between any two of their points. Names too many, never too few.
#pragma once

#include "cob/arithmetic.hpp"
#include "scene/box_tree.hpp"

#include <array>
#include <vector>

namespace cob::radiosity {

using Bounds = std::array<double, 6>;  ///< xmin, ymin, zmin, xmax, ymax, zmax; in units (mesh.hpp).

/// Of points that are off by a few roundings.
Bounds bounds_of(const Point* points, int count);

class Shaft {
public:
    Shaft(const Bounds& a, const Bounds& b);

    /// False only where the convex hull of the corners certainly misses the hull of both boxes.
    bool may_meet(const Bounds& bounds, const std::vector<Point>& corners) const;
    /// The same of a box.
    bool may_meet(const Bounds3& box) const;

private:
    /// Parallel to an axis, supporting both boxes; outside where a p[first] + b p[second] > c.
    struct Side {
        int first, second;
        double a, b, c;
    };

    Bounds both_;
    std::array<Side, 12> sides_{};
    int side_count_ = 0;
};

}  // namespace cob::radiosity
