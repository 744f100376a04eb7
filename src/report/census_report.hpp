/// \file
/// A census for readers: text and JSON of `cob info`.
#pragma once

#include "cob/census.hpp"
#include "cob/omissions.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace cob {

/// Everything that `cob info` knows about a scene.
struct SceneInfo {
    const Scene& scene;
    const ReadReport& read;
    const Census& census;
    const std::vector<PolygonId>& planar_as_decimal;
    const Omissions& omissions;
};

/// What of the machinery the scene needs, a sentence each, with the reason; never empty.
std::vector<std::string> machinery(const SceneInfo& info);

std::string info_text(const SceneInfo& info);
nlohmann::ordered_json info_json(const SceneInfo& info);

}  // namespace cob
