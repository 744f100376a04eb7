#include "radiosity/mesh.hpp"

#include "geometry/bounds.hpp"
#include "scene/edges.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace cob::radiosity {
namespace {

constexpr std::uint32_t whole = std::uint32_t(1) << 31;

double distance(const Point& a, const Point& b) {
    const Point d = b - a;
    return std::hypot(d.x, d.y, d.z);
}

std::uint64_t side_of(MeshVertexId a, MeshVertexId b) {
    return static_cast<std::uint64_t>(static_cast<std::uint32_t>(std::min(a, b))) << 32 |
           static_cast<std::uint32_t>(std::max(a, b));
}

/// Where the patch that holds the lattice point (p, q) stands among those of its root: quadrilaterals run row by row,
/// triangles, too, an upright one before the inverted one beside it.
NodeId patch_index(const Root& root, const Element& patch, std::uint32_t p, std::uint32_t q) {
    const std::uint32_t i = p >> (31 - patch.level_i), j = q >> (31 - patch.level_j);
    if (root.corner_count() == 4) return static_cast<NodeId>((j << patch.level_i) + i);
    const std::uint32_t count = std::uint32_t(1) << patch.level_i, side = whole >> patch.level_i;
    const bool inverted = (p - i * side) + (q - j * side) >= side;
    return static_cast<NodeId>(2 * count * j - j * j + 2 * i + (inverted ? 1 : 0));
}

}  // namespace

int unit_exponent(const Scene& scene) {
    double largest = 0;
    const Bounds bounds = bounds_of(scene);
    if (!scene.pieces().empty())
        for (std::size_t axis = 0; axis < 3; ++axis)
            largest = std::max({largest, std::fabs(bounds.low[axis]), std::fabs(bounds.high[axis])});
    return largest > 0 ? std::ilogb(largest) + 1 : 0;
}

std::size_t Mesh::KeyHash::operator()(const Key& key) const {
    std::uint64_t hash = 0x9e3779b97f4a7c15u;
    for (const std::uint64_t part : {static_cast<std::uint64_t>(static_cast<std::uint32_t>(key.polygon)),
                                     static_cast<std::uint64_t>(static_cast<std::uint32_t>(key.a)),
                                     static_cast<std::uint64_t>(static_cast<std::uint32_t>(key.b)),
                                     static_cast<std::uint64_t>(key.p), static_cast<std::uint64_t>(key.q)}) {
        hash = (hash ^ part) * 0xff51afd7ed558ccdu;
        hash ^= hash >> 32;
    }
    return static_cast<std::size_t>(hash);
}

Mesh::Mesh(const Scene& scene, const Roots& roots, double patch_edge, double light_edge)
    : scene_(scene), roots_(roots), exponent_(unit_exponent(scene)), first_at_position_(first_at_position(scene)) {
    for (RootId root = 0; root < roots.size(); ++root) {
        first_patch_.push_back(static_cast<NodeId>(nodes_.size()));
        const double edge = scene.is_light(roots[root].polygon) ? light_edge : patch_edge;
        for (const Element& element : patches(scene, roots[root], edge)) add_node(element, -1, -1, 0);
    }
    patch_count_ = static_cast<NodeId>(nodes_.size());
    first_patch_.push_back(patch_count_);
    leaf_count_ = nodes_.size();
    for (NodeId patch = 0; patch < patch_count_; ++patch) find_middles(patch);
}

std::pair<NodeId, NodeId> Mesh::patches_of(RootId root) const {
    const auto k = static_cast<std::size_t>(root);
    return {first_patch_[k], first_patch_[k + 1]};
}

std::vector<NodeId> Mesh::leaves() const {
    std::vector<NodeId> result;
    result.reserve(leaf_count_);
    for (NodeId patch = 0; patch < patch_count_; ++patch) append_leaves(patch, result);
    return result;
}

void Mesh::append_leaves(NodeId below, std::vector<NodeId>& out) const {
    const Node& n = node(below);
    if (n.is_leaf()) {
        out.push_back(below);
        return;
    }
    for (NodeId k = 0; k < 4; ++k) append_leaves(n.first_child + k, out);
}

// ------------------------------------------------------------------------------------------------- vertices

std::array<Mesh::Lattice, 4> Mesh::lattice_corners(const Root& root, const Element& e) {
    const auto at = [&](std::uint32_t i, std::uint32_t j) {
        return Lattice{i << (31 - e.level_i), j << (31 - e.level_j)};
    };
    if (root.corner_count() == 4) return {at(e.i, e.j), at(e.i + 1, e.j), at(e.i + 1, e.j + 1), at(e.i, e.j + 1)};
    if (e.inverted) return {at(e.i + 1, e.j + 1), at(e.i, e.j + 1), at(e.i + 1, e.j), Lattice{0, 0}};
    return {at(e.i, e.j), at(e.i + 1, e.j), at(e.i, e.j + 1), Lattice{0, 0}};
}

Mesh::Key Mesh::side_key(PolygonId polygon, VertexId from, VertexId to, std::uint32_t along) const {
    VertexId a = first_at_position_[static_cast<std::size_t>(from)];
    VertexId b = first_at_position_[static_cast<std::size_t>(to)];
    if (along == 0) return {polygon, a, a, 0, 0};
    if (along == whole) return {polygon, b, b, 0, 0};
    if (a < b) return {polygon, a, b, along, 0};
    return {polygon, b, a, whole - along, 0};
}

Mesh::Key Mesh::key_of(RootId id, Lattice at) const {
    const Root& root = roots_[id];
    const auto& c = root.corners;
    if (at.v == 0) return side_key(root.polygon, c[0], c[1], at.u);
    if (root.corner_count() == 4) {
        if (at.u == whole) return side_key(root.polygon, c[1], c[2], at.v);
        if (at.v == whole) return side_key(root.polygon, c[3], c[2], at.u);
        if (at.u == 0) return side_key(root.polygon, c[0], c[3], at.v);
    } else {
        if (at.u == 0) return side_key(root.polygon, c[0], c[2], at.v);
        if (at.u + at.v == whole) return side_key(root.polygon, c[1], c[2], at.v);
    }
    return {root.polygon, -1 - id, 0, at.u, at.v};
}

MeshVertexId Mesh::vertex(RootId id, Lattice at) {
    const auto [place, is_new] = vertex_of_.emplace(key_of(id, at), static_cast<MeshVertexId>(vertices_.size()));
    if (is_new) {
        const Root& root = roots_[id];
        const double u = at.u * 0x1p-31, v = at.v * 0x1p-31;
        const auto corner = [&](std::size_t k) { return in_units(scene_.position(root.corners[k])); };
        const Point position = root.corner_count() == 4 ? (1 - v) * ((1 - u) * corner(0) + u * corner(1)) +
                                                              v * ((1 - u) * corner(3) + u * corner(2))
                                                        : (1 - u - v) * corner(0) + (u * corner(1) + v * corner(2));
        vertices_.push_back({position, root.polygon});
    }
    return place->second;
}

MeshVertexId Mesh::middle_of_side(const Node& n, int side) const {
    const std::array<Lattice, 4> at = lattice_corners(roots_[n.element.root], n.element);
    const auto a = static_cast<std::size_t>(side), b = static_cast<std::size_t>((side + 1) % n.corner_count());
    const auto half = [](std::uint32_t x, std::uint32_t y) {
        return static_cast<std::uint32_t>((std::uint64_t(x) + y) / 2);
    };
    const Lattice middle{half(at[a].u, at[b].u), half(at[a].v, at[b].v)};
    const auto found = vertex_of_.find(key_of(n.element.root, middle));
    return found == vertex_of_.end() ? -1 : found->second;
}

// ---------------------------------------------------------------------------------------------------- nodes

NodeId Mesh::add_node(const Element& element, NodeId parent, NodeId patch, std::uint8_t level) {
    const auto id = static_cast<NodeId>(nodes_.size());
    Node n;
    n.element = element;
    n.parent = parent;
    n.patch = patch < 0 ? id : patch;
    n.level = level;
    const Root& root = roots_[element.root];
    const std::array<Lattice, 4> at = lattice_corners(root, element);
    const int count = root.corner_count();
    for (int k = 0; k < count; ++k)
        n.corners[static_cast<std::size_t>(k)] = vertex(element.root, at[static_cast<std::size_t>(k)]);
    for (int k = 0; k < count; ++k) {
        const MeshVertexId a = n.corners[static_cast<std::size_t>(k)];
        const MeshVertexId b = n.corners[static_cast<std::size_t>((k + 1) % count)];
        auto& nodes = sides_.emplace(side_of(a, b), std::array<NodeId, 2>{-1, -1}).first->second;
        if (nodes[0] < 0)
            nodes[0] = id;
        else if (nodes[1] < 0)
            nodes[1] = id;
    }
    nodes_.push_back(n);
    return id;
}

NodeId Mesh::neighbour(MeshVertexId a, MeshVertexId b, NodeId than) const {
    const auto found = sides_.find(side_of(a, b));
    if (found == sides_.end()) return -1;
    return found->second[0] == than ? found->second[1] : found->second[0];
}

void Mesh::refine(NodeId leaf, std::vector<NodeId>& split_nodes) {
    if (!node(leaf).is_leaf()) return;
    // A neighbour of the parent that is still a leaf is one level coarser than this one, and would be two.
    const NodeId parent = node(leaf).parent;
    if (parent >= 0) {
        const int count = node(parent).corner_count();
        for (int k = 0; k < count; ++k) {
            const auto& c = node(parent).corners;
            const MeshVertexId a = c[static_cast<std::size_t>(k)], b = c[static_cast<std::size_t>((k + 1) % count)];
            const auto& own = node(leaf).corners;
            const bool touches = std::any_of(own.begin(), own.end(), [&](MeshVertexId v) { return v == a || v == b; });
            const NodeId other = neighbour(a, b, parent);
            if (touches && other >= 0 && node(other).is_leaf()) refine(other, split_nodes);
        }
    }
    split(leaf);
    split_nodes.push_back(leaf);
}

void Mesh::find_middles(NodeId id) {
    Node& n = nodes_[static_cast<std::size_t>(id)];
    for (int side = 0; side < n.corner_count(); ++side)
        n.middles[static_cast<std::size_t>(side)] = middle_of_side(n, side);
}

void Mesh::split(NodeId leaf) {
    const Node n = node(leaf);
    const auto first = static_cast<NodeId>(nodes_.size());
    for (const Element& child : children(roots_[n.element.root], n.element))
        add_node(child, leaf, n.patch, static_cast<std::uint8_t>(n.level + 1));
    nodes_[static_cast<std::size_t>(leaf)].first_child = first;

    // T-vertices: of equal neighbours that are leaves still, and of the children along roots cut less finely.
    const int count = n.corner_count();
    for (int k = 0; k < count; ++k) {
        const MeshVertexId a = n.corners[static_cast<std::size_t>(k)];
        const MeshVertexId b = n.corners[static_cast<std::size_t>((k + 1) % count)];
        const NodeId other = neighbour(a, b, leaf);
        if (other < 0) continue;
        Node& beyond = nodes_[static_cast<std::size_t>(other)];
        for (int side = 0; side < beyond.corner_count(); ++side)
            if (beyond.corners[static_cast<std::size_t>(side)] == b &&
                beyond.corners[static_cast<std::size_t>((side + 1) % beyond.corner_count())] == a)
                beyond.middles[static_cast<std::size_t>(side)] = middle_of_side(n, k);
    }
    for (NodeId child = first; child < first + 4; ++child) find_middles(child);
    leaf_count_ += 3;
}

double Mesh::longest_side(NodeId id) const {
    const Node& n = node(id);
    const int count = n.corner_count();
    double longest = 0;
    for (int k = 0; k < count; ++k)
        longest = std::max(
            longest,
            distance(
                vertices_[static_cast<std::size_t>(n.corners[static_cast<std::size_t>(k)])].position,
                vertices_[static_cast<std::size_t>(n.corners[static_cast<std::size_t>((k + 1) % count)])].position));
    return longest;
}

double Mesh::area(NodeId id) const {
    const Node& n = node(id);
    const auto at = [&](std::size_t k) { return vertices_[static_cast<std::size_t>(n.corners[k])].position; };
    const Point d = n.corner_count() == 4 ? cross(at(2) - at(0), at(3) - at(1)) : cross(at(1) - at(0), at(2) - at(0));
    return std::hypot(d.x, d.y, d.z) / 2;
}

NodeId Mesh::leaf_at(RootId id, double u, double v) const {
    const Root& root = roots_[id];
    const auto clamp = [](double x) {
        return static_cast<std::uint32_t>(std::min(std::max(x, 0.0), 1 - 0x1p-31) * 0x1p31);
    };
    std::uint32_t p = clamp(u), q = clamp(v);
    if (root.corner_count() == 3 && std::uint64_t(p) + q >= whole) q = whole - 1 - p;
    // The lattice cell at each level; a triangle's cell holds an upright and an inverted triangle.
    const auto holds = [&](const Element& e) {
        const std::uint32_t i = p >> (31 - e.level_i), j = q >> (31 - e.level_j);
        if (i != e.i || j != e.j) return false;
        if (root.corner_count() == 4) return true;
        const std::uint32_t side = whole >> e.level_i;
        return ((p - i * side) + (q - j * side) >= side) == e.inverted;
    };
    const auto [first, last] = patches_of(id);
    NodeId found = first + patch_index(root, node(first).element, p, q);
    // The order of patches() is a matter of speed only.
    for (NodeId k = first; found >= last || !holds(node(found).element); ++k) {
        if (k == last) throw std::logic_error("no patch of the root holds a point of it");
        found = k;
    }
    while (!node(found).is_leaf()) {
        const NodeId children = node(found).first_child;
        NodeId child = 0;
        while (child < 3 && !holds(node(children + child).element)) ++child;
        found = children + child;
    }
    return found;
}

}  // namespace cob::radiosity
