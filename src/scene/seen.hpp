/// \file
/// A loop as SPEC 2 sees it: projected along an axis, the visible side up.
#pragma once

#include "arithmetic/orientation.hpp"
#include "cob/scene.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace cob {

/// A polygon's loop: corners in space and, in the same order, as seen.
struct SeenLoop {
    View2 view;
    std::vector<Point> space;
    std::vector<Point2> seen;

    std::size_t size() const { return space.size(); }
    std::size_t next(std::size_t k) const { return k + 1 == size() ? 0 : k + 1; }
};

/// The view along the axis where the loop's exact Newell normal is largest in absolute value, the first such axis,
/// and its visible side up; nothing where the normal is zero.
std::optional<View2> view_of(const std::vector<Point>& loop);

/// The projection of a loop.
SeenLoop see(std::vector<Point> loop, View2 view);

/// All corners in one plane. The loop's normal is not zero.
bool is_planar(const SeenLoop& loop);

/// The loop, which is planar, bounds a convex polygon once: it never turns right nor back (SPEC 2) and goes
/// around once.
bool is_convex(const SeenLoop& loop);

/// The numbers of two sides that cross as seen, in the interior of both: the first side that crosses a later one, and
/// the first that it crosses. Side k runs from corner k to the next.
struct SidePair {
    std::size_t first, second;
};
std::optional<SidePair> crossing_sides(const SeenLoop& loop);

/// Corner numbers of a triangle, counter-clockwise as seen.
using EarTriangle = std::array<std::uint32_t, 3>;

/// Cuts a loop into triangles by the rule of SPEC 2 (choice 1); nothing where the rule gets stuck.
std::optional<std::vector<EarTriangle>> cut_ears(const SeenLoop& loop);

/// Triangles that make up a planar polygon whose sides do not cross, whatever its loop: "the closed set of the points
/// that its loop winds around", either way (SPEC 2). No two lie on each other.
struct WoundTriangles {
    std::vector<EarTriangle> triangles;
    int most = 0;  ///< How often the loop winds around some point, at most.
};
WoundTriangles triangulate_wound(const SeenLoop& loop);

/// Some corner stands on a side that it does not end, as seen. Else a loop whose sides do not cross winds once.
bool touches_itself(const SeenLoop& loop);

}  // namespace cob
