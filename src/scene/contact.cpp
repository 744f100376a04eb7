#include "scene/contact.hpp"

#include "scene/piece_plane.hpp"

#include <algorithm>

namespace cob {
namespace {

Point2 seen_along(View2 view, const Point& point) {
    return {point[view.first], point[view.second]};
}

std::vector<Point2> seen_corners(const Scene& scene, const Piece& piece, View2 view) {
    std::vector<Point2> seen;
    for (const VertexId corner : scene.corners(piece)) seen.push_back(seen_along(view, scene.position(corner)));
    return seen;
}

/// A line along a side of `a`, which runs counter-clockwise, has no point of `b` on its left.
bool separated_by_a_side(const std::vector<Point2>& a, const std::vector<Point2>& b) {
    for (std::size_t k = 0; k < a.size(); ++k) {
        bool separated = true;
        for (const Point2& point : b)
            separated = separated && orientation(a[k], a[k + 1 == a.size() ? 0 : k + 1], point) != Sign::positive;
        if (separated) return true;
    }
    return false;
}

}  // namespace

bool is_between(const Point& point, const Point& from, const Point& to) {
    if (point == from || point == to) return false;
    for (int axis = 0; axis < 3; ++axis)
        if (point[axis] < std::min(from[axis], to[axis]) || point[axis] > std::max(from[axis], to[axis])) return false;
    return collinear(from, to, point);
}

Sheet::Sheet(const Scene& scene, const Piece& piece)
    : view_(scene.polygon(piece.polygon).view),
      seen_(seen_corners(scene, piece, view_)),
      corners_(plane_of(scene, piece)) {}

Overlap Sheet::overlap(const Scene& scene, const Piece& other) const {
    for (const VertexId corner : scene.corners(other))
        if (orientation(corners_[0], corners_[1], corners_[2], scene.position(corner)) != Sign::zero)
            return Overlap::none;
    const std::array<Point, 3> base = plane_of(scene, other);
    const Sign turn = orientation(seen_along(view_, base[0]), seen_along(view_, base[1]), seen_along(view_, base[2]));
    std::vector<Point2> seen = seen_corners(scene, other, view_);
    if (turn == Sign::negative) std::reverse(seen.begin(), seen.end());
    if (separated_by_a_side(seen_, seen) || separated_by_a_side(seen, seen_)) return Overlap::none;
    return turn == Sign::positive ? Overlap::same_facing : Overlap::opposite_facing;
}

bool is_duplicate(const Scene& scene, PolygonId first, PolygonId second) {
    const auto a = scene.loop(first), b = scene.loop(second);
    const std::size_t count = a.size();
    if (b.size() != count) return false;
    const auto equal = [&](std::size_t shift, bool forward) {
        for (std::size_t k = 0; k < count; ++k) {
            const std::size_t other = (forward ? shift + k : shift + count - k) % count;
            if (scene.position(a[k]) != scene.position(b[other])) return false;
        }
        return true;
    };
    for (std::size_t shift = 0; shift < count; ++shift)
        if (equal(shift, true) || equal(shift, false)) return true;
    return false;
}

}  // namespace cob
