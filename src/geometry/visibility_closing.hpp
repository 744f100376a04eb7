/// \file
/// Whether the pieces that a segment touches at their sides and corners close around it (SPEC section 6).
#pragma once

#include "geometry/visibility_signs.hpp"
#include "geometry/visibility_touch.hpp"

#include <boost/container/small_vector.hpp>

#include <cstddef>

namespace cob {

/// The local sector of a piece at a point of contact on its side or corner: seen along the segment, the open sector
/// that is swept counter-clockwise from `begin` to `end`; at most half a turn.
struct Sector {
    PieceId piece;
    Touch touch;
    Ray begin, end;
    VertexId corner;      ///< The point of contact where it is a corner, else -1.
    bool closes = false;  ///< Set by the check: belongs to a point at which the pieces close.
};

using Sectors = boost::container::small_vector<Sector, 8>;

/// The sector of a piece touched at a side or a corner.
template <class Signs>
Sector sector_of(const Signs& signs, PieceId id, const Touch& touch) {
    const View<VertexId> corners = signs.scene().corners(signs.scene().piece(id));
    const int count = static_cast<int>(corners.size()), k = touch.index;
    Sector sector{id, touch, {}, {}, -1};
    // Counter-clockwise from the visible side: a half plane from its side's direction to the opposite one, a wedge
    // from the side that leaves the corner to the one that comes in, looked at backwards.
    sector.begin = {corners[k], detail::corner(corners, k + 1)};
    sector.end = -sector.begin;
    if (touch.kind == Touch::Kind::corner) {
        sector.corner = corners[k];
        sector.end = {corners[k], corners[k == 0 ? count - 1 : k - 1]};
    }
    // Seen along a segment that comes from the visible side, everything is mirrored.
    if (touch.begins == Sign::positive) std::swap(sector.begin, sector.end);
    return sector;
}

/// Two sectors belong to one point of the segment.
template <class Signs>
bool same_point(const Signs& signs, const Sector& a, const Sector& b) {
    if (a.corner >= 0 && b.corner >= 0) return signs.same_position(a.corner, b.corner);
    if (a.corner < 0 && b.corner < 0) {
        // The same side: the segment crosses it, so it meets it only once.
        const Ray s = a.begin, t = b.begin;
        if ((signs.same_position(s.from, t.from) && signs.same_position(s.to, t.to)) ||
            (signs.same_position(s.from, t.to) && signs.same_position(s.to, t.from)))
            return true;
    }
    return signs.compare_parameters(a.piece, b.piece) == Sign::zero;
}

/// Seen along the segment, the ray lies on a seam of two other sectors: a ray in space, elsewhere in depth, at which
/// one of them ends and the other begins.
template <class Signs>
bool on_seam(const Signs& signs, const Ray& ray, const Sectors& sectors, const std::size_t* group, std::size_t count) {
    for (std::size_t k = 0; k < count; ++k) {
        const Sector& left = sectors[group[k]];
        if (signs.turn(left.begin, ray) != Sign::zero) continue;
        for (std::size_t l = 0; l < count; ++l) {
            const Sector& right = sectors[group[l]];
            // The ray has the seam's direction, not the opposite one, unless a wedge says otherwise. Between two half
            // turns both directions are seams.
            if (signs.turn(ray, left.end) != Sign::negative && signs.turn(right.begin, ray) != Sign::negative &&
                signs.same_ray(left.begin, right.end))
                return true;
        }
    }
    return false;
}

/// A ray at which some sector begins (or ends) is covered: seen along the segment it lies in an open sector, or it is
/// the same ray in space at which a sector on its other side ends (or begins), or it lies on a seam of others.
template <class Signs>
bool covered(const Signs& signs, const Ray& ray, bool begins, const Sectors& sectors, const std::size_t* group,
             std::size_t count) {
    for (std::size_t k = 0; k < count; ++k) {
        const Sector& other = sectors[group[k]];
        // The quick case of a matched side first: nearly every seam is one.
        const Ray& match = begins ? other.end : other.begin;
        if (match.from == ray.from && match.to == ray.to) return true;
    }
    for (std::size_t k = 0; k < count; ++k) {
        const Sector& other = sectors[group[k]];
        const Sign from_begin = signs.turn(other.begin, ray), to_end = signs.turn(ray, other.end);
        // For half a turn both signs are one; a wedge needs both.
        if (from_begin == Sign::positive && to_end == Sign::positive) return true;
        if (from_begin == Sign::zero || to_end == Sign::zero)
            if (signs.same_ray(begins ? other.end : other.begin, ray)) return true;
    }
    return on_seam(signs, ray, sectors, group, count);
}

/// The sectors of one point cover the full turn. Enough to check the rays at which they begin and end:
///
/// Let O be the union of the open sectors and K the rest of the circle of directions, closed. There is a sector, so
/// unless K is empty it has a boundary, and that consists of rays at which sectors begin or end. All of those are
/// covered, and those in K not by an open sector, so each has the direction of a ray in space at which one sector ends
/// and another begins on its other side: both its neighbourhoods lie in O. So K has no interval, K is finitely many
/// such rays, and SPEC 6 counts them as covered. The other way round is plain.
template <class Signs>
bool closes(const Signs& signs, const Sectors& sectors, const std::size_t* group, std::size_t count) {
    for (std::size_t k = 0; k < count; ++k) {
        const Sector& sector = sectors[group[k]];
        if (!covered(signs, sector.begin, true, sectors, group, count)) return false;
        if (!covered(signs, sector.end, false, sectors, group, count)) return false;
    }
    return count > 0;
}

/// Finds the points of the segment at which sectors meet, and marks those that close; whether any does.
/// `all`: mark every point, else stop at the first.
template <class Signs>
bool mark_closing(const Signs& signs, Sectors& sectors, bool all) {
    boost::container::small_vector<bool, 8> done(sectors.size(), false);
    boost::container::small_vector<std::size_t, 8> group;
    bool any = false;
    for (std::size_t k = 0; k < sectors.size(); ++k) {
        if (done[k]) continue;
        group.clear();
        for (std::size_t l = k; l < sectors.size(); ++l)
            if (!done[l] && (l == k || same_point(signs, sectors[k], sectors[l]))) {
                group.push_back(l);
                done[l] = true;
            }
        if (group.size() < 2 || !closes(signs, sectors, group.data(), group.size())) continue;
        for (const std::size_t l : group) sectors[l].closes = true;
        any = true;
        if (!all) return true;
    }
    return any;
}

}  // namespace cob
