#include "radiosity/sheets.hpp"

#include "geometry/convex_polygon.hpp"
#include "radiosity/plane_sheets.hpp"

#include <algorithm>

namespace cob::radiosity {
namespace {

/// Twice the area as seen along an axis, up to the sign that all of a plane share.
Rational area_seen(const std::vector<ConvexPolygon>& polygons, int axis) {
    Rational sum = 0;
    for (const ConvexPolygon& polygon : polygons) sum += area_vector(polygon)[axis];
    return sum;
}

bool overlap(const Scene& scene, PolygonId p, PolygonId q) {
    for (const Piece& a : scene.pieces_of(p))
        for (const Piece& b : scene.pieces_of(q)) {
            ConvexPolygon common = polygon_of(scene, a);
            for (const OpenHalfSpace& side : sides_of(polygon_of(scene, b)))
                if (!common.empty()) common = clip(common, side);
            if (!common.empty()) return true;
        }
    return false;
}

}  // namespace

Sheets::Sheets(const Scene& scene, const CandidateSource& candidates)
    : scene_(scene), above_(static_cast<std::size_t>(scene.polygon_count())) {
    for (PolygonId polygon = 0; polygon < scene.polygon_count(); ++polygon) {
        if (!scene.polygon(polygon).valid) continue;
        for (const PolygonId top : sheets_on_top(scene, polygon, candidates))
            if (overlap(scene, polygon, top)) above_[static_cast<std::size_t>(polygon)].push_back(top);
    }
}

Cover Sheets::cover(const Root& root, const Element& element) const {
    const std::vector<PolygonId>& tops = above(root.polygon);
    if (tops.empty()) return {};
    const int axis = scene_.polygon(root.polygon).view.axis;
    std::vector<ConvexPolygon> rest{polygon_of(corners(scene_, root, element))};
    const Rational area = area_seen(rest, axis);
    for (const PolygonId top : tops)
        for (const Piece& piece : scene_.pieces_of(top)) subtract(rest, polygon_of(scene_, piece));
    const Rational left = area_seen(rest, axis);
    if (left == area) return {};
    if (left == 0) return {Cover::Kind::wholly, 0};
    return {Cover::Kind::partly, to_nearest(left / area)};
}

bool Sheets::hides(PolygonId polygon, const ExactPoint& point) const {
    const std::vector<PolygonId>& tops = above(polygon);
    if (tops.empty()) return false;
    const RationalPoint p = point.rational();
    for (const PolygonId top : tops)
        for (const Piece& piece : scene_.pieces_of(top)) {
            const std::vector<OpenHalfSpace> sides = sides_of(polygon_of(scene_, piece));
            if (std::all_of(sides.begin(), sides.end(), [&](const OpenHalfSpace& s) { return s.height(p) >= 0; }))
                return true;
        }
    return false;
}

}  // namespace cob::radiosity
