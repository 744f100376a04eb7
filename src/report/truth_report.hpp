/// \file
/// `cob classify --truth`: the paper's heuristic against what is truly seen of the lights.
///
/// An element e and a light l that faces it are *visible* (no piece meets the hull of both), *hidden* (some one
/// polygon lies across everything, or, at every sample point, several do together), or have a *boundary*. It is
/// *sharp* where two sample points of e within a quarter of its side see shares of l that differ by a half. Visible
/// and hidden by one polygon are exact; what samples say is exact at the samples (5 by 5 in an element).
#pragma once

#include "cob/classify.hpp"
#include "cob/progress.hpp"

#include <cstdint>
#include <functional>
#include <string>

namespace cob {

struct TruthOptions {
    ClassifyOptions classify;
    std::uint64_t max_pairs = 20000;  ///< Pairs of element and light; of more, elements at equal distances are taken.
    int threads = 0;                  ///< 0: one for each processor.
    Progress progress;                ///< Counts elements.
    std::function<void(const std::string&)> say;  ///< Told beforehand what it will cost.
};

struct TruthSummary {
    std::uint64_t elements = 0, sampled = 0, lights = 0;
    std::uint64_t empty = 0, close = 0, occluded = 0;  ///< Of the sampled ones, by state.
    std::uint64_t boundary = 0;                        ///< Elements with a shadow boundary of some light,
    std::uint64_t sharp = 0;                           ///< with a sharp one.
    std::uint64_t refined_in_vain = 0;                 ///< State close, and no boundary.
    std::uint64_t sharp_missed = 0;                    ///< A sharp boundary, and state empty or occluded.
    std::uint64_t occluded_lit = 0;                    ///< State occluded, and some light reaches it,
    double occluded_lit_hemisphere = 0;                ///< at most with this share of the hemisphere's solid angle.
    std::uint64_t shut_out_together = 0;  ///< Not occluded, yet no light that faces it was found to reach it, and some
                                          ///< light is hidden by no one polygon alone.
    double seconds = 0;
};

/// Writes truth.csv (a row for each sampled element) and truth_summary.csv (a row for the scene) into the folder.
TruthSummary write_truth(const ElementList& elements, const CandidateSource& source, const std::string& folder,
                         const TruthOptions& options);

std::string to_text(const TruthSummary& summary);

}  // namespace cob
