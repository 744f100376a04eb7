/// \file
/// Exitance along a line across a shadow: of the solution, beside what the same shots bring to each point itself.
#pragma once

#include "cob/solver.hpp"

#include <string>

namespace cob::report {

struct LineOptions {
    Point from, to;  ///< On a polygon; each point counts as on the nearest polygon.
    int points = 200;
    int samples = 64;  ///< Of each shooter from each point: 64 times the shots segments a point.
};

/// Writes base.csv (`share,x,y,z,r,g,b,reference_r,reference_g,reference_b`) and, by gnuplot where it is installed,
/// base.svg and base.png of the green channel.
void write_exitance_line(const RadiositySolver& solver, const LineOptions& options, const std::string& base);

}  // namespace cob::report
