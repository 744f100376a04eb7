// What a segment meets, in order: the answers beyond clear, grazing and blocked.
#include "cob/candidates.hpp"
#include "geometry/visibility_oracle.hpp"

#include <algorithm>
#include <map>

namespace cob {
namespace {

/// Where the line of the segment from x to y crosses the plane of a piece, as a parameter from x (0) to y (1).
Rational crossing_parameter(const PieceTable& pieces, PieceId id, const RationalPoint& x, const RationalPoint& y) {
    const PiecePlane plane = pieces.plane(id);
    const RationalPoint origin = to_rational(pieces.scene().position(plane.origin));
    const RationalPoint normal = cross(to_rational(pieces.scene().position(plane.first)) - origin,
                                       to_rational(pieces.scene().position(plane.last)) - origin);
    const Rational from = dot(normal, x - origin), to = dot(normal, y - origin);
    return from / (from - to);
}

/// Where a segment within the plane of a convex piece, which it meets, is in the closed piece: first and last
/// parameter, cut to [0, 1].
std::pair<Rational, Rational> overlap_in_plane(const PieceTable& pieces, PieceId id, const RationalPoint& x,
                                               const RationalPoint& y) {
    const View<VertexId> corners = pieces.scene().corners(pieces.scene().piece(id));
    const int count = static_cast<int>(corners.size()), axis = pieces.view_axis(id);
    const int inward = static_cast<int>(pieces.view_side(id));
    Rational first = 0, last = 1;
    for (int k = 0; k < count; ++k) {
        const RationalPoint a = to_rational(pieces.scene().position(corners[k]));
        const RationalPoint side = to_rational(pieces.scene().position(detail::corner(corners, k + 1))) - a;
        // How far within this side's half-plane, linear along the segment.
        const Rational from = inward * cross(side, x - a)[axis], to = inward * cross(side, y - a)[axis];
        if (from < 0 && to > from) first = std::max(first, Rational(from / (from - to)));
        if (to < 0 && from > to) last = std::min(last, Rational(from / (from - to)));
    }
    return {first, last};
}

/// A side's direction is all that decides; where a piece runs straight on, the point may belong to another side of
/// the same line, or to the corner between two. For the reader it is named exactly.
Contact named(const PieceTable& pieces, PieceId id, const Touch& touch, const RationalPoint& x,
              const RationalPoint& y) {
    Contact contact;
    contact.piece = id;
    contact.index = touch.index;
    contact.parameter = crossing_parameter(pieces, id, x, y);
    contact.kind = touch.kind == Touch::Kind::inside   ? ContactKind::inside
                   : touch.kind == Touch::Kind::corner ? ContactKind::corner
                                                       : ContactKind::side;
    if (contact.kind != ContactKind::side) return contact;
    const RationalPoint p = x + contact.parameter * (y - x);
    const View<VertexId> corners = pieces.scene().corners(pieces.scene().piece(id));
    for (int k = 0; k < static_cast<int>(corners.size()); ++k) {
        const RationalPoint a = to_rational(pieces.scene().position(corners[k]));
        if (a == p) {
            contact.kind = ContactKind::corner;
            contact.index = k;
            return contact;
        }
        const RationalPoint b = to_rational(pieces.scene().position(detail::corner(corners, k + 1)));
        if (cross(b - a, p - a) == RationalPoint{} && dot(a - p, b - p) < 0) contact.index = k;
    }
    return contact;
}

}  // namespace

std::vector<PieceId> candidates_along(const CandidateSource& source, const Segment& segment) {
    std::vector<PieceId> pieces;
    source.pieces_along(segment.from.nearest(), segment.to.nearest(),
                        {&pieces, [](void* context, PieceId piece, bool) {
                             static_cast<std::vector<PieceId>*>(context)->push_back(piece);
                             return true;
                         }});
    std::sort(pieces.begin(), pieces.end());
    return pieces;
}

std::vector<Contact> VisibilityOracle::contacts(const Segment& segment) const {
    return explain(segment).contacts;
}

Explanation VisibilityOracle::explain(const Segment& segment) const {
    refuse_a_point(segment);
    const PieceTable& pieces = implementation_->pieces;
    const RationalPoint x = segment.from.rational(), y = segment.to.rational();
    PredicateCounters counters;
    const ExactSigns signs(pieces, segment, {&counters});

    // 1. Every contact by itself.
    Explanation explanation;
    Sectors sectors;
    std::vector<std::size_t> contact_of_sector;
    for (const PieceId id : candidates_along(implementation_->candidates, segment)) {
        const Touch met = touch(signs, id);
        if (met.kind == Touch::Kind::none) continue;
        ExplainedContact contact;
        if (met.kind == Touch::Kind::in_plane) {
            const auto [first, last] = overlap_in_plane(pieces, id, x, y);
            contact.contact = {id, ContactKind::in_plane, -1, first};
            contact.last = last;
        } else {
            contact.contact = named(pieces, id, met, x, y);
            contact.last = contact.contact.parameter;
            contact.from_visible_side = met.begins == Sign::positive;
            contact.blocks = met.kind == Touch::Kind::inside;
            if (!contact.blocks) {
                contact_of_sector.push_back(explanation.details.size());
                sectors.push_back(sector_of(signs, id, met));
                contact.begin = {sectors.back().begin.from, sectors.back().begin.to};
                contact.end = {sectors.back().end.from, sectors.back().end.to};
            }
        }
        explanation.details.push_back(contact);
    }

    // 2. Which of those at sides and corners close around their point.
    mark_closing(signs, sectors, true);
    for (std::size_t k = 0; k < sectors.size(); ++k) {
        ExplainedContact& contact = explanation.details[contact_of_sector[k]];
        contact.blocks = sectors[k].closes;
        contact.begin_covering = sectors[k].begin_covering;
        contact.end_covering = sectors[k].end_covering;
    }

    // 3. In order along the segment.
    std::stable_sort(
        explanation.details.begin(), explanation.details.end(),
        [](const ExplainedContact& a, const ExplainedContact& b) { return a.contact.parameter < b.contact.parameter; });
    for (const ExplainedContact& detail : explanation.details) {
        explanation.contacts.push_back(detail.contact);
        if (detail.blocks) explanation.visibility = Visibility::blocked;
        if (explanation.visibility == Visibility::clear) explanation.visibility = Visibility::grazing;
    }
    return explanation;
}

PolygonId VisibilityOracle::nearest_blocker(const Segment& segment) const {
    refuse_a_point(segment);
    const PieceTable& pieces = implementation_->pieces;
    PredicateCounters counters;
    const ExactSigns signs(pieces, segment, {&counters});

    // 1. What each polygon is touched by; the polygons' own pieces follow each other.
    std::map<PolygonId, Sectors> seams;
    std::vector<PieceId> blocking;  // one piece for each point at which a polygon blocks
    for (const PieceId id : candidates_along(implementation_->candidates, segment)) {
        const Touch met = touch(signs, id);
        if (met.kind == Touch::Kind::inside) blocking.push_back(id);
        if (met.kind == Touch::Kind::side || met.kind == Touch::Kind::corner)
            seams[pieces.scene().piece(id).polygon].push_back(sector_of(signs, id, met));
    }
    for (auto& [polygon, sectors] : seams) {
        mark_closing(signs, sectors, true);
        for (const Sector& sector : sectors)
            if (sector.closes) blocking.push_back(sector.piece);
    }
    if (blocking.empty()) return no_polygon;

    // 2. The first of them; where several block at one point, the polygon of the lowest number.
    PieceId nearest = blocking.front();
    for (const PieceId id : blocking) {
        const Sign order = signs.compare_parameters(id, nearest);
        const bool lower = pieces.scene().piece(id).polygon < pieces.scene().piece(nearest).polygon;
        if (order == Sign::negative || (order == Sign::zero && lower)) nearest = id;
    }
    return pieces.scene().piece(nearest).polygon;
}

}  // namespace cob
