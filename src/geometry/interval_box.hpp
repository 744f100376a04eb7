/// \file
/// The exact box, enclosed in intervals: what the interval variant knows of it.
#pragma once

#include "arithmetic/interval.hpp"
#include "geometry/exact_box.hpp"
#include "geometry/frame.hpp"

namespace cob {

/// Directions are divided by powers of two so that they neither over- nor underflow.
struct IntervalBox {
    Point origin;
    std::array<Vector3<Interval>, 3> directions;
    FrameBox<Interval> frame;

    explicit IntervalBox(const ExactBox& box);
};

}  // namespace cob
