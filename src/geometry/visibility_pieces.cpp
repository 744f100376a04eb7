#include "geometry/visibility_pieces.hpp"

#include "geometry/difference_signs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cob {
namespace {

constexpr double least_entry = 1e-97, greatest_entry = 1e102;

double greatest(const Point& v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

double sum(const Point& v) {
    return std::abs(v.x) + std::abs(v.y) + std::abs(v.z);
}

VertexId corner(View<VertexId> corners, std::size_t k) {
    return corners[static_cast<std::ptrdiff_t>(k % corners.size())];
}

/// Some corner where the piece turns strictly left; of corners, the one with the greatest triangle in binary64 if
/// that is one. Pieces of three corners have no others.
std::uint32_t strict_turn(const Scene& scene, const Piece& piece) {
    const View<VertexId> corners = scene.corners(piece);
    const std::size_t count = corners.size();
    if (count == 3) return 0;
    const auto difference = [&](std::size_t a, std::size_t b) {
        return Difference{scene.position(corner(corners, a)), scene.position(corner(corners, b))};
    };
    PredicateCounters counters;
    const auto turns = [&](std::size_t k) {
        for (int axis = 0; axis < 3; ++axis)
            if (cross_component(difference(k + count - 1, k), difference(k, k + 1), axis, {&counters}) != Sign::zero)
                return true;
        return false;
    };
    std::size_t best = 0;
    double best_size = -1;
    for (std::size_t k = 0; k < count; ++k) {
        const Point& p = scene.position(corner(corners, k));
        const double size =
            sum(cross(scene.position(corner(corners, k + 1)) - p, scene.position(corner(corners, k + count - 1)) - p));
        if (size > best_size) best = k, best_size = size;
    }
    // A convex piece never turns right nor back, so that a turn at all is a turn to the left.
    for (std::size_t k = 0; k < count; ++k)
        if (turns(best + k)) return static_cast<std::uint32_t>((best + k) % count);
    return static_cast<std::uint32_t>(best);
}

ApproximatePlane approximate_plane(const Point& origin, const Point& first, const Point& last) {
    ApproximatePlane plane;
    const Point p = first - origin, q = last - origin;
    const Point absolute_p{std::abs(p.x), std::abs(p.y), std::abs(p.z)};
    const Point absolute_q{std::abs(q.x), std::abs(q.y), std::abs(q.z)};
    plane.origin = origin;
    plane.normal = cross(p, q);
    const double products = absolute_p.y * absolute_q.z + absolute_p.z * absolute_q.y + absolute_p.z * absolute_q.x +
                            absolute_p.x * absolute_q.z + absolute_p.x * absolute_q.y + absolute_p.y * absolute_q.x;
    // Each coordinate of the normal has two products with 4 roundings; its product with r adds 5 more (r's own, the
    // multiplication, two sums, and the bound's): (4 + 5) 2^-53 = 1e-15 of the sum of the products.
    plane.error = 1.1e-15 * products;
    const bool in_range = greatest(p) > least_entry && greatest(q) > least_entry && greatest(p) < greatest_entry &&
                          greatest(q) < greatest_entry && plane.error > 1e-250;
    if (!in_range) plane.error = std::numeric_limits<double>::infinity();
    return plane;
}

}  // namespace

PieceTable::PieceTable(const Scene& scene) : scene_(&scene) {
    const std::size_t count = scene.pieces().size();
    planes_.reserve(count);
    for (PieceId id = 0; id < static_cast<PieceId>(count); ++id) {
        const Piece& piece = scene.piece(id);
        const std::uint32_t turn = strict_turn(scene, piece);
        const PiecePlane p = plane(id, turn);
        const Point &first = scene.position(p.first), &last = scene.position(p.last);
        ApproximatePlane approximate = approximate_plane(scene.position(p.origin), first, last);
        const Polygon& polygon = scene.polygon(piece.polygon);
        approximate.group = polygon.planar && polygon.piece_count > 1 ? piece.polygon : -1;
        approximate.corner_count = piece.corner_count;
        approximate.others = {first, last};
        approximate.turn = turn;
        planes_.push_back(approximate);
    }
}

PiecePlane PieceTable::plane(PieceId piece, std::uint32_t turn) const {
    const View<VertexId> corners = scene_->corners(scene_->piece(piece));
    return {corner(corners, turn), corner(corners, turn + 1), corner(corners, turn + corners.size() - 1)};
}

std::size_t PieceTable::memory() const {
    return planes_.capacity() * sizeof(ApproximatePlane);
}

}  // namespace cob
