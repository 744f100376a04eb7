#include "cob/golden.hpp"

#include "cob/arithmetic.hpp"
#include "cob/error.hpp"
#include "cob/files.hpp"
#include "cob/manifest.hpp"
#include "cob/tables.hpp"
#include "golden/answer_shard.hpp"
#include "golden/parameters.hpp"
#include "golden/questions.hpp"
#include "golden/row_codecs.hpp"
#include "golden/scene_writer.hpp"
#include "golden/shards.hpp"
#include "golden/snap.hpp"
#include "scene/remarks.hpp"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <future>
#include <optional>

namespace cob {

namespace {

constexpr std::uint64_t most_questions = 1'000'000'000'000;  ///< Of one sort or shard: nobody has room for more.

void check_ranges(const GoldenParameters& p, const GoldenOptions& options) {
    const auto refuse = [](const char* problem, const std::string& value, const std::string& remedy) {
        throw InputError(problem, {"", 0, value, remedy});
    };
    if (p.level < 0 || p.level > 12) refuse("level out of range", std::to_string(p.level), "choose 0 to 12");
    if (p.edge && !(*p.edge > 0 && std::isfinite(*p.edge)))
        refuse("edge must be positive and finite", to_text(*p.edge), "choose a length");
    if (!(p.margin >= 0 && std::isfinite(p.margin)))
        refuse("margin must not be negative or infinite", to_text(p.margin), "choose 0 or more");
    if (!(p.height > 0 && std::isfinite(p.height)))
        refuse("height must be positive and finite", to_text(p.height), "choose more than 0");
    for (const std::uint64_t count : {p.segments, p.hard})
        if (count > most_questions)
            refuse("too many questions", std::to_string(count), "choose at most " + std::to_string(most_questions));
    if (p.grid && std::abs(*p.grid) > 1000)
        refuse("grid out of range", std::to_string(*p.grid), "choose -1000 to 1000");
    if (!p.boxes && p.segments == 0 && p.hard == 0) refuse("nothing to ask", "", "ask for boxes, --segments or --hard");
    if (options.shard_size == 0 || options.shard_size > most_questions)
        refuse("shard size out of range", std::to_string(options.shard_size),
               "choose 1 to " + std::to_string(most_questions));
    if (options.shards == 0) refuse("no shards", "0", "write --shard i/n with n of 1 or more");
}

/// Where each shard's questions begin and end: first those of boxes, then those of segments.
struct Plan {
    std::uint64_t boxes, segments, size;

    std::uint64_t box_shards() const { return (boxes + size - 1) / size; }
    std::uint64_t count() const { return box_shards() + (segments + size - 1) / size; }
    ShardRange range(std::uint64_t shard) const {
        const bool of_boxes = shard < box_shards();
        const std::uint64_t first = (of_boxes ? shard : shard - box_shards()) * size;
        return {of_boxes ? TagRow::Question::box : TagRow::Question::segment, first,
                std::min(first + size, of_boxes ? boxes : segments)};
    }
};

template <class Row>
std::pair<std::string, std::string> table_and_header() {
    return {RowCodec<Row>::name, std::string(RowCodec<Row>::headers.back())};
}

void move_file(const std::string& from, const std::string& to) {
    std::error_code error;
    std::filesystem::rename(from, to, error);
    if (error)
        throw InputError("cannot write", {to, 0, error.message(), "choose a folder that is writable and has room"});
}

/// Of a set that is finished. Again, where another process that made the same is at it, too, and one fails.
void remove_shards(const std::string& folder) {
    constexpr int attempts = 10;
    const std::string shards = folder + "/shards";
    std::error_code ignored;
    for (int k = 0; k < attempts && exists(shards); ++k) std::filesystem::remove_all(shards, ignored);
}

/// Joins the shards into the set; the manifest comes last and makes it a set.
void merge(const Shards& shards, std::uint64_t count, const std::string& folder, const SceneText& text,
           const GoldenParameters& parameters) {
    // Every byte of every shard is checked before anything is made of it.
    std::vector<Manifest> parts(count);
    tbb::parallel_for(std::uint64_t{0}, count, [&](std::uint64_t shard) { parts[shard] = shards.check(shard); });

    Manifest manifest;
    manifest.parameters = to_text(parameters);
    manifest.counts["triangles"] = text.triangle_count;
    for (const Manifest& part : parts)
        for (const auto& [name, value] : part.counts) manifest.counts[name] += value;

    // Made aside, so that a kill leaves nothing behind in the set; and each process for itself.
    const std::string aside = shards.folder() + "/merged" + std::to_string(::getpid());
    create_folder(aside);
    write_file(aside + "/scene.obj", text.obj);
    write_file(aside + "/scene.mtl", text.mtl);
    write_file(aside + "/triangles.csv", text.triangles);
    const std::vector<std::pair<std::string, std::string>> tables{
        table_and_header<BoxRow>(),     table_and_header<RelationRow>(), table_and_header<StateRow>(),
        table_and_header<SegmentRow>(), table_and_header<TagRow>(),      table_and_header<VisibilityRow>()};
    std::vector<std::optional<ManifestFile>> merged(tables.size());
    tbb::parallel_for(std::size_t{0}, tables.size(), [&](std::size_t k) {
        merged[k] = shards.merge(tables[k].first, tables[k].second, count, aside + "/" + tables[k].first);
    });
    for (const char* name : {"scene.obj", "scene.mtl", "triangles.csv"})
        manifest.files[name] = describe_file(aside + "/" + name);
    for (std::size_t k = 0; k < tables.size(); ++k)
        if (merged[k]) manifest.files[tables[k].first] = *merged[k];
    write_manifest(aside + "/manifest.json", manifest);

    for (const auto& [name, file] : manifest.files) move_file(aside + "/" + name, folder + "/" + name);
    move_file(aside + "/manifest.json", folder + "/manifest.json");
    remove_shards(folder);
}

/// Whether the folder holds the whole set already. Throws InputError where it holds another.
bool finished_before(const std::string& folder, const GoldenParameters& parameters, const SceneText& text) {
    const std::string path = folder + "/manifest.json";
    if (!exists(path)) return false;
    const Manifest manifest = read_manifest(path);
    const auto scene = manifest.files.find("scene.obj"), materials = manifest.files.find("scene.mtl");
    if (manifest.parameters != to_text(parameters) || scene == manifest.files.end() ||
        scene->second.sha256 != sha256(text.obj) || materials == manifest.files.end() ||
        materials->second.sha256 != sha256(text.mtl))
        throw InputError("the folder holds another set", {folder, 0, "", "choose another folder, or remove this one"});
    return true;
}

/// Makes those shards that are missing and asked for, each from nothing but its range. Whether all are there now.
bool make_shards(const Shards& shards, const ShardMaker& maker, const Plan& plan, const GoldenOptions& options,
                 std::uint64_t& made_now) {
    bool finished = true;
    std::future<void> writing;  // the shard before, while the next one is made
    for (std::uint64_t shard = 0; shard < plan.count(); ++shard) {
        if (options.progress) options.progress(shard, plan.count());
        if (shards.has(shard)) continue;
        if (shard % options.shards != options.shard % options.shards) {
            finished = false;
            continue;
        }
        ShardMaker::Shard made = maker.make(plan.range(shard));
        if (writing.valid()) writing.get();
        writing = std::async(std::launch::async,
                             [&shards, shard, made = std::move(made)] { shards.put(shard, made.tables, made.counts); });
        ++made_now;
    }
    if (writing.valid()) writing.get();
    return finished;
}

}  // namespace

GoldenResult make_golden(const std::string& scene_path, const std::string& folder, const GoldenParameters& parameters,
                         const GoldenOptions& options) {
    check_ranges(parameters, options);
    std::optional<tbb::global_control> limit;
    if (options.threads > 0)
        limit.emplace(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(options.threads));

    // The scene, as the set will hold it.
    ReadReport report;
    Scene as_read = read_obj(scene_path, {parameters.skip_invalid, false}, &report);
    if (options.say)
        for (const std::string& remark : remarks_on(as_read, report, scene_path)) options.say(remark);
    const SnappedScene snapped = snap(std::move(as_read), parameters);
    const Scene& scene = snapped.scene;
    const SceneText text = write_scene(scene);
    const auto candidates = make_candidates(scene, Source::tree);
    const Questions questions(scene, *candidates, parameters);
    const Plan plan{questions.box_count(), questions.segment_count(), options.shard_size};
    GoldenResult result{plan.boxes, plan.segments, plan.count(), 0, false, snapped.report};

    if (finished_before(folder, parameters, text)) {
        remove_shards(folder);
        result.finished = true;
        return result;
    }

    // Shards, then the set.
    std::map<std::string, std::string> identity = to_text(parameters);
    identity["scene"] = sha256(text.obj + text.mtl);
    identity["shard_size"] = std::to_string(options.shard_size);
    const OutputFolder created(folder + "/shards");
    const Shards shards(folder, identity);
    for (const std::string& other : options.merge) shards.take_from(other, plan.count());
    const ShardMaker maker(scene, *candidates, questions);
    try {
        result.finished = make_shards(shards, maker, plan, options, result.made);
        if (result.finished) merge(shards, plan.count(), folder, text, parameters);
    } catch (const InputError&) {
        // Another process may have finished the set meanwhile, and removed the shards.
        if (!finished_before(folder, parameters, text)) throw;
        remove_shards(folder);
        result.finished = true;
    }
    return result;
}

}  // namespace cob
