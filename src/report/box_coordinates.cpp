#include "report/box_coordinates.hpp"

#include <algorithm>

namespace cob {
namespace {

/// The part of a convex polygon where inside(corner) >= 0, inside being linear (Sutherland and Hodgman).
template <class Inside>
std::vector<BoxPoint> clip(const std::vector<BoxPoint>& polygon, const Inside& inside) {
    std::vector<BoxPoint> result;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const BoxPoint &p = polygon[k], &q = polygon[(k + 1) % polygon.size()];
        const Rational at_p = inside(p), at_q = inside(q);
        if (at_p >= 0) result.push_back(p);
        if (at_p.sign() * at_q.sign() >= 0) continue;
        const Rational t = at_p / (at_p - at_q);
        result.push_back({p.a + t * (q.a - p.a), p.b + t * (q.b - p.b), p.z + t * (q.z - p.z)});
    }
    return result;
}

Rational projected_area(const std::vector<BoxPoint>& polygon) {
    Rational twice = 0;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const BoxPoint &p = polygon[k], &q = polygon[(k + 1) % polygon.size()];
        twice += p.a * q.b - p.b * q.a;
    }
    return abs(twice) / 2;
}

}  // namespace

BoxCoordinates::BoxCoordinates(const BoxQuestion& question) {
    std::vector<RationalPoint> corners;
    for (int k = 0; k < question.corners.count; ++k)
        corners.push_back(question.corners.points[static_cast<std::size_t>(k)].rational());
    origin_ = corners[0];
    u_ = question.u.rational();
    for (std::size_t k = 1; k + 1 < corners.size(); ++k)
        n_ = n_ + cross(corners[k] - corners[0], corners[k + 1] - corners[0]);
    w_ = cross(n_, u_);

    // Extents along u and w, each widened on both sides.
    const auto widened = [&](const RationalPoint& direction, Rational& first, Rational& width) {
        Rational least = 0, most = 0;
        for (const RationalPoint& corner : corners) {
            const Rational at = dot(direction, corner - origin_);
            least = std::min(least, at);
            most = std::max(most, at);
        }
        const Rational extent = most - least;
        first = least - question.margin * extent;
        width = extent * (1 + 2 * question.margin);
    };
    widened(u_, first_u_, width_u_);
    widened(w_, first_w_, width_w_);
    height_squared_ = question.height * question.height * std::min(extent_squared_u(), extent_squared_w());
    top_squared_ = height_squared_ * dot(n_, n_);
}

BoxPoint BoxCoordinates::operator()(const RationalPoint& point) const {
    const RationalPoint p = point - origin_;
    return {(dot(u_, p) - first_u_) / width_u_, (dot(w_, p) - first_w_) / width_w_, dot(n_, p)};
}

Rational BoxCoordinates::extent_squared_u() const {
    return width_u_ * width_u_ / dot(u_, u_);
}

Rational BoxCoordinates::extent_squared_w() const {
    return width_w_ * width_w_ / dot(w_, w_);
}

RationalPoint BoxCoordinates::base_corner(int a, int b) const {
    const Rational along_u = (first_u_ + a * width_u_) / dot(u_, u_), along_w = (first_w_ + b * width_w_) / dot(w_, w_);
    return origin_ + along_u * u_ + along_w * w_;
}

PieceOverBase clip_to_base(const Scene& scene, PieceId piece, const BoxCoordinates& box) {
    PieceOverBase result;
    result.piece = piece;
    std::vector<BoxPoint> polygon;
    for (const VertexId vertex : scene.corners(scene.piece(piece)))
        polygon.push_back(box(to_rational(scene.position(vertex))));
    polygon = clip(polygon, [](const BoxPoint& p) { return p.a; });
    polygon = clip(polygon, [](const BoxPoint& p) { return Rational(1 - p.a); });
    polygon = clip(polygon, [](const BoxPoint& p) { return p.b; });
    polygon = clip(polygon, [](const BoxPoint& p) { return Rational(1 - p.b); });
    result.corners = polygon;
    if (polygon.empty()) return result;

    // A convex set meets the open rectangle unless it lies in one side of it: ask its middle.
    Rational a = 0, b = 0;
    result.lowest = result.highest = polygon[0].z;
    for (const BoxPoint& p : polygon) {
        a += p.a;
        b += p.b;
        result.lowest = std::min(result.lowest, p.z);
        result.highest = std::max(result.highest, p.z);
    }
    const Rational count(static_cast<int>(polygon.size()));
    result.over_interior = a > 0 && a < count && b > 0 && b < count;
    result.area = projected_area(polygon);
    return result;
}

Relation relation_in_words(const Scene& scene, PolygonId polygon, const BoxCoordinates& box,
                           const std::vector<PieceOverBase>& pieces) {
    bool crossing = false, boundary = false, base = false;
    for (const PieceOverBase& piece : pieces) {
        if (piece.corners.empty()) continue;
        const Rational lowest = box.signed_square_height(piece.lowest);
        crossing = crossing || (piece.over_interior && piece.highest > 0 && lowest < 1);
        boundary = boundary || (piece.highest > 0 && lowest <= 1);
        base = base || (piece.lowest <= 0 && piece.highest >= 0);
    }
    if (crossing) return Relation::crossing;
    if (boundary) return Relation::boundary;
    if (!base) return Relation::disjoint;
    for (const VertexId vertex : scene.loop(polygon))
        if (box(to_rational(scene.position(vertex))).z != 0) return Relation::base;
    return Relation::coplanar;
}

}  // namespace cob
