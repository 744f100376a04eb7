#include "radiosity/cone.hpp"

#include <algorithm>

namespace cob::radiosity {
namespace {

VertexId common_vertex(VertexId a, VertexId b, VertexId c, VertexId d) {
    if (a >= 0 && (a == c || a == d)) return a;
    if (b >= 0 && (b == c || b == d)) return b;
    return -1;
}

}  // namespace

PlaneRef PlanesThroughPoint::add(Plane plane) {
    planes_.push_back(std::move(plane));
    return {static_cast<std::int32_t>(planes_.size()) - 1, false};
}

PlaneRef PlanesThroughPoint::through_edge(VertexId a, VertexId b) {
    const bool flipped = a > b;
    if (flipped) std::swap(a, b);
    const std::uint64_t key = static_cast<std::uint64_t>(a) << 32 | static_cast<std::uint32_t>(b);
    const auto [known, is_new] = edges_.try_emplace(key, static_cast<std::int32_t>(planes_.size()));
    if (is_new) {
        Plane plane;
        plane.normal = cross(viewpoint_->towards(a), viewpoint_->towards(b));
        plane.a = a, plane.b = b;
        add(std::move(plane));
    }
    return {known->second, flipped};
}

PlaneRef PlanesThroughPoint::perpendicular_to(const RationalPoint& normal, const BoundedVector& bounded) {
    Plane plane;
    plane.normal = bounded;
    plane.exact = normal;
    plane.is_exact = true;
    return add(std::move(plane));
}

PlaneRef PlanesThroughPoint::before(PieceId near, PieceId far) {
    // Along d the plane of a piece with normal N, x at height h over it, is met at h / -N.d. With both normals
    // turned so that the heights are positive, near's comes first where (h_near N_far - h_far N_near) . d > 0.
    const auto turned = [this](PieceId piece) {
        const bool turn = viewpoint_->side_of(piece) == Sign::negative;
        const BoundedNumber height = viewpoint_->height_over(piece);
        const BoundedVector normal = viewpoint_->normal(piece);
        return turn ? std::pair{BoundedNumber{-height.value, height.error}, -normal} : std::pair{height, normal};
    };
    const auto [h_near, n_near] = turned(near);
    const auto [h_far, n_far] = turned(far);
    Plane plane;
    plane.near_piece = near, plane.far_piece = far;
    plane.normal = combine(h_near, n_far, h_far, n_near);
    return add(std::move(plane));
}

RationalPoint PlanesThroughPoint::exact_before(PieceId near, PieceId far) const {
    const auto turned = [this](PieceId piece) {
        const Rational height = viewpoint_->exact_height_over(piece);
        const RationalPoint normal = viewpoint_->exact_normal(piece);
        return height < 0 ? std::pair<Rational, RationalPoint>{-height, -normal} : std::pair{height, normal};
    };
    const auto [h_near, n_near] = turned(near);
    const auto [h_far, n_far] = turned(far);
    return h_near * n_far - h_far * n_near;
}

BoundedVector PlanesThroughPoint::normal(PlaneRef ref) const {
    return ref.flipped ? -at(ref).normal : at(ref).normal;
}

RationalPoint PlanesThroughPoint::exact_normal(PlaneRef ref) const {
    Plane& plane = planes_[static_cast<std::size_t>(ref.index)];
    if (!plane.is_exact) {
        plane.exact = plane.a >= 0 ? cob::cross(viewpoint_->exact_towards(plane.a), viewpoint_->exact_towards(plane.b))
                                   : exact_before(plane.near_piece, plane.far_piece);
        plane.is_exact = true;
    }
    return ref.flipped ? -plane.exact : plane.exact;
}

RationalPoint PlanesThroughPoint::exact_direction(const Ray& ray) const {
    if (ray.vertex < 0) return cob::cross(exact_normal(ray.first), exact_normal(ray.second));
    return ray.opposite ? -viewpoint_->exact_towards(ray.vertex) : viewpoint_->exact_towards(ray.vertex);
}

Ray PlanesThroughPoint::meet(PlaneRef first, PlaneRef second) const {
    const Plane &p = at(first), &q = at(second);
    Ray ray;
    ray.first = first, ray.second = second;
    ray.direction = cross(normal(first), normal(second));
    ray.vertex = common_vertex(p.a, p.b, q.a, q.b);
    if (ray.vertex < 0) return ray;
    // Of a shared vertex the direction is known without the product, but for its sign.
    const BoundedVector towards = viewpoint_->towards(ray.vertex);
    std::optional<Sign> along = dot(ray.direction, towards).sign();
    if (!along)
        along = sign_of(
            cob::dot(cob::cross(exact_normal(first), exact_normal(second)), viewpoint_->exact_towards(ray.vertex)));
    ray.opposite = *along == Sign::negative;
    ray.direction = ray.opposite ? -towards : towards;
    return ray;
}

Sign PlanesThroughPoint::side(PlaneRef ref, const Ray& ray) const {
    if (ray.first.index == ref.index || ray.second.index == ref.index) return Sign::zero;
    if (ray.vertex >= 0 && contains(ref, ray.vertex)) return Sign::zero;
    if (const auto certain = dot(normal(ref), ray.direction).sign()) return *certain;
    return sign_of(cob::dot(exact_normal(ref), exact_direction(ray)));
}

std::optional<Cone> PlanesThroughPoint::over(PieceId piece) {
    const Sign side = viewpoint_->side_of(piece);
    if (side == Sign::zero) return std::nullopt;
    // Counter-clockwise from the front: clockwise along the view from there.
    const View<VertexId> loop = viewpoint_->pieces().corners(piece);
    const auto n = loop.size();
    const auto corner = [&](std::size_t k) { return side == Sign::negative ? loop[k % n] : loop[n - 1 - k % n]; };
    Cone cone;
    cone.planes.reserve(n), cone.rays.reserve(n);
    for (std::size_t k = 0; k < n; ++k) cone.planes.push_back(through_edge(corner(k), corner(k + 1)));
    for (std::size_t k = 0; k < n; ++k)
        cone.rays.push_back(
            {cone.planes[k], cone.planes[(k + 1) % n], corner(k + 1), false, viewpoint_->towards(corner(k + 1))});
    return cone;
}

}  // namespace cob::radiosity
