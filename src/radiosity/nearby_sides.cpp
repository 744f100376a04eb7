#include "radiosity/nearby_sides.hpp"

#include "radiosity/cells.hpp"
#include "radiosity/lambert.hpp"

namespace cob::radiosity {
namespace {

/// In radii of the cell. Beyond, what a side adds is smooth on the cell.
constexpr double nearby = 2;

}  // namespace

SplitContour split_off_nearby_sides(const Contour& contour, const Triangle2D& cell,
                                    const std::function<Vector3<double>(VertexId)>& corner, double may_be_off) {
    const Point2D middle = centroid(cell);
    const Vector3<double> centre{middle.s, middle.t, 0};
    const double radius = reach(cell);
    const std::vector<Vector3<double>> around = in_space(left_around(cell));

    SplitContour split;
    split.others.sides = split.light_sides.sides = contour.sides;
    for (const ContourArc& arc : contour.arcs) {
        const auto& [a, b] = contour.sides[static_cast<std::size_t>(arc.side)];
        const bool comes_near = length(nearest_on_side(corner(a), corner(b), centre) - centre) < nearby * radius;
        const bool whole_side = arc.from.vertex >= 0 && arc.to.vertex >= 0;
        if (!comes_near || !whole_side) {
            split.others.arcs.push_back(arc);
            if (comes_near) split.rough.push_back({a, b});
            if (comes_near && !arc.of_light) split.hidden_is_smooth = false;
            continue;
        }
        // The polygons of the closed form turn the other way around than contours.
        (arc.of_light ? split.over_light_sides : split.over_occluder_sides) +=
            mutual_flux_of_side(around, corner(arc.to.vertex), corner(arc.from.vertex), may_be_off);
        if (arc.of_light) split.light_sides.arcs.push_back(arc);
    }
    return split;
}

}  // namespace cob::radiosity
