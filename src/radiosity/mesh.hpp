/// \file
/// The mesh of the solver: a forest of elements over patches (SPEC 3), refined where asked and kept balanced, with
/// vertices that elements of one polygon share wherever their exact positions are one.
#pragma once

#include "cob/geometry.hpp"
#include "cob/scene.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace cob::radiosity {

using NodeId = std::int32_t;        ///< A patch or an element below one; index into Mesh::nodes().
using MeshVertexId = std::int32_t;  ///< Index into Mesh::vertices().

struct Node {
    Element element;
    NodeId parent = -1;
    NodeId first_child = -1;                              ///< Of four consecutive ones; -1: a leaf.
    NodeId patch = -1;                                    ///< The patch that it is or lies in.
    std::uint8_t level = 0;                               ///< Refinements below the patch.
    std::array<MeshVertexId, 4> corners{-1, -1, -1, -1};  ///< In order; the fourth -1 for a triangle.
    /// T-vertices: the vertex in the middle of the side after each corner, where a neighbour is finer; else -1.
    std::array<MeshVertexId, 4> middles{-1, -1, -1, -1};

    bool is_leaf() const { return first_child < 0; }
    int corner_count() const { return corners[3] < 0 ? 3 : 4; }
};

/// Photometry runs in units of 2^exponent scene units, in which no coordinate exceeds 1: no product of a few lengths
/// overflows, whatever the scene's scale.
int unit_exponent(const Scene& scene);
/// A point of the scene in such units.
inline Point in_units(const Point& p, int exponent) {
    return {std::scalbn(p.x, -exponent), std::scalbn(p.y, -exponent), std::scalbn(p.z, -exponent)};
}

struct MeshVertex {
    Point position;  ///< In units, within a few roundings of the exact point.
    PolygonId polygon = no_polygon;
};

class Mesh {
public:
    /// Patches as SPEC 3 cuts them, every side at most patch_edge, of lights light_edge (scene units); patch k is node
    /// k.
    Mesh(const Scene& scene, const Roots& roots, double patch_edge, double light_edge);

    const Scene& scene() const { return scene_; }
    const Roots& roots() const { return roots_; }
    const std::vector<Node>& nodes() const { return nodes_; }
    const Node& node(NodeId id) const { return nodes_[static_cast<std::size_t>(id)]; }
    const std::vector<MeshVertex>& vertices() const { return vertices_; }
    /// Units to scene coordinates and back.
    int exponent() const { return exponent_; }
    Point in_units(const Point& scene_point) const { return radiosity::in_units(scene_point, exponent_); }
    Point in_scene(const Point& unit_point) const { return radiosity::in_units(unit_point, -exponent_); }
    NodeId patch_count() const { return patch_count_; }
    /// Patches of a root: [first, last).
    std::pair<NodeId, NodeId> patches_of(RootId root) const;
    std::size_t leaf_count() const { return leaf_count_; }
    std::vector<NodeId> leaves() const;
    void append_leaves(NodeId below, std::vector<NodeId>& out) const;

    /// Splits a leaf into its four children, and before it the neighbours that would differ by two levels. What was
    /// split is appended in that order.
    void refine(NodeId leaf, std::vector<NodeId>& split);
    double longest_side(NodeId id) const;  ///< In units.
    double area(NodeId id) const;          ///< In square units.
    /// The leaf of a root at bilinear (or, of a triangle, barycentric) coordinates (u, v) in [0, 1].
    NodeId leaf_at(RootId root, double u, double v) const;

private:
    /// A point of a polygon's lattice: inside its root, or on a side between two vertices of the scene, so that roots
    /// that share the side share the point.
    struct Key {
        PolygonId polygon;
        std::int32_t a, b;   ///< Scene vertices, a <= b; or -1 - root, 0.
        std::uint32_t p, q;  ///< Along the side in 2^-31 from a; or lattice coordinates in 2^-31.
        friend bool operator==(const Key& x, const Key& y) {
            return x.polygon == y.polygon && x.a == y.a && x.b == y.b && x.p == y.p && x.q == y.q;
        }
    };
    struct KeyHash {
        std::size_t operator()(const Key& key) const;
    };
    struct Lattice {
        std::uint32_t u, v;  ///< In 2^-31 of the root.
    };

    static std::array<Lattice, 4> lattice_corners(const Root& root, const Element& element);
    Key key_of(RootId root, Lattice at) const;
    Key side_key(PolygonId polygon, VertexId a, VertexId b, std::uint32_t along) const;
    MeshVertexId vertex(RootId root, Lattice at);
    NodeId add_node(const Element& element, NodeId parent, NodeId patch, std::uint8_t level);
    MeshVertexId middle_of_side(const Node& node, int side) const;
    NodeId neighbour(MeshVertexId a, MeshVertexId b, NodeId than) const;
    void find_middles(NodeId id);
    void split(NodeId leaf);

    const Scene& scene_;
    const Roots& roots_;
    int exponent_;
    std::vector<VertexId> first_at_position_;  ///< The first scene vertex at each one's position.
    std::vector<Node> nodes_;
    std::vector<MeshVertex> vertices_;
    std::vector<NodeId> first_patch_;  ///< By root, and the end.
    std::unordered_map<Key, MeshVertexId, KeyHash> vertex_of_;
    std::unordered_map<std::uint64_t, std::array<NodeId, 2>> sides_;  ///< Nodes at each side.
    NodeId patch_count_ = 0;
    std::size_t leaf_count_ = 0;
};

}  // namespace cob::radiosity
