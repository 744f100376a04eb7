// Claims about buffers alone: what they hold and what building them costs. No light is needed for these.
#include "arithmetic/process.hpp"
#include "cob/classify.hpp"
#include "geometry/candidate_list.hpp"
#include "geometry/relation_alone.hpp"
#include "radiosity/mesh.hpp"
#include "report/claims_bench.hpp"
#include "report/stress_scene.hpp"
#include "report/text.hpp"

#include <algorithm>
#include <iterator>

namespace cob::claims {
namespace {

/// A large floor under many small sheets, in rows of so many: one root that everything is close to.
Scene floor_of_details(int per_side) {
    stress::Shapes shapes;
    const double side = per_side;
    shapes.loops.push_back({{0, 0, 0}, {side, 0, 0}, {side, side, 0}, {0, side, 0}});
    for (int i = 0; i < per_side; ++i)
        for (int j = 0; j < per_side; ++j) {
            const double x = i + 0.25, y = j + 0.25, z = 0.03125;
            shapes.loops.push_back({{x, y, z}, {x + 0.5, y, z}, {x + 0.5, y + 0.5, z}, {x, y + 0.5, z}});
        }
    shapes.loops.push_back({{0, 0, 4}, {0, 1, 4}, {1, 1, 4}, {1, 0, 4}});
    shapes.lights = {static_cast<PolygonId>(shapes.loops.size()) - 1};
    return scene_of(shapes);
}

/// A scene with the meshing on which its buffers are built.
struct BufferScene {
    std::string name;
    const Scene* scene;
    Meshing meshing;
};

std::vector<BufferScene> shipped(Bench& bench, std::vector<std::string> names) {
    std::vector<BufferScene> scenes;
    for (const std::string& name : bench.names(std::move(names), 1)) {
        const Scene& scene = bench.scene(name);
        scenes.push_back({name, &scene, {bench.edge(scene, 12), bench.quick() ? 1 : 2}});
    }
    return scenes;
}

ClassifyOptions states_only(BufferLevels levels) {
    ClassifyOptions options;
    options.levels = levels;
    options.relations = false;
    return options;
}

// -------------------------------------------------------------------------------------------------- two levels

/// Seconds of one thread for the states of up to so many elements, and how many they were.
struct ClassifyTime {
    double seconds = 0;
    std::uint64_t elements = 0;
    double microseconds() const { return 1e6 * seconds / static_cast<double>(elements); }
};

ClassifyTime classify_time(const ElementList& elements, Source source, BufferLevels levels, double least_seconds) {
    const auto candidates = make_candidates(elements.scene(), source);
    const ClassifyOptions options = states_only(levels);
    ClassifiedElement found;
    {
        ElementClassifier warm_up(elements, *candidates, options);  // trees are built when they are first asked
        warm_up(0, found);
    }
    ElementClassifier classifier(elements, *candidates, options);
    ClassifyTime time;
    const double before = processor_seconds();
    for (std::uint64_t k = 0; k < elements.size(); ++k) {
        classifier(k, found);
        ++time.elements;
        if (k % 64 == 63) {
            time.seconds = processor_seconds() - before;
            if (time.seconds > least_seconds) return time;
        }
    }
    time.seconds = processor_seconds() - before;
    return time;
}

void two_levels(Bench& bench, ClaimResult& result) {
    std::vector<BufferScene> scenes = shipped(bench, {"figure7", "open_box", "desk", "office", "hall"});
    const Scene made = floor_of_details(bench.quick() ? 8 : 50);
    scenes.push_back({printed("one floor under %d details", made.polygon_count() - 2), &made, {1, 1}});
    for (const BufferScene& s : scenes) {
        const Roots roots(*s.scene);
        const ElementList elements(*s.scene, roots, s.meshing);
        const double seconds = bench.quick() ? 0.02 : 0.5;
        const auto measure = [&](Source source, BufferLevels levels) {
            return classify_time(elements, source, levels, seconds).microseconds();
        };
        const double one = measure(Source::tree, BufferLevels::element);
        const double two = measure(Source::tree, BufferLevels::polygon);
        const double octree = measure(Source::octree, BufferLevels::element);
        const double brute = measure(Source::all, BufferLevels::element);
        ClaimCase c;
        c.scene = s.name;
        c.value = std::min({one, octree, brute}) / two;
        c.holds = c.value > 1;
        c.measured = printed("microseconds an element: two levels %.2f, one level %.2f, octree %.2f, brute force %.2f",
                             two, one, octree, brute);
        result.cases.push_back(std::move(c));
        bench.tick();
    }
}

// --------------------------------------------------------------------------------------------------- neighbours

double jaccard(const std::vector<PolygonId>& a, const std::vector<PolygonId>& b) {
    std::vector<PolygonId> both;
    std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both));
    return static_cast<double>(both.size()) / static_cast<double>(a.size() + b.size() - both.size());
}

void neighbours_alike(Bench& bench, ClaimResult& result) {
    for (const BufferScene& s : shipped(bench, {"figure7", "open_box", "desk", "office", "hall"})) {
        const Roots roots(*s.scene);
        const ElementList elements(*s.scene, roots, s.meshing);
        const auto candidates = make_candidates(*s.scene, Source::tree);
        const ClassifyOptions options = states_only(BufferLevels::tree);
        ElementClassifier classifier(elements, *candidates, options);
        std::array<std::vector<PolygonId>, 4> lists;
        std::array<BufferState, 4> states{};
        ClassifiedElement found;
        std::uint64_t pairs = 0, same_state = 0, with_list = 0;
        double alike = 0;
        for (std::uint64_t k = 0; k < elements.size(); ++k) {
            classifier(k, found);
            lists[k % 4] = found.found.close;
            states[k % 4] = found.found.state;
            if (k % 4 != 3) continue;
            // Four children of one parent: of a quadrilateral each borders the next, of a triangle each the last.
            const bool triangle = elements.root_of(found.element).corner_count() == 3;
            for (std::size_t child = 0; child < (triangle ? 3U : 4U); ++child) {
                const std::size_t other = triangle ? 3 : (child + 1) % 4;
                ++pairs;
                same_state += states[child] == states[other] ? 1 : 0;
                if (lists[child].empty() && lists[other].empty()) continue;
                ++with_list;
                alike += jaccard(lists[child], lists[other]);
            }
        }
        ClaimCase by_state;
        by_state.scene = s.name + ", states";
        by_state.value = static_cast<double>(same_state) / static_cast<double>(pairs);
        by_state.holds = by_state.value >= 0.8;
        by_state.measured = printed("%.1f %% of %llu pairs have one state", 100 * by_state.value,
                                    static_cast<unsigned long long>(pairs));
        result.cases.push_back(std::move(by_state));
        ClaimCase by_list;
        by_list.scene = s.name + ", lists";
        by_list.value = with_list > 0 ? alike / static_cast<double>(with_list) : 1;
        by_list.holds = by_list.value >= 0.5;
        by_list.measured = printed("of %llu pairs that store polygons each shares %.0f %% of them on average",
                                   static_cast<unsigned long long>(with_list), 100 * by_list.value);
        result.cases.push_back(std::move(by_list));
        bench.tick();
    }
}

// --------------------------------------------------------------------------------------------------- cover test

void cover_test(Bench& bench, ClaimResult& result) {
    for (const BufferScene& s : shipped(bench, {"figure4", "open_box", "desk", "office", "hall"})) {
        // Boxes and the polygons that the tree names for them, of up to so many elements evenly picked.
        const Roots roots(*s.scene);
        const ElementList elements(*s.scene, roots, s.meshing);
        const auto candidates = make_candidates(*s.scene, Source::tree);
        const std::uint64_t stride = std::max<std::uint64_t>(1, elements.size() / (bench.quick() ? 100 : 2000));
        std::vector<Box> boxes;
        std::vector<std::vector<PolygonId>> named;
        for (std::uint64_t k = 0; k < elements.size(); k += stride) {
            const Element element = elements[k];
            boxes.emplace_back(
                box_question(*s.scene, elements.root_of(element), element, Rational(1, 8), Rational(1, 4)));
            named.push_back(polygons_in(*candidates, boxes.back().bounds()));
        }
        std::uint64_t tested = 0, close = 0;
        const auto all = [&](bool with_cover) {
            const double before = processor_seconds();
            tested = close = 0;
            for (std::size_t b = 0; b < boxes.size(); ++b)
                for (const PolygonId polygon : named[b]) {
                    if (polygon == boxes[b].polygon()) continue;
                    ++tested;
                    const Relation relation = with_cover ? relate(*s.scene, polygon, boxes[b]).relation
                                                         : relation_alone(*s.scene, polygon, boxes[b]);
                    close += is_close(relation) ? 1 : 0;
                }
            return processor_seconds() - before;
        };
        double with = 0, without = 0;
        for (int repeat = 0; repeat < (bench.quick() ? 1 : 5); ++repeat) {
            const double t = all(true), u = all(false);
            with = repeat == 0 ? t : std::min(with, t);
            without = repeat == 0 ? u : std::min(without, u);
        }
        ClaimCase c;
        c.scene = s.name;
        c.value = with / without - 1;
        c.holds = c.value <= 0.1;
        c.measured =
            printed("%.1f %% on top of the relation: %llu of %llu candidates are close and tested for it",
                    100 * c.value, static_cast<unsigned long long>(close), static_cast<unsigned long long>(tested));
        result.cases.push_back(std::move(c));
        bench.tick();
    }
}

// ------------------------------------------------------------------------------------------------------- sheets

/// A table with a sheet over it at some height (0: on it, exactly), and a light.
Scene sheet_on_table(double height) {
    stress::Shapes shapes;
    shapes.loops = {
        {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
        {{0.1875, 0.1875, height}, {0.8125, 0.1875, height}, {0.8125, 0.8125, height}, {0.1875, 0.8125, height}},
        {{0.375, 0.375, 2}, {0.375, 0.625, 2}, {0.625, 0.625, 2}, {0.625, 0.375, 2}}};
    shapes.lights = {2};
    return scene_of(shapes);
}

void sheets_cost_one(Bench& bench, ClaimResult& result) {
    for (const double height : {0.0, 0.001, 0.015625, 0.0625}) {
        const Scene scene = sheet_on_table(height);
        RadiosityOptions options;
        options.refinement = Refinement::buffer;
        constexpr double patch = 0.0625;
        options.patch_edge = patch;
        options.buffer.minimum_edge = patch / 8;
        options.stop.shots = bench.quick() ? 20 : 60;
        options.threads = bench.options().threads;
        RadiositySolver solver(scene, options);
        bench.solve(solver);
        // Patches of the table whose boxes lie wholly under the sheet: the buffers in them, and what they became.
        const double low = 0.1875 + patch / 8, high = 0.8125 - patch / 8;
        const radiosity::Mesh& mesh = solver.mesh();
        std::size_t patches = 0, built = 0, leaves = 0;
        const auto [first, last] = mesh.patches_of(0);
        for (std::size_t n = 0; n < mesh.nodes().size(); ++n) {
            const radiosity::Node& node = mesh.nodes()[n];
            if (node.patch < first || node.patch >= last) continue;
            const radiosity::Node& around = mesh.node(node.patch);
            bool under = true;
            for (const radiosity::MeshVertexId corner : around.corners) {
                const Point p = mesh.in_scene(mesh.vertices()[static_cast<std::size_t>(corner)].position);
                under = under && p.x >= low && p.x <= high && p.y >= low && p.y <= high;
            }
            if (!under) continue;
            patches += node.parent < 0 ? 1 : 0;
            built += solver.buffer_state(static_cast<radiosity::NodeId>(n)) != BufferState::uninitialised ? 1 : 0;
            leaves += node.is_leaf() ? 1 : 0;
        }
        ClaimCase c;
        c.scene = printed("sheet %g above the table, patches of 1/16", height);
        c.value = static_cast<double>(built) / static_cast<double>(std::max<std::size_t>(1, patches));
        c.holds = patches > 0 && c.value <= 1;
        c.measured = printed(
            "%zu patches with their margin under the sheet: %zu buffers built in them in %lld shots, %zu elements left",
            patches, built, static_cast<long long>(solver.counters().shots), leaves);
        result.cases.push_back(std::move(c));
        bench.tick();
    }
}

}  // namespace

std::vector<Claim> buffer_claims() {
    return {
        {"two-levels", "The two-level buffer beats one level, an octree and brute force.", "section 7",
         "Time of one thread for the states of all elements: two levels take the least.",
         "there are few polygons around each root; not on one large floor under many details", two_levels},
        {"neighbours", "Neighbouring elements have similar buffers.", "section 7",
         "Of siblings 80 % have one state; where one stores polygons they share half of them on average.",
         "states are meant: of the polygons that they store neighbours share less than half", neighbours_alike},
        {"cover-test", "The test for total occlusion costs virtually nothing.", "figure 4",
         "It adds at most 10 % to the time of the relations.", "few candidates are close", cover_test},
        {"sheets", "A sheet that lies on a table costs one attempt for each element under it.", "figure 4",
         "At most one buffer is built for each patch whose box lies under the sheet, whatever the number of shots.",
         "the sheet is lower than the boxes of the patches are high", sheets_cost_one},
    };
}

}  // namespace cob::claims
