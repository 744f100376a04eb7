/// \file
/// What is seen of a convex light behind convex occluders from every point of a triangle at once: the border of the
/// visible region.
///
/// The border consists of what the occluders leave of the light's sides, and of what lies before the light of the
/// occluders' sides, less what others hide: no region is cut, and no sign is asked for that does not bear on the
/// border. Where two shapes meet along a line of sides, what lies on its left and on its right is told apart by which
/// of their planes are the same for all x, exactly.
#pragma once

#include "radiosity/cell_signs.hpp"

#include <vector>

namespace cob::radiosity {

/// A part of the border: on the plane through x and a side ab, from ray to ray. Its angle counts positive around
/// (a - x) x (b - x).
struct ContourArc {
    std::int32_t side = -1;
    ContourRay from, to;
    bool of_light = false;  ///< Else of an occluder.
};

/// The border of a visible region. Arcs run around it to the left, as seen from x; those of the light's parts may
/// cancel.
struct Contour {
    std::vector<ContourArc> arcs;
    std::vector<std::array<VertexId, 2>> sides;  ///< By the numbers that arcs and rays name.
    double sliver = 0;                           ///< See SignsOverCell.
    std::vector<DoubtfulSign> doubtful;          ///< The contour is that of the centroid. Nothing where certain.
};

/// A triangle of the receiver's plane. Functions throw UndecidedSign where what they ask for is not certain all over
/// it.
class CellView {
public:
    CellView(const PairShapes& shapes, const Triangle2D& cell) : shapes_(&shapes), signs_(shapes, cell) {}
    /// A point of a cell.
    CellView(const CellView& around, const Point2D& point) : shapes_(around.shapes_), signs_(around.signs_, point) {}

    /// Those of the occluders whose cones may meet a light's from some point of the cell. Never throws.
    std::vector<const CornerLoop*> between(const std::vector<CornerLoop>& lights,
                                           const std::vector<const CornerLoop*>& occluders);

    /// The border of what is seen of the lights together, for every x of the cell. Where quadratic determinants are not
    /// decided, they may be taken for so up to `doubt`; see SignsOverCell.
    Contour visible_contour(const std::vector<CornerLoop>& lights, const std::vector<const CornerLoop*>& occluders,
                            double doubt = 0);

private:
    bool apart(const CornerLoop& one, const CornerLoop& other);
    std::optional<Sign> outside_of(PlaneRef side, const CornerLoop& other);

    const PairShapes* shapes_;
    SignsOverCell signs_;
};

}  // namespace cob::radiosity
