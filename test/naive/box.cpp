#include "naive/box.hpp"

#include "naive/clip.hpp"

#include <algorithm>

namespace cob::naive {

Box prepare(const BoxQuestion& question) {
    Box box;
    box.corners = question.corners;
    const auto& corners = box.corners;
    box.origin = corners.front();
    box.u = question.u;
    // From one of the corners, and as in SPEC 2 corners at one position count once.
    Loop around;
    for (const RationalPoint& corner : corners)
        if (around.empty() || around.back() != corner - box.origin) around.push_back(corner - box.origin);
    if (around.size() > 1 && around.back() == around.front()) around.pop_back();
    const std::size_t count = around.size();
    box.n = newell(around);
    box.w = cross(box.n, box.u);
    if (box.n == RationalPoint{} || box.u == RationalPoint{}) box.refused = "no area or no direction";
    if (dot(box.u, box.n) != 0) box.refused = "u is not perpendicular to the normal";
    for (std::size_t k = 0; k < count; ++k) {
        const RationalPoint side = around[(k + 1) % count] - around[k];
        const RationalPoint next = around[(k + 2) % count] - around[(k + 1) % count];
        const Rational bend = dot(box.n, cross(side, next));
        if (dot(box.n, around[k]) != 0) box.refused = "the corners are not coplanar";
        if (bend < 0 || (bend == 0 && dot(side, next) <= 0)) box.refused = "the corners are not convex";
    }
    if (!box.refused.empty()) return box;

    // "Along u and w: the element's extents, each widened on both sides by margin x that extent."
    const auto widened = [&](const RationalPoint& direction, Rational& low, Rational& high) {
        low = high = 0;
        for (const RationalPoint& corner : around) {
            const Rational along = dot(direction, corner);
            low = std::min(low, along);
            high = std::max(high, along);
        }
        const Rational extra = question.margin * (high - low);
        low -= extra;
        high += extra;
        return Rational((high - low) * (high - low) / dot(direction, direction));  // squared true length
    };
    const Rational length_u = widened(box.u, box.low_u, box.high_u);
    const Rational length_w = widened(box.w, box.low_w, box.high_w);
    // "Up to h = height x (the shorter of the two widened extents)", times |n| in this frame.
    box.top_squared = question.height * question.height * std::min(length_u, length_w) * dot(box.n, box.n);
    return box;
}

const char* to_text(Relation relation) {
    static const char* const names[] = {"disjoint", "base", "coplanar", "boundary", "crossing"};
    return names[static_cast<int>(relation)];
}

const char* to_text(Shared shared) {
    static const char* const names[] = {"none", "vertex", "edge"};
    return names[static_cast<int>(shared)];
}

namespace {

Corners in_frame(const Loop& piece, const Box& box) {
    Corners result;
    for (const RationalPoint& corner : piece) {
        const RationalPoint from_origin = corner - box.origin;
        result.push_back({dot(box.u, from_origin), dot(box.w, from_origin), dot(box.n, from_origin)});
    }
    return result;
}

using Frame = RationalPoint;  ///< In the box's frame.

/// The part of a piece that stands over, in or under the closed base rectangle.
Corners over_rectangle(const Corners& piece, const Box& box) {
    auto part = clip(piece, [&](const Frame& p) { return Rational(p.x - box.low_u); });
    part = clip(part, [&](const Frame& p) { return Rational(box.high_u - p.x); });
    part = clip(part, [&](const Frame& p) { return Rational(p.y - box.low_w); });
    return clip(part, [&](const Frame& p) { return Rational(box.high_w - p.y); });
}

/// The same below the closed top: coordinates from here on contain the root that the height is.
std::vector<Vector3<Surd>> below_top(const Corners& part, const Surd& top) {
    std::vector<Vector3<Surd>> kept;
    for (std::size_t k = 0; k < part.size(); ++k) {
        const Frame &a = part[k], &b = part[(k + 1) % part.size()];
        const int at_a = (top - a.z).sign(), at_b = (top - b.z).sign();
        if (at_a >= 0) kept.push_back({a.x, a.y, a.z});
        if (at_a * at_b < 0) {
            const Surd parameter = (top - a.z) / Rational(b.z - a.z);
            const auto between = [&](const Rational& from, const Rational& to) {
                return Surd(from) + parameter * Rational(to - from);
            };
            kept.push_back({between(a.x, b.x), between(a.y, b.y), top});
        }
    }
    return kept;
}

/// The relation of one piece, by what of it is over the rectangle. The closed part of a convex piece in the closed box
/// has a middle, the mean of its corners; the piece meets the open interior exactly where this middle does.
Relation relation_of(const Corners& over, bool in_plane, const Box& box) {
    const auto above = clip(over, [](const Frame& p) { return p.z; });
    const Surd top = Surd::root(box.top_squared);
    const auto part = below_top(above, top);
    if (part.empty()) return Relation::disjoint;

    Surd u, w, z;
    bool off_base = false;
    for (const auto& corner : part) {
        u = u + corner.x;
        w = w + corner.y;
        z = z + corner.z;
        off_base = off_base || corner.z.sign() > 0;
    }
    const Rational count = part.size();
    u = u / count;
    w = w / count;
    z = z / count;
    if (Surd(box.low_u) < u && u < box.high_u && Surd(box.low_w) < w && w < box.high_w && z.sign() > 0 && z < top)
        return Relation::crossing;
    if (off_base) return Relation::boundary;
    return in_plane ? Relation::coplanar : Relation::base;
}

/// The pieces hide the whole rectangle, and all of them over it is at 0 < z <= h.
bool covers(std::vector<Corners> over, const Box& box) {
    const Surd top = Surd::root(box.top_squared);
    for (Corners& piece : over) {
        for (Frame& corner : piece) {
            if (corner.z <= 0 || (top - corner.z).sign() < 0) return false;
            corner.z = 0;
        }
    }
    const Corners rectangle{
        {box.low_u, box.low_w, 0}, {box.high_u, box.low_w, 0}, {box.high_u, box.high_w, 0}, {box.low_u, box.high_w, 0}};
    return subtract_all(rectangle, over).empty();
}

}  // namespace

Answer relate(const Polygon& polygon, const Box& box) {
    std::vector<Corners> over;
    bool in_plane = true;
    for (const Piece& piece : polygon.pieces) {
        const Corners corners = in_frame(piece.corners, box);
        for (const Frame& corner : corners) in_plane = in_plane && corner.z == 0;
        over.push_back(over_rectangle(corners, box));
    }
    Answer answer;
    for (const Corners& piece : over) answer.relation = std::max(answer.relation, relation_of(piece, in_plane, box));
    answer.covers = answer.close() && covers(over, box);
    return answer;
}

namespace {

/// Two closed segments of positive length share a segment (edge), a point (vertex) or nothing.
Shared shared(const RationalPoint& a, const RationalPoint& b, const RationalPoint& c, const RationalPoint& d) {
    const RationalPoint ab = b - a, cd = d - c, ac = c - a, normal = cross(ab, cd);
    if (normal == RationalPoint{}) {
        if (cross(ab, ac) != RationalPoint{}) return Shared::none;
        const Rational at_c = dot(ab, c - a), at_d = dot(ab, d - a);
        const Rational overlap =
            std::min<Rational>(dot(ab, ab), std::max(at_c, at_d)) - std::max<Rational>(0, std::min(at_c, at_d));
        return overlap > 0 ? Shared::edge : overlap == 0 ? Shared::vertex : Shared::none;
    }
    if (dot(ac, normal) != 0) return Shared::none;
    const Rational length = dot(normal, normal);
    const Rational on_ab = dot(cross(ac, cd), normal), on_cd = dot(cross(ac, ab), normal);
    return on_ab >= 0 && on_ab <= length && on_cd >= 0 && on_cd <= length ? Shared::vertex : Shared::none;
}

}  // namespace

Shared shared(const Polygon& a, const Polygon& b) {
    Shared strongest = Shared::none;
    for (std::size_t i = 0; i < a.loop.size(); ++i)
        for (std::size_t j = 0; j < b.loop.size(); ++j)
            strongest = std::max(strongest, shared(a.loop[i], a.loop[(i + 1) % a.loop.size()], b.loop[j],
                                                   b.loop[(j + 1) % b.loop.size()]));
    return strongest;
}

bool faces(const Polygon& light, const Box& box) {
    for (const Piece& piece : light.pieces)
        for (const RationalPoint& corner : box.corners)
            if (dot(piece.normal, corner - piece.corners.front()) > 0) return true;
    return false;
}

std::vector<Answer> relate_all(const std::vector<SceneItem>& scene, int own_polygon, const Box& box) {
    std::vector<Answer> answers(scene.size());
    for (std::size_t id = 0; id < scene.size(); ++id) {
        const Polygon& polygon = scene[id].polygon;
        if (static_cast<int>(id) == own_polygon || !polygon.refused.empty()) continue;
        answers[id] = relate(polygon, box);
        answers[id].lights_it = answers[id].close() && scene[id].emits && faces(polygon, box);
    }
    return answers;
}

State state(const std::vector<Answer>& answers) {
    State result;
    for (std::size_t id = 0; id < answers.size(); ++id) {
        if (answers[id].close()) result.close.push_back(static_cast<int>(id));
        if (answers[id].covers) result.cover.push_back(static_cast<int>(id));
        if (answers[id].lights_it) result.light.push_back(static_cast<int>(id));
    }
    if (!result.cover.empty() && result.light.empty()) {
        result.name = "occluded";
        result.close.clear();
    } else if (!result.close.empty()) {
        result.name = "close";
    }
    return result;
}

}  // namespace cob::naive
