// Claims about what is truly seen of the lights.
#include "cob/files.hpp"
#include "cob/irradiance.hpp"
#include "radiosity/mesh.hpp"
#include "report/claims_bench.hpp"
#include "report/stress_scene.hpp"
#include "report/study_points.hpp"
#include "report/text.hpp"
#include "report/truth_report.hpp"

#include <algorithm>
#include <cmath>

namespace cob::claims {
namespace {

// ----------------------------------------------------------------------------------------------------- penumbra

/// A strip of light, `tilt` times as steep as wide, over a half-plane at some height over a floor; all so long that
/// their ends do not matter.
Scene half_plane(double light_width, double light_height, double occluder_height, double tilt) {
    constexpr double far = 1e4;
    const double x = light_width / 2, rise = tilt * x;
    stress::Shapes shapes;
    shapes.loops = {{{-far, -far, 0}, {far, -far, 0}, {far, far, 0}, {-far, far, 0}},
                    {{-far, -far, occluder_height},
                     {0, -far, occluder_height},
                     {0, far, occluder_height},
                     {-far, far, occluder_height}},
                    {{-x, -far, light_height - rise},
                     {-x, far, light_height - rise},
                     {x, far, light_height + rise},
                     {x, -far, light_height + rise}}};
    shapes.lights = {2};
    return scene_of(shapes);
}

/// Where along x the seen share of the light passes from at most `share` to more: bisection.
double switch_at(const IrradianceOracle& oracle, double low, double high, double share) {
    for (int step = 0; step < 48; ++step) {
        const double middle = (low + high) / 2;
        const LightAtPoint seen = oracle(Point{middle, 0, 0}, RationalPoint{0, 0, 1}, oracle.lights().front());
        (seen.visible <= share * seen.unobstructed ? low : high) = middle;
    }
    return (low + high) / 2;
}

void penumbra(Bench& bench, ClaimResult& result) {
    constexpr double light = 0.5, above = 2;
    ClaimPlot plot{"Width of the penumbra",
                   "height of the occluder h over that of the light H",
                   "width",
                   true,
                   true,
                   {{"measured", {}}, {"h L / (H - h)", {}}}};
    for (const double tilt : {0.0, 1.0})
        for (const double h :
             bench.quick() ? std::vector<double>{0.0625} : std::vector<double>{0.015625, 0.0625, 0.25, 1}) {
            const Scene scene = half_plane(light, above, h, tilt);
            const auto candidates = make_candidates(scene, Source::all);
            const IrradianceOracle oracle(scene, *candidates);
            const double begin = switch_at(oracle, -8, 8, 0), end = switch_at(oracle, -8, 8, 1 - 1e-12);
            const double foretold = h * light / (above - h), width = end - begin;
            if (tilt == 0) {
                plot.curves[0].points.push_back({h / above, width});
                plot.curves[1].points.push_back({h / above, foretold});
            }
            ClaimCase c;
            c.scene = printed("half-plane at h = H / %g under a light %s the floor", above / h,
                              tilt == 0 ? "parallel to" : "at 45 degrees to");
            c.value = std::fabs(width / foretold - 1);
            c.holds = c.value < 1e-3;
            c.measured = printed("width %.6g, formula %.6g: %.2g %% apart", width, foretold, 100 * c.value);
            result.cases.push_back(std::move(c));
            bench.tick();
        }
    result.plot = std::move(plot);
}

// --------------------------------------------------------------------------------------------- tangential light

/// Direct light at five points of each occluded element.
void tangential(Bench& bench, ClaimResult& result) {
    for (const std::string& name : bench.names({"figure4", "figure5", "figure6", "open_box", "desk"}, 3)) {
        const Scene& scene = bench.scene(name);
        const StudyReference reference = study_reference(scene, 100, bench.options().progress);
        RadiosityOptions options;
        options.refinement = Refinement::buffer;
        options.patch_edge = bench.edge(scene, name == "desk" ? 32 : 8);
        options.buffer.minimum_edge = options.patch_edge / 4;
        options.stop.shots = bench.quick() ? 20 : 60;
        options.threads = bench.options().threads;
        RadiositySolver solver(scene, options);
        bench.solve(solver);
        const auto candidates = make_candidates(scene, Source::tree);
        const IrradianceOracle oracle(scene, *candidates);
        double mean = 0;
        for (const StudyPoint& point : reference.points)
            mean += point.irradiance / static_cast<double>(reference.points.size());

        const radiosity::Mesh& mesh = solver.mesh();
        std::size_t occluded = 0, lit = 0;
        double most = 0, sum = 0;
        for (const radiosity::NodeId leaf : mesh.leaves()) {
            if (solver.buffer_state(leaf) != BufferState::occluded) continue;
            ++occluded;
            const radiosity::Node& node = mesh.node(leaf);
            const Root& root = solver.roots()[node.element.root];
            const RationalPoint normal = point_on_root(scene, root, {0, 0}).normal;
            double highest = 0;
            const std::vector<std::array<double, 2>> places{
                {0.3125, 0.3125}, {0.03125, 0.03125}, {0.9375, 0.03125}, {0.03125, 0.9375}, {0.46875, 0.46875}};
            for (const auto& [s, t] : places) {
                double irradiance = 0;
                const ExactPoint x = point_in(scene, root, node.element, s, t);
                for (const PolygonId light : oracle.lights()) {
                    const Rgb& emitted = scene.material(light).emitted_exitance;
                    irradiance += oracle(x, normal, light).visible * (emitted[0] + emitted[1] + emitted[2]);
                }
                highest = std::max(highest, irradiance);
                sum += irradiance / static_cast<double>(places.size());
            }
            lit += highest > 0 ? 1 : 0;
            most = std::max(most, highest);
        }
        bench.tick();
        if (occluded == 0) continue;  // says nothing
        ClaimCase c;
        c.scene = name;
        c.value = most / mean;
        c.holds = c.value <= 0.05;
        c.measured = printed(
            "%zu occluded elements, %zu of them lit all the same: %.2f %% of the scene's mean irradiance at "
            "most, %.2f %% on average",
            occluded, lit, 100 * c.value, 100 * sum / static_cast<double>(occluded) / mean);
        result.cases.push_back(std::move(c));
    }
}

// ---------------------------------------------------------------------------------------------------- in vain

void in_vain(Bench& bench, ClaimResult& result) {
    for (const std::string& name :
         bench.names({"figure3", "figure4", "figure2", "figure5", "figure6", "figure7", "open_box", "desk"}, 2)) {
        const Scene& scene = bench.scene(name);
        const Roots roots(scene);
        const ElementList elements(scene, roots, {bench.edge(scene, 16), 0});
        const auto candidates = make_candidates(scene, Source::tree);
        TruthOptions options;
        options.classify.relations = false;
        options.max_pairs = bench.quick() ? 60 : 250;
        options.threads = bench.options().threads;
        options.progress = bench.options().progress;
        const TruthSummary truth =
            write_truth(elements, *candidates, bench.options().folder + "/truth/" + name, options);
        ClaimCase c;
        c.scene = name;
        c.value = truth.close > 0 ? static_cast<double>(truth.refined_in_vain) / static_cast<double>(truth.close) : 0;
        c.holds = c.value <= 0.1;
        c.measured = printed(
            "%llu of %llu elements that the buffer refines have no shadow boundary (%.0f %%); of all %llu "
            "elements that is %.1f %%",
            static_cast<unsigned long long>(truth.refined_in_vain), static_cast<unsigned long long>(truth.close),
            100 * c.value, static_cast<unsigned long long>(truth.sampled),
            100 * static_cast<double>(truth.refined_in_vain) / static_cast<double>(truth.sampled));
        result.cases.push_back(std::move(c));
        bench.tick();
    }
}

}  // namespace

std::vector<Claim> sight_claims() {
    return {
        {"penumbra", "An occluder near the receiver casts a sharper shadow: the penumbra is w = h L / (H - h) wide.",
         "motivation", "The measured width is within a thousandth of the formula.",
         "the light is parallel to the receiver; tilted, its ends have two heights H", penumbra},
        {"tangential", "Light that reaches a totally occluded element tangentially can be ignored.", "figure 5",
         "No point of an occluded element receives more than 5 % of the scene's mean irradiance.",
         "other light than tangential falls on the scene", tangential},
        {"in-vain", "Subdivision in vain is rare.", "figure 3",
         "At most 10 % of the elements that the buffer refines have no shadow boundary of any light.",
         "what is close stands between the element and a light; not at shared edges and beside things", in_vain},
    };
}

}  // namespace cob::claims
