/// \file
/// What of a polygonal light is seen from a point, exactly, and its form factor (SPEC 8).
#pragma once

#include "radiosity/cone.hpp"
#include "radiosity/lambert.hpp"

#include <vector>

namespace cob::radiosity {

/// A light as it is seen: its pieces and what lies on top of it in its own plane.
struct LightPieces {
    std::vector<PieceId> pieces;
    std::vector<PieceId> on_top;  ///< Pieces of sheets in the light's plane that hide it (choice 9).
};

/// A receiver's normal, prepared once.
struct ReceiverNormal {
    explicit ReceiverNormal(const RationalPoint& normal);

    RationalPoint exact;
    BoundedVector bounded;  ///< Scaled to a largest component of 1.
};

enum class Precision : std::uint8_t {
    binary64,  ///< The form factors in binary64, a few 1e-16 off; the regions are exact all the same.
    certain    ///< Within 1e-14 of the unobstructed value, with as many digits as that takes.
};

struct LightView {
    double unobstructed = 0;  ///< Form factor without obstruction.
    double visible = 0;       ///< Form factor of the visible part.
    double solid_angle = 0;   ///< Of the visible part, in steradians. Only in Precision::certain.
    int parts = 0;            ///< Convex parts that the visible region was cut into.
};

/// Looks at the light from the viewpoint. Counts only what is in front of the receiver and what the viewpoint is
/// in front of. `occluders` must name every piece that may lie between; others do no harm.
LightView view_light(const Viewpoint& viewpoint, const ReceiverNormal& normal, const LightPieces& light,
                     const std::vector<PieceId>& occluders, Precision precision);

}  // namespace cob::radiosity
