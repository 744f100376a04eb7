/// \file
/// Error of exitance against time and elements, over refinements and budgets: the figures behind `cob study`.
///
/// Direct light alone: the reference is the exact irradiance (cob/irradiance.hpp), so that the error is the solver's.
/// The scene is solved with every reflectance times 2^-20, which is exact and makes what is reflected twice vanish.
/// Full transport: the reference is a direct solution of the discrete system with form factors from exact visibility.
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

/// What light is studied.
enum class StudyLight : std::uint8_t {
    direct,  ///< From the lights alone.
    full,    ///< Reflected any number of times.
};

/// A point that receives, and what it receives.
struct StudyPoint {
    RootId root = -1;
    std::array<double, 2> coordinates{};  ///< Of the root, bilinear or barycentric.
    double irradiance = 0;                ///< Exact direct light, W/m2, summed over channels.
    double exitance = 0;                  ///< The reference, W/m2, summed over channels.
    /// In the band around shadow boundaries: in a penumbra, or within band_width of where more or less of a light is
    /// seen. A penumbra is found exactly; what is seen nearby, by samples.
    bool in_band = false;
};

/// Fixed points, spread evenly by area over all polygons that reflect, emit nothing and lie under no sheet in their own
/// plane (there the exitance has no one value); on the visible side.
struct StudyReference {
    StudyLight light = StudyLight::direct;
    std::vector<StudyPoint> points;
    double receiver_share = 0;  ///< Area of these polygons over that of all.
    double mean_exitance = 0;   ///< Over the points.
    double band_width = 0;      ///< A 48th of the scene's longest extent.
    double light_exitance = 0;  ///< Emitted, W/m2 over the area of all polygons, summed over channels.
    // Of full transport:
    std::size_t unknowns = 0;  ///< Patches of the finer of its two meshes.
    double own_error = 0;      ///< Relative L2 distance of what both meshes give at the points.
};

/// Where points may lie.
struct StudyRegion {
    std::vector<PolygonId> polygons;              ///< On these; empty: on all.
    std::optional<std::array<double, 6>> bounds;  ///< And within these: xmin, ymin, zmin, xmax, ymax, zmax.
};
/// Exact direct light. Throws InputError where no polygon emits, receives or is lit.
StudyReference study_reference(const Scene& scene, std::size_t points, const Progress& progress,
                               const StudyRegion& region = {});
/// Full transport on at least so many patches (unknowns), and on a mesh twice as coarse to see how much that matters.
/// Time grows with unknowns times (unknowns + points).
StudyReference study_transport_reference(const Scene& scene, std::size_t points, std::size_t unknowns, int threads,
                                         const Progress& progress, const StudyRegion& region = {});

/// What one run is made with.
struct StudySettings {
    std::string series;  ///< "budget", "threshold", "receiving points", "initial mesh", "height", "margin".
    Refinement refinement = Refinement::none;
    double patch_edge = 0;     ///< Scene units.
    double light_edge = 0;     ///< Of the lights' patches, scene units; 0: patch_edge.
    double minimum_edge = 0;   ///< Of the buffer and of gradients, scene units.
    double threshold = 0.25;   ///< Of gradients.
    int receiving_points = 1;  ///< Of an element: 1, 4 or 16.
    Rational margin = Rational(1, 8), height = Rational(1, 4);

    /// Names the settings; fit for a file name.
    std::string key() const;
};
/// "uniform" for Refinement::none, else its name.
const char* name_in_study(Refinement refinement);

/// Uniform, gradient, buffer and both over budgets that halve the smallest edge (those that refine once more often than
/// uniform); then the gradient's threshold, the receiving points, the initial mesh, the height and the margin. Lights
/// are cut alike in all runs. The coarsest uniform edge is a twelfth of the scene's extent, of full light a sixth.
std::vector<StudySettings> study_plan(const Scene& scene, StudyLight light, int budgets);

struct StudyErrors {
    double l1 = 0, l2 = 0;  ///< Relative: of the difference over that of the reference.
    double most = 0;        ///< Largest difference over the mean of the reference.
};

/// Where the squared error is: in the band or not, on elements refined to (twice) the smallest edge or on larger ones.
/// Shares of the whole.
struct StudyShares {
    double band_fine = 0, band_coarse = 0, smooth_fine = 0, smooth_coarse = 0;
};

struct StudyRun {
    StudySettings settings;
    std::int64_t elements = 0, shots = 0, segments = 0, form_factors = 0, buffers = 0;
    double seconds_least = 0, seconds_median = 0;
    std::uint64_t peak_bytes = 0;  ///< Most memory at any time of the first run, beyond what was held before it.
    StudyErrors all;
    std::optional<StudyErrors> band;  ///< Nothing where no point lies in the band, or no light falls there.
    StudyShares shares;               ///< Of `all`.
};
/// Solves the scene so many times. `alive` is told the shots after each one and may throw to end the run.
StudyRun study_run(const Scene& scene, const StudyReference& reference, const StudySettings& settings, int repeats,
                   int threads, const Progress& alive = {});

/// One line of comma-separated text and back; nothing where the line is not of these settings.
std::string to_line(const StudyRun& run);
std::optional<StudyRun> study_run_from_line(const std::string& line, const StudySettings& settings);

/// For each run: no other has both less time and less error.
std::vector<bool> pareto_front(const std::vector<std::array<double, 2>>& time_and_error);

/// The bar: the error of the finest uniform mesh with 10 times fewer elements and 5 times less time.
struct StudyBar {
    bool in_band = false;                       ///< Of errors in the band; else over all points.
    double target = 0;                          ///< Relative L2 error of the finest uniform mesh,
    StudyRun uniform;                           ///< and that run.
    std::optional<StudyRun> reached;            ///< The run with the buffer that reaches it with fewest elements.
    StudyRun nearest;                           ///< Else the run with the buffer that errs least.
    double elements_ratio = 0, time_ratio = 0;  ///< Uniform over refined; 0 where none reaches it.
    bool met = false;
    std::string reason;  ///< In words and numbers, where not met.
};
/// Over all points, and in the band where there is one. None where no uniform run or none with the buffer is there.
std::vector<StudyBar> study_bars(const StudyReference& reference, const std::vector<StudyRun>& runs);

}  // namespace cob
