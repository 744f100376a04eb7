#include "radiosity/sheets.hpp"

#include "radiosity/plane_sheets.hpp"

namespace cob::radiosity {
namespace {

/// A point of a polygon's plane, as seen (SPEC 2).
struct RationalPoint2 {
    Rational x, y;
};
using Convex = std::vector<RationalPoint2>;  ///< Counter-clockwise.

RationalPoint2 seen(const View2& view, const RationalPoint& p) {
    return {p[view.first], p[view.second]};
}

Convex seen(const Scene& scene, const Piece& piece) {
    Convex result;
    const View2& view = scene.polygon(piece.polygon).view;
    for (const VertexId v : scene.corners(piece)) result.push_back(seen(view, to_rational(scene.position(v))));
    return result;
}

Rational twice_area(const Convex& loop) {
    Rational sum = 0;
    for (std::size_t k = 0; k < loop.size(); ++k) {
        const RationalPoint2 &a = loop[k], &b = loop[(k + 1) % loop.size()];
        sum += a.x * b.y - a.y * b.x;
    }
    return sum;
}

/// Positive where p lies left of the line from a to b.
Rational turn(const RationalPoint2& a, const RationalPoint2& b, const RationalPoint2& p) {
    return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

/// The part of a convex loop on one side of the line from a to b; empty where it has no area.
Convex clip(const Convex& loop, const RationalPoint2& a, const RationalPoint2& b, bool left) {
    Convex result;
    bool area = false;
    for (std::size_t k = 0; k < loop.size(); ++k) {
        const RationalPoint2 &p = loop[k], &q = loop[(k + 1) % loop.size()];
        Rational at_p = turn(a, b, p), at_q = turn(a, b, q);
        if (!left) {
            at_p = -at_p;
            at_q = -at_q;
        }
        if (at_p >= 0) result.push_back(p);
        area = area || at_p > 0;
        if ((at_p > 0 && at_q < 0) || (at_p < 0 && at_q > 0)) {
            const Rational t = at_p / (at_p - at_q);
            result.push_back({p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)});
        }
    }
    return area ? result : Convex{};
}

/// Takes a convex loop off a set of disjoint convex loops.
std::vector<Convex> subtract(const std::vector<Convex>& from, const Convex& what) {
    std::vector<Convex> result;
    for (Convex rest : from) {
        // What lies beyond each side of `what` in turn stays; what is left at the end lies inside.
        std::vector<Convex> outside;
        for (std::size_t k = 0; k < what.size() && !rest.empty(); ++k) {
            const RationalPoint2 &a = what[k], &b = what[(k + 1) % what.size()];
            Convex beyond = clip(rest, a, b, false);
            if (!beyond.empty()) outside.push_back(std::move(beyond));
            rest = clip(rest, a, b, true);
        }
        result.insert(result.end(), outside.begin(), outside.end());
    }
    return result;
}

Rational twice_area(const std::vector<Convex>& loops) {
    Rational sum = 0;
    for (const Convex& loop : loops) sum += twice_area(loop);
    return sum;
}

bool overlap(const Scene& scene, PolygonId p, PolygonId q) {
    for (const Piece& a : scene.pieces_of(p))
        for (const Piece& b : scene.pieces_of(q)) {
            Convex rest = seen(scene, a);
            const Convex other = seen(scene, b);
            for (std::size_t k = 0; k < other.size() && !rest.empty(); ++k)
                rest = clip(rest, other[k], other[(k + 1) % other.size()], true);
            if (!rest.empty()) return true;
        }
    return false;
}

}  // namespace

Sheets::Sheets(const Scene& scene, const CandidateSource& candidates)
    : scene_(scene), above_(static_cast<std::size_t>(scene.polygon_count())) {
    for (PolygonId polygon = 0; polygon < scene.polygon_count(); ++polygon) {
        if (!scene.polygon(polygon).valid) continue;
        for (const PolygonId top : sheets_on_top(scene, polygon, candidates))
            if (overlap(scene, polygon, top)) above_[static_cast<std::size_t>(polygon)].push_back(top);
    }
}

Cover Sheets::cover(const Root& root, const Element& element) const {
    const std::vector<PolygonId>& tops = above(root.polygon);
    if (tops.empty()) return {};
    const Corners at = corners(scene_, root, element);
    Convex whole;
    for (int k = 0; k < at.count; ++k)
        whole.push_back(seen(scene_.polygon(root.polygon).view, at.points[static_cast<std::size_t>(k)].rational()));
    const Rational area = twice_area(whole);
    std::vector<Convex> rest{std::move(whole)};
    for (const PolygonId top : tops)
        for (const Piece& piece : scene_.pieces_of(top)) rest = subtract(rest, seen(scene_, piece));
    const Rational left = twice_area(rest);
    if (left == area) return {};
    if (left == 0) return {Cover::Kind::wholly, 0};
    return {Cover::Kind::partly, to_nearest(left / area)};
}

bool Sheets::hides(PolygonId polygon, const ExactPoint& point) const {
    const std::vector<PolygonId>& tops = above(polygon);
    if (tops.empty()) return false;
    const RationalPoint2 p = seen(scene_.polygon(polygon).view, point.rational());
    for (const PolygonId top : tops)
        for (const Piece& piece : scene_.pieces_of(top)) {
            const Convex loop = seen(scene_, piece);
            bool inside = true;
            for (std::size_t k = 0; k < loop.size() && inside; ++k)
                inside = turn(loop[k], loop[(k + 1) % loop.size()], p) >= 0;
            if (inside) return true;
        }
    return false;
}

}  // namespace cob::radiosity
