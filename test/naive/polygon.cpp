#include "naive/polygon.hpp"

#include "naive/ears.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace cob::naive {

RationalPoint newell(const Loop& loop) {
    RationalPoint normal;
    for (std::size_t k = 0; k < loop.size(); ++k) normal = normal + cross(loop[k], loop[(k + 1) % loop.size()]);
    return normal;
}

namespace {

/// "Consecutive vertices at one position count once (last and first, too; the first of a run is kept)."
Loop drop_repeated(const std::vector<Point>& corners) {
    Loop loop;
    for (const Point& corner : corners) {
        const RationalPoint exact = to_rational(corner);
        if (loop.empty() || loop.back() != exact) loop.push_back(exact);
    }
    while (loop.size() > 1 && loop.back() == loop.front()) loop.pop_back();
    return loop;
}

/// "Along the coordinate axis where that normal is largest in absolute value (the first such axis), the visible
/// side up": the two other axes in the order that makes the loop run counter-clockwise.
void choose_view(Polygon& polygon) {
    int axis = 0;
    for (const int other : {1, 2})
        if (abs(polygon.normal[other]) > abs(polygon.normal[axis])) axis = other;
    polygon.first = (axis + 1) % 3;
    polygon.second = (axis + 2) % 3;
    if (polygon.normal[axis] < 0) std::swap(polygon.first, polygon.second);
}

bool all_in_one_plane(const Polygon& polygon) {
    return std::all_of(polygon.loop.begin(), polygon.loop.end(), [&](const RationalPoint& corner) {
        return dot(polygon.normal, corner - polygon.loop.front()) == 0;
    });
}

/// Two sides cross: each has its ends strictly on both sides of the other.
std::string crossing_sides(const std::vector<Seen>& seen) {
    const std::size_t n = seen.size();
    const auto side = [&](std::size_t k) { return Side{seen[k], seen[(k + 1) % n]}; };
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = i + 1; j < n; ++j) {
            const Side a = side(i), b = side(j);
            if (turn(a.from, a.to, b.from) * turn(a.from, a.to, b.to) < 0 &&
                turn(b.from, b.to, a.from) * turn(b.from, b.to, a.to) < 0)
                return "sides " + std::to_string(i) + " and " + std::to_string(j) + " cross";
        }
    }
    return {};
}

/// "It never turns right nor back; straight angles are allowed"; and it goes round once, else its region is that of
/// its winding number.
bool is_convex(const std::vector<Seen>& seen) {
    const std::size_t n = seen.size();
    const auto points_up = [&](std::size_t k) {
        const Seen &a = seen[k % n], &b = seen[(k + 1) % n];
        return b.t > a.t || (b.t == a.t && b.s > a.s);
    };
    int rounds = 0;
    for (std::size_t k = 0; k < n; ++k) {
        const Seen &a = seen[k], &b = seen[(k + 1) % n], &c = seen[(k + 2) % n];
        const Rational bend = turn(a, b, c);
        if (bend < 0 || (bend == 0 && ahead(a, b, c) <= 0)) return false;
        if (!points_up(k) && points_up(k + 1)) ++rounds;
    }
    return rounds == 1;
}

/// The points that the loop winds around, as trapezoids between verticals through all corners.
std::vector<std::vector<Seen>> trapezoids(const std::vector<Seen>& seen) {
    const std::size_t n = seen.size();
    std::set<Rational> verticals;
    for (const Seen& corner : seen) verticals.insert(corner.s);
    std::vector<std::vector<Seen>> result;
    for (auto left = verticals.begin(), right = std::next(left); right != verticals.end(); ++left, ++right) {
        // Sides across this strip from below to above: no two cross, so their middles order them, and those with
        // one middle coincide. +1 where the loop runs to the right.
        std::map<Rational, std::pair<int, Side>> crossings;
        for (std::size_t k = 0; k < n; ++k) {
            Seen a = seen[k], b = seen[(k + 1) % n];
            const int direction = a.s < b.s ? 1 : -1;
            if (direction < 0) std::swap(a, b);
            if (a.s > *left || b.s < *right) continue;
            const auto height = [&](const Rational& s) {
                return Rational(a.t + (b.t - a.t) * (s - a.s) / (b.s - a.s));
            };
            const Side across{{*left, height(*left)}, {*right, height(*right)}};
            auto& crossing = crossings[(across.from.t + across.to.t) / 2];
            crossing.first += direction;
            crossing.second = across;
        }
        int winding = 0;
        for (auto below = crossings.begin(); below != crossings.end(); ++below) {
            winding += below->second.first;
            if (winding == 0) continue;
            const Side &low = below->second.second, &high = std::next(below)->second.second;
            std::vector<Seen> trapezoid{low.from, low.to};
            if (high.to.t != low.to.t) trapezoid.push_back(high.to);
            if (high.from.t != low.from.t) trapezoid.push_back(high.from);
            result.push_back(trapezoid);
        }
    }
    return result;
}

/// The point of the polygon's plane that is seen at this place.
RationalPoint lift(const Polygon& polygon, const Seen& place) {
    const int axis = 3 - polygon.first - polygon.second;
    RationalPoint point = polygon.loop.front();
    const Rational ds = place.s - point[polygon.first], dt = place.t - point[polygon.second];
    point[polygon.first] = place.s;
    point[polygon.second] = place.t;
    point[axis] -= (polygon.normal[polygon.first] * ds + polygon.normal[polygon.second] * dt) / polygon.normal[axis];
    return point;
}

void add_piece(Polygon& polygon, const Loop& corners) {
    polygon.pieces.push_back({corners, newell(corners)});
}

}  // namespace

Polygon prepare(const std::vector<Point>& corners) {
    Polygon polygon;
    polygon.loop = drop_repeated(corners);
    if (std::set<RationalPoint>(polygon.loop.begin(), polygon.loop.end()).size() < 3) {
        polygon.refused = "fewer than 3 distinct vertices";
        return polygon;
    }
    polygon.normal = newell(polygon.loop);
    if (polygon.normal == RationalPoint{}) {
        polygon.refused = "zero area";
        return polygon;
    }
    choose_view(polygon);
    std::vector<Seen> seen;
    for (const RationalPoint& corner : polygon.loop) seen.push_back({corner[polygon.first], corner[polygon.second]});
    polygon.refused = crossing_sides(seen);
    if (!polygon.refused.empty()) return polygon;

    polygon.planar = all_in_one_plane(polygon);
    if (!polygon.planar) {
        const Ears ears = cut_ears(polygon.loop, seen);
        if (!ears.complete) polygon.refused = "it cannot be cut into triangles";
        for (const auto& ear : ears.triangles)
            add_piece(polygon, {polygon.loop[ear[0]], polygon.loop[ear[1]], polygon.loop[ear[2]]});
    } else if (is_convex(seen)) {
        add_piece(polygon, polygon.loop);
    } else {
        for (const auto& trapezoid : trapezoids(seen)) {
            Loop piece;
            for (const Seen& place : trapezoid) piece.push_back(lift(polygon, place));
            add_piece(polygon, piece);
        }
    }
    return polygon;
}

}  // namespace cob::naive
