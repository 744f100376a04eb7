// Ear cutting by the rule of SPEC 2 (choice 1), evaluated step by step as it stands there, with the answers of
// earlier steps kept as long as they hold. "Left", "straight", "back" are meant as seen throughout.
//
// A vertex with a left turn is always in one of two places: among the candidates, sorted by position, or with a
// watched side, one that meets its open triangle. It leaves the latter when that side changes or vanishes, so a
// vertex that is not a candidate is certainly no ear, and the first candidate that no side meets is the ear of the
// rule.
#include "scene/seen.hpp"
#include "scene/side_tree.hpp"

#include <set>
#include <utility>

namespace cob {
namespace {

/// A closed segment meets an open triangle, which turns left. Two convex sets are apart exactly where a line along
/// an edge of one of them separates them.
bool meets_open_triangle(const Point2& p, const Point2& q, const std::array<Point2, 3>& triangle) {
    for (std::size_t k = 0; k < 3; ++k) {
        const Point2 &a = triangle[k], &b = triangle[(k + 1) % 3];
        if (orientation(a, b, p) != Sign::positive && orientation(a, b, q) != Sign::positive) return false;
    }
    if (p == q) return true;
    bool left = false, right = false;
    for (const Point2& corner : triangle) {
        const Sign side = orientation(p, q, corner);
        left = left || side == Sign::positive;
        right = right || side == Sign::negative;
    }
    return left && right;
}

class EarCutter {
public:
    explicit EarCutter(const SeenLoop& loop)
        : loop_(loop),
          remaining_(loop.size()),
          before_(loop.size()),
          after_(loop.size()),
          turns_(loop.size(), Turn::none),
          watchers_(loop.size()),
          sides_(loop.size()) {}

    std::optional<std::vector<EarTriangle>> run() {
        start();
        while (remaining_ >= 3) {
            if (!back_.empty()) {
                drop(*back_.begin());
            } else if (const auto ear = first_ear()) {
                triangles_.push_back({before_[*ear], *ear, after_[*ear]});
                drop(*ear);
            } else if (!straight_.empty()) {
                drop(*straight_.begin());
            } else {
                return std::nullopt;
            }
        }
        return std::move(triangles_);
    }

private:
    using Corner = std::uint32_t;
    enum class Turn : std::uint8_t { none, left, right, straight, back };

    void start() {
        const auto count = static_cast<Corner>(loop_.size());
        for (Corner k = 0; k < count; ++k) {
            after_[k] = k + 1 == count ? 0 : k + 1;
            before_[after_[k]] = k;
        }
        sides_.fill(count, [&](std::size_t k) { return side_bounds(static_cast<Corner>(k)); });
        for (Corner k = 0; k < count; ++k) classify(k);
    }

    /// The side from a remaining corner to the next remaining one.
    Bounds2 side_bounds(Corner k) const { return Bounds2::of(loop_.seen[k], loop_.seen[after_[k]]); }

    Turn turn_at(Corner k) const {
        const Point2 &before = loop_.seen[before_[k]], &at = loop_.seen[k], &after = loop_.seen[after_[k]];
        if (before == at) return Turn::back;  // stands where the one before it stands: dropped alike
        if (at == after) return Turn::none;   // the next one is dropped before this one matters
        const Sign sign = orientation(before, at, after);
        if (sign != Sign::zero) return sign == Sign::positive ? Turn::left : Turn::right;
        return turns_back(before, at, after) ? Turn::back : Turn::straight;
    }

    void classify(Corner k) {
        forget(k);
        turns_[k] = turn_at(k);
        if (turns_[k] == Turn::back) back_.insert(k);
        if (turns_[k] == Turn::straight) straight_.insert(k);
        if (turns_[k] == Turn::left) candidates_.insert(k);
    }

    void forget(Corner k) {
        if (turns_[k] == Turn::back) back_.erase(k);
        if (turns_[k] == Turn::straight) straight_.erase(k);
        if (turns_[k] == Turn::left) candidates_.erase(k);
        turns_[k] = Turn::none;
    }

    /// The candidate at the smallest position whose open triangle meets no remaining side. Those before it that
    /// some side does meet go to watch that side.
    std::optional<Corner> first_ear() {
        while (!candidates_.empty()) {
            const Corner k = *candidates_.begin();
            const auto side = side_in_the_way(k);
            if (!side) return k;
            candidates_.erase(candidates_.begin());
            watchers_[*side].push_back(k);
        }
        return std::nullopt;
    }

    std::optional<Corner> side_in_the_way(Corner k) const {
        const std::array<Point2, 3> triangle{loop_.seen[before_[k]], loop_.seen[k], loop_.seen[after_[k]]};
        const Bounds2 bounds = Bounds2::of(triangle[0], triangle[1]) | Bounds2::of(triangle[2], triangle[2]);
        std::optional<Corner> met;
        sides_.find(
            0, [&](const Bounds2& box) { return meets_open(box, bounds); },
            [&](std::size_t leaf) {
                const auto side = static_cast<Corner>(leaf);
                if (meets_open_triangle(loop_.seen[side], loop_.seen[after_[side]], triangle)) met = side;
                return met.has_value();
            });
        return met;
    }

    /// Takes a corner out of the loop: its side vanishes, the side before it now ends at the corner after it.
    void drop(Corner k) {
        const Corner before = before_[k], after = after_[k];
        forget(k);
        after_[before] = after;
        before_[after] = before;
        --remaining_;
        sides_.set(k, Bounds2{});
        sides_.set(before, side_bounds(before));
        release_watchers(k);
        release_watchers(before);
        classify(before);
        classify(after);
    }

    void release_watchers(Corner side) {
        for (const Corner k : std::exchange(watchers_[side], {}))
            if (turns_[k] == Turn::left) candidates_.insert(k);
    }

    /// By position in space, then by place in the loop.
    struct ByPosition {
        const SeenLoop* loop;
        bool operator()(Corner a, Corner b) const {
            const Point &p = loop->space[a], &q = loop->space[b];
            return p != q ? p < q : a < b;
        }
    };

    const SeenLoop& loop_;
    std::size_t remaining_;
    std::vector<Corner> before_, after_;
    std::vector<Turn> turns_;
    std::vector<std::vector<Corner>> watchers_;  ///< Of each side, the corners whose triangle it is known to meet.
    SideTree sides_;                             ///< Leaf k: the side that begins at corner k.
    std::set<Corner> back_, straight_;
    std::set<Corner, ByPosition> candidates_{ByPosition{&loop_}};
    std::vector<EarTriangle> triangles_;
};

}  // namespace

std::optional<std::vector<EarTriangle>> cut_ears(const SeenLoop& loop) {
    return EarCutter(loop).run();
}

}  // namespace cob
