#include "radiosity/planes.hpp"

#include "arithmetic/orientation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cob::radiosity {
namespace {

/// The determinant of three differences d, e, f is off by at most 7.8e-16 times its permanent, and that is at most
/// |d||e||f| in the L1 norm (Shewchuk 1997, with room to spare); coordinates are at most 1 and off by at most 8 units
/// of rounding, which each factor feels.
constexpr double relative_error = 2e-15;
constexpr double coordinate_error = 0x1p-50;
constexpr double underflow = 1e-300;  ///< Far above what products of so few factors lose to it.
/// Far above what coordinates are off by, far below what matters.
constexpr double bounds_slack = 0x1p-48;

double length1(const Point& p) {
    return std::fabs(p.x) + std::fabs(p.y) + std::fabs(p.z);
}

std::optional<Sign> certain(double value, double error) {
    if (value > error) return Sign::positive;
    if (value < -error) return Sign::negative;
    return std::nullopt;
}

bool on_one_line(const Point& a, const Point& b, const Point& c) {
    const RationalPoint u = to_rational(b) - to_rational(a), v = to_rational(c) - to_rational(a);
    return cross(u, v) == RationalPoint{};
}

}  // namespace

Planes::Planes(const Scene& scene, int exponent) : scene_(scene) {
    const auto unit = [&](const Point& p) {
        return Point{std::scalbn(p.x, -exponent), std::scalbn(p.y, -exponent), std::scalbn(p.z, -exponent)};
    };
    for (const Piece& piece : scene.pieces()) {
        const View<VertexId> loop = scene.corners(piece);
        std::vector<Point> corners;
        for (const VertexId v : loop) corners.push_back(unit(scene.position(v)));
        constexpr double infinity = std::numeric_limits<double>::infinity();
        Bounds bounds{infinity, infinity, infinity, -infinity, -infinity, -infinity};
        for (const Point& p : corners)
            for (int axis = 0; axis < 3; ++axis) {
                const auto k = static_cast<std::size_t>(axis);
                bounds[k] = std::min(bounds[k], p[axis]);
                bounds[k + 3] = std::max(bounds[k + 3], p[axis]);
            }

        // Convex: any three corners that are not on one line run as the loop does. The largest triangle at corner 0
        // gives the sharpest bound; the first that is exact where rounding hides them all.
        std::size_t best = 1;
        double best_length = -1;
        for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
            const double size = length1(cross(corners[k] - corners[0], corners[k + 1] - corners[0]));
            if (size > best_length &&
                !on_one_line(scene.position(loop[0]), scene.position(loop[k]), scene.position(loop[k + 1]))) {
                best = k;
                best_length = size;
            }
        }
        const Point u = corners[best] - corners[0], v = corners[best + 1] - corners[0], n = cross(u, v);
        planes_.push_back({corners[0],
                           n,
                           relative_error * length1(u) * length1(v) + underflow,
                           {loop[0], loop[best], loop[best + 1]}});
        const double length = std::hypot(n.x, n.y, n.z);
        normals_.push_back(length > 1e-300 ? (1 / length) * n : Point{});
        corners_.push_back(std::move(corners));
        bounds_.push_back(bounds);
    }
}

std::optional<Sign> Planes::side(PieceId id, const Point& rounded) const {
    const Plane& plane = planes_[static_cast<std::size_t>(id)];
    const Point d = rounded - plane.origin;
    // error per L1 distance; the point's own rounding counts as one more unit of distance.
    return certain(dot(plane.normal, d), plane.error * (length1(d) + 2));
}

Sign Planes::exact_side(PieceId id, const ExactPoint& point) const {
    const Plane& plane = planes_[static_cast<std::size_t>(id)];
    const auto at = [&](std::size_t k) { return to_rational(scene_.position(plane.vertices[k])); };
    const RationalPoint origin = at(0);
    return sign_of(dot(cross(at(1) - origin, at(2) - origin), point.rational() - origin));
}

Planes::ClosedSides Planes::closed_sides(PieceId piece, PieceId id) const {
    const Plane& plane = planes_[static_cast<std::size_t>(id)];
    const std::vector<Point>& points = corners(piece);
    const View<VertexId> loop = scene_.corners(scene_.piece(piece));
    ClosedSides result;
    for (std::size_t k = 0; k < points.size() && (result.before || result.behind); ++k) {
        const std::optional<Sign> quick = side(id, points[k]);
        const Sign sign = quick ? *quick
                                : orientation(scene_.position(plane.vertices[0]), scene_.position(plane.vertices[1]),
                                              scene_.position(plane.vertices[2]), scene_.position(loop[k]));
        result.behind = result.behind && sign != Sign::positive;
        result.before = result.before && sign != Sign::negative;
    }
    return result;
}

Crossing Planes::crossing(PieceId id, const Point& from, std::optional<Sign> side_from, const Point& to,
                          std::optional<Sign> side_to) const {
    if (side_from && side_to && *side_from == *side_to) return Crossing::misses;
    const Bounds& bounds = bounds_[static_cast<std::size_t>(id)];
    for (int axis = 0; axis < 3; ++axis) {
        const auto k = static_cast<std::size_t>(axis);
        if (std::min(from[axis], to[axis]) > bounds[k + 3] + bounds_slack ||
            std::max(from[axis], to[axis]) < bounds[k] - bounds_slack)
            return Crossing::misses;
    }

    // The line turns the same way about every side of a convex piece that it pierces, both ways about one it misses:
    // the sign of det(to - from, a - from, b - from) for the side from a to b.
    const std::vector<Point>& loop = corners(id);
    const Point d = to - from;
    const double length = length1(d);
    bool left = false, right = false, unsure = false;
    Point a = loop.back() - from;
    double length_a = length1(a);
    for (const Point& corner : loop) {
        const Point b = corner - from;
        const double length_b = length1(b), product = length_a * length_b;
        const std::optional<Sign> turn = certain(
            dot(d, cross(a, b)), relative_error * length * product +
                                     2 * coordinate_error * (length * (length_a + length_b) + product) + underflow);
        if (!turn)
            unsure = true;
        else
            (*turn == Sign::positive ? left : right) = true;
        if (left && right) return Crossing::misses;
        a = b;
        length_a = length_b;
    }
    return !unsure && side_from && side_to ? Crossing::pierces : Crossing::unknown;
}

}  // namespace cob::radiosity
