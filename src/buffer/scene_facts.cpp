#include "buffer/scene_facts.hpp"

#include "arithmetic/orientation.hpp"
#include "scene/box_tree.hpp"
#include "scene/piece_plane.hpp"

#include <array>
#include <vector>

namespace cob {
namespace {

using Plane = std::array<Point, 3>;  ///< Counter-clockwise from its front.

std::string name(PolygonId polygon) {
    return "polygon " + std::to_string(polygon);
}

bool is_behind(const Plane& plane, const Point& point) {
    return orientation(plane[0], plane[1], plane[2], point) == Sign::negative;
}

bool reaches_behind(const Plane& plane, const Scene& scene, const Piece& piece) {
    for (const VertexId corner : scene.corners(piece))
        if (is_behind(plane, scene.position(corner))) return true;
    return false;
}

/// A box does if and only if one of its corners is there.
bool reaches_behind(const Plane& plane, const Bounds3& box) {
    for (int k = 0; k < 8; ++k)
        if (is_behind(plane, {(k & 1 ? box.high : box.low)[0], (k & 2 ? box.high : box.low)[1],
                              (k & 4 ? box.high : box.low)[2]}))
            return true;
    return false;
}

Bounds3 bounds_of(const Scene& scene, View<VertexId> corners) {
    Bounds3 bounds;
    for (const VertexId corner : corners) bounds.add(scene.position(corner));
    return bounds;
}

Bounds3 bounds_of(const Box& box) {
    const auto& b = box.bounds();
    return {{b[0], b[1], b[2]}, {b[3], b[4], b[5]}};
}

}  // namespace

Fact find_convex(const Scene& scene) {
    const std::vector<Piece>& pieces = scene.pieces();
    const auto refuted = [](const Piece& wall, const Piece& other) -> Fact {
        return {false, name(other.polygon) + " reaches behind the plane of " + name(wall.polygon)};
    };

    // Neighbours in the file first: next to each other on a solid, they decide most scenes at the first one.
    for (std::size_t k = 1; k < pieces.size(); ++k)
        if (reaches_behind(plane_of(scene, pieces[k - 1]), scene, pieces[k])) return refuted(pieces[k - 1], pieces[k]);

    // Each plane against all pieces but those in boxes wholly before it.
    std::vector<Bounds3> boxes;
    boxes.reserve(pieces.size());
    for (const Piece& piece : pieces) boxes.push_back(bounds_of(scene, scene.corners(piece)));
    const BoxTree tree(std::move(boxes));
    for (const Piece& wall : pieces) {
        const Plane plane = plane_of(scene, wall);
        const Piece* found = nullptr;
        tree.find_where([&](const Bounds3& box) { return found == nullptr && reaches_behind(plane, box); },
                        [&](std::uint32_t id) {
                            if (found == nullptr && reaches_behind(plane, scene, pieces[id])) found = &pieces[id];
                        });
        if (found != nullptr) return refuted(wall, *found);
    }
    return {true, "the scene is convex: no polygon reaches behind the plane of another"};
}

Fact find_apart(const Scene& scene, const Roots& roots, const OmissionOptions& options) {
    const auto refuted = [](PolygonId polygon, const Root& root) -> Fact {
        return {false, name(polygon) + " is near the box of " + name(root.polygon)};
    };
    std::vector<PolygonId> polygons;
    std::vector<Bounds3> bounds;
    for (PolygonId p = 0; p < scene.polygon_count(); ++p) {
        if (!scene.polygon(p).valid) continue;
        polygons.push_back(p);
        bounds.push_back(bounds_of(scene, scene.loop(p)));
    }

    // Neighbours in the file first: they decide most scenes at the first root.
    std::vector<Bounds3> around;
    for (std::size_t k = 0; k < polygons.size(); ++k)
        for (auto [id, last] = roots.of(polygons[k]); id < last; ++id) {
            around.push_back(
                bounds_of(Box(box_question(scene, roots[id], root_element(id), options.margin, options.height))));
            for (const std::size_t other : {k - 1, k + 1})
                if (other < polygons.size() && bounds[other].meets(around.back()))
                    return refuted(polygons[other], roots[id]);
        }

    const BoxTree tree(std::move(bounds));
    for (RootId id = 0; id < roots.size(); ++id) {
        const Root& root = roots[id];
        const Bounds3& box = around[static_cast<std::size_t>(id)];  // of all roots: they ascend by polygon
        PolygonId found = no_polygon;
        tree.find_where([&](const Bounds3& other) { return found == no_polygon && other.meets(box); },
                        [&](std::uint32_t k) {
                            if (found == no_polygon && polygons[k] != root.polygon) found = polygons[k];
                        });
        if (found != no_polygon) return refuted(found, root);
    }
    return {true, "no polygon is near the box of another"};
}

}  // namespace cob
