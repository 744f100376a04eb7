/// \file
/// The same polygons for the library and for the naive twin.
#pragma once

#include "loops.hpp"
#include "naive/cases.hpp"

#include <string>
#include <vector>

namespace cob::test {

/// Repeated corners of a face stay what they are.
inline Scene library_scene(const std::vector<naive::Face>& faces, Vertices vertices = Vertices::apart) {
    Scene::Input input;
    input.name = "case";
    input.materials.resize(2);
    input.materials[1].emitted_exitance = {1, 0, 0};
    for (const naive::Face& face : faces) add_loop(input, face.corners, vertices).material = face.emits ? 1 : 0;
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
