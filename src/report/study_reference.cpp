// The points of a study and the exact direct light there.
#include "cob/census.hpp"
#include "cob/error.hpp"
#include "cob/irradiance.hpp"
#include "cob/visibility.hpp"
#include "geometry/bounds.hpp"
#include "geometry/convex_polygon.hpp"
#include "radiosity/mesh.hpp"
#include "report/study_points.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace cob {
namespace {

double length(const Point& v) {
    return std::hypot(v.x, v.y, v.z);
}

/// The root's corners; for areas and weights only.
std::vector<Point> outline(const Scene& scene, const Root& root) {
    std::vector<Point> corners;
    for (int c = 0; c < root.corner_count(); ++c) corners.push_back(scene.position(root.corners[c]));
    return corners;
}

/// In square units (mesh.hpp), for binary64 holds more lengths than areas.
double area(const Scene& scene, const Root& root, int exponent) {
    std::vector<Point> p = outline(scene, root);
    for (Point& corner : p) corner = radiosity::in_units(corner, exponent);
    const Point twice = p.size() == 3 ? cross(p[1] - p[0], p[2] - p[0]) : cross(p[2] - p[0], p[3] - p[1]);
    return length(twice) / 2;
}

/// Polygons that another one may lie on, in their plane.
std::set<PolygonId> overlapped(const Scene& scene) {
    std::set<PolygonId> polygons;
    for (const CoplanarOverlap& overlap : take_census(scene).overlaps)
        if (overlap.same_facing) {
            polygons.insert(overlap.first);
            polygons.insert(overlap.second);
        }
    return polygons;
}

/// The k-th point of the sequence with the plastic number (Roberts 2018), in the unit square, off its sides.
std::array<double, 2> spread(std::size_t k) {
    const double first = 0.7548776662466927, second = 0.5698402909980532, n = static_cast<double>(k) + 0.5;
    return {n * first - std::floor(n * first), n * second - std::floor(n * second)};
}

Point rounded_point(const Scene& scene, const Root& root, const std::array<double, 2>& coordinates) {
    const std::vector<Point> p = outline(scene, root);
    const auto [s, t] = coordinates;
    if (p.size() == 3) return p[0] + s * (p[1] - p[0]) + t * (p[2] - p[0]);
    return (1 - t) * ((1 - s) * p[0] + s * p[1]) + t * ((1 - s) * p[3] + s * p[2]);
}

bool is_within(const std::array<double, 6>& bounds, const Point& point) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double x = point[static_cast<int>(axis)];
        if (x < bounds[axis] || x > bounds[axis + 3]) return false;
    }
    return true;
}

/// How much of a light segments to samples of it see from a point.
enum class Seen { none, some, all };

/// Looks for shadow boundaries near a point, light by light.
class BandFinder {
public:
    BandFinder(const Scene& scene, const Roots& roots, const CandidateSource& candidates)
        : scene_(scene), roots_(roots), oracle_(scene, candidates) {}

    /// Some point within the width, along the sides of the root, sees another share of the light.
    bool near_boundary(const StudyPoint& point, PolygonId light, double width) const {
        const Root& root = roots_[point.root];
        const std::vector<Point> p = outline(scene_, root);
        const double along_s = width / length(p[1] - p[0]), along_t = width / length(p.back() - p[0]);
        const Seen here = seen(root, point.coordinates, light);
        for (const std::array<double, 2>& step :
             {std::array{along_s, 0.0}, {-along_s, 0.0}, {0.0, along_t}, {0.0, -along_t}}) {
            const double s = point.coordinates[0] + step[0], t = point.coordinates[1] + step[1];
            const bool inside = s > 0 && t > 0 && (p.size() == 3 ? s + t < 1 : s < 1 && t < 1);
            if (inside && seen(root, {s, t}, light) != here) return true;
        }
        return false;
    }

private:
    Seen seen(const Root& root, const std::array<double, 2>& coordinates, PolygonId light) const {
        const ExactPoint from = point_in(scene_, root, root_element(root.id), coordinates[0], coordinates[1]);
        int clear = 0, all = 0;
        const auto [first, last] = roots_.of(light);
        for (RootId part = first; part < last; ++part)
            for (const std::array<double, 2>& at :
                 {std::array{0.3125, 0.3125}, {0.03125, 0.03125}, {0.9375, 0.03125}, {0.03125, 0.9375}}) {
                const ExactPoint to = point_in(scene_, roots_[part], root_element(part), at[0], at[1]);
                ++all;
                clear += oracle_({from, to, root.piece, roots_[part].piece}) == Visibility::clear ? 1 : 0;
            }
        return clear == 0 ? Seen::none : clear == all ? Seen::all : Seen::some;
    }

    const Scene& scene_;
    const Roots& roots_;
    VisibilityOracle oracle_;
};

}  // namespace

StudyReference study_points(const Scene& scene, const Roots& roots, std::size_t points, const StudyRegion& region) {
    StudyReference reference;
    const int exponent = radiosity::unit_exponent(scene);

    // 1. The roots that receive, and the areas.
    const std::set<PolygonId> left_out = overlapped(scene);
    const std::set<PolygonId> wanted_polygons(region.polygons.begin(), region.polygons.end());
    reference.band_width = longest_extent(bounds_of(scene)) / 48;
    std::vector<RootId> chosen;
    double receiving = 0, all = 0;
    bool lit = false;
    for (const Root& root : roots.all()) {
        const Material& material = scene.material(root.polygon);
        const double a = area(scene, root, exponent);
        all += a;
        for (const double e : material.emitted_exitance) reference.light_exitance += a * e;
        lit = lit || material.emits();
        const bool reflects = material.reflectance[0] + material.reflectance[1] + material.reflectance[2] > 0;
        if (!reflects || material.emits() || left_out.count(root.polygon) > 0) continue;
        if (!wanted_polygons.empty() && wanted_polygons.count(root.polygon) == 0) continue;
        chosen.push_back(root.id);
        receiving += a;
    }
    if (!lit) throw InputError("no polygon emits", {scene.name(), 0, "", "give a material a Ke above 0"});
    if (chosen.empty())
        throw InputError("no polygon receives: none reflects and lies free in its plane",
                         {scene.name(), 0, "", "give one a Kd above 0"});
    reference.light_exitance /= all;
    reference.receiver_share = receiving / all;

    // 2. Points by area: root by root, as many as its share of the area so far asks for.
    double so_far = 0;
    for (const RootId id : chosen) {
        const Root& root = roots[id];
        so_far += area(scene, root, exponent);
        const auto wanted = static_cast<std::size_t>(std::llround(static_cast<double>(points) * so_far / receiving));
        // Draws that fall outside the region's bounds are lost; so many of them that there is nothing to find.
        const std::size_t most_draws = region.bounds ? 10000000 : 0;
        for (std::size_t draw = reference.points.size(), lost = 0; reference.points.size() < wanted; ++draw) {
            StudyPoint point;
            point.root = id;
            point.coordinates = spread(draw);
            auto& [s, t] = point.coordinates;
            if (root.corner_count() == 3 && s + t > 1) {
                s = 1 - s;
                t = 1 - t;
            }
            if (!region.bounds || is_within(*region.bounds, rounded_point(scene, root, point.coordinates)))
                reference.points.push_back(point);
            else if (++lost > most_draws)
                break;
        }
    }
    return reference;
}

Scene dimmed(const Scene& scene) {
    Scene::Input input = input_of(scene);
    for (Material& material : input.materials)
        for (double& reflectance : material.reflectance) reflectance *= dimming;
    return Scene::build(std::move(input), Scene::Options{true});
}

PointOnRoot point_on_root(const Scene& scene, const Root& root, const std::array<double, 2>& coordinates) {
    const Element whole = root_element(root.id);
    return {point_in(scene, root, whole, coordinates[0], coordinates[1]),
            area_vector(polygon_of(corners(scene, root, whole)))};
}

StudyReference study_reference(const Scene& scene, std::size_t points, const Progress& progress,
                               const StudyRegion& region) {
    const Roots roots(scene);
    const auto candidates = make_candidates(scene, Source::tree);
    const IrradianceOracle oracle(scene, *candidates);
    const BandFinder band(scene, roots, *candidates);
    StudyReference reference = study_points(scene, roots, points, region);
    std::size_t done = 0;
    for (StudyPoint& point : reference.points) {
        if (progress) progress(done++, reference.points.size());
        const Root& root = roots[point.root];
        const PointOnRoot x = point_on_root(scene, root, point.coordinates);
        const Material& material = scene.material(root.polygon);
        for (const PolygonId light : oracle.lights()) {
            const LightAtPoint seen = oracle(x.position, x.normal, light);
            if (seen.unobstructed > 0)
                point.in_band = point.in_band || (seen.visible > 0 && seen.visible < seen.unobstructed * (1 - 1e-9)) ||
                                band.near_boundary(point, light, reference.band_width);
            for (std::size_t c = 0; c < 3; ++c) {
                const double irradiance = seen.visible * scene.material(light).emitted_exitance[c];
                point.irradiance += irradiance;
                point.exitance += material.reflectance[c] * irradiance;
            }
        }
        reference.mean_exitance += point.exitance / static_cast<double>(reference.points.size());
    }
    if (!(reference.mean_exitance > 0))
        throw InputError("no light reaches any point", {scene.name(), 0, "", "light what reflects"});
    return reference;
}

}  // namespace cob
