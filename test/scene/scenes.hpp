// Small scenes for the tests of this room.
#pragma once

#include "cob/scene.hpp"

#include <utility>
#include <vector>

namespace cob::test {

/// One polygon, its corners in order.
inline Scene::Input one_polygon(std::vector<Point> corners) {
    Scene::Input input;
    input.name = "test";
    input.materials.emplace_back();
    Scene::Face face;
    for (std::size_t k = 0; k < corners.size(); ++k) face.corners.push_back(static_cast<VertexId>(k));
    input.positions = std::move(corners);
    input.faces.push_back(std::move(face));
    return input;
}

inline Scene build_one(std::vector<Point> corners) {
    return Scene::build(one_polygon(std::move(corners)), {true});
}

/// Why the only polygon is refused; empty: it is not.
inline std::string refusal(const Scene& scene) {
    return scene.invalid().empty() ? std::string() : scene.invalid().front().reason;
}

}  // namespace cob::test
