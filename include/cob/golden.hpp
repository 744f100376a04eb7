/// \file
/// Golden sets (SPEC section 7): making them from a scene, and checking a variant's answers against them.
#pragma once

#include "cob/manifest.hpp"
#include "cob/progress.hpp"
#include "cob/verify/report.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace cob {

// ----------------------------------------------------------------------------------------------- making a set

/// What a set contains. Everything here stands in the manifest; nothing else changes a byte of the set.
struct GoldenParameters {
    int level = 0;                   ///< Boxes: refinements below the patches, 0 to 12.
    std::optional<double> edge;      ///< Boxes: wanted length of a patch's side; none: whole pieces are patches.
    bool boxes = true;               ///< False: no boxes of elements.
    double margin = 0.125;           ///< SPEC 4.
    double height = 0.25;            ///< SPEC 4.
    std::uint64_t segments = 0;      ///< Segments between sample points of elements and lights.
    std::uint64_t hard = 0;          ///< So many hard boxes and so many hard segments, aimed at the degenerate.
    std::vector<std::string> kinds;  ///< Of the hard questions, in turn; empty: all there are.
    std::optional<int> grid;         ///< Snap the scene to multiples of 2^-grid: all questions are binary64 numbers.
    bool binary32 = false;           ///< As grid, chosen where none is given: all questions are binary32 numbers.
    std::uint64_t seed = 1;          ///< Of the sample points and the hard questions.
    bool skip_invalid = false;       ///< Polygons that SPEC 2 refuses keep their numbers and occur in no answer.
};

/// The parameters that a manifest tells: with the set's own scene they make the same bytes again. Throws InputError.
GoldenParameters parameters_of(const Manifest& manifest);

/// How a set is made: of no influence on its bytes.
struct GoldenOptions {
    std::uint64_t shard_size = 50000;  ///< Questions held in memory at once.
    /// Make only the shards k with k mod shards = shard mod shards.
    std::uint64_t shard = 0, shards = 1;
    std::vector<std::string> merge;               ///< Folders whose finished shards are taken over.
    int threads = 0;                              ///< 0: all.
    Progress progress;                            ///< Counts shards.
    std::function<void(const std::string&)> say;  ///< Told warnings about the scene and what is skipped, a line each.
};

/// How snapping to a grid changed the scene.
struct SnapReport {
    int grid = 0;                           ///< Coordinates are multiples of 2^-grid.
    std::size_t moved = 0;                  ///< Vertices that were elsewhere.
    double largest_move = 0;                ///< Of a vertex, in scene units.
    std::vector<std::int32_t> not_planar;   ///< Polygons that were planar.
    std::vector<std::int32_t> now_invalid;  ///< Polygons that were valid.
};

struct GoldenResult {
    std::uint64_t boxes = 0, segments = 0;  ///< Questions of the whole set.
    std::uint64_t shards = 0;               ///< Of the whole set.
    std::uint64_t made = 0;                 ///< Shards made now; the others were there.
    bool finished = false;                  ///< The set is whole; else some shards are still missing.
    std::optional<SnapReport> snapped;
};

/// Makes the set in the folder, or goes on with one begun by the same parameters. Each shard is written to a
/// temporary folder and appears under `FOLDER/shards` only when it is whole, so that a kill at any moment loses
/// no finished shard; when all are there they are merged, the manifest last, and removed. The bytes of the set
/// depend on the scene and the parameters alone. Throws InputError.
GoldenResult make_golden(const std::string& scene, const std::string& folder, const GoldenParameters& parameters,
                         const GoldenOptions& options = {});

// ------------------------------------------------------------------------------------------- checking a variant

/// Checks the set's checksums and compares the answer tables with it, in bounded memory. Throws InputError.
verify::Report verify_answers(const std::string& set, const std::string& answers, const verify::Options& options);

/// For scripts: every count and the first disagreements.
std::string to_json(const verify::Report& report);
/// For continuous integration: one test case for each table and kind of question.
std::string to_junit(const verify::Report& report);

}  // namespace cob
