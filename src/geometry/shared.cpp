// How the sides of two polygons touch (SPEC 5), exactly.
#include "arithmetic/orientation.hpp"
#include "cob/geometry.hpp"

#include <algorithm>
#include <vector>

namespace cob {
namespace {

struct Side {
    VertexId from, to;
    Point p, q;
    Point low, high;
};

std::vector<Side> sides(const Scene& scene, PolygonId polygon) {
    const View<VertexId> loop = scene.loop(polygon);
    std::vector<Side> result;
    for (std::size_t i = 0; i < static_cast<std::size_t>(loop.size()); ++i) {
        Side side;
        side.from = loop[static_cast<std::ptrdiff_t>(i)];
        side.to = loop[static_cast<std::ptrdiff_t>((i + 1) % static_cast<std::size_t>(loop.size()))];
        side.p = scene.position(side.from);
        side.q = scene.position(side.to);
        for (int axis = 0; axis < 3; ++axis) {
            side.low[axis] = std::min(side.p[axis], side.q[axis]);
            side.high[axis] = std::max(side.p[axis], side.q[axis]);
        }
        result.push_back(side);
    }
    return result;
}

struct Bounds {
    Point low, high;
};

Bounds bounds_of(const std::vector<Side>& all) {
    Bounds bounds{all.front().low, all.front().high};
    for (const Side& side : all)
        for (int axis = 0; axis < 3; ++axis) {
            bounds.low[axis] = std::min(bounds.low[axis], side.low[axis]);
            bounds.high[axis] = std::max(bounds.high[axis], side.high[axis]);
        }
    return bounds;
}

template <class A, class B>
bool apart(const A& a, const B& b) {
    for (int axis = 0; axis < 3; ++axis)
        if (a.high[axis] < b.low[axis] || b.high[axis] < a.low[axis]) return true;
    return false;
}

/// Two sides on one line whose bounds meet: along any axis that they run in they overlap or touch.
Shared on_one_line(const Side& a, const Side& b) {
    for (int axis = 0; axis < 3; ++axis)
        if (std::max(a.low[axis], b.low[axis]) < std::min(a.high[axis], b.high[axis])) return Shared::edge;
    return Shared::vertex;
}

/// The signs are opposite or one of them is zero.
bool on_both_sides(Sign s, Sign t) {
    return s * t != Sign::positive;
}

/// Two sides in one plane, not on one line, whose bounds meet.
bool cross_in_plane(const Side& a, const Side& b) {
    static constexpr int views[3][2] = {{1, 2}, {2, 0}, {0, 1}};
    for (const auto& view : views) {
        const auto turn = [&](const Point& x, const Point& y, const Point& z) {
            return orientation(Point2{x[view[0]], x[view[1]]}, Point2{y[view[0]], y[view[1]]},
                               Point2{z[view[0]], z[view[1]]});
        };
        const Sign bp = turn(a.p, a.q, b.p), bq = turn(a.p, a.q, b.q);
        const Sign ap = turn(b.p, b.q, a.p), aq = turn(b.p, b.q, a.q);
        // Seen so, all on one line: the plane stands upright, look from elsewhere.
        if (bp == Sign::zero && bq == Sign::zero && ap == Sign::zero && aq == Sign::zero) continue;
        return on_both_sides(bp, bq) && on_both_sides(ap, aq);
    }
    return false;  // never: some view shows the plane
}

Shared contact(const Side& a, const Side& b) {
    if (apart(a, b)) return Shared::none;
    const bool common_end = a.from == b.from || a.from == b.to || a.to == b.from || a.to == b.to;
    if (common_end) {
        const bool same = (a.from == b.from && a.to == b.to) || (a.from == b.to && a.to == b.from);
        if (same) return Shared::edge;
    } else if (orientation(a.p, a.q, b.p, b.q) != Sign::zero) {
        return Shared::none;
    }
    if (collinear(a.p, a.q, b.p) && collinear(a.p, a.q, b.q)) return on_one_line(a, b);
    return common_end || cross_in_plane(a, b) ? Shared::vertex : Shared::none;
}

}  // namespace

Shared shared(const Scene& scene, PolygonId a, PolygonId b) {
    if (a == no_polygon || b == no_polygon) return Shared::none;
    const std::vector<Side> sides_a = sides(scene, a), sides_b = sides(scene, b);
    if (sides_a.empty() || sides_b.empty()) return Shared::none;
    const Bounds bounds_a = bounds_of(sides_a), bounds_b = bounds_of(sides_b);
    if (apart(bounds_a, bounds_b)) return Shared::none;

    Shared strongest = Shared::none;
    for (const Side& side_a : sides_a) {
        if (apart(side_a, bounds_b)) continue;
        for (const Side& side_b : sides_b) {
            strongest = std::max(strongest, contact(side_a, side_b));
            if (strongest == Shared::edge) return strongest;
        }
    }
    return strongest;
}

}  // namespace cob
