/// Checkpoints: all that the state cannot make again. The mesh is made again from the order of its splits, and
/// buffers are built again: neither depends on anything else.
#include "cob/error.hpp"
#include "radiosity/state.hpp"

#include <cstring>
#include <string>
#include <type_traits>

namespace cob {

using namespace radiosity;

namespace {

constexpr char magic[] = "cob checkpoint 3\n";

class Writer {
public:
    template <class T>
    void value(const T& x) {
        static_assert(std::is_trivially_copyable_v<T>);
        text.append(reinterpret_cast<const char*>(&x), sizeof x);
    }
    template <class T>
    void list(const std::vector<T>& xs) {
        value(static_cast<std::uint64_t>(xs.size()));
        for (const T& x : xs) value(x);
    }
    std::string text;
};

class Reader {
public:
    explicit Reader(const std::string& from) : text_(from) {}
    template <class T>
    void value(T& x) {
        if (text_.size() - at_ < sizeof x) damaged();
        std::memcpy(&x, text_.data() + at_, sizeof x);
        at_ += sizeof x;
    }
    template <class T>
    void list(std::vector<T>& xs) {
        std::uint64_t count = 0;
        value(count);
        if (count > (text_.size() - at_) / sizeof(T)) damaged();
        xs.resize(static_cast<std::size_t>(count));
        for (T& x : xs) value(x);
    }
    void end() {
        if (at_ != text_.size()) damaged();
    }
    [[noreturn]] static void damaged() {
        throw InputError("the checkpoint is damaged", {"", 0, "", "remove it and start again"});
    }

private:
    const std::string& text_;
    std::size_t at_ = 0;
};

std::uint64_t fingerprint(const std::string& text) {
    std::uint64_t hash = 0xcbf29ce484222325u;
    for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
    return hash;
}

/// What must be the same for the run to go on: the scene and all options that the result depends on. The stop may be
/// another one: going on longer is what checkpoints are for.
std::uint64_t fingerprint(const Scene& scene, const RadiosityOptions& o) {
    Writer all;
    all.list(scene.positions());
    for (PolygonId p = 0; p < scene.polygon_count(); ++p) {
        for (const VertexId v : scene.loop(p)) all.value(v);
        all.value(scene.material(p).reflectance);
        all.value(scene.material(p).emitted_exitance);
    }
    all.text += to_text(o.buffer.margin) + " " + to_text(o.buffer.height);
    all.value(o.refinement);
    all.value(o.patch_edge);
    all.value(o.light_edge);
    all.value(o.buffer.minimum_edge);
    all.value(o.buffer.strength);
    all.value(o.buffer.threshold);
    all.value(o.buffer.levels);
    all.value(o.buffer.mode);
    all.value(o.buffer.skip_occluded);
    all.value(o.gradient.threshold);
    all.value(o.gradient.minimum_edge);
    all.value(o.gradient.floor);
    all.value(o.stop.elements);
    all.value(o.samples);
    all.value(o.mixed_samples);
    all.value(o.receiving_points);
    all.value(o.overshoot);
    return fingerprint(all.text);
}

}  // namespace

std::string RadiositySolver::State::checkpoint() const {
    Writer out;
    out.value(fingerprint(scene, options));
    out.list(splits);
    out.value(static_cast<std::uint64_t>(shots.size()));
    for (const Shot& shot : shots) {
        out.value(shot.patch);
        out.value(shot.exitance);
    }
    out.list(unshot_flux);
    out.list(shot_flux);
    for (const Cell& cell : cells) {
        out.value(cell.irradiance);
        out.value(static_cast<std::uint8_t>(cell.buffer.is_built()));
        out.list(cell.sights);
    }
    for (const CloseObjectBuffer& buffer : root_buffers) out.value(static_cast<std::uint8_t>(buffer.is_built()));
    for (const double x : {flux_moved, flux_taken, flux_arrived, flux_off, closure_sum, closure_least, closure_most})
        out.value(x);
    out.value(closure_least_patch);
    out.value(closure_most_patch);
    out.value(counters);
    out.value(times);
    return magic + std::to_string(fingerprint(out.text)) + "\n" + out.text;
}

void RadiositySolver::State::resume(const std::string& text) {
    const std::size_t begin = std::strlen(magic);
    if (text.compare(0, begin, magic) != 0)
        throw InputError("this is no checkpoint of this version", {"", 0, text.substr(0, begin - 1), "remove it"});
    const std::size_t end = text.find('\n', begin);
    if (end == std::string::npos) Reader::damaged();
    const std::string body = text.substr(end + 1);
    if (std::to_string(fingerprint(body)) != text.substr(begin, end - begin)) Reader::damaged();

    Reader in(body);
    std::uint64_t same = 0, count = 0;
    in.value(same);
    if (same != fingerprint(scene, options))
        throw InputError("the checkpoint belongs to another scene or other options",
                         {"", 0, "", "give those it was made with, or remove it"});
    std::vector<NodeId> again, split_nodes;
    in.list(again);
    for (const NodeId node : again) {
        if (node < 0 || static_cast<std::size_t>(node) >= mesh->nodes().size()) Reader::damaged();
        mesh->refine(node, split_nodes);
    }
    if (split_nodes != again) Reader::damaged();
    splits = again;
    add_cells();
    refresh_leaves(splits);
    in.value(count);
    for (std::uint64_t k = 0; k < count; ++k) {
        NodeId patch = -1;
        Rgb exitance{};
        in.value(patch);
        in.value(exitance);
        if (patch < 0 || patch >= mesh->patch_count()) Reader::damaged();
        shots.push_back(transport->make_shot(patch, exitance));
    }
    for (std::vector<Rgb>* flux : {&unshot_flux, &shot_flux}) {
        in.list(*flux);
        if (flux->size() != static_cast<std::size_t>(mesh->patch_count())) Reader::damaged();
    }
    std::vector<std::uint8_t> built(cells.size()), root_built(root_buffers.size());
    for (std::size_t k = 0; k < cells.size(); ++k) {
        in.value(cells[k].irradiance);
        in.value(built[k]);
        in.list(cells[k].sights);
    }
    for (std::uint8_t& b : root_built) in.value(b);
    for (double* x : {&flux_moved, &flux_taken, &flux_arrived, &flux_off, &closure_sum, &closure_least, &closure_most})
        in.value(*x);
    in.value(closure_least_patch);
    in.value(closure_most_patch);
    for (const NodeId patch : {closure_least_patch, closure_most_patch})
        if (patch < -1 || patch >= mesh->patch_count()) Reader::damaged();
    in.value(counters);
    in.value(times);
    in.end();

    // In the order in which they were built first: roots, then elements from the outside in.
    for (std::size_t k = 0; k < root_buffers.size(); ++k)
        if (root_built[k] != 0) root_buffers[k] = build_root_buffer(static_cast<RootId>(k));
    for (std::size_t k = 0; k < cells.size(); ++k)
        if (built[k] != 0) cells[k].buffer = build_buffer(static_cast<NodeId>(k));
}

}  // namespace cob
