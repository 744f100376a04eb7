/// \file
/// The summary of `cob classify`, as text and as JSON.
#pragma once

#include "cob/omissions.hpp"
#include "report/classify_scene.hpp"

#include <map>
#include <optional>
#include <string>

namespace cob {

struct ClassifySummary {
    std::map<std::string, std::string> parameters;  ///< Options of the command, as text.
    std::uint64_t polygons = 0;                     ///< Of the scene.
    std::uint64_t skipped = 0;                      ///< Of these, refused.
    ClassifySceneResult result;
    std::optional<Omissions> omissions;
    double read_seconds = 0, mesh_seconds = 0, tree_seconds = 0, classify_seconds = 0;
    double processor_seconds = 0;  ///< Of classifying, summed over the threads.
    std::uint64_t tree_bytes = 0;  ///< Of the source of candidates.
    std::uint64_t peak_bytes = 0;  ///< Of the process.
};

std::string to_text(const ClassifySummary& summary);
std::string to_json(const ClassifySummary& summary);

}  // namespace cob
