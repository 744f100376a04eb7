/// \file
/// What the reader of a scene should be told about it.
#pragma once

#include "cob/scene.hpp"

#include <string>
#include <vector>

namespace cob {

/// Warnings, then polygons that were skipped, a line each.
std::vector<std::string> remarks_on(const Scene& scene, const ReadReport& report, const std::string& path);

}  // namespace cob
