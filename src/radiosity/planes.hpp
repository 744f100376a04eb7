/// \file
/// Planes and sides of pieces in binary64 with error bounds, and exactly where those do not tell: which side a point
/// is on, and what a segment certainly does to a piece. Coordinates in units (mesh.hpp).
#pragma once

#include "cob/arithmetic.hpp"
#include "cob/scene.hpp"
#include "radiosity/shaft.hpp"

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
    const Bounds& bounds(PieceId piece) const { return bounds_[static_cast<std::size_t>(piece)]; }
    /// Unit normal to the visible side, rounded.
    const Point& normal(PieceId piece) const { return normals_[static_cast<std::size_t>(piece)]; }

    /// Side of a point, off by a few roundings, on a piece's plane; nothing where that does not decide.
    std::optional<Sign> side(PieceId plane, const Point& rounded) const;
    /// The same exactly, of a point in scene coordinates.
    Sign exact_side(PieceId plane, const ExactPoint& point) const;
    /// On which closed sides of a plane a piece lies; exact. Both: in the plane.
    struct ClosedSides {
        bool before = true;  ///< No corner lies strictly behind it.
        bool behind = true;  ///< No corner lies strictly in front of it.
    };
    ClosedSides closed_sides(PieceId piece, PieceId plane) const;

    /// The ends are off by a few roundings. The sides are those of side(), as far as they are known.
    Crossing crossing(PieceId piece, const Point& from, std::optional<Sign> side_from, const Point& to,
                      std::optional<Sign> side_to) const;

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
    std::vector<Bounds> bounds_;
};

}  // namespace cob::radiosity
