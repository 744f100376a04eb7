/// \file
/// The flux that a receiver gets from an obstructed light: adaptive cubature of the exact values at its points.
///
/// The receiver is cut into triangles along the lines and the chords of the curves at which the visible part of the
/// light changes its structure (the events EV, VE and EEE of discontinuity meshing; Heckbert 1992, Lischinski,
/// Tampieri, Greenberg 1992), each found where it is needed: as the determinant that keeps a triangle's structure from
/// being certain (cell_signs.hpp). Where it is certain, the integrand is analytic, and its values follow from one
/// contour.
#pragma once

#include "radiosity/cell_view.hpp"
#include "radiosity/contour.hpp"
#include "radiosity/penumbra.hpp"

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
    /// Nothing where the visible region certainly, or but for doubtful signs, has one structure all over the triangle.
    std::optional<UndecidedSign> event;
    double change = 0;  ///< What one side's motion may change the form factor by, where there is an event.
    std::vector<const CornerLoop*> occluders;  ///< Those that may matter to it.
    Contour contour;                           ///< Of the visible region, where there is no event.
    CellView view;
};

struct ReceiverIntegrand {
    /// Given those occluders of a triangle around that may matter to it.
    std::function<Structure(const Triangle2D&, const std::vector<const CornerLoop*>&)> structure;
    /// At a point of a triangle of whatever structure.
    std::function<PointValue(const Point2D&, const Structure&)> exact;
    /// By the contour of the triangle: the same but for rounding, and cheaper. By some of its arcs: what these add.
    std::function<PointValue(const Point2D&, const Contour&)> by_contour;
    /// Integral over a triangle, in closed form; its error may be that large.
    std::function<Integral(const Triangle2D&, double may_be_off)> unobstructed;
    /// Between a triangle's occluders hiding all they may and nothing.
    std::function<FluxRange(const Triangle2D&, const std::vector<const CornerLoop*>&, double may_be_off)> range;
    std::function<Vector3<double>(VertexId)> corner;  ///< Of an occluder: (s, t, h).
};

struct QuadratureOptions {
    double tolerance = 1e-6;                  ///< Of the integral, absolute.
    std::uint64_t max_evaluations = 1000000;  ///< Points; beyond, the error is what it is.
    std::function<void()> pulse{};            ///< Called now and then, if any; may throw to end the work.
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
