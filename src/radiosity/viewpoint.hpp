/// \file
/// The scene as it is seen from one point: vertices relative to it, and the sides of pieces on which it lies.
#pragma once

#include "cob/arithmetic.hpp"
#include "cob/scene.hpp"
#include "radiosity/bounded.hpp"

#include <vector>

namespace cob::radiosity {

/// What every viewpoint needs of a scene, made once: pieces by their strict corners, vertices by their position.
class PreparedPieces {
public:
    explicit PreparedPieces(const Scene& scene);

    const Scene& scene() const { return *scene_; }
    /// The corners of a piece at which it turns, counter-clockwise as seen; at least three. Vertices at one
    /// position have one number here, so that neighbours share them.
    View<VertexId> corners(PieceId piece) const;
    /// A power of two that brings the scene to a size of about 1.
    double scale() const { return scale_; }

private:
    const Scene* scene_;
    std::vector<VertexId> corners_;
    std::vector<std::uint32_t> first_corner_;
    double scale_ = 1;
};

/// One viewpoint x. Cheap to make; not to be shared between threads.
class Viewpoint {
public:
    Viewpoint(const PreparedPieces& pieces, const ExactPoint& position) : pieces_(&pieces), position_(position) {}

    const PreparedPieces& pieces() const { return *pieces_; }
    const ExactPoint& position() const { return position_; }

    /// Vertex - x, times the pieces' scale.
    BoundedVector towards(VertexId vertex) const;
    /// Vertex - x.
    RationalPoint exact_towards(VertexId vertex) const;

    /// The side of the piece's plane on which x lies: positive in front of it.
    Sign side_of(PieceId piece) const;
    /// A normal of the piece, towards its visible side (positively scaled).
    BoundedVector normal(PieceId piece) const;
    RationalPoint exact_normal(PieceId piece) const;
    /// Normal . (x - piece): positive in front.
    BoundedNumber height_over(PieceId piece) const;
    Rational exact_height_over(PieceId piece) const;

    /// The side of the piece's plane on which a vertex lies: positive in front of it.
    Sign side_of(PieceId piece, VertexId vertex) const;

private:
    const RationalPoint& exact_position() const;

    const PreparedPieces* pieces_;
    ExactPoint position_;
    mutable std::optional<RationalPoint> exact_position_;
};

}  // namespace cob::radiosity
