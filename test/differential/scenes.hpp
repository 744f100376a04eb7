/// \file
/// The same polygons for the library and for the naive twin.
#pragma once

#include "naive/cases.hpp"

#include "cob/scene.hpp"

#include <vector>

namespace cob::test {

/// One vertex for each corner of each face: consecutive and distant repetitions stay what they are.
inline Scene library_scene(const std::vector<naive::Face>& faces) {
    Scene::Input input;
    input.name = "case";
    input.materials.resize(2);
    input.materials[1].emitted_exitance = {1, 0, 0};
    for (const naive::Face& face : faces) {
        Scene::Face line;
        line.material = face.emits ? 1 : 0;
        for (const Point& corner : face.corners) {
            line.corners.push_back(static_cast<VertexId>(input.positions.size()));
            input.positions.push_back(corner);
        }
        input.faces.push_back(line);
    }
    return Scene::build(std::move(input), {true});
}

inline std::vector<naive::SceneItem> naive_scene(const std::vector<naive::Face>& faces) {
    std::vector<naive::SceneItem> items;
    for (const naive::Face& face : faces) items.push_back({naive::prepare(face.corners), face.emits});
    return items;
}

/// Full-precision literals of a loop, for a message from which a regression row can be made.
inline std::string literals(const std::vector<Point>& corners) {
    std::string text;
    for (const Point& corner : corners)
        text += "{" + to_hex_text(corner.x) + "," + to_hex_text(corner.y) + "," + to_hex_text(corner.z) + "} ";
    return text;
}

}  // namespace cob::test
