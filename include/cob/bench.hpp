/// \file
/// Error against run time: our own formula in several arithmetics, and other people's code, on a golden set.
#pragma once

#include "cob/progress.hpp"
#include "cob/visibility.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace cob {

struct BenchOptions {
    int repetitions = 5;               ///< Runs over all questions of a kind; each gives one time.
    std::uint64_t most_of_kind = 500;  ///< Questions of each kind that are asked: the first ones.
    Progress progress;                 ///< Called for each kind that a variant is asked: so many of this set.
};

/// One variant on one kind of question.
struct BenchRow {
    std::string question;  ///< "box" or "segment".
    std::string variant;   ///< "float", "double", "epsilon", "interval", "exact", "rational", "embree", ...
    std::string kind;      ///< As in tags.csv; "all" sums them up.
    std::uint64_t questions = 0;
    std::uint64_t wrong = 0;      ///< Questions with an answer that differs (grazing segments: either way is right).
    std::uint64_t undecided = 0;  ///< Questions that the variant says it cannot decide, and is not wrong on.
    double nanoseconds_min = 0, nanoseconds_median = 0;  ///< Per question, over the repetitions.
    std::uint64_t bytes = 0;                             ///< Of what the variant holds beside the scene.
};

/// A box question is all its candidates' relations (of yes-or-no variants: does the polygon meet the closed box?). The
/// search for candidates and the box's frame in binary64 are not timed; what a variant makes of the box beyond that,
/// once for each question, is. A segment question is one visibility. One thread. Throws InputError.
/// Variants `cgal-epick` and `cgal-epeck` are asked only about axis-aligned boxes of binary64 corners.
std::vector<BenchRow> bench_set(const std::string& set, const BenchOptions& options = {});

/// Several sets, one after another: counts are summed, times are means over all questions, bytes are the largest.
std::vector<BenchRow> bench_sets(const std::vector<std::string>& sets, const BenchOptions& options = {});

/// A segment to which Embree's triangles give the other answer; grazing ones have none.
struct EmbreeDisagreement {
    std::string kind;  ///< As in tags.csv.
    Segment segment;
    bool blocked = false;  ///< The exact answer: blocked, and Embree hits nothing; or clear, and it hits something.
    PieceId piece = -1;    ///< That blocks by most; or that Embree hits.
    double parameter = 0;  ///< Where along the segment.
    bool at_end = false;   ///< Within the part of the segment that Embree is not asked about.
    /// How plain the answer is: from the contact to the nearest side of the piece, as the line of the segment passes
    /// it, or to the nearest end where that is less; 0 for a seam.
    double clearance = 0;
    Point across;  ///< Unit, from the line to that side or away from it: perpendicular to both.
};
/// Of the questions that bench_set() asks, those of the greatest clearance first. Nothing where the program was built
/// without Embree. Throws InputError.
std::vector<EmbreeDisagreement> embree_disagreements(const std::string& set, const BenchOptions& options = {});

/// What the figures were measured on.
struct BenchMachine {
    std::string processor, compiler, commit;
};
BenchMachine bench_machine();

}  // namespace cob
