#include "radiosity/state.hpp"

#include "arithmetic/threads.hpp"
#include "cob/error.hpp"
#include "geometry/bounds.hpp"
#include "radiosity/photometric_range.hpp"

#include <algorithm>
#include <cmath>

namespace cob {

using namespace radiosity;

const char* to_text(Refinement refinement) {
    switch (refinement) {
        case Refinement::none:
            return "none";
        case Refinement::gradient:
            return "gradient";
        case Refinement::buffer:
            return "buffer";
        case Refinement::both:
            return "both";
    }
    return "";
}

const char* to_text(Strength strength) {
    switch (strength) {
        case Strength::exitance:
            return "exitance";
        case Strength::flux:
            return "flux";
        case Strength::paper:
            return "paper";
    }
    return "";
}

namespace {

/// Emitted, in W in units: of less, what arrives has lost its digits.
constexpr double least_flux = 1e-305;

}  // namespace

RadiositySolver::State::State(const Scene& a_scene, RadiosityOptions some_options)
    : scene(a_scene),
      options(checked(a_scene, std::move(some_options))),
      roots(a_scene),
      omissions(a_scene, roots, {options.keep, options.buffer.margin, options.buffer.height}),
      channels_(omissions(Omission::grey) ? 1 : 3),
      arena_(thread_count(options.threads)) {
    const PhaseTimer timer(times.meshing);
    candidates = make_candidates(scene, omissions(Omission::tree) ? Source::all : Source::tree);
    mesh = std::make_unique<Mesh>(scene, roots, options.patch_edge, options.light_edge);
    sheets = std::make_unique<Sheets>(scene, *candidates);
    arena_.execute(
        [&] { transport = std::make_unique<Transport>(scene, *mesh, *candidates, *sheets, options, omissions); });
    BufferOptions buffers;
    buffers.margin = options.buffer.margin;
    buffers.height = options.buffer.height;
    buffers.mode = options.buffer.mode;
    omissions.apply_to(buffers);
    builder = std::make_unique<BufferBuilder>(scene, roots, *candidates, buffers);
    root_buffers.resize(static_cast<std::size_t>(roots.size()));
    add_cells();

    const auto patches = static_cast<std::size_t>(mesh->patch_count());
    leaves.resize(patches);
    unshot_flux.resize(patches);
    shot_flux.resize(patches);
    for (std::size_t p = 0; p < patches; ++p) {
        const auto id = static_cast<NodeId>(p);
        leaves[p] = {id};
        if (!(omissions(Omission::black) && is_black(material(id)))) shooters.push_back(id);
        for (std::size_t c = 0; c < 3; ++c) {
            unshot_flux[p][c] = area(id) * material(id).emitted_exitance[c];
            emitted_flux[c] += unshot_flux[p][c];
        }
    }
    if (sum(emitted_flux) > 0 && sum(emitted_flux) < least_flux)
        throw InputError("the lights are too faint", {scene.name(), 0, to_text(sum(emitted_flux)), "give a larger Ke"});
    if (sum(emitted_flux) == 0)
        throw InputError("every light lies wholly under sheets in its plane: everything stays black",
                         {scene.name(), 0, "", "uncover a light, or turn it round"});
}

RadiosityOptions RadiositySolver::State::checked(const Scene& scene, RadiosityOptions options) {
    const auto refuse = [&](const std::string& problem, const std::string& value, const std::string& remedy) {
        throw InputError(problem, {scene.name(), 0, value, remedy});
    };
    check_solvable(scene);

    RadiosityOptions& o = options;
    const std::pair<const char*, double> numbers[] = {{"patch edge", o.patch_edge},
                                                      {"light's patch edge", o.light_edge},
                                                      {"buffer's minimum edge", o.buffer.minimum_edge},
                                                      {"strength threshold", o.buffer.threshold},
                                                      {"gradient's minimum edge", o.gradient.minimum_edge},
                                                      {"gradient threshold", o.gradient.threshold[0]},
                                                      {"gradient threshold", o.gradient.threshold[1]},
                                                      {"gradient threshold", o.gradient.threshold[2]},
                                                      {"gradient's floor", o.gradient.floor},
                                                      {"share of unshot flux", o.stop.unshot}};
    for (const auto& [name, number] : numbers)
        if (!(number >= 0)) refuse(std::string("the ") + name + " is no number from 0 up", to_text(number), "give one");
    if (o.patch_edge == 0) o.patch_edge = longest_extent(bounds_of(scene)) / 12;
    if (o.light_edge == 0) o.light_edge = o.patch_edge;
    if (o.buffer.minimum_edge == 0) o.buffer.minimum_edge = o.patch_edge / 16;
    if (o.gradient.minimum_edge == 0) o.gradient.minimum_edge = o.patch_edge / 8;
    for (const int samples : {o.samples, o.mixed_samples})
        if (samples != 1 && samples != 4 && samples != 16 && samples != 64)
            refuse("samples of a patch come in grids", std::to_string(samples), "choose 1, 4, 16 or 64");
    if (o.receiving_points != 1 && o.receiving_points != 4 && o.receiving_points != 16)
        refuse("receiving points come in grids", std::to_string(o.receiving_points), "choose 1, 4 or 16");
    return options;
}

bool RadiositySolver::State::uses_buffer() const {
    return options.refinement == Refinement::buffer || options.refinement == Refinement::both;
}

bool RadiositySolver::State::uses_gradient() const {
    return options.refinement == Refinement::gradient || options.refinement == Refinement::both;
}

void RadiositySolver::State::add_cells() {
    for (std::size_t k = cells.size(); k < mesh->nodes().size(); ++k) {
        const auto id = static_cast<NodeId>(k);
        Cell cell;
        const Element& element = mesh->node(id).element;
        cell.cover = sheets->cover(roots[element.root], element);
        cell.area = mesh->area(id) * cell.cover.visible_share;
        cell.longest_side = mesh->longest_side(id);
        cells.push_back(std::move(cell));
    }
}

double RadiositySolver::State::area(NodeId node) const {
    return cells[static_cast<std::size_t>(node)].area;
}

const Material& RadiositySolver::State::material(NodeId node) const {
    return scene.material(roots[mesh->node(node).element.root].polygon);
}

Rgb RadiositySolver::State::exitance(NodeId node) const {
    const Material& m = material(node);
    const Rgb& irradiance = cells[static_cast<std::size_t>(node)].irradiance;
    Rgb result;
    for (std::size_t c = 0; c < 3; ++c) result[c] = m.emitted_exitance[c] + m.reflectance[c] * irradiance[c];
    return result;
}

double RadiositySolver::State::unshot_share() const {
    double unshot = 0;
    for (const Rgb& flux : unshot_flux)
        for (const double f : flux) unshot += std::fabs(f);
    return unshot / sum(emitted_flux);
}

Rgb RadiositySolver::State::ambient(double most_reflectance) const {
    // Cohen et al. 1988: what is unshot spreads over all surfaces and is reflected again and again.
    Rgb unshot{}, reflected{}, result{};
    double all = 0;
    for (std::size_t p = 0; p < unshot_flux.size(); ++p) {
        const auto id = static_cast<NodeId>(p);
        all += area(id);
        for (std::size_t c = 0; c < 3; ++c) {
            unshot[c] += unshot_flux[p][c];
            reflected[c] += area(id) * material(id).reflectance[c];
        }
    }
    for (std::size_t c = 0; c < 3; ++c)
        result[c] = unshot[c] / all / (1 - std::min(reflected[c] / all, most_reflectance));
    return result;
}

EnergyBooks RadiositySolver::State::books() const {
    EnergyBooks books;
    books.exponent = 2 * mesh->exponent();
    for (std::size_t p = 0; p < leaves.size(); ++p) {
        for (const NodeId leaf : leaves[p]) {
            const Rgb m = exitance(leaf);
            for (std::size_t c = 0; c < 3; ++c) books.by_elements[c] += area(leaf) * m[c];
        }
        for (std::size_t c = 0; c < 3; ++c) books.by_patches[c] += shot_flux[p][c] + unshot_flux[p][c];
    }
    const auto count = static_cast<double>(std::max<std::int64_t>(1, counters.shots));
    books.closure_mean = closure_sum / count;
    books.closure_least = closure_least;
    books.closure_most = closure_most;
    books.closure_flux = flux_taken > 0 ? flux_arrived / flux_taken : 0;
    books.closure_error = flux_taken > 0 ? flux_off / flux_taken : 0;
    books.closure_least_patch = closure_least_patch;
    books.closure_most_patch = closure_most_patch;
    books.moved = flux_arrived > 0 ? flux_moved / flux_arrived : 0;
    return books;
}

double EnergyBooks::difference() const {
    double worst = 0;
    for (std::size_t c = 0; c < 3; ++c)
        if (by_patches[c] != by_elements[c])
            worst = std::max(worst, std::fabs(by_patches[c] - by_elements[c]) / std::fabs(by_elements[c]));
    return worst;
}

// ------------------------------------------------------------------------------------------- the public face

RadiositySolver::RadiositySolver(const Scene& scene, RadiosityOptions options)
    : state_(std::make_unique<State>(scene, std::move(options))) {}
RadiositySolver::~RadiositySolver() = default;
RadiositySolver::RadiositySolver(RadiositySolver&&) noexcept = default;

bool RadiositySolver::step() {
    return state_->step();
}
double RadiositySolver::unshot_share() const {
    return state_->unshot_share();
}
const RadiosityOptions& RadiositySolver::options() const {
    return state_->options;
}
const RadiosityCounters& RadiositySolver::counters() const {
    return state_->counters;
}
const RadiosityTimes& RadiositySolver::times() const {
    return state_->times;
}
EnergyBooks RadiositySolver::books() const {
    return state_->books();
}
const Mesh& RadiositySolver::mesh() const {
    return *state_->mesh;
}
const Roots& RadiositySolver::roots() const {
    return state_->roots;
}
std::size_t RadiositySolver::element_count() const {
    return state_->mesh->leaf_count();
}
std::size_t RadiositySolver::patch_count() const {
    return static_cast<std::size_t>(state_->mesh->patch_count());
}
Rgb RadiositySolver::exitance(std::int32_t leaf) const {
    return state_->exitance(leaf);
}
std::vector<Rgb> RadiositySolver::vertex_exitance() const {
    return state_->vertex_exitance();
}
Rgb RadiositySolver::ambient() const {
    return state_->ambient();
}
const Omissions& RadiositySolver::omissions() const {
    return state_->omissions;
}
std::string RadiositySolver::checkpoint() const {
    return state_->checkpoint();
}
void RadiositySolver::resume(const std::string& checkpoint) {
    state_->resume(checkpoint);
}

std::vector<std::size_t> RadiositySolver::elements_by_level() const {
    std::vector<std::size_t> result;
    for (const Node& node : state_->mesh->nodes()) {
        if (!node.is_leaf()) continue;
        if (result.size() <= node.level) result.resize(node.level + 1u);
        ++result[node.level];
    }
    return result;
}

BufferState RadiositySolver::buffer_state(std::int32_t node) const {
    return state_->cells[static_cast<std::size_t>(node)].buffer.state();
}

bool RadiositySolver::hidden(std::int32_t node) const {
    return state_->cells[static_cast<std::size_t>(node)].cover.kind == Cover::Kind::wholly;
}

bool RadiositySolver::lies_on(PolygonId top, PolygonId under) const {
    const std::vector<PolygonId>& above = state_->sheets->above(under);
    return std::find(above.begin(), above.end(), top) != above.end();
}

std::size_t RadiositySolver::buffer_bytes() const {
    return (state_->cells.size() + state_->root_buffers.size()) * sizeof(CloseObjectBuffer) +
           state_->builder->list_bytes();
}

std::size_t RadiositySolver::buffer_count() const {
    return state_->cells.size() + state_->root_buffers.size();
}

}  // namespace cob
