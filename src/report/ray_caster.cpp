#include "report/ray_caster.hpp"

#include "radiosity/mesh.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cob::report {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
/// Hits nearer to each other than this share of their distance are at one place.
constexpr double same_place = 1e-10;

}  // namespace

RayCaster::RayCaster(const Scene& scene, int exponent, OnTop on_top) : scene_(scene), on_top_(std::move(on_top)) {
    for (PieceId id = 0; id < static_cast<PieceId>(scene.pieces().size()); ++id) {
        const View<VertexId> loop = scene.corners(scene.piece(id));
        const auto at = [&](std::size_t k) { return radiosity::in_units(scene.position(loop[k]), exponent); };
        for (std::size_t k = 1; k + 1 < loop.size(); ++k)
            triangles_.push_back({at(0), at(k) - at(0), at(k + 1) - at(0), id});
    }
    if (!triangles_.empty()) build(0, static_cast<std::int32_t>(triangles_.size()));
}

std::int32_t RayCaster::build(std::int32_t first, std::int32_t last) {
    const auto id = static_cast<std::int32_t>(branches_.size());
    branches_.emplace_back();
    std::array<double, 6> bounds{infinity, infinity, infinity, -infinity, -infinity, -infinity};
    for (std::int32_t k = first; k < last; ++k) {
        const Triangle& t = triangles_[static_cast<std::size_t>(k)];
        for (const Point& p : {t.corner, t.corner + t.first, t.corner + t.second})
            for (int axis = 0; axis < 3; ++axis) {
                const auto a = static_cast<std::size_t>(axis);
                bounds[a] = std::min(bounds[a], p[axis]);
                bounds[a + 3] = std::max(bounds[a + 3], p[axis]);
            }
    }
    branches_[static_cast<std::size_t>(id)].bounds = bounds;
    if (last - first <= 4) {
        branches_[static_cast<std::size_t>(id)].first = first;
        branches_[static_cast<std::size_t>(id)].count = last - first;
        return id;
    }
    // In halves along the longest extent.
    int axis = 0;
    for (int a = 1; a < 3; ++a)
        if (bounds[static_cast<std::size_t>(a) + 3] - bounds[static_cast<std::size_t>(a)] >
            bounds[static_cast<std::size_t>(axis) + 3] - bounds[static_cast<std::size_t>(axis)])
            axis = a;
    const auto middle = [&](const Triangle& t) { return 3 * t.corner[axis] + t.first[axis] + t.second[axis]; };
    const std::int32_t half = first + (last - first) / 2;
    std::nth_element(triangles_.begin() + first, triangles_.begin() + half, triangles_.begin() + last,
                     [&](const Triangle& a, const Triangle& b) {
                         return middle(a) != middle(b) ? middle(a) < middle(b) : a.piece < b.piece;
                     });
    build(first, half);
    const std::int32_t second = build(half, last);
    branches_[static_cast<std::size_t>(id)].first = second;
    return id;
}

void RayCaster::meet(const Triangle& t, const Point& origin, const Point& direction, Hit& hit) const {
    // Moeller and Trumbore 1997, visible side only.
    const Point p = cross(direction, t.second);
    const double determinant = dot(t.first, p);
    if (!(determinant > 0)) return;
    const Point d = origin - t.corner;
    const double u = dot(d, p);
    if (u < 0 || u > determinant) return;
    const Point q = cross(d, t.first);
    const double v = dot(direction, q);
    if (v < 0 || u + v > determinant) return;
    const double distance = dot(t.second, q) / determinant;
    if (!(distance > 0)) return;
    if (hit.piece >= 0) {
        if (distance > hit.distance * (1 + same_place)) return;
        const PolygonId here = scene_.piece(t.piece).polygon, before = scene_.piece(hit.piece).polygon;
        if (distance > hit.distance * (1 - same_place) && !on_top_(here, before)) return;
    }
    const Point normal = cross(t.first, t.second);
    hit = {t.piece, distance, determinant / std::hypot(normal.x, normal.y, normal.z)};
}

Hit RayCaster::first(const Point& origin, const Point& direction) const {
    Hit hit;
    if (branches_.empty()) return hit;
    const Point inverse{1 / direction.x, 1 / direction.y, 1 / direction.z};
    std::array<std::int32_t, 64> stack;
    int depth = 0;
    stack[static_cast<std::size_t>(depth++)] = 0;
    while (depth > 0) {
        const std::int32_t id = stack[static_cast<std::size_t>(--depth)];
        const Branch& branch = branches_[static_cast<std::size_t>(id)];
        double enter = 0, leave = hit.piece >= 0 ? hit.distance * (1 + same_place) : infinity;
        for (int axis = 0; axis < 3; ++axis) {
            const auto a = static_cast<std::size_t>(axis);
            double near = (branch.bounds[a] - origin[axis]) * inverse[axis];
            double far = (branch.bounds[a + 3] - origin[axis]) * inverse[axis];
            if (near > far) std::swap(near, far);
            enter = near > enter ? near : enter;  // a NaN, in the plane of a side, changes nothing
            leave = far * (1 + 1e-12) < leave ? far * (1 + 1e-12) : leave;
        }
        if (enter > leave) continue;
        if (branch.count > 0) {
            for (std::int32_t k = 0; k < branch.count; ++k)
                meet(triangles_[static_cast<std::size_t>(branch.first + k)], origin, direction, hit);
            continue;
        }
        stack[static_cast<std::size_t>(depth++)] = branch.first;
        stack[static_cast<std::size_t>(depth++)] = id + 1;
    }
    return hit;
}

}  // namespace cob::report
