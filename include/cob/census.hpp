/// \file
/// What is in a scene: the counts and lists behind `cob info`. Everything is exact (SPEC 1); invalid polygons are
/// left out of all but their own list.
#pragma once

#include "cob/scene.hpp"

#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace cob {

/// Two polygons with pieces in one plane that overlap in an area.
struct CoplanarOverlap {
    PolygonId first = no_polygon, second = no_polygon;  ///< first < second.
    bool same_facing = false;                           ///< Seen from the same side (SPEC 8, choice 9).
    bool duplicate = false;                             ///< The same loop, in either direction.
};

/// A corner of one polygon inside a side of another, not at its ends.
struct TJunction {
    PolygonId corner_of = no_polygon, side_of = no_polygon;
    VertexId corner = -1;    ///< A position of the scene.
    std::uint32_t side = 0;  ///< Of side_of: from this corner of its loop to the next.
};

struct CensusOptions {
    /// Lists of pairs are cut off here; their counts are not.
    std::size_t most_listed = 100000;
};

struct Census {
    std::size_t valid = 0;                        ///< Polygons that are not refused.
    std::array<std::size_t, 3> pieces{};          ///< Triangles, quadrilaterals, pieces with more corners.
    std::size_t most_corners = 0;                 ///< Of one loop.
    std::vector<PolygonId> not_planar;            ///< Their corners are in no one plane.
    std::vector<PolygonId> not_convex;            ///< Planar, and made up of triangles.
    std::vector<PolygonId> with_spikes;           ///< The loop turns back on itself at some corner, as seen.
    std::vector<PolygonId> with_bridges;          ///< Some side is run in both directions: holes.
    std::vector<PolygonId> with_straight_angles;  ///< Some corner does not turn, as seen.
    std::vector<PolygonId> lights;                ///< Their material emits.
    Point lowest, highest;                        ///< Bounding box of all corners; only where valid > 0.

    std::size_t shared_edges = 0;        ///< Pairs of positions that are a side of two polygons or more.
    std::size_t crowded_edges = 0;       ///< Those that are a side of three or more.
    std::size_t t_junction_corners = 0;  ///< Positions that stand inside another polygon's side.
    std::size_t t_junction_pairs = 0;    ///< Pairs of such a position and such a side, as a pair of positions.
    std::vector<TJunction> t_junctions;  ///< One for each pair, ascending by polygon of the side.

    std::size_t overlap_pairs = 0;              ///< Pairs of polygons.
    std::size_t same_facing_overlap_pairs = 0;  ///< Those that face the same way.
    std::size_t duplicates = 0;                 ///< Polygons whose loop repeats that of one with a lower number.
    std::vector<CoplanarOverlap> overlaps;      ///< Ascending.

    int lowest_bit = 0, bits = 0;  ///< All coordinates are multiples of 2^lowest_bit, with this many bits at most.
};

Census take_census(const Scene& scene, const CensusOptions& options = {});

/// The polygons that are not planar, although they would be with the coordinates that the text of the OBJ file says,
/// taken as exact decimal fractions. `path` is the file that the scene was read from.
std::vector<PolygonId> planar_as_decimal(const Scene& scene, const std::string& path);

}  // namespace cob
