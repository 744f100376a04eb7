#include "scene/seen.hpp"
#include "scene/side_tree.hpp"

#include <algorithm>
#include <array>
#include <numeric>

namespace cob {
namespace {

/// Two segments meet in exactly one point, which is inside both.
bool cross_properly(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
    if (a == c || a == d || b == c || b == d) return false;
    const Sign side_of_c = orientation(a, b, c), side_of_d = orientation(a, b, d);
    if (side_of_c * side_of_d != Sign::negative) return false;
    return orientation(c, d, a) * orientation(c, d, b) == Sign::negative;
}

/// Sides that are run before, in either direction: they cross nothing that the first run does not, and loops that go
/// around many times would make very many pairs.
std::vector<bool> repeated_sides(const SeenLoop& loop) {
    const auto less = [](const Point2& a, const Point2& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; };
    const auto ends = [&](std::size_t side) {
        const Point2 &from = loop.seen[side], &to = loop.seen[loop.next(side)];
        return less(from, to) ? std::array<Point2, 2>{from, to} : std::array<Point2, 2>{to, from};
    };
    std::vector<std::size_t> order(loop.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        const auto p = ends(a), q = ends(b);
        if (p[0] != q[0]) return less(p[0], q[0]);
        if (p[1] != q[1]) return less(p[1], q[1]);
        return a < b;
    });
    std::vector<bool> repeated(loop.size());
    for (std::size_t k = 1; k < order.size(); ++k) repeated[order[k]] = ends(order[k]) == ends(order[k - 1]);
    return repeated;
}

}  // namespace

std::optional<SidePair> crossing_sides(const SeenLoop& loop) {
    const std::size_t count = loop.size();
    if (count < 4) return std::nullopt;
    const std::vector<bool> repeated = repeated_sides(loop);
    const auto bounds_of = [&](std::size_t k) {
        return repeated[k] ? Bounds2{} : Bounds2::of(loop.seen[k], loop.seen[loop.next(k)]);
    };
    SideTree tree(count);
    tree.fill(count, bounds_of);

    std::optional<SidePair> pair;
    for (std::size_t side = 0; side + 2 < count && !pair; ++side) {
        if (repeated[side]) continue;
        const Bounds2 bounds = bounds_of(side);
        tree.find(
            side + 2, [&](const Bounds2& box) { return meets_closed(box, bounds); },
            [&](std::size_t other) {
                if (cross_properly(loop.seen[side], loop.seen[loop.next(side)], loop.seen[other],
                                   loop.seen[loop.next(other)]))
                    pair = SidePair{side, other};
                return pair.has_value();
            });
    }
    return pair;
}

}  // namespace cob
