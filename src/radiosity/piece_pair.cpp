#include "radiosity/piece_pair.hpp"

#include "radiosity/cell_flux.hpp"
#include "radiosity/cells.hpp"
#include "radiosity/certified_flux.hpp"
#include "radiosity/lambert_sum.hpp"

#include <boost/math/constants/constants.hpp>

#include <algorithm>

namespace cob::radiosity {
namespace {

/// The patch of a convex part.
ConvexPatch patch_of(const ConvexPolygon& polygon) {
    ConvexPatch patch;
    for (const RationalPoint& corner : polygon) patch.corners.emplace_back(corner);
    return patch;
}

/// What of a piece lies on top in its own plane.
std::vector<ConvexPolygon> uncovered(const PairContext& context, const ConvexPolygon& polygon, PolygonId owner) {
    std::vector<ConvexPolygon> parts{polygon};
    for (PieceId sheet : context.polygons[owner].on_top)
        subtract(parts, polygon_of(context.scene, context.scene.piece(sheet)));
    return parts;
}

std::vector<PieceId> pieces_in(const PairContext& context, const Shaft& shaft) {
    struct Search {
        const PairContext& context;
        const Shaft& shaft;
        std::vector<PieceId> found;
    } search{context, shaft, {}};
    context.candidates.polygons_in(shaft.bounds(),
                                   {&search, [](void* data, std::int32_t polygon) {
                                        auto& s = *static_cast<Search*>(data);
                                        for (PieceId piece : s.context.polygons[polygon].pieces)
                                            if (s.shaft.meets(s.context.scene, s.context.scene.piece(piece)))
                                                s.found.push_back(piece);
                                        return true;
                                    }});
    std::sort(search.found.begin(), search.found.end());
    return std::move(search.found);
}

bool some_polygon_lies_across(const Scene& scene, const std::vector<PieceId>& pieces, const ConvexPatch& a,
                              const ConvexPatch& b) {
    PolygonId last = no_polygon;
    for (PieceId piece : pieces) {
        if (lies_across(scene, scene.piece(piece), a, b)) return true;
        const PolygonId polygon = scene.piece(piece).polygon;
        if (polygon != last && scene.polygon(polygon).piece_count > 1 &&
            planar_polygon_lies_across(scene, polygon, a, b))
            return true;
        last = polygon;
    }
    return false;
}

std::vector<Vector3<double>> relative(const ReceiverFrame& frame, const ConvexPolygon& polygon) {
    std::vector<Vector3<double>> corners;
    for (const RationalPoint& corner : polygon) corners.push_back(frame.relative(corner));
    return corners;
}

double form_factor_to(std::vector<Vector3<double>> corners, const Vector3<double>& from,
                      const Vector3<double>& normal) {
    for (Vector3<double>& corner : corners) corner = corner - from;
    return lambert_sum(normal, corners.data(), static_cast<int>(corners.size())).value /
           (2 * boost::math::constants::pi<double>());
}

QuadratureResult unobstructed_flux(const PiecePair& pair, const ReceiverFrame& frame) {
    QuadratureResult result;
    for (const ConvexPolygon& a : pair.receiving)
        for (const ConvexPolygon& b : pair.sending)
            result.visible += mutual_flux(relative(frame, a), relative(frame, b));
    return result;
}

/// What of a pair the cubatures need.
struct PairParts {
    PairShapes shapes;
    std::vector<CornerLoop> lights, occluders;
    std::vector<PieceId> pieces;  ///< Of the occluders.
};

/// What of the occluders lies in front of both planes, the largest first: they shadow most.
PairParts parts_of(const PairContext& context, const PiecePair& pair) {
    const Scene& scene = context.scene;
    const ConvexPolygon receiver = polygon_of(scene, scene.piece(pair.receiver));
    const OpenHalfSpace before_receiver = front_of(receiver),
                        before_light = front_of(polygon_of(scene, scene.piece(pair.light)));
    PairParts parts{PairShapes(receiver, context.pieces.scale()), {}, {}, {}};
    for (const ConvexPolygon& light : pair.sending) parts.lights.push_back(parts.shapes.add(light));
    struct Clipped {
        double size;
        PieceId piece;
        ConvexPolygon polygon;
    };
    std::vector<Clipped> clipped;
    for (PieceId piece : pair.occluders) {
        ConvexPolygon part = clip(polygon_of(scene, scene.piece(piece)), before_receiver);
        if (!part.empty()) part = clip(part, before_light);
        if (!part.empty()) clipped.push_back({area(part), piece, std::move(part)});
    }
    std::stable_sort(clipped.begin(), clipped.end(), [](const auto& a, const auto& b) { return a.size > b.size; });
    for (const Clipped& part : clipped) {
        parts.occluders.push_back(parts.shapes.add(part.polygon));
        parts.pieces.push_back(part.piece);
    }
    return parts;
}

/// Signs are taken for decided where what has the other one is, against the largest value, at most this; so many of
/// them.
constexpr double most_doubt = 0.25;
constexpr std::size_t most_doubtful = 8;

/// Every side is held against every occluder; among more, cutting cones one by one is cheaper at single points.
constexpr std::size_t most_by_contour = 24;

/// Is it certain, or nearly, that what is seen of the light has one structure over a triangle?
Structure structure_of(const PairParts& parts, const Triangle2D& t, const std::vector<const CornerLoop*>& occluders) {
    Structure structure{{}, 0, {}, {}, CellView(parts.shapes, t)};
    CellView& view = structure.view;
    structure.occluders = view.between(parts.lights, occluders);
    try {
        structure.contour = view.visible_contour(parts.lights, structure.occluders, most_doubt);
        const std::vector<DoubtfulSign>& doubtful = structure.contour.doubtful;
        if (doubtful.size() <= most_doubtful) return structure;
        structure.event = std::max_element(doubtful.begin(), doubtful.end(), [](const auto& a, const auto& b) {
                              return a.share < b.share;
                          })->sign;
    } catch (const UndecidedSign& event) {
        structure.event = event;
    }
    const Motion motion = motion_over_cell(parts.shapes, t, parts.lights, structure.occluders);
    const double turned = motion.of_directions * reach(t);  // beyond an event, what it opens is so wide and so long
    structure.change = std::min(motion.of_one_side * reach(t), turned * turned);
    return structure;
}

/// Without rounding but that of the values themselves.
PointValue exact_value(const PairContext& context, const PairParts& parts, const PiecePair& pair,
                       const ExactPoint& where, const std::vector<const CornerLoop*>& occluders) {
    std::vector<PieceId> pieces;
    for (const CornerLoop* occluder : occluders)
        pieces.push_back(parts.pieces[static_cast<std::size_t>(occluder - parts.occluders.data())]);
    const ReceiverNormal normal(area_vector(polygon_of(context.scene, context.scene.piece(pair.receiver))));
    const LightPieces light{{pair.light}, context.polygons[context.scene.piece(pair.light).polygon].on_top};
    const LightView view = view_light(Viewpoint(context.pieces, where), normal, light, pieces, Precision::binary64);
    return {view.unobstructed, view.visible};
}

}  // namespace

PiecePair make_pair(const PairContext& context, PieceId receiver, PieceId light) {
    const Scene& scene = context.scene;
    PiecePair pair;
    pair.receiver = receiver, pair.light = light;
    const ConvexPolygon a = polygon_of(scene, scene.piece(receiver)), b = polygon_of(scene, scene.piece(light));
    const ConvexPolygon front_a = clip(a, front_of(b)), front_b = clip(b, front_of(a));
    if (front_a.empty() || front_b.empty()) return pair;
    pair.receiving = uncovered(context, front_a, scene.piece(receiver).polygon);
    pair.sending = uncovered(context, front_b, scene.piece(light).polygon);
    pair.whole_sending = front_b;
    if (pair.receiving.empty() || pair.sending.empty()) {
        pair.passage = Passage::hidden;
        return pair;
    }
    const ConvexPatch patch_a = patch_of(front_a), patch_b = patch_of(front_b);
    pair.occluders = pieces_in(context, Shaft(patch_a, patch_b));
    pair.passage = pair.occluders.empty()                                              ? Passage::unobstructed
                   : some_polygon_lies_across(scene, pair.occluders, patch_a, patch_b) ? Passage::hidden
                                                                                       : Passage::obstructed;
    return pair;
}

QuadratureResult flux_between(const PairContext& context, const PiecePair& pair, const QuadratureOptions& options) {
    if (pair.passage == Passage::not_facing || pair.passage == Passage::hidden) return {};
    const ConvexPolygon plane = polygon_of(context.scene, context.scene.piece(pair.receiver));
    const ReceiverFrame frame(plane, context.pieces.scale());
    if (pair.passage == Passage::unobstructed) return unobstructed_flux(pair, frame);

    const PairParts parts = parts_of(context, pair);
    const std::vector<Vector3<double>> sender = relative(frame, pair.whole_sending);
    ReceiverIntegrand integrand;
    integrand.structure = [&](const Triangle2D& t, const std::vector<const CornerLoop*>& occluders) {
        return structure_of(parts, t, occluders);
    };
    integrand.corner = [&](VertexId v) { return parts.shapes.bounded_corner(v).value; };
    integrand.by_contour = [&](const Point2D& where, const Contour& contour) {
        const double unobstructed = form_factor_to(sender, frame.relative_at(where), frame.normal());
        return PointValue{unobstructed, form_factor_at(parts.shapes, where, contour)};
    };
    integrand.exact = [&](const Point2D& where, const Structure& around) {
        if (around.occluders.size() > most_by_contour)
            return exact_value(context, parts, pair, frame.point_at(where), around.occluders);
        try {
            PointValue value = integrand.by_contour(
                where, CellView(around.view, where).visible_contour(parts.lights, around.occluders));
            value.visible = std::clamp(value.visible, 0.0, value.unobstructed);
            return value;
        } catch (const UndecidedSign&) {
            return exact_value(context, parts, pair, frame.point_at(where), around.occluders);
        }
    };
    integrand.unobstructed = [&](const Triangle2D& t, double may_be_off) {
        std::vector<Vector3<double>> corners;
        for (const Point2D& corner : left_around(t)) corners.push_back(frame.relative_at(corner));
        return mutual_flux(corners, sender, may_be_off);
    };
    const PossibleShadows shadows(parts.shapes, parts.lights, parts.occluders);
    integrand.range = [&](const Triangle2D& t, const std::vector<const CornerLoop*>& occluders, double may_be_off) {
        return shadows.range(t, occluders, may_be_off);
    };

    std::vector<Triangle2D> triangles;
    for (const ConvexPolygon& part : pair.receiving) {
        std::vector<Point2D> corners;
        for (const RationalPoint& corner : part) {
            const Vector3<double> local = frame.local(corner);
            corners.push_back({local.x, local.y});
        }
        for (std::size_t k = 2; k < corners.size(); ++k) triangles.push_back({corners[0], corners[k - 1], corners[k]});
    }
    std::vector<const CornerLoop*> occluders;
    for (const CornerLoop& occluder : parts.occluders) occluders.push_back(&occluder);
    return integrate_visible(triangles, occluders, integrand, options);
}

QuadratureResult certified_flux(const PairContext& context, const PiecePair& pair, const QuadratureOptions& options) {
    if (pair.passage == Passage::not_facing || pair.passage == Passage::hidden) return {};
    const PairParts parts = parts_of(context, pair);
    const CertifiedFlux flux = certified_flux(parts.shapes, pair.receiving, parts.lights, parts.occluders,
                                              {2 * options.tolerance, options.max_evaluations, options.pulse});
    QuadratureResult result;
    result.visible = {(flux.low + flux.high) / 2, (flux.high - flux.low) / 2 * (1 + 0x1p-50) + 0x1p-50 * flux.high};
    result.evaluations = flux.cells;
    return result;
}

}  // namespace cob::radiosity
