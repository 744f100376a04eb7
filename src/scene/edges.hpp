/// \file
/// The positions of a scene, each once however many vertices stand there, and the edges between those of its valid
/// polygons, each once however many sides run along it in either direction.
#pragma once

#include "cob/scene.hpp"

#include <cstddef>
#include <vector>

namespace cob {

/// Of every vertex, the first at its position.
std::vector<VertexId> first_at_position(const Scene& scene);

/// Positions and edges of valid polygons.
class EdgeTable {
public:
    /// A side of a polygon: from corner `number` of its loop to the next.
    struct Side {
        PolygonId polygon = no_polygon;
        std::uint32_t number = 0;
        bool forward = true;  ///< Runs from the edge's `from` to its `to`.
    };

    /// The scene must outlive it.
    explicit EdgeTable(const Scene& scene);

    /// Positions ascend.
    std::size_t position_count() const { return vertices_.size(); }
    const Point& position(std::size_t id) const { return scene_->position(vertices_[id]); }
    /// Some vertex of the scene that stands there.
    VertexId vertex(std::size_t id) const { return vertices_[id]; }
    /// Polygons with a corner there, ascending.
    View<PolygonId> polygons_at(std::size_t position) const;

    std::size_t edge_count() const { return edges_.size(); }
    const Point& from(std::size_t edge) const { return position(edges_[edge].from); }
    const Point& to(std::size_t edge) const { return position(edges_[edge].to); }
    /// Sides along it, in either direction, ascending.
    View<Side> sides_of(std::size_t edge) const;

private:
    struct Edge {
        std::uint32_t from = 0, to = 0;  ///< Positions; from < to.
        std::size_t first_side = 0, side_count = 0;
    };

    const Scene* scene_;
    std::vector<VertexId> vertices_;  ///< Of each position, one vertex.
    std::vector<std::size_t> first_polygon_;
    std::vector<PolygonId> polygons_;
    std::vector<Edge> edges_;
    std::vector<Side> sides_;
};

}  // namespace cob
