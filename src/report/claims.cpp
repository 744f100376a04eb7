// The registry of claims and what they share.
#include "cob/claims.hpp"

#include "arithmetic/process.hpp"
#include "cob/error.hpp"
#include "geometry/bounds.hpp"
#include "radiosity/mesh.hpp"
#include "report/claims_bench.hpp"

#include <algorithm>
#include <cstdio>
#include <limits>
#include <numeric>
#include <set>

namespace cob {

const char* to_text(ClaimVerdict verdict) {
    switch (verdict) {
        case ClaimVerdict::confirmed:
            return "confirmed";
        case ClaimVerdict::refuted:
            return "refuted";
        case ClaimVerdict::only_if:
            return "only if";
    }
    return "";
}

ClaimVerdict ClaimResult::verdict() const {
    const auto holding = std::count_if(cases.begin(), cases.end(), [](const ClaimCase& c) { return c.holds; });
    if (holding == 0) return ClaimVerdict::refuted;
    return holding == static_cast<std::ptrdiff_t>(cases.size()) ? ClaimVerdict::confirmed : ClaimVerdict::only_if;
}

std::string ClaimResult::fails_on() const {
    std::string names;
    for (const ClaimCase& c : cases)
        if (!c.holds) names += (names.empty() ? "" : ", ") + c.scene;
    return names;
}

namespace {

/// In the order in which the table shows them.
const std::vector<claims::Claim>& registry() {
    static const std::vector<claims::Claim> all = [] {
        std::vector<claims::Claim> list;
        for (const auto& part :
             {claims::error_claims(), claims::run_claims(), claims::buffer_claims(), claims::sight_claims()})
            list.insert(list.end(), part.begin(), part.end());
        return list;
    }();
    return all;
}

}  // namespace

std::vector<std::string> claim_ids() {
    std::vector<std::string> ids;
    for (const claims::Claim& claim : registry()) ids.emplace_back(claim.id);
    return ids;
}

std::vector<ClaimResult> measure_claims(const std::vector<std::string>& ids, const ClaimOptions& options) {
    claims::Bench bench(options);
    std::vector<ClaimResult> results;
    for (const std::string& id : ids.empty() ? claim_ids() : ids) {
        const auto claim = std::find_if(registry().begin(), registry().end(),
                                        [&](const claims::Claim& entry) { return entry.id == id; });
        if (claim == registry().end()) throw InputError("no such claim", {"", 0, id, "cob study --help lists them"});
        ClaimResult result{claim->id, claim->text, claim->where, claim->criterion, claim->condition, {}, {}};
        claim->measure(bench, result);
        if (result.cases.empty()) throw std::logic_error("claim " + id + " was measured on nothing");
        results.push_back(std::move(result));
    }
    return results;
}

namespace claims {

// ------------------------------------------------------------------------------------------------ the bench

const Scene& Bench::scene(const std::string& name) {
    const auto known = scenes_.find(name);
    if (known != scenes_.end()) return known->second;
    return scenes_.emplace(name, read_obj(options_.data + "/" + name + ".obj", ReadOptions{})).first->second;
}

std::vector<std::string> Bench::names(std::vector<std::string> all, std::size_t quick_count) const {
    if (quick()) all.resize(std::min(all.size(), quick_count));
    return all;
}

double Bench::edge(const Scene& scene, double parts) const {
    return longest_extent(bounds_of(scene)) / parts;
}

void Bench::tick() {
    if (options_.progress) options_.progress(done_++, 0);
}

void Bench::solve(RadiositySolver& solver) {
    while (solver.step())
        if (options_.progress) options_.progress(done_, 0);
}

RunRecord Bench::run(const Scene& scene, const RadiosityOptions& options) {
    RunRecord record;
    const double processor_before = processor_seconds();
    RadiositySolver solver(scene, options);
    for (double before = solver.times().total();;) {
        const auto elements = static_cast<std::int64_t>(solver.element_count());
        if (!solver.step()) break;
        record.shot_elements.push_back(elements);
        record.shot_seconds.push_back(solver.times().total() - before);
        record.shot_nodes.push_back(static_cast<std::int64_t>(solver.mesh().nodes().size()));
        const std::array<std::int64_t, 4>& built = solver.counters().buffers;
        record.shot_buffers.push_back(std::accumulate(built.begin(), built.end(), std::int64_t{0}));
        before = solver.times().total();
        if (options_.progress) options_.progress(done_, 0);
    }
    record.processor_seconds = processor_seconds() - processor_before;
    record.counters = solver.counters();
    record.times = solver.times();
    record.elements = solver.element_count();
    record.nodes = solver.mesh().nodes().size();
    if (!record.shot_buffers.empty()) record.buffers = static_cast<std::size_t>(record.shot_buffers.back());
    record.buffer_bytes = solver.buffer_bytes();
    for (const radiosity::NodeId leaf : solver.mesh().leaves())
        record.occluded += solver.buffer_state(leaf) == BufferState::occluded ? 1 : 0;
    tick();
    return record;
}

const RunRecord& Bench::run_once(const std::string& name, const Scene& scene, const RadiosityOptions& options) {
    const auto known = runs_.find(name);
    return known != runs_.end() ? known->second : runs_.emplace(name, run(scene, options)).first->second;
}

const RunRecord& Bench::buffer_run(const std::string& name) {
    RadiosityOptions options;
    options.refinement = Refinement::buffer;
    options.threads = options_.threads;
    options.stop.shots = quick() ? 30 : 100;
    if (quick()) {
        options.patch_edge = edge(scene(name), 6);
        options.buffer.minimum_edge = options.patch_edge / 8;
    }
    return run_once(name, scene(name), options);
}

const StudyReference& Bench::reference(const std::string& name, std::size_t points) {
    const std::string key = name + " " + std::to_string(points);
    const auto known = references_.find(key);
    if (known != references_.end()) return known->second;
    return references_.emplace(key, study_reference(scene(name), points, options_.progress)).first->second;
}

StudyRun Bench::study(const Scene& scene, const StudyReference& reference, Refinement refinement, double patch_edge,
                      double minimum_edge, const Rational& height, int repeats) {
    StudySettings settings;
    settings.series = "claim";
    settings.refinement = refinement;
    settings.patch_edge = patch_edge;
    settings.light_edge = edge(scene, 12);
    settings.minimum_edge = minimum_edge;
    settings.height = height;
    StudyRun run = study_run(scene, reference, settings, quick() ? 1 : repeats, options_.threads, options_.progress);
    tick();
    return run;
}

// ---------------------------------------------------------------------------------------------- the pencil

PencilScene pencil_on_desk(const Scene& desk) {
    // 1. The pencil, by its materials.
    std::set<PolygonId> pencil;
    Bounds around;
    for (PolygonId id = 0; id < desk.polygon_count(); ++id) {
        const std::string& material = desk.material(id).name;
        if (material != "yellow" && material != "graphite") continue;
        pencil.insert(id);
        around.add(bounds_of(desk, desk.loop(id)));
    }
    if (pencil.empty()) throw InputError("the desk has no pencil: no polygon of material yellow or graphite");
    const double ground = around.low[2], width = around.high[2] - ground;
    for (std::size_t axis = 0; axis < 2; ++axis) {
        around.low[axis] -= 2 * width;
        around.high[axis] += 2 * width;
    }

    // 2. With it what lies around it, and the lights.
    Scene::Input input = input_of(desk);
    PencilScene result;
    std::vector<Scene::Face> faces;
    for (PolygonId id = 0; id < desk.polygon_count(); ++id) {
        const Bounds bounds = bounds_of(desk, desk.loop(id));
        if (!desk.is_light(id) && !bounds.meets(around)) continue;
        const bool flat = bounds.low[2] == bounds.high[2];
        if (flat && bounds.low[2] == ground && pencil.count(id) == 0)
            result.region.polygons.push_back(static_cast<PolygonId>(faces.size()));
        faces.push_back(input.faces[static_cast<std::size_t>(id)]);
    }
    if (result.region.polygons.empty()) throw InputError("the desk's pencil lies on nothing");
    input.faces = std::move(faces);
    result.scene = Scene::build(std::move(input));
    result.region.bounds = {around.low[0],  around.low[1],  around.low[2],
                            around.high[0], around.high[1], around.high[2]};
    result.width = width;
    return result;
}

}  // namespace claims
}  // namespace cob
