/// \file
/// Scenes for tests of the buffer.
#pragma once

#include "cob/classify.hpp"
#include "loops.hpp"
#include "naive/dice.hpp"

#include <string>
#include <vector>

namespace cob::test {

inline Scene data_scene(const std::string& name) {
    return read_obj(COB_DATA "/" + name + ".obj", ReadOptions{});
}

/// A floor of 8 by 8 and, over it and through it, small horizontal and vertical rectangles on a grid of quarters:
/// ties, shared edges, covered elements and low lights really happen.
inline Scene random_room(std::uint64_t seed) {
    naive::Dice dice(seed);
    Scene::Input input;
    input.name = "room " + std::to_string(seed);
    input.materials.resize(2);
    input.materials[1].emitted_exitance = {1, 1, 1};
    const auto add = [&](const Loop& loop, bool light) { add_loop(input, loop).material = light ? 1 : 0; };
    add({{0, 0, 0}, {8, 0, 0}, {8, 8, 0}, {0, 8, 0}}, false);
    const int count = dice.between(2, 8);
    for (int k = 0; k < count; ++k) {
        const double x = dice.below(28) / 4.0, y = dice.below(28) / 4.0, z = dice.below(12) / 16.0;
        const double dx = dice.between(1, 16) / 4.0, dy = dice.between(1, 16) / 4.0;
        const bool light = dice.one_in(4);
        switch (dice.below(4)) {
            case 0:
                add({{x, y, z}, {x + dx, y, z}, {x + dx, y, z + dy}, {x, y, z + dy}}, light);
                break;
            case 1:
                add({{x, y, z}, {x, y + dy, z}, {x + dx, y + dy, z}, {x + dx, y, z}}, light);
                break;
            default:
                add({{x, y, z}, {x + dx, y, z}, {x + dx, y + dy, z}, {x, y + dy, z}}, light);
        }
    }
    return Scene::build(std::move(input));
}

inline std::vector<PolygonId> to_vector(View<PolygonId> list) {
    return {list.begin(), list.end()};
}

}  // namespace cob::test
