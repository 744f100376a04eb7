/// \file
/// Exitance along a line across a shadow: of the solution, beside what the same shots bring to each point itself.
#pragma once

#include "cob/progress.hpp"
#include "cob/solver.hpp"

#include <array>
#include <string>
#include <vector>

namespace cob::report {

struct LineOptions {
    /// On a polygon: each point counts as on the nearest of those pieces that lie under or over it, seen along their
    /// normals. Where there is none, it has no values.
    Point from, to;
    int points = 200;
    int samples = 64;  ///< Of each shooter from each point: 64 times the shots segments a point.
    int threads = 0;   ///< 0: as many as the machine has.
};

class ExitanceLine {
public:
    /// Finds the points' pieces. The solver must outlive it. Throws InputError where no point has one.
    ExitanceLine(const RadiositySolver& solver, const LineOptions& options);
    /// Writes base.csv (`share,x,y,z,r,g,b,reference_r,reference_g,reference_b`, the last six empty where a point has
    /// no values) and, by gnuplot where it is installed, base.svg and base.png of the green channel.
    /// False where there is no plot. Progress counts points.
    bool write(const std::string& base, const Progress& progress = {}) const;

private:
    /// A root, and bilinear (of a triangle: barycentric) coordinates in it.
    struct Place {
        RootId root = -1;
        std::array<double, 2> at{};
    };
    double share(std::size_t k) const;
    Point point(std::size_t k) const;
    Place nearest(const Point& point) const;

    const RadiositySolver& solver_;
    LineOptions options_;
    std::vector<Place> places_;
};

}  // namespace cob::report
