/// \file
/// Error of exitance against time and elements, over refinements and budgets: the figures behind `cob study`.
///
/// Direct light alone: the reference is the exact irradiance (cob/irradiance.hpp), so that the error is the solver's.
/// The scene is solved with every reflectance times 2^-20, which is exact and makes what is reflected twice vanish.
#pragma once

#include "cob/progress.hpp"
#include "cob/scene.hpp"
#include "cob/solver.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace cob {

/// A point that receives, and what it receives.
struct StudyPoint {
    RootId root = -1;
    std::array<double, 2> coordinates{};  ///< Of the root, bilinear or barycentric.
    double irradiance = 0;                ///< Exact direct light, W/m2, summed over channels.
    double exitance = 0;                  ///< Times reflectance, channel by channel.
    bool in_band = false;  ///< In a penumbra: some but not all of a light is seen, however little or much.
};

/// Fixed points, spread evenly by area over all polygons that reflect, emit nothing and lie under no sheet in their own
/// plane (there the exitance has no one value); on the visible side.
struct StudyReference {
    std::vector<StudyPoint> points;
    double receiver_share = 0;  ///< Area of these polygons over that of all.
    double mean_exitance = 0;   ///< Over the points.
    double light_exitance = 0;  ///< Emitted, W/m2 over the area of all polygons, summed over channels.
};
StudyReference study_reference(const Scene& scene, std::size_t points, const Progress& progress);

/// What one run is made with.
struct StudySettings {
    std::string series;  ///< "budget", "initial mesh", "height", "margin".
    Refinement refinement = Refinement::none;
    double patch_edge = 0;    ///< Scene units.
    double minimum_edge = 0;  ///< Of the buffer and of gradients, scene units.
    Rational margin = Rational(1, 8), height = Rational(1, 4);

    /// Names the settings; fit for a file name.
    std::string key() const;
};
const char* to_text(Refinement refinement);

/// Uniform, gradient, buffer and both over budgets that halve the smallest edge; then the initial mesh, the height and
/// the margin for `both` in the middle of the budgets.
std::vector<StudySettings> study_plan(const Scene& scene, int budgets);

struct StudyErrors {
    double l1 = 0, l2 = 0;  ///< Relative: of the difference over that of the reference.
    double most = 0;        ///< Largest difference over the mean of the reference.
};

struct StudyRun {
    StudySettings settings;
    std::int64_t elements = 0, shots = 0, segments = 0, form_factors = 0, buffers = 0;
    double seconds_least = 0, seconds_median = 0;
    std::uint64_t bytes = 0;  ///< Held on the heap at the end of the run, beyond what was before it.
    StudyErrors all, band;
};
StudyRun study_run(const Scene& scene, const StudyReference& reference, const StudySettings& settings, int repeats,
                   int threads);

/// One line of comma-separated text and back; nothing where the line is not of these settings.
std::string to_line(const StudyRun& run);
std::optional<StudyRun> study_run_from_line(const std::string& line, const StudySettings& settings);

/// For each run: no other has both less time and less error.
std::vector<bool> pareto_front(const std::vector<std::array<double, 2>>& time_and_error);

}  // namespace cob
