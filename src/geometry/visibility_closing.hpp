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
    VertexId corner;  ///< The point of contact where it is a corner, else -1.
    // Set by mark_closing():
    bool closes = false;  ///< Belongs to a point at which the pieces close.
    Covering begin_covering = Covering::none, end_covering = Covering::none;
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

/// The sectors that meet at one point: indices into all sectors.
using Group = boost::container::small_vector<std::size_t, 8>;

/// Seen along the segment, the direction of a ray lies in one of the open sectors.
template <class Signs>
bool in_open_sector(const Signs& signs, const Ray& ray, const Sectors& sectors, const Group& group) {
    for (const std::size_t k : group)  // for half a turn both signs are one; a wedge needs both
        if (signs.turn(sectors[k].begin, ray) == Sign::positive && signs.turn(ray, sectors[k].end) == Sign::positive)
            return true;
    return false;
}

/// Seen along the segment, the direction of a ray is that of a matched one: a ray in space at which one sector begins
/// and another ends. The matched ray may be nearer or farther along the segment than the ray itself.
template <class Signs>
bool on_matched_ray(const Signs& signs, const Ray& ray, const Sectors& sectors, const Group& group) {
    for (const std::size_t k : group)
        if (signs.same_sight(sectors[k].begin, ray))
            for (const std::size_t l : group)
                if (signs.same_ray(sectors[k].begin, sectors[l].end)) return true;
    return false;
}

/// Some sector ends (or begins) at just this ray, of the same two vertices: the quick case, nearly every seam is one.
inline bool plainly_matched(const Ray& ray, bool begins, const Sectors& sectors, const Group& group) {
    for (const std::size_t k : group) {
        const Ray& match = begins ? sectors[k].end : sectors[k].begin;
        if (match.from == ray.from && match.to == ray.to) return true;
    }
    return false;
}

/// The sectors of one point, with the matched rays, cover the full turn. Enough to check the directions in which they
/// begin and end:
///
/// Let O be the union of the open sectors and K the rest of the circle of directions, closed. There is a sector, so
/// unless K is empty it has a boundary, and that consists of directions in which sectors begin or end. Those are
/// covered, and not by an open sector, so in each of them one sector ends and another begins: both its neighbourhoods
/// lie in O. So K has no interval, K is finitely many such directions, and SPEC 6 counts them as covered. The other
/// way round is plain.
template <class Signs>
bool closes(const Signs& signs, Sectors& sectors, const Group& group, bool all) {
    const auto covering = [&](const Ray& ray, bool begins) {
        return plainly_matched(ray, begins, sectors, group) ? Covering::seam
               : in_open_sector(signs, ray, sectors, group) ? Covering::sector
               : on_matched_ray(signs, ray, sectors, group) ? Covering::seam
                                                            : Covering::none;
    };
    bool every = true;
    for (const std::size_t k : group) {
        sectors[k].begin_covering = covering(sectors[k].begin, true);
        every = every && sectors[k].begin_covering != Covering::none;
        if (!every && !all) return false;
        sectors[k].end_covering = covering(sectors[k].end, false);
        every = every && sectors[k].end_covering != Covering::none;
        if (!every && !all) return false;
    }
    return every;
}

/// Finds the points of the segment at which sectors meet, and marks those that close; whether any does.
/// `all`: mark every point and every ray, else stop as soon as the answer is known.
template <class Signs>
bool mark_closing(const Signs& signs, Sectors& sectors, bool all) {
    boost::container::small_vector<bool, 8> done(sectors.size(), false);
    Group group;
    bool any = false;
    for (std::size_t k = 0; k < sectors.size(); ++k) {
        if (done[k]) continue;
        group.clear();
        for (std::size_t l = k; l < sectors.size(); ++l)
            if (!done[l] && (l == k || same_point(signs, sectors[k], sectors[l]))) {
                group.push_back(l);
                done[l] = true;
            }
        if (!closes(signs, sectors, group, all)) continue;
        for (const std::size_t l : group) sectors[l].closes = true;
        any = true;
        if (!all) return true;
    }
    return any;
}

}  // namespace cob
