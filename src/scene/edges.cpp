#include "scene/edges.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>

namespace cob {
namespace {

constexpr std::uint32_t unused = std::numeric_limits<std::uint32_t>::max();

void sort_by_position(const Scene& scene, std::vector<VertexId>& vertices) {
    std::sort(vertices.begin(), vertices.end(), [&](VertexId a, VertexId b) {
        const Point &p = scene.position(a), &q = scene.position(b);
        return p != q ? p < q : a < b;
    });
}

/// Vertices that valid polygons use, ascending by position.
std::vector<VertexId> used_vertices(const Scene& scene) {
    std::vector<bool> used(scene.positions().size());
    for (PolygonId id = 0; id < scene.polygon_count(); ++id)
        if (scene.polygon(id).valid)
            for (const VertexId corner : scene.loop(id)) used[static_cast<std::size_t>(corner)] = true;
    std::vector<VertexId> vertices;
    for (std::size_t k = 0; k < used.size(); ++k)
        if (used[k]) vertices.push_back(static_cast<VertexId>(k));
    sort_by_position(scene, vertices);
    return vertices;
}

}  // namespace

std::vector<VertexId> first_at_position(const Scene& scene) {
    std::vector<VertexId> order(scene.positions().size()), first(order.size());
    std::iota(order.begin(), order.end(), 0);
    sort_by_position(scene, order);
    for (std::size_t k = 0; k < order.size(); ++k) {
        const bool same = k > 0 && scene.position(order[k]) == scene.position(order[k - 1]);
        first[order[k]] = same ? first[order[k - 1]] : order[k];
    }
    return first;
}

EdgeTable::EdgeTable(const Scene& scene) : scene_(&scene) {
    // Positions: one number for all vertices that stand at one.
    std::vector<std::uint32_t> position_of(scene.positions().size(), unused);
    for (const VertexId vertex : used_vertices(scene)) {
        if (vertices_.empty() || scene.position(vertices_.back()) != scene.position(vertex))
            vertices_.push_back(vertex);
        position_of[static_cast<std::size_t>(vertex)] = static_cast<std::uint32_t>(vertices_.size() - 1);
    }

    // All corners and sides, sorted by where they are.
    std::vector<std::pair<std::uint32_t, PolygonId>> corners;
    std::vector<std::tuple<std::uint32_t, std::uint32_t, PolygonId, std::uint32_t, bool>> sides;
    for (PolygonId id = 0; id < scene.polygon_count(); ++id) {
        if (!scene.polygon(id).valid) continue;
        const auto loop = scene.loop(id);
        const auto count = static_cast<std::uint32_t>(loop.size());
        for (std::uint32_t k = 0; k < count; ++k) {
            const std::uint32_t a = position_of[static_cast<std::size_t>(loop[k])];
            const std::uint32_t b = position_of[static_cast<std::size_t>(loop[k + 1 == count ? 0 : k + 1])];
            corners.emplace_back(a, id);
            sides.emplace_back(std::min(a, b), std::max(a, b), id, k, a < b);
        }
    }
    std::sort(corners.begin(), corners.end());
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    std::sort(sides.begin(), sides.end());

    first_polygon_.assign(vertices_.size() + 1, 0);
    for (const auto& [position, polygon] : corners) {
        ++first_polygon_[position + 1];
        polygons_.push_back(polygon);
    }
    for (std::size_t k = 0; k < vertices_.size(); ++k) first_polygon_[k + 1] += first_polygon_[k];

    for (const auto& [from, to, polygon, number, forward] : sides) {
        if (edges_.empty() || edges_.back().from != from || edges_.back().to != to)
            edges_.push_back({from, to, sides_.size(), 0});
        ++edges_.back().side_count;
        sides_.push_back({polygon, number, forward});
    }
}

View<PolygonId> EdgeTable::polygons_at(std::size_t position) const {
    return {polygons_.data() + first_polygon_[position], polygons_.data() + first_polygon_[position + 1]};
}

View<EdgeTable::Side> EdgeTable::sides_of(std::size_t edge) const {
    const Side* first = sides_.data() + edges_[edge].first_side;
    return {first, first + edges_[edge].side_count};
}

}  // namespace cob
