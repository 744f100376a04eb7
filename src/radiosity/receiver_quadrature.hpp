/// \file
/// The flux that a receiver gets from an obstructed light: adaptive cubature of the exact values at its points.
///
/// The receiver is cut into triangles along the lines at which the visible part of the light changes its structure
/// (the events EV and VE of discontinuity meshing; Heckbert 1992, Lischinski, Tampieri, Greenberg 1992), each found
/// where it is needed: as the determinant that keeps a triangle's structure from being certain (cell_view.hpp). The
/// curves of three edges are left to refinement.
#pragma once

#include "radiosity/cell_view.hpp"
#include "radiosity/contour.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace cob::radiosity {

/// Form factors from one point.
struct PointValue {
    double unobstructed = 0, visible = 0;
};

/// What is certain of a triangle.
struct Structure {
    /// Nothing where the visible region certainly has one structure all over the triangle: the form factor is smooth.
    std::optional<UndecidedSign> event;
    double change = 0;  ///< What one side's motion may change the form factor by at most, where there is an event.
    std::vector<const CornerLoop*> occluders;  ///< Those that may matter to it.
};

struct ReceiverIntegrand {
    /// Given those occluders of a triangle around that may matter to it.
    std::function<Structure(const Triangle2D&, const std::vector<const CornerLoop*>&)> structure;
    std::function<PointValue(const Point2D&, const std::vector<const CornerLoop*>&)> at_point;
    std::function<Integral(const Triangle2D&)> unobstructed;  ///< Integral over a triangle, in closed form.
};

struct QuadratureOptions {
    double tolerance = 1e-6;                 ///< Of the integral, absolute.
    std::uint64_t max_evaluations = 200000;  ///< Points; beyond, the error is what it is.
    std::function<void()> pulse{};           ///< Called now and then, if any; may throw to end the work.
};

struct QuadratureResult {
    Integral visible;
    std::uint64_t evaluations = 0;
};

/// Integrates the visible form factor over triangles of the receiver's plane.
QuadratureResult integrate_visible(const std::vector<Triangle2D>& triangles,
                                   const std::vector<const CornerLoop*>& occluders, const ReceiverIntegrand& integrand,
                                   const QuadratureOptions& options);

}  // namespace cob::radiosity
