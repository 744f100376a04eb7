/// \file
/// The scene of a golden set as text, always the same for the same scene (SPEC 7).
#pragma once

#include "cob/scene.hpp"

#include <string>

namespace cob {

struct SceneText {
    std::string obj, mtl, triangles;  ///< Of scene.obj, scene.mtl and triangles.csv.
    std::int64_t triangle_count = 0;
};

/// Positions in shortest round-trip decimals; polygon k is the k-th face line, repeated corners dropped; the materials
/// in use, in the order of their first use. Reading the text and writing it again gives the same text.
SceneText write_scene(const Scene& scene);

}  // namespace cob
