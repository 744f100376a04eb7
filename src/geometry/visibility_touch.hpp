/// \file
/// An open segment against one closed convex piece (SPEC section 6), by signs alone.
#pragma once

#include "geometry/visibility_signs.hpp"

#include <cstddef>
#include <optional>

namespace cob {

/// How the open segment meets a piece.
struct Touch {
    enum class Kind : std::uint8_t {
        none,
        inside,    ///< Crosses the plane in the piece's interior: blocked.
        side,      ///< Crosses the plane on a side, or at a corner where the piece runs straight on.
        corner,    ///< Crosses the plane at a corner.
        in_plane,  ///< Runs within the plane and meets the piece.
    };
    Kind kind = Kind::none;
    int index = -1;            ///< Of the side or corner.
    Sign begins = Sign::zero;  ///< Where it crosses: the side of the plane that it comes from.
};

namespace detail {

inline VertexId corner(View<VertexId> corners, int k) {
    const int count = static_cast<int>(corners.size());
    return corners[k < count ? k : k - count];
}

}  // namespace detail

/// The corner at which two sides that are not parallel both carry the point of contact; nothing where the sides
/// through it are all parallel. The loop of a convex piece passes each of its true corners with two such sides
/// in a row, straight angles notwithstanding.
template <class Signs>
std::optional<int> corner_touched(const Signs& signs, PieceId id, int first_zero) {
    const Piece& piece = signs.scene().piece(id);
    const View<VertexId> corners = signs.scene().corners(piece);
    const int count = static_cast<int>(corners.size());
    const auto touched = [&](int k) {
        return signs.line_side(detail::corner(corners, k), detail::corner(corners, k + 1)) == Sign::zero;
    };
    const int axis = signs.pieces().view_axis(id);
    bool before = touched(first_zero == 0 ? count - 1 : first_zero - 1);
    for (int k = first_zero; k < count; ++k) {
        const bool here = touched(k);
        if (before && here) {
            const Ray in{detail::corner(corners, k == 0 ? count - 1 : k - 1), detail::corner(corners, k)};
            const Ray out{detail::corner(corners, k), detail::corner(corners, k + 1)};
            if (count == 3 || !signs.parallel(in, out, axis)) return k;
        }
        before = here;
    }
    return std::nullopt;
}

/// The plane is crossed from `begins`. Seen along d the piece runs counter-clockwise where the segment leaves to the
/// visible side, so the line passes inside where every side has the sign of the far end.
template <class Signs>
Touch cross_piece(const Signs& signs, PieceId id, Sign begins) {
    const View<VertexId> corners = signs.scene().corners(signs.scene().piece(id));
    const int count = static_cast<int>(corners.size());
    int first_zero = -1;
    for (int k = 0; k < count; ++k) {
        const Sign side = signs.line_side(corners[k], detail::corner(corners, k + 1));
        if (side == begins) return {};
        if (side == Sign::zero && first_zero < 0) first_zero = k;
    }
    if (first_zero < 0) return {Touch::Kind::inside, -1, begins};
    if (const auto corner = corner_touched(signs, id, first_zero)) return {Touch::Kind::corner, *corner, begins};
    return {Touch::Kind::side, first_zero, begins};
}

/// Both ends lie in the plane: the open segment misses the closed piece where a side separates them or the line of
/// the segment passes by. A side that is not parallel to the segment separates even where an end lies on it, because
/// the end does not count; seen along the view axis nothing changes.
template <class Signs>
bool meets_in_plane(const Signs& signs, PieceId id) {
    const View<VertexId> corners = signs.scene().corners(signs.scene().piece(id));
    const int count = static_cast<int>(corners.size());
    const int axis = signs.pieces().view_axis(id);
    const Sign inward = signs.pieces().view_side(id);
    bool left = false, right = false, on = false;
    for (int k = 0; k < count; ++k) {
        const VertexId a = corners[k], b = detail::corner(corners, k + 1);
        const Sign from = signs.flat_side(a, b, End::from, axis), to = signs.flat_side(a, b, End::to, axis);
        const bool along = from == Sign::zero && to == Sign::zero;
        if (from != inward && to != inward && !along) return false;
        const Sign passes = signs.flat_side(a, axis);
        (passes == Sign::positive ? left : passes == Sign::negative ? right : on) = true;
    }
    return on || (left && right);
}

/// The open segment against one piece.
template <class Signs>
Touch touch(const Signs& signs, PieceId id) {
    switch (signs.at_once(id)) {
        case Certain::missed:
            return {};
        case Certain::crossed_inside:
            return {Touch::Kind::inside, -1, signs.end_side(id, End::from)};
        case Certain::unknown:
            break;
    }
    const Sign from = signs.end_side(id, End::from);
    const Sign to = signs.end_side(id, End::to);
    if (from == Sign::zero && to == Sign::zero) {
        if (meets_in_plane(signs, id)) return {Touch::Kind::in_plane, -1, Sign::zero};
        return {};
    }
    // A plane touched at an end is met there only, and the end does not count.
    if (from == Sign::zero || to == Sign::zero || from == to) return {};
    return cross_piece(signs, id, from);
}

}  // namespace cob
