/// \file
/// Scenes written down as loops of points.
#pragma once

#include "cob/scene.hpp"

#include <algorithm>
#include <vector>

namespace cob::test {

using Loop = std::vector<Point>;

/// Whether corners at one position are one vertex of the scene.
enum class Vertices : bool { apart, shared };

/// Adds a polygon, as it stands; returns it, of material 0.
inline Scene::Face& add_loop(Scene::Input& input, const Loop& loop, Vertices vertices = Vertices::apart) {
    Scene::Face face;
    for (const Point& corner : loop) {
        const auto begin = input.positions.begin(), end = input.positions.end();
        const auto same = vertices == Vertices::shared ? std::find(begin, end, corner) : end;
        face.corners.push_back(static_cast<VertexId>(same - begin));
        if (same == end) input.positions.push_back(corner);
    }
    return input.faces.emplace_back(std::move(face));
}

/// A scene of these polygons and one material.
inline Scene scene_of(const std::vector<Loop>& loops, Vertices vertices = Vertices::apart, bool skip_invalid = false) {
    Scene::Input input;
    input.name = "test";
    input.materials.resize(1);
    for (const Loop& loop : loops) add_loop(input, loop, vertices);
    return Scene::build(std::move(input), {skip_invalid});
}

}  // namespace cob::test
