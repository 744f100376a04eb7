// Claims about the counters and times of runs.
#include "cob/bench.hpp"
#include "cob/irradiance.hpp"
#include "golden/bench_set.hpp"
#include "radiosity/mesh.hpp"
#include "report/claims_bench.hpp"
#include "report/stress_scene.hpp"
#include "report/study_points.hpp"
#include "report/text.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace cob::claims {
namespace {

// --------------------------------------------------------------------------------------- a room lit indirectly

/// A lamp that faces the ceiling alone, and a sheet above a table: no light reaches the table but by reflection.
Scene indirect_room() {
    stress::Shapes shapes;
    const auto add = [&](const stress::Loop& loop) { shapes.loops.push_back(loop); };
    add({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}});  // floor
    add({{0, 0, 3}, {0, 4, 3}, {4, 4, 3}, {4, 0, 3}});  // ceiling
    add({{0, 0, 0}, {0, 0, 3}, {4, 0, 3}, {4, 0, 0}});  // walls
    add({{4, 0, 0}, {4, 0, 3}, {4, 4, 3}, {4, 4, 0}});
    add({{4, 4, 0}, {4, 4, 3}, {0, 4, 3}, {0, 4, 0}});
    add({{0, 4, 0}, {0, 4, 3}, {0, 0, 3}, {0, 0, 0}});
    add({{1.5, 1.5, 0.0625}, {2.5, 1.5, 0.0625}, {2.5, 2.5, 0.0625}, {1.5, 2.5, 0.0625}});  // sheet, both sides
    add({{1.5, 2.5, 0.0625}, {2.5, 2.5, 0.0625}, {2.5, 1.5, 0.0625}, {1.5, 1.5, 0.0625}});
    add({{0.25, 0.25, 2}, {0.75, 0.25, 2}, {0.75, 0.75, 2}, {0.25, 0.75, 2}});  // lamp, facing up, and its underside
    add({{0.25, 0.75, 2}, {0.75, 0.75, 2}, {0.75, 0.25, 2}, {0.25, 0.25, 2}});
    shapes.lights = {8};
    return scene_of(shapes);
}

void secondary_shooters(Bench& bench, ClaimResult& result) {
    const Scene scene = indirect_room();
    const Roots roots(scene);
    // Points around the sheet's outline on the floor; what they receive by every shot of a run, with many segments.
    std::vector<std::array<double, 2>> points;
    const int per_side = bench.quick() ? 8 : 24;
    for (int k = 0; k < per_side; ++k)
        for (const double across : {-0.06, -0.02, 0.03}) {
            points.push_back({(1.5 + (k + 0.5) / per_side) / 4, (1.5 - across) / 4});
            points.push_back({(2.5 + across) / 4, (1.5 + (k + 0.5) / per_side) / 4});
        }
    std::vector<double> truth;
    std::array<double, 2> errors{};
    std::array<std::size_t, 2> on_floor{};
    double direct = 0;
    for (const Refinement refinement : {Refinement::none, Refinement::buffer}) {
        RadiosityOptions options;
        options.refinement = refinement;
        options.patch_edge = 0.5;
        options.buffer.minimum_edge = bench.quick() ? 0.1 : 0.03;
        options.stop.unshot = bench.quick() ? 0.05 : 0.01;
        options.threads = bench.options().threads;
        RadiositySolver solver(scene, options);
        bench.solve(solver);
        if (truth.empty()) {
            for (const auto& [u, v] : points) {
                const Rgb m = solver.gather(0, u, v, bench.quick() ? 16 : 64);
                truth.push_back(m[0] + m[1] + m[2]);
            }
            const auto candidates = make_candidates(scene, Source::all);
            const IrradianceOracle oracle(scene, *candidates);
            for (const auto& at : points) {
                const PointOnRoot x = point_on_root(scene, roots[0], at);
                for (const PolygonId light : oracle.lights()) direct += oracle(x.position, x.normal, light).visible;
            }
        }
        const ExitanceField field(solver);
        double difference = 0, whole = 0;
        for (std::size_t k = 0; k < points.size(); ++k) {
            const Rgb m = field.at(0, points[k][0], points[k][1]);
            difference += std::pow(m[0] + m[1] + m[2] - truth[k], 2);
            whole += truth[k] * truth[k];
        }
        const std::size_t which = refinement == Refinement::none ? 0 : 1;
        errors[which] = std::sqrt(difference / whole);
        for (const radiosity::NodeId leaf : solver.mesh().leaves())
            on_floor[which] += solver.mesh().node(leaf).element.root == 0 ? 1 : 0;
        bench.tick();
    }
    ClaimCase c;
    c.scene = "a room lit by its ceiling alone, made in code";
    c.value = errors[0] / errors[1];
    c.holds = c.value >= 1.5 && direct == 0;
    c.measured = printed(
        "around the sheet: direct light %g, L2 error %.1f %% without and %.1f %% with the buffer, which "
        "made %zu floor elements of %zu",
        direct, 100 * errors[0], 100 * errors[1], on_floor[1], on_floor[0]);
    result.cases.push_back(std::move(c));
}

// ------------------------------------------------------------------------------------------------ one for all

/// The scene with one of its lights alone, or with all (-1), and reflection all but switched off.
Scene lit_by(const Scene& scene, PolygonId light) {
    Scene::Input input = input_of(dimmed(scene));
    if (light >= 0) {
        Material dark = scene.material(light);
        dark.emitted_exitance = {0, 0, 0};
        dark.reflectance = {0, 0, 0};
        input.materials.push_back(dark);
        for (PolygonId id = 0; id < scene.polygon_count(); ++id)
            if (scene.is_light(id) && id != light)
                input.faces[static_cast<std::size_t>(id)].material =
                    static_cast<std::int32_t>(input.materials.size()) - 1;
    }
    return Scene::build(std::move(input), Scene::Options{true});
}

void one_for_all_lights(Bench& bench, ClaimResult& result) {
    for (const std::string& name : bench.names({"desk", "office"}, 1)) {
        const Scene& scene = bench.scene(name);
        std::vector<PolygonId> lights;
        for (PolygonId id = 0; id < scene.polygon_count(); ++id)
            if (scene.is_light(id)) lights.push_back(id);
        RadiosityOptions options;
        options.refinement = Refinement::buffer;
        options.patch_edge = bench.edge(scene, bench.quick() ? 6 : 12);
        options.buffer.minimum_edge = options.patch_edge / 4;
        options.light_edge = bench.edge(scene, 1);
        options.stop.unshot = 4 * dimming;
        options.threads = bench.options().threads;
        const std::size_t together = bench.run(lit_by(scene, -1), options).buffers;
        std::size_t apart = 0;
        for (const PolygonId light : lights) apart += bench.run(lit_by(scene, light), options).buffers;
        ClaimCase c;
        c.scene = name;
        c.value = static_cast<double>(apart) / static_cast<double>(std::max<std::size_t>(1, together));
        c.holds = lights.size() > 1 && c.value >= 1.2;
        c.measured = printed("%zu lights: %zu buffers for all of them together, %zu for each light by itself",
                             lights.size(), together, apart);
        result.cases.push_back(std::move(c));
    }
}

// ------------------------------------------------------------------------------------------- runs with the buffer

void on_demand(Bench& bench, ClaimResult& result) {
    for (const std::string& name : bench.names({"figure4", "open_box", "desk", "office", "hall"}, 2)) {
        const RunRecord& run = bench.buffer_run(name);
        std::size_t before = 0;
        for (const std::size_t shots : {std::size_t{3}, run.shot_nodes.size()}) {
            if (shots <= before || shots > run.shot_nodes.size()) continue;
            before = shots;
            const std::int64_t nodes = run.shot_nodes[shots - 1], built = run.shot_buffers[shots - 1];
            ClaimCase c;
            c.scene = name + printed(", %zu shots", shots);
            c.value = static_cast<double>(nodes) / static_cast<double>(std::max<std::int64_t>(1, built));
            c.holds = c.value >= 1.2;
            c.measured =
                printed("%lld buffers built, those over whole polygons included, for %lld elements of all levels",
                        static_cast<long long>(built), static_cast<long long>(nodes));
            result.cases.push_back(std::move(c));
        }
    }
}

void bytes_an_element(Bench& bench, ClaimResult& result) {
    for (const std::string& name : bench.names({"figure4", "open_box", "desk", "office", "hall"}, 2)) {
        const RunRecord& run = bench.buffer_run(name);
        ClaimCase c;
        c.scene = name;
        c.value = static_cast<double>(run.buffer_bytes) / static_cast<double>(run.nodes);
        c.holds = c.value <= 5;
        c.measured =
            printed("%zu bytes for each buffer, with its lists %.2f an element", sizeof(CloseObjectBuffer), c.value);
        result.cases.push_back(std::move(c));
    }
}

/// Nanoseconds of a segment with Embree's own triangles, single precision, one thread; 0: built without Embree.
double fastest_segment(const Scene& scene) {
    const stress::Questions questions = stress::ask(scene, 1, Rational(1, 8), Rational(1, 4), 200, 2000);
    BenchSet set{Scene::build(input_of(scene), Scene::Options{true}), nullptr, {}, {}};
    for (const Segment& segment : questions.segments) set.segments["all"].push_back({segment, Visibility::grazing});
    std::vector<BenchRow> rows;
    bench_embree(set, BenchOptions{3, 2000, {}}, rows);
    return rows.empty() ? 0 : rows.front().nanoseconds_min;
}

/// The share of the time that went into buffers, and what it would be with the fastest segments.
ClaimCase buffer_share(const Scene& scene, const std::string& name, const RunRecord& run) {
    const double total = run.times.total(), others = total - run.times.shooting;
    const double fast = 1e-9 * fastest_segment(scene) * static_cast<double>(run.counters.segments);
    ClaimCase c;
    c.scene = name + printed(", %lld shots", static_cast<long long>(run.counters.shots));
    c.value = run.times.buffer / total;
    c.holds = c.value < 0.02;
    c.measured =
        printed("%.2f %% of %.3f s, %zu elements; were segments as fast as Embree's own, %.2f %%", 100 * c.value, total,
                run.elements, 100 * run.times.buffer / (others + std::min(fast, run.times.shooting)));
    return c;
}

void two_percent(Bench& bench, ClaimResult& result) {
    for (const std::string& name : bench.names({"figure4", "open_box", "desk", "office", "hall"}, 2))
        result.cases.push_back(buffer_share(bench.scene(name), name, bench.buffer_run(name)));
    if (bench.quick()) return;
    // Patches and elements about as many as the paper's office has.
    RadiosityOptions options;
    options.patch_edge = 0.3;
    options.buffer.minimum_edge = 0.1;
    options.gradient.minimum_edge = 0.15;
    options.threads = bench.options().threads;
    const Scene& office = bench.scene("office");
    result.cases.push_back(buffer_share(office, "office as the paper's, both refinements", bench.run(office, options)));
}

void first_slower(Bench& bench, ClaimResult& result) {
    ClaimPlot plot{"Time of a shot", "shot", "microseconds for each element at its beginning", false, true, {}};
    for (const std::string& name : bench.names({"open_box", "desk", "office", "hall"}, 1)) {
        const RunRecord& run = bench.buffer_run(name);
        const std::size_t count = run.shot_seconds.size(), tenth = std::max<std::size_t>(1, count / 10);
        const auto sum = [&](std::size_t first, std::size_t last) {
            return std::accumulate(run.shot_seconds.begin() + static_cast<std::ptrdiff_t>(first),
                                   run.shot_seconds.begin() + static_cast<std::ptrdiff_t>(last), 0.0) /
                   static_cast<double>(last - first);
        };
        ClaimCase c;
        c.scene = name;
        c.value = sum(0, tenth) / sum(count / 2, count);
        c.holds = c.value >= 1.2;
        c.measured =
            printed("a shot takes %.2f ms in the first tenth, %.2f ms in the second half, on %lld and %lld elements",
                    1e3 * sum(0, tenth), 1e3 * sum(count / 2, count), static_cast<long long>(run.shot_elements.front()),
                    static_cast<long long>(run.shot_elements.back()));
        ClaimCurve curve{name, {}};
        for (std::size_t k = 0; k < count; ++k)
            curve.points.push_back(
                {static_cast<double>(k + 1), 1e6 * run.shot_seconds[k] / static_cast<double>(run.shot_elements[k])});
        plot.curves.push_back(std::move(curve));
        result.cases.push_back(std::move(c));
    }
    result.plot = std::move(plot);
}

// ------------------------------------------------------------------------------------------- occluded elements

struct WithAndWithout {
    RunRecord with, without;
    double seconds_with = 0, seconds_without = 0;  ///< Of processors, least of three.
};

/// The same run with step 1 and without; on small patches, so that elements fit under things.
WithAndWithout step_1(Bench& bench, const std::string& name) {
    const Scene& scene = bench.scene(name);
    RadiosityOptions options;
    options.refinement = Refinement::buffer;
    options.patch_edge = bench.edge(scene, 16);
    options.buffer.minimum_edge = options.patch_edge / 4;
    options.stop.shots = bench.quick() ? 20 : 60;
    options.threads = bench.options().threads;
    WithAndWithout result;
    for (int repeat = 0; repeat < (bench.quick() ? 1 : 3); ++repeat)
        for (const bool skip : {true, false}) {
            options.buffer.skip_occluded = skip;
            const RunRecord& run =
                bench.run_once(name + printed(", step 1 %s, %d", skip ? "on" : "off", repeat), scene, options);
            double& seconds = skip ? result.seconds_with : result.seconds_without;
            seconds = repeat == 0 ? run.processor_seconds : std::min(seconds, run.processor_seconds);
            (skip ? result.with : result.without) = run;
        }
    return result;
}

void step_1_saves(Bench& bench, ClaimResult& result) {
    for (const std::string& name : bench.names({"figure4", "figure5", "figure6", "open_box", "desk", "office"}, 2)) {
        const WithAndWithout runs = step_1(bench, name);
        const auto share = [](std::int64_t with, std::int64_t without) {
            return without > 0 ? 1 - static_cast<double>(with) / static_cast<double>(without) : 0.0;
        };
        const double form_factors = share(runs.with.counters.form_factors, runs.without.counters.form_factors);
        const double segments = share(runs.with.counters.segments, runs.without.counters.segments);
        ClaimCase c;
        c.scene = name;
        c.value = std::min(form_factors, segments);
        c.holds = c.value >= 0.01;
        c.measured =
            printed("%zu of %zu elements occluded; spares %.1f %% of the form factors, %.1f %% of the segments",
                    runs.with.occluded, runs.with.elements, 100 * form_factors, 100 * segments);
        result.cases.push_back(std::move(c));
    }
}

void occluded_speed_up(Bench& bench, ClaimResult& result) {
    for (const std::string& name : bench.names({"figure4", "figure5", "figure6", "open_box", "desk", "office"}, 2)) {
        const WithAndWithout runs = step_1(bench, name);
        ClaimCase c;
        c.scene = name;
        c.value = runs.seconds_without / runs.seconds_with;
        c.holds = runs.with.occluded > 0 && c.value >= 1.05;
        c.measured = printed("%.1f ms skipping occluded elements (%zu of %zu), %.1f ms shooting at them: %.2f times",
                             1e3 * runs.seconds_with, runs.with.occluded, runs.with.elements,
                             1e3 * runs.seconds_without, c.value);
        result.cases.push_back(std::move(c));
    }
}

}  // namespace

std::vector<Claim> run_claims() {
    return {
        {"secondary-shooters", "The buffer also serves secondary shooters: a room lit indirectly has detail shadows.",
         "section 5", "No light reaches the points directly, and the error there falls by a factor of 1.5 or more.",
         "secondary shooters are strong enough to ask for buffers", secondary_shooters},
        {"all-lights", "One buffer serves all lights.", "sections 3 and 7",
         "Each light by itself asks for at least 1.2 times as many buffers, in sum, as all lights together.",
         "the lights shine on the same elements", one_for_all_lights},
        {"on-demand", "Building on demand saves time against building all buffers.", "section 5",
         "At most 1 / 1.2 of the elements get a buffer.", "not every element meets a strong shooter", on_demand},
        {"five-bytes", "A buffer takes 5 bytes an element.", "sections 3 and 7",
         "All buffers with their lists take at most 5 bytes for each element.",
         "few elements are close to many polygons, so that lists stay short", bytes_an_element},
        {"two-percent", "Buffers take less than 2 % of the time.", "results",
         "Time of building buffers over the time of the run.",
         "the run is long enough to pay for buffers that are built in its first shots", two_percent},
        {"first-slower", "The first iterations are slower than the later ones.", "results",
         "A shot of the first tenth takes at least 1.2 times as long as one of the second half.",
         "what the first shots refine outweighs that later ones have more elements to shoot at", first_slower},
        {"step-1", "Step 1 saves form factors and occlusion tests.", "section 5",
         "At least 1 % of both, against the same run that shoots at occluded elements.",
         "elements lie wholly under something low", step_1_saves},
        {"occluded-faster", "Totally occluded elements speed the solution up.", "results",
         "Some elements are occluded, and the same run without skipping takes 1.05 times the processor time or more.",
         "enough elements are occluded", occluded_speed_up},
    };
}

}  // namespace cob::claims
