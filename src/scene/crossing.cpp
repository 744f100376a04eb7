#include "scene/seen.hpp"
#include "scene/side_tree.hpp"

namespace cob {
namespace {

/// Two segments meet in exactly one point, which is inside both.
bool cross_properly(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
    const Sign side_of_c = orientation(a, b, c), side_of_d = orientation(a, b, d);
    if (side_of_c * side_of_d != Sign::negative) return false;
    return orientation(c, d, a) * orientation(c, d, b) == Sign::negative;
}

}  // namespace

std::optional<SidePair> crossing_sides(const SeenLoop& loop) {
    const std::size_t count = loop.size();
    if (count < 4) return std::nullopt;
    const auto bounds_of = [&](std::size_t k) { return Bounds2::of(loop.seen[k], loop.seen[loop.next(k)]); };
    SideTree tree(count);
    tree.fill(count, bounds_of);

    std::optional<SidePair> pair;
    for (std::size_t side = 0; side + 2 < count && !pair; ++side) {
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
