#include "geometry/shaft.hpp"

#include "arithmetic/orientation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cob {
namespace {

std::vector<ExactPoint> corners_of(const Scene& scene, const Piece& piece) {
    std::vector<ExactPoint> corners;
    for (VertexId corner : scene.corners(piece)) corners.emplace_back(scene.position(corner));
    return corners;
}

std::array<double, 6> bounds_of(const std::vector<ExactPoint>& points) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    std::array<double, 6> bounds{infinity, infinity, infinity, -infinity, -infinity, -infinity};
    for (const ExactPoint& point : points)
        for (int axis = 0; axis < 3; ++axis) {
            bounds[axis] = std::min(bounds[axis], std::nextafter(point.nearest()[axis], -infinity));
            bounds[axis + 3] = std::max(bounds[axis + 3], std::nextafter(point.nearest()[axis], infinity));
        }
    return bounds;
}

}  // namespace

Shaft::Shaft(const ConvexPatch& a, const ConvexPatch& b) {
    points_.reserve(a.corners.size() + b.corners.size());
    points_.insert(points_.end(), a.corners.begin(), a.corners.end());
    points_.insert(points_.end(), b.corners.begin(), b.corners.end());
    bounds_ = bounds_of(points_);
    // A facet holds all of one patch, or a side of one and a corner of the other.
    const ExactPoint *first = points_.data(), *second = first + a.corners.size();
    const auto add_facets = [this](const ExactPoint* one, std::size_t n, const ExactPoint* other, std::size_t m) {
        if (n < 3) return;
        // Its first corners may be on one line; the first facet found is that of the plane.
        const std::size_t before = facets_.size();
        for (std::size_t k = 2; k < n && facets_.size() == before; ++k) add_facet(one[0], one[1], one[k]);
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t j = 0; j < m; ++j) add_facet(one[i], one[(i + 1) % n], other[j]);
    };
    add_facets(first, a.corners.size(), second, b.corners.size());
    add_facets(second, b.corners.size(), first, a.corners.size());
}

void Shaft::add_facet(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c) {
    Sign inner = Sign::zero;
    for (const ExactPoint& point : points_) {
        if (&point == &a || &point == &b || &point == &c) continue;
        const Sign side = orientation(a, b, c, point);
        if (side == Sign::zero) continue;
        if (inner == -side) return;
        inner = side;
    }
    // All on the plane: it is none (a, b, c on one line), or the hull is flat.
    if (inner != Sign::zero) facets_.push_back({{&a, &b, &c}, inner});
}

bool Shaft::separated_by_own_facet(const std::vector<ExactPoint>& corners) const {
    return std::any_of(facets_.begin(), facets_.end(), [&](const Facet& facet) {
        return std::all_of(corners.begin(), corners.end(), [&](const ExactPoint& corner) {
            return orientation(*facet.plane[0], *facet.plane[1], *facet.plane[2], corner) != facet.inner;
        });
    });
}

bool Shaft::separated_by_side(const std::vector<ExactPoint>& corners) const {
    // A plane between two convex bodies that have no inner point in common can be turned until it holds a facet of
    // the hull, or the piece, or a side of the piece and a corner of the hull; the piece's own plane is among these.
    const std::size_t n = corners.size();
    for (std::size_t k = 0; k < n; ++k) {
        const ExactPoint &from = corners[k], &to = corners[(k + 1) % n];
        const auto separates = [&](const ExactPoint& third) {
            Sign hull = Sign::zero;
            for (const ExactPoint& point : points_) {
                if (&point == &third) continue;
                const Sign side = orientation(from, to, third, point);
                if (side == Sign::zero) continue;
                if (hull == -side) return false;
                hull = side;
            }
            return hull != Sign::zero && std::all_of(corners.begin(), corners.end(), [&](const ExactPoint& corner) {
                       return orientation(from, to, third, corner) != hull;
                   });
        };
        if (separates(corners[(k + 2) % n])) return true;
        if (std::any_of(points_.begin(), points_.end(), separates)) return true;
    }
    return false;
}

bool Shaft::meets(const Scene& scene, const Piece& piece) const {
    if (is_flat()) return false;
    const std::vector<ExactPoint> corners = corners_of(scene, piece);
    const std::array<double, 6> box = bounds_of(corners);
    for (int axis = 0; axis < 3; ++axis)
        if (box[axis] > bounds_[axis + 3] || box[axis + 3] < bounds_[axis]) return false;
    return !separated_by_own_facet(corners) && !separated_by_side(corners);
}

}  // namespace cob
