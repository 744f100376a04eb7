#include "naive/clip.hpp"

namespace cob::naive {

namespace {

/// Twice the signed area in the plane z = 0.
Rational area(const Corners& polygon) {
    Rational sum = 0;
    for (std::size_t k = 0; k < polygon.size(); ++k) sum += cross(polygon[k], polygon[(k + 1) % polygon.size()]).z;
    return sum;
}

}  // namespace

std::vector<Corners> subtract(const Corners& from, const Corners& taken) {
    const int orientation = area(taken).sign();
    if (orientation == 0) return {from};
    // Cut off what lies outside side after side; what is left in the end lies inside all of them.
    std::vector<Corners> result;
    Corners rest = from;
    for (std::size_t k = 0; k < taken.size() && !rest.empty(); ++k) {
        const RationalPoint &a = taken[k], &b = taken[(k + 1) % taken.size()];
        if (a == b) continue;
        const auto inside = [&](const RationalPoint& p) { return Rational(cross(b - a, p - a).z * orientation); };
        const Corners cut = clip(rest, [&](const RationalPoint& p) { return Rational(-inside(p)); });
        if (area(cut) != 0) result.push_back(cut);
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
