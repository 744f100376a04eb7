/// \file
/// Reader of Wavefront OBJ text.
#pragma once

#include "cob/scene.hpp"

#include <string>
#include <string_view>

namespace cob {

/// The text of an OBJ file as a scene's input. `path` is for messages, and its folder is where material libraries are
/// sought. Throws InputError.
Scene::Input parse_obj(std::string_view text, const std::string& path, const ReadOptions& options, ReadReport& report);

}  // namespace cob
