// The naive twin of the loop algorithms: SPEC section 2 read aloud, over small integers, all pairs, no memory of
// earlier steps.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <utility>
#include <vector>

namespace cob::naive {

using Number = std::int64_t;

struct Corner {
    std::array<Number, 3> space{};
    std::array<Number, 2> seen{};
};
using Loop = std::vector<Corner>;
using Triangle = std::array<Corner, 3>;

inline Number cross(const Corner& a, const Corner& b, const Corner& c) {
    return (b.seen[0] - a.seen[0]) * (c.seen[1] - a.seen[1]) - (b.seen[1] - a.seen[1]) * (c.seen[0] - a.seen[0]);
}
inline Number forward(const Corner& a, const Corner& b, const Corner& c) {
    return (b.seen[0] - a.seen[0]) * (c.seen[0] - b.seen[0]) + (b.seen[1] - a.seen[1]) * (c.seen[1] - b.seen[1]);
}

/// Newell's normal; the loop's seen coordinates filled in; false where it is zero.
inline bool see(Loop& loop) {
    std::array<Number, 3> normal{};
    for (std::size_t k = 0; k < loop.size(); ++k) {
        const auto &p = loop[k].space, &q = loop[(k + 1) % loop.size()].space;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::size_t s = (axis + 1) % 3, t = (axis + 2) % 3;
            normal[axis] += p[s] * q[t] - p[t] * q[s];
        }
    }
    std::size_t largest = 0;
    for (std::size_t axis = 1; axis < 3; ++axis)
        if (std::abs(normal[axis]) > std::abs(normal[largest])) largest = axis;
    if (normal[largest] == 0) return false;
    std::size_t s = (largest + 1) % 3, t = (largest + 2) % 3;
    if (normal[largest] < 0) std::swap(s, t);
    for (Corner& corner : loop) corner.seen = {corner.space[s], corner.space[t]};
    return true;
}

inline Number sign(Number value) {
    return (value > 0) - (value < 0);
}

inline bool sides_cross(const Loop& loop) {
    const std::size_t n = loop.size();
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = i + 1; j < n; ++j) {
            const Corner &a = loop[i], &b = loop[(i + 1) % n], &c = loop[j], &d = loop[(j + 1) % n];
            if (sign(cross(a, b, c)) * sign(cross(a, b, d)) < 0 && sign(cross(c, d, a)) * sign(cross(c, d, b)) < 0)
                return true;
        }
    return false;
}

/// Some point of the closed segment lies inside the open triangle: the parameters at which it is inside the three
/// open half-planes, from exact fraction to exact fraction, leave something.
inline bool meets_open_triangle(const Corner& p, const Corner& q, const Triangle& t) {
    struct Fraction {
        Number p, q;  // q > 0
        bool operator<(const Fraction& other) const { return p * other.q < other.p * q; }
    };
    Fraction from{0, 1}, to{1, 1};
    for (std::size_t k = 0; k < 3; ++k) {
        const Number at_p = cross(t[k], t[(k + 1) % 3], p), at_q = cross(t[k], t[(k + 1) % 3], q);
        if (at_p <= 0 && at_q <= 0) return false;
        if (at_p > 0 && at_q > 0) continue;
        // at_p + s (at_q - at_p) = 0
        const Fraction root = at_q > at_p ? Fraction{-at_p, at_q - at_p} : Fraction{at_p, at_p - at_q};
        if (at_q > at_p) {
            if (from < root) from = root;
        } else if (root < to) {
            to = root;
        }
    }
    return from < to || p.seen == q.seen;  // a segment of one point has passed all three tests as it is
}

inline bool is_ear(const Loop& loop, std::size_t k) {
    const std::size_t n = loop.size();
    const Triangle triangle{loop[(k + n - 1) % n], loop[k], loop[(k + 1) % n]};
    if (cross(triangle[0], triangle[1], triangle[2]) <= 0) return false;
    for (std::size_t side = 0; side < n; ++side)
        if (meets_open_triangle(loop[side], loop[(side + 1) % n], triangle)) return false;
    return true;
}

/// Choice 1; nothing: stuck.
inline std::optional<std::vector<Triangle>> cut(Loop loop) {
    std::vector<Triangle> pieces;
    const auto before = [&](std::size_t k) -> const Corner& { return loop[(k + loop.size() - 1) % loop.size()]; };
    const auto after = [&](std::size_t k) -> const Corner& { return loop[(k + 1) % loop.size()]; };
    const auto drop = [&](std::size_t k) { loop.erase(loop.begin() + static_cast<std::ptrdiff_t>(k)); };
    while (loop.size() >= 3) {
        std::optional<std::size_t> back, ear, straight;
        for (std::size_t k = 0; k < loop.size(); ++k) {
            const Number turn = cross(before(k), loop[k], after(k)), ahead = forward(before(k), loop[k], after(k));
            if (!back && (before(k).seen == loop[k].seen || (turn == 0 && ahead < 0))) back = k;
            if (!straight && turn == 0 && ahead > 0) straight = k;
            if (is_ear(loop, k) && (!ear || loop[k].space < loop[*ear].space)) ear = k;
        }
        if (back) {
            drop(*back);
        } else if (ear) {
            pieces.push_back({before(*ear), loop[*ear], after(*ear)});
            drop(*ear);
        } else if (straight) {
            drop(*straight);
        } else {
            return std::nullopt;
        }
    }
    return pieces;
}

/// How often the loop winds around a point that is on no side; coordinates times `scale`.
inline int winding(const Loop& loop, Number scale, std::array<Number, 2> point) {
    int turns = 0;
    for (std::size_t k = 0; k < loop.size(); ++k) {
        Corner a = loop[k], b = loop[(k + 1) % loop.size()], p;
        for (std::size_t axis = 0; axis < 2; ++axis) a.seen[axis] *= scale, b.seen[axis] *= scale;
        p.seen = point;
        const bool a_above = a.seen[1] > point[1], b_above = b.seen[1] > point[1];
        if (a_above == b_above) continue;
        const Number side = cross(a, b, p);
        if (b_above && side > 0) ++turns;
        if (a_above && side < 0) --turns;
    }
    return turns;
}

}  // namespace cob::naive
