/// \file
/// Error against run time: our own formula in several arithmetics, and other people's code, on a golden set.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace cob {

struct BenchOptions {
    int repetitions = 5;               ///< Runs over all questions of a kind; each gives one time.
    std::uint64_t most_of_kind = 500;  ///< Questions of each kind that are asked: the first ones.
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

/// What the figures were measured on.
struct BenchMachine {
    std::string processor, compiler, commit;
};
BenchMachine bench_machine();

}  // namespace cob
