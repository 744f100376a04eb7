/// \file
/// The work of `cob classify`: tables, picture and summary of the buffers of all elements of a scene.
#pragma once

#include "cob/classify.hpp"
#include "cob/progress.hpp"

#include <cstdint>
#include <string>

namespace cob {

struct ClassifySceneOptions {
    ClassifyOptions classify;
    int threads = 0;                                  ///< 0: one for each processor.
    bool boxes = true, relations = true, ply = true;  ///< Which files to write besides states.csv.
    Progress progress;                                ///< Counts elements.
};

struct ClassifySceneResult {
    ClassifyStatistics statistics;
    std::uint64_t relations = 0;     ///< Rows of relations.csv.
    std::uint64_t buffer_bytes = 0;  ///< Of the buffers of all elements, without their lists.
    std::uint64_t list_bytes = 0;    ///< Of all stored lists of close polygons.
};

/// Writes boxes.csv, states.csv, relations.csv, elements.ply and, in BufferMode::inherit, inherited.csv into the
/// folder. Memory: 4 bytes an element, the stored lists and the blocks under way.
ClassifySceneResult classify_scene(const ElementList& elements, const CandidateSource& source,
                                   const std::string& folder, const ClassifySceneOptions& options);

}  // namespace cob
