/// \file
/// The one formula behind every relation of SPEC 5: a convex piece against a box by separating axes, over any
/// number type.
///
/// Letters: q corners of the piece P, e its sides, N its normal; k an axis of the box B; d the direction of a
/// possible separation, c the corner of B that comes first along d. The gap along d is
///     min over B of d.x - max over P of d.x = d.(c - q),   q the corner of P that comes last.
/// The facets of the convex set B - P have normals among: the box axes (both ways), N (both ways), and e x k. Of
/// the latter only those count along which P lies behind e: seen along k, those that point out of P's outline,
/// which has e as a side; where N.k = 0 the outline has no area and e x k is along N. N.k != 0 also keeps e x k
/// from vanishing. B - P is full-dimensional, so that
///     some gap > 0: P and B are apart;  all gaps < 0: P meets the interior of B;  else P only touches B.
/// The last case asks whether P touches B elsewhere than in its base: raise the base by an infinitely small amount.
/// A zero gap becomes positive exactly where c is a corner of the base and d.z > 0; then nothing but the base is
/// touched.
#pragma once

#include "arithmetic/uncertain_sign.hpp"
#include "geometry/frame.hpp"

#include <algorithm>
#include <array>
#include <type_traits>

namespace cob {

/// A set of separating axes, for the stages that look only at what the stage before left open.
struct AxisSet {
    std::uint8_t faces = 0;                ///< Bit 2k: below the box along axis k; bit 2k + 1: above.
    std::uint8_t normals = 0;              ///< Bit 0: along N; bit 1: against N.
    std::uint8_t groups = 0;               ///< Bit k: all of e x k, because the sign of N.k is not known.
    std::array<std::uint32_t, 3> sides{};  ///< Bit i of [k]: side i x k; sides from 31 on share a bit.

    bool empty() const { return (faces | normals | groups | sides[0] | sides[1] | sides[2]) == 0; }
    bool only_faces() const { return (normals | groups | sides[0] | sides[1] | sides[2]) == 0; }

    bool face(int bit) const { return (faces >> bit & 1) != 0; }
    bool normal(int bit) const { return (normals >> bit & 1) != 0; }
    bool group(int k) const { return (groups >> k & 1) != 0 || sides[static_cast<std::size_t>(k)] != 0; }
    bool side(int k, int i) const {
        return (groups >> k & 1) != 0 || (sides[static_cast<std::size_t>(k)] >> std::min(i, 31) & 1) != 0;
    }

    void add_face(int bit) { faces = static_cast<std::uint8_t>(faces | 1u << bit); }
    void add_normal(int bit) { normals = static_cast<std::uint8_t>(normals | 1u << bit); }
    void add_group(int k) { groups = static_cast<std::uint8_t>(groups | 1u << k); }
    void add_side(int k, int i) { sides[static_cast<std::size_t>(k)] |= std::uint32_t{1} << std::min(i, 31); }
};

/// Every axis.
struct AllAxes {
    static constexpr bool only_faces() { return false; }
    static constexpr bool face(int) { return true; }
    static constexpr bool normal(int) { return true; }
    static constexpr bool group(int) { return true; }
    static constexpr bool side(int, int) { return true; }
};

/// What the axes looked at so far tell.
struct Findings {
    bool apart = false;      ///< Some gap > 0.
    bool touches = false;    ///< Some gap = 0.
    bool only_base = false;  ///< Some gap = 0 that grows when the base is raised.
    AxisSet undecided;

    bool decided() const { return apart || undecided.empty(); }
};

/// Calls visit with the axes 0, 1 and 2 as constants, until one call returns true; that is returned.
template <class Visit>
bool any_axis(const Visit& visit) {
    return visit(std::integral_constant<int, 0>()) || visit(std::integral_constant<int, 1>()) ||
           visit(std::integral_constant<int, 2>());
}

/// Looks at the wanted axes and adds to the findings. A kernel supplies the number type and the signs:
///   face(gap, k), base(gap), top(gap)   gaps along the box's axes; top(gap) is that above the box,
///   edge(gap, d, top)                   gaps along e x k, top: c is a corner of the box's top,
///   plane(gap, d, offset, top)          gaps along N, which are d.offset(),
///   turn(value, k)                      sign of N.k.
template <class Kernel, class Axes>
void separate(const Kernel& kernel, const FrameBox<typename Kernel::Number>& box,
              const FramePiece<typename Kernel::Number>& piece, const Axes& wanted, Findings& findings) {
    using Number = typename Kernel::Number;

    /// Notes the sign of a gap; true: apart, no need to go on.
    const auto note = [&findings](UncertainSign sign, bool at_base, auto&& leave_open) {
        if (sign == UncertainSign::negative) return false;
        if (sign == UncertainSign::positive) return findings.apart = true;
        if (sign == UncertainSign::undecided) return leave_open(), false;
        findings.touches = true;
        findings.only_base = findings.only_base || at_base;
        return false;
    };

    // 1. The faces of the box.
    const auto beyond_faces = [&](auto k) {
        if (wanted.face(2 * k)) {
            const Number gap = box.low[k] - piece.high[k];
            const auto leave_open = [&] { findings.undecided.add_face(2 * k); };
            if (note(k == 2 ? kernel.base(gap) : kernel.face(gap, k), k == 2, leave_open)) return true;
        }
        if (wanted.face(2 * k + 1)) {
            const Number gap = piece.low[k] - box.high[k];
            const auto leave_open = [&] { findings.undecided.add_face(2 * k + 1); };
            if (note(k == 2 ? kernel.top(gap) : kernel.face(gap, k), false, leave_open)) return true;
        }
        return false;
    };
    if (any_axis(beyond_faces) || wanted.only_faces()) return;

    // 2. The plane of the piece, from both sides.
    const Vector3<Number> normal = piece.normal();
    const Vector3<Number> low = box.low - piece.corner(0), high = box.high - piece.corner(0);
    for (int way = 0; way < 2; ++way) {
        if (!wanted.normal(way)) continue;
        const Vector3<Number> d = way == 0 ? normal : -normal;
        const bool top = less_than_zero(d.z), foot = greater_than_zero(d.z);
        const Number gap =
            least_along(d.x, low.x, high.x) + least_along(d.y, low.y, high.y) + least_along(d.z, low.z, high.z);
        const auto offset = [&] {
            return Vector3<Number>{first_along(d.x, low.x, high.x), first_along(d.y, low.y, high.y),
                                   first_along(d.z, low.z, high.z)};
        };
        if (note(kernel.plane(gap, d, offset, top), foot, [&] { findings.undecided.add_normal(way); })) return;
    }

    // 3. The sides of the piece x the axes of the box: seen along k, the box's rectangle behind a side.
    const auto beyond_sides = [&](auto k) {
        if (!wanted.group(k)) return false;
        const UncertainSign turn = kernel.turn(normal[k], k);
        if (turn == UncertainSign::zero) return false;
        if (turn == UncertainSign::undecided) {
            findings.undecided.add_group(k);
            return false;
        }
        const bool left = greater_than_zero(normal[k]);
        constexpr int i = k == 2 ? 0 : k + 1, j = k == 0 ? 2 : k - 1;
        for (int side = 0; side < piece.count; ++side) {
            if (!wanted.side(k, side)) continue;
            const Vector3<Number>& q = piece.corner(side);
            const Vector3<Number>& r = piece.next(side);
            Vector3<Number> d;  // out of the outline, which runs counter-clockwise where N.k > 0
            d[i] = signed_by(left, Number(r[j] - q[j]));
            d[j] = signed_by(left, Number(q[i] - r[i]));
            const bool top = less_than_zero(d.z), foot = greater_than_zero(d.z);
            const Number gap = least_along(d[i], Number(box.low[i] - q[i]), Number(box.high[i] - q[i])) +
                               least_along(d[j], Number(box.low[j] - q[j]), Number(box.high[j] - q[j]));
            if (note(kernel.edge(gap, d, top), foot, [&] { findings.undecided.add_side(k, side); })) return true;
        }
        return false;
    };
    any_axis(beyond_sides);
}

/// The paper's test of cover for a convex piece (SPEC 5): it meets all four edges of the box; and, a little more
/// than SPEC asks of `covers`, nothing about a piece whose plane contains n, which hides no area.
template <class Kernel>
UncertainBool meets_all_box_edges(const Kernel& kernel, const FrameBox<typename Kernel::Number>& box,
                                  const FramePiece<typename Kernel::Number>& piece) {
    using Number = typename Kernel::Number;
    const Vector3<Number> normal = piece.normal();
    const UncertainSign turn = kernel.turn(normal.z, 2);
    if (turn == UncertainSign::zero) return UncertainBool::no;
    if (turn == UncertainSign::undecided) return UncertainBool::undecided;
    const bool left = greater_than_zero(normal.z);
    const Vector3<Number> up = left ? normal : -normal;

    UncertainBool answer = UncertainBool::yes;
    /// Notes a sign that must not be positive; true: it is.
    const auto fails = [&answer](UncertainSign sign, bool zero_fails) {
        if (sign == UncertainSign::undecided) answer = UncertainBool::undecided;
        return sign == UncertainSign::positive || (zero_fails && sign == UncertainSign::zero);
    };
    for (int corner = 0; corner < 4; ++corner) {
        Vector3<Number> c{corner == 0 || corner == 3 ? box.low.x : box.high.x, corner < 2 ? box.low.y : box.high.y,
                          box.low.z};
        for (int side = 0; side < piece.count; ++side) {
            const Vector3<Number>& q = piece.corner(side);
            const Vector3<Number>& r = piece.next(side);
            Vector3<Number> d;
            d.x = signed_by(left, Number(r.y - q.y));
            d.y = signed_by(left, Number(q.x - r.x));
            if (fails(kernel.edge(d.x * (c.x - q.x) + d.y * (c.y - q.y), d, false), false)) return UncertainBool::no;
        }
        // The plane of the piece passes above the box edge's foot and not above its top.
        const auto offset = [&] { return c - piece.corner(0); };
        if (fails(kernel.plane(dot(up, offset()), up, offset, false), true)) return UncertainBool::no;
        c.z = box.high.z;
        const Vector3<Number> down = -up;
        if (fails(kernel.plane(dot(down, offset()), down, offset, true), false)) return UncertainBool::no;
    }
    return answer;
}

}  // namespace cob
