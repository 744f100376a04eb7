/// \file
/// The sides of a contour that come near a cell, integrated over the cell in closed form.
///
/// What a side adds to the form factor (Lambert) peaks on the scale of the side's distance, and cubature would have to
/// resolve it; the contour integral does not mind. It needs whole sides: an arc that another polygon ends is left.
#pragma once

#include "radiosity/cell_view.hpp"
#include "radiosity/contour.hpp"

#include <functional>

namespace cob::radiosity {

/// A contour in parts: visible = others + sides of the light + sides of occluders.
struct SplitContour {
    Contour others;
    Contour light_sides;  ///< The whole sides of the light that come near, which bound nothing of what is hidden.
    Integral over_light_sides, over_occluder_sides;  ///< What the whole sides that come near add, over the cell.
    std::vector<std::array<VertexId, 2>> rough;      ///< Sides of those of the others that come near.
    bool hidden_is_smooth = true;                    ///< None of these is an occluder's.
};

/// Corners as (s, t, h) over the cell's plane. Each side is integrated until its error is below `may_be_off`.
SplitContour split_off_nearby_sides(const Contour& contour, const Triangle2D& cell,
                                    const std::function<Vector3<double>(VertexId)>& corner, double may_be_off);

}  // namespace cob::radiosity
