/// \file
/// Answers the questions of a golden set, whatever program wrote it (SPEC section 7).
#pragma once

#include "cob/candidates.hpp"
#include "cob/geometry.hpp"
#include "cob/progress.hpp"

#include <cstdint>
#include <functional>
#include <string>

namespace cob {

/// Other people's code, as a subject: it answers yes or no, in the short tables that `cob verify` takes, too.
/// Embree: is a segment hidden (`segment,hidden`)? CGAL: do a polygon and the closed box meet (`box,polygon,close`)?
/// Only for axis-aligned boxes of binary64 corners.
enum class Peer : std::uint8_t { none, embree, cgal_epick, cgal_epeck };

struct AnswerOptions {
    /// Of the predicates; `exact` gives the golden answers. Questions are read and boxes refused exactly in all.
    Arithmetic arithmetic = Arithmetic::exact;
    Peer peer = Peer::none;  ///< Who answers instead, one table of questions only.
    Source source = Source::tree;
    int threads = 0;                              ///< 0: one for each processor.
    bool skip_invalid = false;                    ///< Refused polygons keep their numbers and occur in no answer.
    Progress progress;                            ///< Counts questions; how many there are is not known.
    std::function<void(const std::string&)> say;  ///< Told warnings about the scene and what is skipped, a line each.
};

struct AnswerSummary {
    std::uint64_t boxes = 0, relations = 0;  ///< Rows of states.csv and relations.csv.
    std::uint64_t segments = 0;              ///< Rows of visibility.csv.
    std::uint64_t irradiances = 0;           ///< Rows of irradiance.csv.
    std::uint64_t undecided = 0;             ///< Relations, states and segments, in Arithmetic::interval.
    PredicateCounters predicates;
    bool has_boxes = false, has_segments = false, has_points = false;  ///< Which questions the set has.
};

/// Reads scene.obj and the tables of questions that the set has, and writes their answers, and nothing else, into the
/// folder: boxes.csv gives states.csv and relations.csv, segments.csv gives visibility.csv, points.csv gives
/// irradiance.csv (always exactly). Streams: memory does not grow with the number of questions. The columns from and to
/// of segments.csv must name polygons of the scene, but are not trusted: the answer is that of the two points. Throws
/// InputError: no scene, no questions, a question that SPEC refuses or the peer cannot be asked, with its line; a peer
/// that the program was built without.
AnswerSummary answer_set(const std::string& set, const std::string& folder, const AnswerOptions& options);

}  // namespace cob
