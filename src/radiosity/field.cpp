/// Exitance between elements: vertices, T-vertices, and interpolation without cracks.
#include "geometry/bounds.hpp"
#include "radiosity/state.hpp"

#include <algorithm>
#include <cmath>

namespace cob {

using namespace radiosity;

std::vector<Rgb> RadiositySolver::State::vertex_exitance() const {
    struct Mean {
        Rgb sum{};
        double weight = 0;
        void add(const Rgb& value, double w) {
            for (std::size_t c = 0; c < 3; ++c) sum[c] += w * value[c];
            weight += w;
        }
    };
    // Nobody sees an element that is shut in; where all around a vertex are, they count after all.
    std::vector<Mean> open(mesh->vertices().size()), shut(mesh->vertices().size());
    for (const auto& of_patch : leaves)
        for (const NodeId leaf : of_patch) {
            const Cell& cell = cells[static_cast<std::size_t>(leaf)];
            const bool is_shut = cell.cover.kind == Cover::Kind::wholly || cell.buffer.state() == BufferState::occluded;
            std::vector<Mean>& means = is_shut ? shut : open;
            const Rgb m = exitance(leaf);
            for (const MeshVertexId v : mesh->node(leaf).corners)
                if (v >= 0) means[static_cast<std::size_t>(v)].add(m, 1);
            // A T-vertex has half a turn of the coarser element around it.
            for (const MeshVertexId v : mesh->node(leaf).middles)
                if (v >= 0) means[static_cast<std::size_t>(v)].add(m, 2);
        }
    std::vector<Rgb> result(open.size());
    for (std::size_t v = 0; v < result.size(); ++v) {
        const Mean& mean = open[v].weight > 0 ? open[v] : shut[v];
        for (std::size_t c = 0; c < 3 && mean.weight > 0; ++c) result[v][c] = mean.sum[c] / mean.weight;
    }
    return result;
}

std::vector<std::array<std::int32_t, 2>> RadiositySolver::outline(std::int32_t leaf) const {
    const Node& node = state_->mesh->node(leaf);
    const std::array<MeshVertexId, 4>& middles = node.middles;
    std::vector<std::array<std::int32_t, 2>> result;
    for (int k = 0; k < node.corner_count(); ++k) {
        result.push_back({node.corners[static_cast<std::size_t>(k)], 2 * k});
        if (middles[static_cast<std::size_t>(k)] >= 0)
            result.push_back({middles[static_cast<std::size_t>(k)], 2 * k + 1});
    }
    return result;
}

// ------------------------------------------------------------------------------------------------ the field

ExitanceField::ExitanceField(const RadiositySolver& solver) : solver_(solver), vertices_(solver.vertex_exitance()) {
    outlines_.resize(solver.mesh().nodes().size());
    for (const NodeId leaf : solver.mesh().leaves()) outlines_[static_cast<std::size_t>(leaf)] = solver.outline(leaf);
}

Rgb ExitanceField::at(RootId root, double u, double v) const {
    const Mesh& mesh = solver_.mesh();
    return in_leaf(mesh.leaf_at(root, u, v), u, v);
}

namespace {

/// Parameters within an element of a root's parameters.
std::array<double, 2> local(const Element& e, bool triangle, double u, double v) {
    double s = std::scalbn(u, e.level_i) - e.i, t = std::scalbn(v, e.level_j) - e.j;
    if (triangle && e.inverted) {
        s = 1 - s;
        t = 1 - t;
    }
    return {s, t};
}

/// Parameters of a place on an element's outline: corner k at 2 k, the middle of the side after it at 2 k + 1.
std::array<double, 2> outline_point(bool triangle, int place) {
    static constexpr double quadrilateral[8][2] = {{0, 0}, {.5, 0}, {1, 0}, {1, .5}, {1, 1}, {.5, 1}, {0, 1}, {0, .5}};
    static constexpr double triangular[6][2] = {{0, 0}, {.5, 0}, {1, 0}, {.5, .5}, {0, 1}, {0, .5}};
    const double* p = triangle ? triangular[place] : quadrilateral[place];
    return {p[0], p[1]};
}

}  // namespace

Rgb RadiositySolver::gather(RootId root, double u, double v, int samples) const {
    const NodeId leaf = state_->mesh->leaf_at(root, u, v);
    const Node& node = state_->mesh->node(leaf);
    const auto [s, t] = local(node.element, node.corner_count() == 3, u, v);
    const Material& m = state_->material(leaf);
    Rgb result = m.emitted_exitance;
    TransportScratch scratch;
    for (const Shot& shot : state_->shots) {
        const double form_factor = state_->transport->receive_at(shot, leaf, s, t, samples, scratch);
        for (std::size_t c = 0; c < 3; ++c) result[c] += m.reflectance[c] * shot.exitance[c] * form_factor;
    }
    return result;
}

Rgb ExitanceField::in_leaf(std::int32_t leaf, double u, double v) const {
    const Node& node = solver_.mesh().node(leaf);
    const bool triangle = node.corner_count() == 3;
    const auto [s, t] = local(node.element, triangle, u, v);
    const auto value = [&](std::int32_t vertex) -> const Rgb& { return vertices_[static_cast<std::size_t>(vertex)]; };
    const auto corner = [&](std::size_t k) -> const Rgb& { return value(node.corners[k]); };
    const auto& outline = outlines_[static_cast<std::size_t>(leaf)];
    Rgb result{};
    if (outline.size() == static_cast<std::size_t>(node.corner_count())) {
        for (std::size_t c = 0; c < 3; ++c)
            result[c] = triangle ? (1 - s - t) * corner(0)[c] + s * corner(1)[c] + t * corner(2)[c]
                                 : (1 - t) * ((1 - s) * corner(0)[c] + s * corner(1)[c]) +
                                       t * ((1 - s) * corner(3)[c] + s * corner(2)[c]);
        return result;
    }

    // A finer neighbour: triangles around the centre, one for each stretch of the outline, so that both sides of it
    // interpolate between the same two vertices.
    const double middle = triangle ? 1.0 / 3 : 0.5;
    Rgb centre{};
    for (int k = 0; k < node.corner_count(); ++k)
        for (std::size_t c = 0; c < 3; ++c) centre[c] += corner(static_cast<std::size_t>(k))[c] / node.corner_count();
    double best = -std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < outline.size(); ++k) {
        const auto& from = outline[k];
        const auto& to = outline[(k + 1) % outline.size()];
        const auto a = outline_point(triangle, from[1]), b = outline_point(triangle, to[1]);
        // Barycentric coordinates in (centre, a, b).
        const double ax = a[0] - middle, ay = a[1] - middle, bx = b[0] - middle, by = b[1] - middle;
        const double px = s - middle, py = t - middle, all = ax * by - ay * bx;
        const double to_a = (px * by - py * bx) / all, to_b = (ax * py - ay * px) / all;
        const double inside = std::min(to_a, to_b);
        if (inside <= best) continue;
        best = inside;
        for (std::size_t c = 0; c < 3; ++c)
            result[c] = (1 - to_a - to_b) * centre[c] + to_a * value(from[0])[c] + to_b * value(to[0])[c];
    }
    return result;
}

Rgb ExitanceField::at(PolygonId polygon, const Point& point) const {
    const Scene& scene = solver_.mesh().scene();
    const auto [first, last] = solver_.roots().of(polygon);
    // The root that holds the point, or lies nearest to holding it.
    RootId best = first;
    std::array<double, 2> best_at{};
    double best_inside = -std::numeric_limits<double>::infinity();
    for (RootId root = first; root < last; ++root) {
        const Root& r = solver_.roots()[root];
        const std::array<double, 2> at = root_coordinates(scene, r, point);
        const double inside = r.corner_count() == 3 ? std::min({at[0], at[1], 1 - at[0] - at[1]})
                                                    : std::min({at[0], at[1], 1 - at[0], 1 - at[1]});
        if (!(inside > best_inside)) continue;
        best = root;
        best_at = at;
        best_inside = inside;
    }
    return this->at(best, best_at[0], best_at[1]);
}

std::array<double, 2> root_coordinates(const Scene& scene, const Root& root, const Point& point) {
    // In the root's own scale, for there are products of four lengths.
    cob::Bounds bounds;
    for (int k = 0; k < root.corner_count(); ++k) bounds.add(scene.position(root.corners[static_cast<std::size_t>(k)]));
    const int scale = std::ilogb(bounds.half_extent(bounds.longest_axis()));
    const auto corner = [&](std::size_t k) { return in_units(scene.position(root.corners[k]), scale); };
    const Point d = in_units(point, scale) - corner(0), e = corner(1) - corner(0);
    if (root.corner_count() == 3) {
        const Point f = corner(2) - corner(0);
        const double ee = dot(e, e), ef = dot(e, f), ff = dot(f, f), de = dot(d, e), df = dot(d, f);
        const double all = ee * ff - ef * ef;
        return {(de * ff - df * ef) / all, (df * ee - de * ef) / all};
    }
    // Bilinear: d = u e + v f + u v g; crossing out u gives a quadratic in v, in the plane along the normal's axis.
    const Point f = corner(3) - corner(0), g = corner(0) - corner(1) + corner(2) - corner(3);
    const View2& view = scene.polygon(root.polygon).view;
    const auto cross2 = [&](const Point& a, const Point& b) {
        return a[view.first] * b[view.second] - a[view.second] * b[view.first];
    };
    const double a = cross2(g, f), b = cross2(e, f) + cross2(d, g), c = cross2(d, e);
    // a v^2 + b v + c = 0, the root between 0 and 1, without cancellation; b > 0 within a convex quadrilateral.
    const double q = -(b + std::copysign(std::sqrt(std::max(b * b - 4 * a * c, 0.0)), b)) / 2;
    const double first = q != 0 ? c / q : 0, second = a != 0 ? q / a : first;
    const auto off = [](double x) { return std::max({0.0, -x, x - 1}); };
    const double v = off(first) <= off(second) ? first : second;
    const Point along = e + v * g, rest = d - v * f;
    const double length = dot(along, along);
    return {length > 0 ? dot(rest, along) / length : 0, v};
}

}  // namespace cob
