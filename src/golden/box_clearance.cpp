#include "golden/box_clearance.hpp"

#include "geometry/convex_polygon.hpp"

#include <algorithm>
#include <cmath>

namespace cob {

namespace {

constexpr double rounding = 1.0 / (1LL << 46);  ///< Generous: a hundred roundings of relative size 2^-53.
constexpr double infinite = HUGE_VAL;
constexpr double within = 1 - 1.0 / 256;  ///< Only switches at factors from here to 2 - within are of interest.

double length(const Point& v) {
    return std::sqrt(dot(v, v));
}

double largest_coordinate(const Point& p) {
    return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
}

Clearance around(double value, double error) {
    return {std::max(0.0, value - error), value + error};
}

/// Keeps the part of a polygon where value(p) >= 0; value is linear.
template <class Value>
void clip(std::vector<Point>& polygon, std::vector<Point>& scratch, Value value) {
    scratch.clear();
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Point &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
        const double at_a = value(a), at_b = value(b);
        if (at_a >= 0) scratch.push_back(a);
        if ((at_a > 0 && at_b < 0) || (at_a < 0 && at_b > 0)) scratch.push_back(a + (at_a / (at_a - at_b)) * (b - a));
    }
    polygon.swap(scratch);
}

/// The smallest factor at which the cube meets the polygon: the least maximum norm of its points. In each of the six
/// cones over a face of the cube that norm is linear, so the least one stands at a corner of the part within the cone.
double reach_of(const std::vector<Point>& polygon) {
    static thread_local std::vector<Point> part, scratch;
    double least = infinite;
    for (int axis = 0; axis < 3; ++axis)
        for (const double sign : {1.0, -1.0}) {
            part = polygon;
            for (int other = 1; other < 3 && !part.empty(); ++other) {
                const int beside = (axis + other) % 3;
                clip(part, scratch, [&](const Point& p) { return sign * p[axis] - p[beside]; });
                clip(part, scratch, [&](const Point& p) { return sign * p[axis] + p[beside]; });
            }
            for (const Point& p : part) least = std::min(least, sign * p[axis]);
        }
    return least;
}

struct CubePolygon {
    std::vector<Point> corners;
    double error = 0;
};

void to_cube(const Scene& scene, View<VertexId> corners, const BoxFrame& frame, CubePolygon& out) {
    out.corners.clear();
    double largest = 0;
    for (const VertexId corner : corners) {
        const Point& p = scene.position(corner);
        largest = std::max(largest, largest_coordinate(p));
        out.corners.push_back(frame.to_cube(p));
    }
    out.error = frame.error(largest);
}

/// Factors up to which a convex polygon, seen along z, contains the rectangle: low to high bounds.
Clearance rectangle_factor(const CubePolygon& polygon) {
    double area = 0;
    const std::size_t count = polygon.corners.size();
    const auto at = [&](std::size_t k) -> const Point& { return polygon.corners[k % count]; };
    for (std::size_t k = 0; k < count; ++k) area += at(k).x * at(k + 1).y - at(k).y * at(k + 1).x;
    Clearance factor{infinite, infinite};
    for (std::size_t k = 0; k < count; ++k) {
        const Point side = at(k + 1) - at(k);
        const double norm = std::abs(side.x) + std::abs(side.y);
        const double turn = at(k).x * side.y - at(k).y * side.x;
        const double here = (area < 0 ? -turn : turn) / norm;
        const double error = polygon.error * (4 + 4 * largest_coordinate(at(k)) / norm);
        factor.low = std::min(factor.low, here - error), factor.high = std::min(factor.high, here + error);
    }
    return factor;
}

/// Seen along z, some line along a side of the piece keeps it certainly away from the point.
bool misses(const CubePolygon& piece, double x, double y) {
    const std::size_t count = piece.corners.size();
    for (std::size_t k = 0; k < count; ++k) {
        const Point side = piece.corners[(k + 1) % count] - piece.corners[k];
        const double norm = std::abs(side.x) + std::abs(side.y);
        if (!(norm > 0)) continue;
        double least = infinite, most = -infinite;
        for (const Point& p : piece.corners) {
            const double across = ((p.x - x) * side.y - (p.y - y) * side.x) / norm;
            least = std::min(least, across), most = std::max(most, across);
        }
        if (least > 4 * piece.error || most < -4 * piece.error) return true;
    }
    return false;
}

/// A point of the rectangle, at all factors of interest, over which no piece lies: then the polygon never covers.
bool leaves_a_point_free(const Scene& scene, PolygonId polygon, const BoxFrame& frame) {
    constexpr int probes = 5;
    static thread_local CubePolygon piece;
    std::array<bool, probes * probes> open;
    open.fill(true);
    for (const Piece& part : scene.pieces_of(polygon)) {
        to_cube(scene, scene.corners(part), frame, piece);
        for (std::size_t k = 0; k < open.size(); ++k) {
            const auto at = [](std::size_t step) { return within * (static_cast<double>(step) - 2) / 2; };
            open[k] = open[k] && misses(piece, at(k % probes), at(k / probes));
        }
    }
    return std::find(open.begin(), open.end(), true) != open.end();
}

/// Factors from which on the polygon's plane stays between base and top over the rectangle: low to high bounds.
Clearance slab_factor(const CubePolygon& polygon) {
    Point normal{};
    double size = 0;
    const std::size_t count = polygon.corners.size();
    for (std::size_t k = 0; k < count; ++k) {
        normal = normal + cross(polygon.corners[k], polygon.corners[(k + 1) % count]);
        size = std::max(size, largest_coordinate(polygon.corners[k]));
    }
    const double up = std::abs(normal.z), aside = std::abs(normal.x) + std::abs(normal.y);
    const double error = 16 * polygon.error * (1 + size) * (1 + size) / std::max(up - aside, 1e-300);
    if (!(up > aside)) return {up + 1e-6 * aside < aside ? infinite : 0, infinite};
    const double here = std::abs(dot(normal, polygon.corners[0])) / (up - aside);
    return {here - error * (1 + here), here + error * (1 + here)};
}

}  // namespace

BoxFrame::BoxFrame(const BoxQuestion& question) {
    for (int k = 0; k < question.corners.count; ++k)
        corners_.push_back(question.corners.points[static_cast<std::size_t>(k)].nearest());
    const Point normal = area_vector(corners_);
    const Point& u = question.u.nearest();
    n_ = (1 / length(normal)) * normal;
    u_ = (1 / length(u)) * u;
    w_ = cross(n_, u_);

    std::array<double, 2> low{infinite, infinite}, high{-infinite, -infinite};
    for (const Point& corner : corners_) {
        largest_ = std::max(largest_, largest_coordinate(corner));
        const std::array<double, 2> at{dot(corner - corners_[0], u_), dot(corner - corners_[0], w_)};
        for (std::size_t k = 0; k < 2; ++k) low[k] = std::min(low[k], at[k]), high[k] = std::max(high[k], at[k]);
    }
    const double widening = 1 + 2 * to_nearest(question.margin);
    for (std::size_t k = 0; k < 2; ++k) half_[k] = (high[k] - low[k]) * widening / 2;
    half_[2] = to_nearest(question.height) * std::min(half_[0], half_[1]);
    smallest_half_ = std::min({half_[0], half_[1], half_[2]});
    centre_ = corners_[0] + ((low[0] + high[0]) / 2) * u_ + ((low[1] + high[1]) / 2) * w_ + half_[2] * n_;
}

Point BoxFrame::to_cube(const Point& p) const {
    const Point d = p - centre_;
    return {dot(d, u_) / half_[0], dot(d, w_) / half_[1], dot(d, n_) / half_[2]};
}

double BoxFrame::error(double largest) const {
    return rounding * (largest + largest_ + half_[0] + half_[1]) / smallest_half_;
}

Clearance meeting_clearance(const Scene& scene, PolygonId polygon, const BoxFrame& frame, Relation relation) {
    static thread_local CubePolygon piece;
    double reach = infinite, error = 0;
    for (const Piece& part : scene.pieces_of(polygon)) {
        to_cube(scene, scene.corners(part), frame, piece);
        error = std::max(error, piece.error);
        // A corner deep inside settles it.
        for (const Point& p : piece.corners) reach = std::min(reach, largest_coordinate(p));
        if (!(error < 1)) return {0, infinite};
        if (reach + error < within && relation == Relation::crossing) return {infinite, infinite};
        reach = std::min(reach, reach_of(piece.corners));
    }
    return around(std::max(0.0, relation == Relation::crossing ? 1 - reach : reach - 1), error);
}

Clearance covering_clearance(const Scene& scene, PolygonId polygon, const BoxFrame& frame, bool covers) {
    static thread_local CubePolygon loop;
    to_cube(scene, scene.loop(polygon), frame, loop);

    if (!(loop.error < 1)) return {0, infinite};

    // Not as wide as the rectangle at any factor of interest.
    Point low{infinite, infinite, 0}, high{-infinite, -infinite, 0};
    for (const Point& p : loop.corners) {
        low.x = std::min(low.x, p.x), low.y = std::min(low.y, p.y);
        high.x = std::max(high.x, p.x), high.y = std::max(high.y, p.y);
    }
    const double needed = within - loop.error;
    if (low.x > -needed || low.y > -needed || high.x < needed || high.y < needed) return {infinite, infinite};
    if (scene.polygon(polygon).piece_count != 1) {
        if (!covers && leaves_a_point_free(scene, polygon, frame)) return {infinite, infinite};
        return {0, infinite};  // Left to exact arithmetic.
    }

    const Clearance up_to = rectangle_factor(loop), from = slab_factor(loop);
    const auto distance = [&](double first, double last) {
        if (covers) return std::max(0.0, std::min(last - 1, 1 - first));
        return first > last ? infinite : std::max({0.0, first - 1, 1 - last});
    };
    const double wide = distance(from.low, up_to.high), narrow = distance(from.high, up_to.low);
    return {std::min(wide, narrow), std::max(wide, narrow)};
}

Clearance facing_clearance(const Scene& scene, PolygonId light, const BoxFrame& frame, bool faces) {
    Clearance result = faces ? Clearance{0, 0} : Clearance{infinite, infinite};
    for (const Piece& piece : scene.pieces_of(light)) {
        const auto corners = scene.corners(piece);
        const auto at = [&](std::size_t k) -> const Point& { return scene.position(corners[k]); };
        Point normal{};
        double largest = largest_coordinate(frame.centre()), size = 0;
        for (std::size_t k = 0; k < corners.size(); ++k) {
            normal = normal + cross(at(k) - at(0), at((k + 1) % corners.size()) - at(0));
            largest = std::max(largest, largest_coordinate(at(k)));
            size = std::max(size, length(at(k) - at(0)));
        }
        // Relative error of the unit normal: roundings of the differences against the piece's breadth.
        const double area = length(normal);
        const double tilt = rounding * (1 + largest / size) * size * size / area;
        for (const Point& corner : frame.corners()) {
            const double distance = dot(normal, corner - at(0)) / area,
                         slope = dot(normal, corner - frame.centre()) / area;
            const double reach = length(corner - at(0)) + length(corner - frame.centre());
            const double error = rounding * largest + tilt * reach;
            const double low = std::max(0.0, std::abs(distance) - error) / (std::abs(slope) + error);
            const double high =
                std::abs(slope) > error ? (std::abs(distance) + error) / (std::abs(slope) - error) : infinite;
            if (!faces)
                result = {std::min(result.low, low), std::min(result.high, high)};
            else if (distance > -error)
                result = {std::max(result.low, distance > error ? low : 0), std::max(result.high, high)};
        }
    }
    return result;
}

}  // namespace cob
