/// \file
/// How far a box may be scaled about its centre before an answer changes: estimated in binary64, with an error bound.
#pragma once

#include "cob/classification.hpp"
#include "cob/geometry.hpp"
#include "cob/scene.hpp"

#include <array>
#include <vector>

namespace cob {

/// |factor - 1| at the nearest switch lies within [low, high].
struct Clearance {
    double low, high;
};

/// The box in coordinates in which it is the cube [-1, 1]^3 (x along u, y along w, z along n).
class BoxFrame {
public:
    explicit BoxFrame(const BoxQuestion& question);

    /// False where binary64 overflows or underflows: then nothing below means anything.
    bool usable() const { return error(0) < 1; }
    const Point& centre() const { return centre_; }
    Point to_cube(const Point& p) const;
    /// Bound for the error of to_cube() of points whose coordinates are at most this.
    double error(double largest_coordinate) const;
    const std::vector<Point>& corners() const { return corners_; }

private:
    Point centre_, u_, w_, n_;
    std::array<double, 3> half_{};
    std::vector<Point> corners_;  ///< Of the element.
    double largest_ = 0, smallest_half_ = 0;
};

/// Switches of "does the polygon meet the box"; relation must be crossing or disjoint.
Clearance meeting_clearance(const Scene& scene, PolygonId polygon, const BoxFrame& frame, Relation relation);
/// Switches of "does it cover", of a polygon that crosses.
Clearance covering_clearance(const Scene& scene, PolygonId polygon, const BoxFrame& frame, bool covers);
/// Switches of "does the light face the element".
Clearance facing_clearance(const Scene& scene, PolygonId light, const BoxFrame& frame, bool faces);

}  // namespace cob
