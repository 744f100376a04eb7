/// \file
/// Two pieces that face each other, and what stands between them.
#pragma once

#include "cob/candidates.hpp"
#include "geometry/convex_polygon.hpp"
#include "geometry/shaft.hpp"
#include "radiosity/receiver_quadrature.hpp"
#include "radiosity/visible_light.hpp"

#include <vector>

namespace cob::radiosity {

enum class Passage : std::uint8_t { not_facing, hidden, unobstructed, obstructed };

/// A polygon as form factors need it.
struct PolygonParts {
    std::vector<PieceId> pieces;
    std::vector<PieceId> on_top;  ///< Pieces of the sheets that hide parts of it (choice 9).
    double area = 0;              ///< In scaled units.
};

/// What is common to all pairs of a scene.
struct PairContext {
    const Scene& scene;
    const CandidateSource& candidates;
    const PreparedPieces& pieces;
    const std::vector<PolygonParts>& polygons;
};

/// The pair of a receiving and a sending piece, parts not in front of the other cut off, exactly.
struct PiecePair {
    PieceId receiver = -1, light = -1;
    Passage passage = Passage::not_facing;
    std::vector<ConvexPolygon> receiving, sending;  ///< Convex parts, in front of the other and on top.
    ConvexPolygon whole_sending;                    ///< In front of the receiver, whether on top or not.
    std::vector<PieceId> occluders;                 ///< Those that meet the shaft, ascending.
};

/// Decides exactly how the two see each other.
PiecePair make_pair(const PairContext& context, PieceId receiver, PieceId light);

/// Integral of the form factor to the light over the receiver, that is area x form factor, in scaled units.
QuadratureResult flux_between(const PairContext& context, const PiecePair& pair, const QuadratureOptions& options);

/// Certified bounds of the same integral: its middle and half its width.
QuadratureResult certified_flux(const PairContext& context, const PiecePair& pair, const QuadratureOptions& options);

}  // namespace cob::radiosity
