/// \file
/// What the visibility of SPEC section 6 keeps of every piece: its plane by three corners, and in binary64 with an
/// error bound.
#pragma once

#include "cob/scene.hpp"
#include "geometry/large_pages.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace cob {

/// The plane of a piece. At `origin` the piece turns strictly left from `last` to `first`, so that
/// (first - origin) x (last - origin) is a normal that points to the visible side.
struct PiecePlane {
    VertexId origin = -1, first = -1, last = -1;
};

/// The plane in binary64, in one cache line, and what else the filters read, in the next. A point whose difference from
/// the origin is r lies where normal . r says, if that is beyond error * (the greatest coordinate of r) + size() * (how
/// far the point is off in each coordinate).
struct alignas(128) ApproximatePlane {
    Point normal;
    Point origin;      ///< A corner of the piece, the first of a triangle.
    double error = 0;  ///< Infinite where binary64 cannot hold the normal.
    /// Pieces of one number are known to lie in one plane: those of one planar polygon. -1: no other piece is.
    std::int32_t group = -1;
    std::uint32_t corner_count = 0;
    std::array<Point, 2> others;  ///< Of a triangle: its second and third corner.
    std::uint32_t turn = 0;       ///< The number of the corner that PiecePlane::origin is.

    double size() const { return std::abs(normal.x) + std::abs(normal.y) + std::abs(normal.z); }
};

class PieceTable {
public:
    explicit PieceTable(const Scene& scene);

    const Scene& scene() const { return *scene_; }
    PiecePlane plane(PieceId piece) const { return plane(piece, approximate(piece).turn); }
    const ApproximatePlane& approximate(PieceId piece) const { return planes_[static_cast<std::size_t>(piece)]; }
    /// The coordinate axis along which the piece is seen (SPEC 2): its normal is not zero there.
    int view_axis(PieceId piece) const { return polygon(piece).view.axis; }
    /// Sign of the normal along that axis.
    Sign view_side(PieceId piece) const {
        const View2& view = polygon(piece).view;
        return view.first == (view.axis + 1) % 3 ? Sign::positive : Sign::negative;
    }
    std::size_t memory() const;

private:
    PiecePlane plane(PieceId piece, std::uint32_t turn) const;
    const Polygon& polygon(PieceId piece) const { return scene_->polygon(scene_->piece(piece).polygon); }

    const Scene* scene_;
    LargeVector<ApproximatePlane> planes_;
};

}  // namespace cob
