/// \file
/// Planes and sides of pieces in binary64 with error bounds, and exactly where those do not tell: which side a point
/// is on, and what a segment certainly does to a piece. Coordinates in units (mesh.hpp).
#pragma once

#include "cob/arithmetic.hpp"
#include "cob/scene.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace cob::radiosity {

/// What binary64 can say about an open segment and a closed piece.
enum class Crossing : std::uint8_t { misses, pierces, unknown };

class Planes {
public:
    Planes(const Scene& scene, int exponent);

    const std::vector<Point>& corners(PieceId piece) const { return corners_[static_cast<std::size_t>(piece)]; }
    const std::array<double, 6>& bounds(PieceId piece) const { return bounds_[static_cast<std::size_t>(piece)]; }
    /// Unit normal to the visible side, rounded.
    const Point& normal(PieceId piece) const { return normals_[static_cast<std::size_t>(piece)]; }

    /// Side of a point, off by a few roundings, on a piece's plane; nothing where that does not decide.
    std::optional<Sign> side(PieceId plane, const Point& rounded) const;
    /// The same exactly, of a point in scene coordinates.
    Sign exact_side(PieceId plane, const ExactPoint& point) const;
    /// No corner of the piece lies strictly in front of the plane; exact.
    bool wholly_behind(PieceId piece, PieceId plane) const;

    /// The ends are off by a few roundings. side_from: side() of the beginning.
    Crossing crossing(PieceId piece, const Point& from, std::optional<Sign> side_from, const Point& to) const;

private:
    struct Plane {
        Point origin, normal;
        double error;                      ///< Bound of side()'s error per L1 distance from the origin.
        std::array<VertexId, 3> vertices;  ///< Of the scene, not on one line.
    };

    const Scene& scene_;
    std::vector<Plane> planes_;
    std::vector<Point> normals_;
    std::vector<std::vector<Point>> corners_;
    std::vector<std::array<double, 6>> bounds_;
};

}  // namespace cob::radiosity
