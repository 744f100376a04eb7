/// \file
/// Progressive refinement radiosity with the Close Object Buffer inside (the paper's sections 4 to 8; SPEC section 8).
///
///     RadiositySolver solver(scene, options);
///     while (solver.step()) {}
///     solver.exitance(leaf), solver.counters(), solver.books(), ...
#pragma once

#include "cob/arithmetic.hpp"
#include "cob/buffer.hpp"
#include "cob/geometry.hpp"
#include "cob/omissions.hpp"
#include "cob/scene.hpp"

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace cob {

namespace radiosity {
class Mesh;
}

/// Red, green, blue; W/m2 where it is exitance or irradiance, W where it is flux.
using Rgb = std::array<double, 3>;

/// Which refinement is on.
enum class Refinement : std::uint8_t { none, gradient, buffer, both };
const char* to_text(Refinement refinement);
/// Strength of an interaction (SPEC 8, choice 7).
enum class Strength : std::uint8_t {
    exitance,  ///< Unobstructed dM_i, summed over channels, as a share of M_i.
    flux,      ///< Unobstructed A_i dM_i, summed over channels, as a share of the shooter's flux A_j dM_j.
    paper,     ///< Equation (1) as printed: reflectance times the form factor from centre to centre.
};
const char* to_text(Strength strength);

struct RadiosityOptions {
    Refinement refinement = Refinement::both;
    double patch_edge = 0;  ///< Longest side of a patch, scene units; 0: a twelfth of the scene's longest extent.
    double light_edge = 0;  ///< The same for polygons that emit; 0: patch_edge.

    /// The buffer's refinement.
    struct Buffer {
        Rational margin = Rational(1, 8), height = Rational(1, 4);  ///< SPEC 4.
        double minimum_edge = 0;  ///< Elements with no longer side are not refined; 0: patch_edge / 16.
        Strength strength = Strength::exitance;
        double threshold = 0.05;  ///< Weaker interactions do not refine.
        BufferLevels levels = BufferLevels::tree;
        BufferMode mode = BufferMode::strict;
        bool skip_occluded = true;  ///< Step 1; false: shoot at occluded elements, too, to see what step 1 saves.
    } buffer;

    /// Refinement where the exitance at an element's corners differs by more than threshold times its mean.
    struct Gradient {
        Rgb threshold{0.25, 0.25, 0.25};
        double minimum_edge = 0;  ///< 0: patch_edge / 8.
        double floor = 0.05;      ///< The mean counts as no less than this share of the scene's mean exitance.
    } gradient;

    /// Whatever comes first ends the run.
    struct Stop {
        std::int64_t shots = 300;
        std::int64_t elements = std::numeric_limits<std::int64_t>::max();
        double unshot = 1e-3;  ///< Share of the emitted flux that is still to be shot.
    } stop;

    int samples = 4;           ///< Points of the shooter seen from each receiving point; 1, 4, 16 or 64.
    int mixed_samples = 16;    ///< Instead, where some but not all of these are blocked.
    int receiving_points = 1;  ///< Points of an element that receive: 1 (its centroid), 4 or 16.
    bool overshoot = false;    ///< Shoot what is going to arrive, too, as far as the ambient term foresees it.
    OmissionSet keep;          ///< What is done although the scene does not need it; same result, more time.
    int threads = 0;           ///< 0: as many as the machine has.
};

/// What was done; independent of the number of threads.
struct RadiosityCounters {
    std::int64_t shots = 0;
    std::int64_t interactions = 0;       ///< Elements shot at.
    std::int64_t form_factors = 0;       ///< Closed forms evaluated.
    std::int64_t segments = 0;           ///< Pairs of sample points decided.
    std::int64_t oracle_segments = 0;    ///< Of these, by the exact oracle; the rest were certain in binary64.
    std::int64_t segments_left_out = 0;  ///< Not needed: nothing can stand between (a convex scene, an empty shaft).
    std::int64_t skipped_occluded = 0;   ///< Step 1: shots spared at totally occluded elements.
    std::int64_t put_aside = 0;          ///< Step 3: elements refined by the buffer.
    std::int64_t refined_by_gradient = 0;
    std::int64_t refined_for_balance = 0;
    std::int64_t resampled = 0;             ///< Earlier shots sampled anew at children.
    std::array<std::int64_t, 4> buffers{};  ///< Built, by BufferState, of elements and of roots.
    std::int64_t buffers_left_out = 0;      ///< Known to be empty without: no polygon is near another.
    std::int64_t light_tests = 0;           ///< Facing tests of lights.
};

/// Wall-clock seconds by phase.
struct RadiosityTimes {
    double meshing = 0;      ///< Roots, patches, trees, sheets in one plane.
    double interaction = 0;  ///< Steps 1 and 2: unobstructed form factors.
    double buffer = 0;       ///< Step 3: building buffers.
    double shooting = 0;     ///< Visibility and exchange.
    double refinement = 0;   ///< Splitting elements and what children take over.
    double gradient = 0;     ///< Vertex exitance and gradients.
    double total() const { return meshing + interaction + buffer + shooting + refinement + gradient; }
};

/// The two books: nothing is ever renormalised.
struct EnergyBooks {
    // Bookkeeping: both sums say how much flux has been made so far, in 2^exponent W; they differ by rounding only.
    Rgb by_elements{};  ///< Sum of A_i M_i over elements.
    Rgb by_patches{};   ///< Sum over patches of the flux shot and unshot.
    int exponent = 0;   ///< Binary: W itself may leave binary64 where lengths do not.
    /// Largest relative difference of the two over channels.
    double difference() const;
    // Closure of the form factors: flux given over flux taken, per shot; 1 in a closed scene that is sampled
    // perfectly. Subdivision and sampling anew move flux; `moved` says how much, as a share of all flux given.
    double closure_mean = 0, closure_least = 0, closure_most = 0;
    double closure_flux = 0;  ///< The same of all flux together: what is off by it is missing or too much in the scene.
    double closure_error = 0;  ///< Mean distance from 1, each shot by its flux: falls with the mesh in a closed scene.
    std::int32_t closure_least_patch = -1, closure_most_patch = -1;  ///< Which patches shot least and most completely.
    double moved = 0;
};

class RadiositySolver {
public:
    /// Cuts the patches. The scene must outlive it. Throws InputError: no light that shines, reflectance of 1 and the
    /// like.
    RadiositySolver(const Scene& scene, RadiosityOptions options);
    ~RadiositySolver();
    RadiositySolver(RadiositySolver&&) noexcept;

    /// One shot and all that follows from it. False, and nothing done, where a stop is reached.
    bool step();
    /// Share of the emitted flux that is still to be shot.
    double unshot_share() const;

    const RadiosityOptions& options() const;  ///< With every default filled in.
    const RadiosityCounters& counters() const;
    const RadiosityTimes& times() const;
    EnergyBooks books() const;
    const radiosity::Mesh& mesh() const;
    const Roots& roots() const;

    std::size_t element_count() const;  ///< Leaves.
    std::size_t patch_count() const;
    /// Leaves by refinements below their patch.
    std::vector<std::size_t> elements_by_level() const;
    BufferState buffer_state(std::int32_t node) const;
    /// Wholly under a sheet in its own plane (SPEC 8, choice 9).
    bool hidden(std::int32_t node) const;
    /// The first polygon lies on top of the second in its plane.
    bool lies_on(PolygonId top, PolygonId under) const;
    /// Bytes of all buffers, lists included, and how many elements have had one.
    std::size_t buffer_bytes() const;
    std::size_t buffer_count() const;

    /// Exitance of one leaf, W/m2 per channel.
    Rgb exitance(std::int32_t leaf) const;
    /// A leaf's outline in order: vertex of the mesh, and 2 k at corner k or 2 k + 1 at the T-vertex after it.
    std::vector<std::array<std::int32_t, 2>> outline(std::int32_t leaf) const;
    /// At every vertex of the mesh, from the elements around it on the same polygon.
    std::vector<Rgb> vertex_exitance() const;
    /// What the same shots bring to one point, at bilinear (of a triangle: barycentric) coordinates of a root, with so
    /// many samples (4, 16, 64, ...) of each shooter: exitance that no mesh has smeared. Slow.
    Rgb gather(RootId root, double u, double v, int samples) const;
    /// The ambient term: what the unshot flux would add to each exitance, per unit of reflectance.
    Rgb ambient() const;
    /// What the scene lets the solver leave out, and why.
    const Omissions& omissions() const;

    /// A checkpoint of the whole state; resuming gives the same bytes as going on. Throws InputError where the
    /// text belongs to another scene or other options, or is damaged.
    std::string checkpoint() const;
    void resume(const std::string& checkpoint);

private:
    class State;
    std::unique_ptr<State> state_;
};

/// Exitance anywhere on the visible sides, interpolated over the mesh without cracks: within an element linearly in
/// triangles around its centre where a neighbour is finer, else bilinearly between its corners.
class ExitanceField {
public:
    explicit ExitanceField(const RadiositySolver& solver);
    /// At bilinear (of a triangle: barycentric) coordinates of a root.
    Rgb at(RootId root, double u, double v) const;
    /// At a point on or near a polygon: of its root that the point lies in.
    Rgb at(PolygonId polygon, const Point& point) const;
    const std::vector<Rgb>& vertices() const { return vertices_; }

private:
    Rgb in_leaf(std::int32_t leaf, double u, double v) const;

    const RadiositySolver& solver_;
    std::vector<Rgb> vertices_;
    std::vector<std::vector<std::array<std::int32_t, 2>>> outlines_;  ///< By node.
};

/// Bilinear (of a triangle: barycentric) coordinates of a point of a root's plane.
std::array<double, 2> root_coordinates(const Scene& scene, const Root& root, const Point& point);

}  // namespace cob
