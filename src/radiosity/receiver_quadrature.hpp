/// \file
/// The flux that a receiver gets from an obstructed light: adaptive cubature of the exact values at its points,
/// over triangles that are split along shadow lines before anything else.
#pragma once

#include "radiosity/contour.hpp"
#include "radiosity/shadow_lines.hpp"

#include <functional>

namespace cob::radiosity {

/// What is seen of the light from one point: form factors, and a name of what bounds the visible region.
struct PointValue {
    double unobstructed = 0, visible = 0;
    std::uint64_t outline = 0;
};

/// What is certain of a triangle (cell_view.hpp).
struct Structure {
    enum class Kind : std::uint8_t {
        one,     ///< The visible region has one structure all over it;
        lines,   ///< it may change along a line; or
        curves,  ///< along a curve: where three edges pass one point.
    };
    Kind kind = Kind::one;
    double change = 0;  ///< What the form factor may change by at most within it.
};

struct ReceiverIntegrand {
    std::function<PointValue(const Point2D&)> at_point;
    std::function<Integral(const Triangle2D&)> unobstructed;  ///< Integral over a triangle, in closed form.
    std::function<Structure(const Triangle2D&)> structure;
};

struct QuadratureOptions {
    double tolerance = 1e-6;                 ///< Of the integral, absolute.
    std::uint64_t max_evaluations = 200000;  ///< Points; beyond, the error is what it is.
    std::function<void()> pulse{};           ///< Called now and then, if any; may throw to end the work.
};

struct QuadratureResult {
    Integral visible;  ///< The error bounds what the rules differ by, doubled.
    std::uint64_t evaluations = 0;
};

/// Integrates the visible form factor over convex regions of the receiver's plane.
QuadratureResult integrate_visible(const std::vector<std::vector<Point2D>>& regions,
                                   const std::vector<ShadowLine>& lines, const ReceiverIntegrand& integrand,
                                   const QuadratureOptions& options);

}  // namespace cob::radiosity
