// Stiff transport: high reflectance, single precision, lights of very different size, a narrow slit.
#include "arithmetic/process.hpp"
#include "cob/form_factor.hpp"
#include "cob/irradiance.hpp"
#include "cob/solver.hpp"
#include "cob/stress.hpp"
#include "radiosity/mesh.hpp"
#include "report/stress_scene.hpp"
#include "report/text.hpp"

#include <algorithm>
#include <cmath>

namespace cob {
namespace {

using stress::Shapes;

/// The six sides of a room of 1 by 2 by 3, facing inward: no two of its directions are alike.
std::vector<stress::Loop> room() {
    return {{{0, 0, 0}, {1, 0, 0}, {1, 2, 0}, {0, 2, 0}}, {{0, 0, 3}, {0, 2, 3}, {1, 2, 3}, {1, 0, 3}},
            {{0, 0, 0}, {0, 0, 3}, {1, 0, 3}, {1, 0, 0}}, {{0, 2, 0}, {1, 2, 0}, {1, 2, 3}, {0, 2, 3}},
            {{0, 0, 0}, {0, 2, 0}, {0, 2, 3}, {0, 0, 3}}, {{1, 0, 0}, {1, 0, 3}, {1, 2, 3}, {1, 2, 0}}};
}

// ------------------------------------------------------------------------------------------- closed boxes

/// Every side emits 1 W/m2 and reflects rho: the exitance is 1 / (1 - rho) everywhere.
StressRow closed_box(double rho, bool overshoot, std::int64_t most_shots) {
    Shapes shapes{room(), {0, 1, 2, 3, 4, 5}};
    const Scene scene = scene_of(shapes, rho);
    RadiosityOptions options;
    options.refinement = Refinement::none;
    options.patch_edge = 1;
    options.overshoot = overshoot;
    options.receiving_points = 16;
    options.stop.shots = most_shots;
    options.stop.unshot = 1e-6;
    options.threads = 1;  // few elements a shot: nothing to share
    Stopwatch watch;
    RadiositySolver solver(scene, options);
    while (solver.step()) {
    }
    const double seconds = watch.lap();

    const double truth = 1 / (1 - rho);
    double largest = 0, mean = 0;
    for (const std::int32_t leaf : solver.mesh().leaves()) {
        const double exitance = solver.exitance(leaf)[0];
        largest = std::max(largest, std::fabs(exitance / truth - 1));
        mean += exitance / static_cast<double>(solver.element_count());
    }
    const EnergyBooks books = solver.books();
    StressRow row{"stiff", "closed box, rho = " + to_text(rho) + (overshoot ? ", overshooting" : ""),
                  "B = E / (1 - rho) within 1 %; unshot flux 1e-6", "", Verdict::pass};
    row.came_out = printed("B off by %.2e at most, mean by %.2e", largest, mean / truth - 1) +
                   printed("; %.0f shots, %.2f s, unshot %.1e", static_cast<double>(solver.counters().shots), seconds,
                           solver.unshot_share()) +
                   printed("; closure %.6f (%.6f to %.6f); books differ by %.1e", books.closure_mean,
                           books.closure_least, books.closure_most, books.difference());
    const bool reached = solver.unshot_share() <= 1e-6;
    if (!reached || largest > 0.01) row.verdict = Verdict::limit;
    if (!reached) row.came_out += "; ended by the number of shots, which grows as 1 / (1 - rho)";
    if (!std::isfinite(largest) || books.difference() > 1e-9 || !(solver.unshot_share() <= 1))
        row.verdict = Verdict::failed;
    return row;
}

/// Progressive refinement between a cube's sides in the number type T, until the unshot flux is a millionth of the
/// emitted or nothing changes any more. Returns the exitance of a side.
template <class T>
double shoot_between_sides(double rho, std::int64_t* shots) {
    const T opposite = static_cast<T>(0.19982489569838746);  // of two opposite sides of a cube, in closed form
    const T adjacent = (T(1) - opposite) / T(4), reflectance = static_cast<T>(rho);
    std::array<T, 6> exitance, unshot;
    exitance.fill(T(1));
    unshot.fill(T(1));
    for (*shots = 0; *shots < 10000000; ++*shots) {
        const std::size_t shooter =
            static_cast<std::size_t>(std::max_element(unshot.begin(), unshot.end()) - unshot.begin());
        T remaining = 0;
        for (const T u : unshot) remaining += u;
        if (remaining <= static_cast<T>(6e-6)) break;
        const T shot = unshot[shooter];
        unshot[shooter] = 0;
        for (std::size_t side = 0; side < 6; ++side)
            if (side != shooter) {
                const T more = reflectance * (side / 2 == shooter / 2 ? opposite : adjacent) * shot;
                exitance[side] += more;
                unshot[side] += more;
            }
    }
    return static_cast<double>(exitance[0]);
}

StressRow single_precision(double rho) {
    std::int64_t shots_single = 0, shots_double = 0;
    const double truth = 1 / (1 - rho);
    const double single = shoot_between_sides<float>(rho, &shots_single) / truth - 1;
    const double twice = shoot_between_sides<double>(rho, &shots_double) / truth - 1;
    // What is left unshot is missing, too: a millionth of the emitted, times 1 / (1 - rho), of which B is as much.
    StressRow row{"stiff", "single precision, rho = " + to_text(rho), "error of the sum below 1e-5", "", Verdict::pass};
    row.came_out = printed("binary32 off by %.2e after %.0f shots, binary64 by %.2e after %.0f", single,
                           static_cast<double>(shots_single), twice, static_cast<double>(shots_double));
    if (std::fabs(single) > 1e-5) {
        row.verdict = Verdict::limit;
        row.came_out += "; binary32 drops what is below half an ulp of the sum, so solve in binary64";
    }
    if (std::fabs(twice) > 1e-5) row.verdict = Verdict::failed;
    return row;
}

// ----------------------------------------------------------------------------------------- unequal lights

/// A light of side 1e-3 and 1e9 W/m2 beside one of side 0.8 and 1 mW/m2, both under the ceiling: direct light at
/// the floor's elements against closed forms.
StressRow unequal_lights() {
    const stress::Loop tiny{{0.1, 0.1, 0.9}, {0.1, 0.101, 0.9}, {0.101, 0.101, 0.9}, {0.101, 0.1, 0.9}};
    const stress::Loop large{{0.15, 0.15, 0.9}, {0.15, 0.95, 0.9}, {0.95, 0.95, 0.9}, {0.95, 0.15, 0.9}};
    Scene::Input input;
    input.name = "unequal lights";
    input.materials.resize(3);
    input.materials[1].reflectance = input.materials[2].reflectance = {0, 0, 0};  // direct light alone
    input.materials[1].emitted_exitance = {1e9, 1e9, 1e9};
    input.materials[2].emitted_exitance = {1e-3, 1e-3, 1e-3};
    const stress::Loop floor{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    const std::vector<stress::Loop> loops{floor, tiny, large};
    for (std::size_t k = 0; k < loops.size(); ++k) {
        Scene::Face face;
        face.material = static_cast<std::int32_t>(k);
        for (const Point& p : loops[k]) {
            face.corners.push_back(static_cast<VertexId>(input.positions.size()));
            input.positions.push_back(p);
        }
        input.faces.push_back(face);
    }
    const Scene scene = Scene::build(std::move(input));
    RadiosityOptions options;
    options.refinement = Refinement::none;
    options.patch_edge = 0.25;
    options.stop.unshot = 0;
    options.threads = 1;
    RadiositySolver solver(scene, options);
    while (solver.step()) {
    }

    double worst = 0, least_share = 1;
    for (const std::int32_t leaf : solver.mesh().leaves()) {
        const Element& element = solver.mesh().node(leaf).element;
        const Root& root = solver.roots()[element.root];
        if (root.polygon != 0) continue;
        const Point center = point_in(scene, root, element, 0.5, 0.5).nearest();
        const auto part = [&](const stress::Loop& loop, double exitance) {
            return 0.5 * exitance * precise_form_factor(center, {0, 0, 1}, {loop.data(), loop.data() + 4}).value;
        };
        const double bright = part(tiny, 1e9), dim = part(large, 1e-3);
        worst = std::max(worst, std::fabs(solver.exitance(leaf)[0] / (bright + dim) - 1));
        least_share = std::min(least_share, dim / (bright + dim));
    }
    StressRow row{"stiff", "a light of side 1e-3 and 1e9 W/m2 beside one of side 0.8 and 1e-3 W/m2",
                  "direct light within 1e-9, relative", "", Verdict::pass};
    row.came_out = printed("off by %.2e at most; the dim light is down to %.1e of it; %.0f shots", worst, least_share,
                           static_cast<double>(solver.counters().shots));
    if (!(worst < 1e-9)) row.verdict = Verdict::limit;
    return row;
}

// --------------------------------------------------------------------------------------------------- slit

/// Two sheets at half height leave a slit of this width under a square light. On the floor, straight below, what is
/// seen of the light is a strip twice as wide.
StressRow slit(double width) {
    const double w = width / 2;
    Shapes shapes;
    shapes.loops = {{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}},
                    {{-4, -4, 0.5}, {-w, -4, 0.5}, {-w, 4, 0.5}, {-4, 4, 0.5}},
                    {{w, -4, 0.5}, {4, -4, 0.5}, {4, 4, 0.5}, {w, 4, 0.5}},
                    {{-0.5, -0.5, 1}, {-0.5, 0.5, 1}, {0.5, 0.5, 1}, {0.5, -0.5, 1}}};
    shapes.lights = {3};
    const Scene scene = scene_of(shapes);
    const std::unique_ptr<CandidateSource> candidates = make_candidates(scene, Source::tree);
    const LightAtPoint light = IrradianceOracle(scene, *candidates)(Point{0, 0, 0}, to_rational({0, 0, 1}), 3);
    const stress::Loop strip{{-width, -0.5, 1}, {-width, 0.5, 1}, {width, 0.5, 1}, {width, -0.5, 1}};
    const double truth = precise_form_factor({0, 0, 0}, {0, 0, 1}, {strip.data(), strip.data() + 4}).value;
    const double off = light.visible / truth - 1;

    // The same by the shooter's sample points, as the solver sees it: eight across, none of them in line with it.
    RadiosityOptions options;
    options.refinement = Refinement::none;
    options.patch_edge = 2;
    options.samples = 64;
    options.mixed_samples = 64;
    options.stop.shots = 1;
    options.threads = 1;
    RadiositySolver solver(scene, options);
    while (solver.step()) {
    }
    double floor = 0;
    for (const std::int32_t leaf : solver.mesh().leaves())
        if (solver.roots()[solver.mesh().node(leaf).element.root].polygon == 0) floor = solver.exitance(leaf)[0];

    StressRow row{"stiff", printed("slit of %.0e", width),
                  "exact irradiance within 1e-9, relative; the solver's 64 samples within 10 %", "", Verdict::pass};
    row.came_out = printed("form factor %.6e, exact irradiance off by %.1e; by 64 samples off by %.1e", truth, off,
                           floor / (0.5 * truth) - 1);
    if (std::fabs(floor / (0.5 * truth) - 1) > 0.1) {
        row.verdict = Verdict::limit;
        row.came_out += "; no sample point lies in line with the slit, so ask the exact irradiance";
    }
    if (!(std::fabs(off) < 1e-9)) row.verdict = Verdict::failed;
    return row;
}

}  // namespace

std::vector<StressRow> stress_stiff(const StressOptions& options) {
    std::vector<StressRow> rows;
    const auto add = [&](StressRow row) {
        rows.push_back(std::move(row));
        if (options.progress) options.progress(rows.size(), 0);
    };
    const std::int64_t most_shots = options.quick ? 2000 : 20000;
    for (const double rho : {0.5, 0.9, 0.99, 0.999, 0.9999})
        if (!options.quick || rho <= 0.9)
            for (const bool overshoot : {false, true}) add(closed_box(rho, overshoot, most_shots));
    for (const double rho : {0.5, 0.9, 0.99, 0.999, 0.9999})
        if (!options.quick || rho >= 0.999) add(single_precision(rho));
    add(unequal_lights());
    for (const double width : {1e-2, 1e-4, 1e-8})
        if (!options.quick || width == 1e-4) add(slit(width));
    return rows;
}

}  // namespace cob
