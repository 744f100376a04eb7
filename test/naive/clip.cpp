#include "naive/clip.hpp"

namespace cob::naive {

namespace {

/// Twice the signed area of the triangle a, b, p in the plane z = 0.
Rational turn(const RationalPoint& a, const RationalPoint& b, const RationalPoint& p) {
    return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

/// The orientation of a convex polygon in the plane z = 0; 0 where it has no area.
int orientation_of(const Corners& polygon) {
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
        if (const int sign = turn(polygon[0], polygon[i], polygon[i + 1]).sign(); sign != 0) return sign;
    return 0;
}

}  // namespace

std::vector<Corners> subtract(const Corners& from, const Corners& taken) {
    const int orientation = orientation_of(taken);
    if (orientation == 0) return {from};
    // Cut off what lies outside side after side; what is left in the end lies inside all of them.
    std::vector<Corners> result;
    Corners rest = from;
    for (std::size_t k = 0; k < taken.size() && !rest.empty(); ++k) {
        const RationalPoint &a = taken[k], &b = taken[(k + 1) % taken.size()];
        if (a == b) continue;
        const auto inside = [&](const RationalPoint& p) { return orientation > 0 ? turn(a, b, p) : turn(b, a, p); };
        const Corners cut = clip(rest, [&](const RationalPoint& p) { return Rational(-inside(p)); });
        if (orientation_of(cut) != 0) result.push_back(cut);
        rest = clip(rest, inside);
    }
    return result;
}

std::vector<Corners> subtract_all(const Corners& from, const std::vector<Corners>& taken) {
    std::vector<Corners> left{from};
    for (const Corners& one : taken) {
        std::vector<Corners> rest;
        for (const Corners& part : left)
            for (Corners& kept : subtract(part, one)) rest.push_back(std::move(kept));
        left = std::move(rest);
    }
    return left;
}

}  // namespace cob::naive
