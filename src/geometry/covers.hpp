/// \file
/// Cover by a polygon of several pieces (SPEC 5): together they must hide the closed base rectangle, and nothing
/// of them over it may lie at z <= 0 or above the top. Constructs points, so it needs a field: fractions, or a
/// floating type for the study of its errors.
#pragma once

#include "arithmetic/uncertain_sign.hpp"
#include "geometry/frame.hpp"

#include <utility>
#include <vector>

namespace cob {

/// The corners of one convex piece in the frame.
template <class Number>
using FrameCorners = std::vector<Vector3<Number>>;

/// The part of a convex polygon where value <= 0, value being linear. Points and segments are kept: a degenerate
/// polygon is the hull of its corners all the same.
template <class Number, class Value, class SignOf>
FrameCorners<Number> clip(const FrameCorners<Number>& polygon, const Value& value, const SignOf& sign) {
    FrameCorners<Number> inside;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vector3<Number>& p = polygon[i];
        const Vector3<Number>& q = polygon[i + 1 == polygon.size() ? 0 : i + 1];
        const Number at_p = value(p), at_q = value(q);
        const UncertainSign side_p = sign(at_p), side_q = sign(at_q);
        if (side_p != UncertainSign::positive) inside.push_back(p);
        const bool crosses = (side_p == UncertainSign::positive && side_q == UncertainSign::negative) ||
                             (side_p == UncertainSign::negative && side_q == UncertainSign::positive);
        if (crosses) inside.push_back(p + Number(at_p / (at_p - at_q)) * (q - p));
    }
    return inside;
}

/// All of the piece over the closed base rectangle lies at 0 < z <= h.
template <class Kernel>
bool lies_within_height(const Kernel& kernel, const FrameBox<typename Kernel::Number>& box,
                        FrameCorners<typename Kernel::Number> piece) {
    using Number = typename Kernel::Number;
    for (int k = 0; k < 2; ++k) {
        const auto sign = [&](const Number& value) { return kernel.face(value, k); };
        piece = clip(
            piece, [&](const Vector3<Number>& p) { return Number(box.low[k] - p[k]); }, sign);
        piece = clip(
            piece, [&](const Vector3<Number>& p) { return Number(p[k] - box.high[k]); }, sign);
    }
    for (const Vector3<Number>& p : piece) {
        if (kernel.base(box.low.z - p.z) != UncertainSign::negative) return false;
        if (kernel.top(p.z - box.high.z) == UncertainSign::positive) return false;
    }
    return true;
}

/// Parts of a convex polygon with area that a piece, seen along the normal, does not hide: cut off along the
/// piece's sides one by one. Parts without area are dropped; a closed cover hides them anyway.
template <class Kernel>
std::vector<FrameCorners<typename Kernel::Number>> not_hidden(const Kernel& kernel,
                                                              FrameCorners<typename Kernel::Number> rest,
                                                              const FramePiece<typename Kernel::Number>& piece) {
    using Number = typename Kernel::Number;
    std::vector<FrameCorners<Number>> parts;
    const UncertainSign turn = kernel.turn(piece.normal().z, 2);
    if (turn == UncertainSign::zero) return {std::move(rest)};
    for (int side = 0; side < piece.count; ++side) {
        const bool left = turn == UncertainSign::positive;
        const Vector3<Number>& q = piece.corner(side);
        const Vector3<Number>& r = piece.next(side);
        Vector3<Number> d;  // out of the piece
        d.x = left ? r.y - q.y : q.y - r.y;
        d.y = left ? q.x - r.x : r.x - q.x;
        const auto beyond = [&](const Vector3<Number>& p) { return Number(d.x * (p.x - q.x) + d.y * (p.y - q.y)); };
        const auto sign = [&](const Number& value) { return kernel.edge(value, d, false); };
        const auto before = [&](const Vector3<Number>& p) { return Number(-beyond(p)); };

        bool outside = false, inside = false;
        for (const Vector3<Number>& p : rest) {
            const UncertainSign s = sign(beyond(p));
            outside = outside || s == UncertainSign::positive;
            inside = inside || s == UncertainSign::negative;
        }
        if (outside) parts.push_back(clip(rest, before, sign));
        if (!inside) return parts;
        rest = clip(rest, beyond, sign);
    }
    return parts;
}

/// The pieces together cover the box (SPEC 5).
template <class Kernel>
bool pieces_cover(const Kernel& kernel, const FrameBox<typename Kernel::Number>& box,
                  const std::vector<FrameCorners<typename Kernel::Number>>& pieces) {
    using Number = typename Kernel::Number;
    for (const auto& piece : pieces)
        if (!lies_within_height(kernel, box, piece)) return false;

    std::vector<FrameCorners<Number>> open = {{box.low,
                                               {box.high.x, box.low.y, box.low.z},
                                               {box.high.x, box.high.y, box.low.z},
                                               {box.low.x, box.high.y, box.low.z}}};
    for (const auto& piece : pieces) {
        std::vector<FrameCorners<Number>> next;
        for (auto& part : open) {
            auto parts =
                not_hidden(kernel, std::move(part), FramePiece<Number>(piece.data(), static_cast<int>(piece.size())));
            std::move(parts.begin(), parts.end(), std::back_inserter(next));
        }
        open = std::move(next);
        if (open.empty()) return true;
    }
    return false;
}

}  // namespace cob
