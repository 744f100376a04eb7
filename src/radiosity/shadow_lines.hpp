/// \file
/// Where on a receiver the visible part of a light changes its shape: the lines at which shadow boundaries begin
/// and end (the events EV and VE of discontinuity meshing; Heckbert 1992, Lischinski, Tampieri, Greenberg 1992).
/// The curves of three edges are left to the quadrature's own refinement.
#pragma once

#include "radiosity/receiver_frame.hpp"

#include <vector>

namespace cob::radiosity {

/// A segment in the receiver's plane.
struct ShadowLine {
    Point2D from, to;
};

/// What bounds a light or an occluder, in the receiver's coordinates (s, t, h).
struct Outline {
    std::vector<Vector3<double>> corners;
    std::vector<std::pair<Vector3<double>, Vector3<double>>> sides;
    PolygonId polygon = no_polygon;
};

/// A polygon seen from pieces: each corner and each side of theirs, without those inside the polygon.
Outline outline_of(const Scene& scene, const std::vector<PieceId>& pieces, const ReceiverFrame& frame);

/// All lines that may matter; some may not. Where occluders are many, those between two occluders are left out.
std::vector<ShadowLine> shadow_lines(const Outline& light, const std::vector<Outline>& occluders);

}  // namespace cob::radiosity
