#include "cob/patch_visibility.hpp"

#include "geometry/patch_refinement.hpp"

#include <algorithm>

namespace cob {

const char* to_text(PatchRelation relation) {
    switch (relation) {
        case PatchRelation::visible:
            return "visible";
        case PatchRelation::hidden:
            return "hidden";
        case PatchRelation::partial:
            return "partial";
        case PatchRelation::undecided:
            return "undecided";
    }
    return "";
}

ConvexPatch patch_of(const Corners& corners) {
    return {{corners.points.begin(), corners.points.begin() + corners.count}};
}

ConvexPatch patch_of(const Scene& scene, const Piece& piece) {
    ConvexPatch patch;
    for (VertexId corner : scene.corners(piece)) patch.corners.emplace_back(scene.position(corner));
    return patch;
}

ConvexPatch patch_of(const ExactPoint& light) {
    return {{light}};
}

namespace {

ConvexPolygon polygon_of(const ConvexPatch& patch) {
    ConvexPolygon polygon;
    for (const ExactPoint& corner : patch.corners) polygon.push_back(corner.rational());
    return polygon;
}

/// What of `polygon` lies in front of the patch: of a point, everything.
ConvexPolygon in_front(const ConvexPolygon& polygon, const ConvexPolygon& of) {
    if (of.size() == 1) return polygon;
    const OpenHalfSpace front = front_of(of);
    if (polygon.size() == 1) return front.height(polygon[0]) > 0 ? polygon : ConvexPolygon{};
    return clip(polygon, front);
}

std::vector<ConvexPatch> parts_of(const ConvexPolygon& polygon) {
    if (polygon.size() == 1) return {{{ExactPoint(polygon[0])}}};
    return triangles_of(polygon);
}

/// Share of the whole polygon's area that a triangle of its fan takes.
Range share(const ConvexPatch& part, const ConvexPolygon& whole) {
    if (whole.size() == 1) return {1, 1};
    const RationalPoint a = area_vector(polygon_of(part)), w = area_vector(whole);
    const int axis = w.x != 0 ? 0 : w.y != 0 ? 1 : 2;
    const double ratio = to_nearest(Rational(a[axis] / w[axis]));
    return {ratio * (1 - 0x1p-52), ratio * (1 + 0x1p-52)};
}

/// A point inside, and where it can be no corner, side or middle of anything.
ExactPoint inner_point(const ConvexPatch& patch) {
    if (patch.is_point()) return patch.corners[0];
    const auto at = [&](int k) { return patch.corners[k].rational(); };
    return ExactPoint(Rational(1, 64) * (Rational(23) * at(0) + Rational(22) * at(1) + Rational(19) * at(2)));
}

Segment segment_between(const PatchPair& pair) {
    return {inner_point(pair.a), inner_point(pair.b), -1, -1};
}

}  // namespace

struct PatchVisibility::Implementation {
    Implementation(const Scene& s, const CandidateSource& c) : scene(s), candidates(c), oracle(s, c) {}

    std::vector<PieceId> pieces_in(const std::array<double, 6>& bounds) const {
        struct Search {
            const Scene& scene;
            std::vector<PieceId> found;
        } search{scene, {}};
        candidates.polygons_in(bounds, {&search, [](void* data, std::int32_t id) {
                                            auto& s = *static_cast<Search*>(data);
                                            const Polygon& polygon = s.scene.polygon(id);
                                            for (std::uint32_t k = 0; k < polygon.piece_count; ++k)
                                                s.found.push_back(static_cast<PieceId>(polygon.first_piece + k));
                                            return true;
                                        }});
        std::sort(search.found.begin(), search.found.end());
        return std::move(search.found);
    }

    /// A polygon that lies across everything: by one of its pieces, or, planar, by all of them.
    PolygonId blocker(const PatchPair& whole, const std::function<void()>& pulse) const {
        for (PieceId piece : whole.between)
            if (lies_across(scene, scene.piece(piece), whole.a, whole.b)) return scene.piece(piece).polygon;
        PolygonId last = no_polygon;
        for (PieceId piece : whole.between) {
            const PolygonId polygon = scene.piece(piece).polygon;
            if (pulse) pulse();
            if (polygon != last && planar_polygon_lies_across(scene, polygon, whole.a, whole.b)) return polygon;
            last = polygon;
        }
        return no_polygon;
    }

    void look_for_witnesses(const PatchPair& pair, PairState state, PatchAnswer& answer) const {
        if (answer.clear && answer.blocked) return;
        if (state == PairState::clear && answer.clear) return;
        if (state == PairState::blocked && answer.blocked) return;
        const Segment segment = segment_between(pair);
        const Visibility visibility = oracle(segment);
        if (visibility == Visibility::clear && !answer.clear) answer.clear = segment;
        if (visibility == Visibility::blocked && !answer.blocked) answer.blocked = segment;
    }

    const Scene& scene;
    const CandidateSource& candidates;
    VisibilityOracle oracle;
};

PatchVisibility::PatchVisibility(const Scene& scene, const CandidateSource& candidates)
    : implementation_(std::make_unique<Implementation>(scene, candidates)) {}
PatchVisibility::~PatchVisibility() = default;

PatchAnswer PatchVisibility::operator()(const ConvexPatch& a, const ConvexPatch& b, const PatchOptions& options) const {
    const Implementation& self = *implementation_;
    PatchAnswer answer;

    // Facing parts.
    const ConvexPolygon whole_a = polygon_of(a), whole_b = polygon_of(b);
    const ConvexPolygon facing_a = in_front(whole_a, whole_b), facing_b = in_front(whole_b, whole_a);
    if (facing_a.empty() || facing_b.empty() || (a.is_point() && b.is_point())) {
        answer.facing = false;
        answer.relation = PatchRelation::hidden;
        answer.upper = 0;
        return answer;
    }

    // The whole at once: visible, or hidden by one polygon.
    PatchPair whole;
    for (const RationalPoint& corner : facing_a) whole.a.corners.emplace_back(corner);
    for (const RationalPoint& corner : facing_b) whole.b.corners.emplace_back(corner);
    {
        const Shaft shaft(whole.a, whole.b);
        for (PieceId piece : self.pieces_in(shaft.bounds())) {
            if (options.pulse) options.pulse();
            if (shaft.meets(self.scene, self.scene.piece(piece))) whole.between.push_back(piece);
        }
    }
    if (whole.between.empty()) {
        answer.relation = PatchRelation::visible;
        answer.lower = 1;
        return answer;
    }
    answer.blocker = self.blocker(whole, options.pulse);
    if (answer.blocker != no_polygon) {
        answer.relation = PatchRelation::hidden;
        answer.upper = 0;
        return answer;
    }

    // Parts of it, until the bounds are near enough.
    std::vector<PatchPair> pairs;
    for (const ConvexPatch& part_a : parts_of(facing_a))
        for (const ConvexPatch& part_b : parts_of(facing_b)) {
            const Range share_a = share(part_a, facing_a), share_b = share(part_b, facing_b);
            pairs.push_back({part_a, part_b, {share_a.low * share_b.low, share_a.high * share_b.high}, whole.between});
        }
    const auto quarter = [](const PatchPair&, const PatchPair& parent) {
        return Range{parent.measure.low / 4, parent.measure.high / 4};
    };
    const auto witness = [&](const PatchPair& pair, PairState state) { self.look_for_witnesses(pair, state, answer); };
    const RefinedPairs refined = refine(self.scene, std::move(pairs), quarter, witness,
                                        {options.width, options.max_pairs, options.seconds, options.pulse});
    answer.pairs = refined.pairs;
    answer.lower = std::min(1.0, refined.clear.low);
    answer.upper = std::min(1.0, refined.clear.high + refined.open);
    if (answer.clear && answer.blocked) answer.relation = PatchRelation::partial;
    return answer;
}

}  // namespace cob
