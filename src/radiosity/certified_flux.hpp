/// \file
/// Guaranteed bounds of the flux between two pieces behind occluders.
///
/// The receiver is cut into triangles until the bounds are near enough: along the lines at which the visible part of
/// the light changes its structure, where such a line crosses a cell, and in four where the integral over a cell is not
/// known well enough. Every number is an interval, every decision a certified sign: lower <= flux <= upper is a
/// theorem.
#pragma once

#include "radiosity/cell_view.hpp"

#include <cstdint>
#include <functional>
#include <vector>

namespace cob::radiosity {

struct CertifiedOptions {
    double width = 1e-6;             ///< Stop when the bounds are so near to each other,
    std::uint64_t max_cells = 4000;  ///< or when so many cells were looked at.
    std::function<void()> pulse{};   ///< Called now and then, if any; may throw to end the work.
};

struct CertifiedFlux {
    double low = 0, high = 0;
    std::uint64_t cells = 0;
};

/// \param receiving  Convex parts of the receiver's plane.
/// \param lights     Convex parts of the light, before the receiver's plane.
/// \param occluders  Convex, before both planes: what lies in either blocks nothing.
CertifiedFlux certified_flux(const PairShapes& shapes, const std::vector<ConvexPolygon>& receiving,
                             const std::vector<CornerLoop>& lights, const std::vector<CornerLoop>& occluders,
                             const CertifiedOptions& options);

}  // namespace cob::radiosity
