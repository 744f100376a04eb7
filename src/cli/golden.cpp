#include "cob/golden.hpp"

#include "cli/commands.hpp"
#include "cli/number_checks.hpp"
#include "cli/options.hpp"
#include "cli/terminal.hpp"
#include "cob/error.hpp"

#include <charconv>
#include <cstdio>
#include <memory>
#include <sstream>

namespace cob::cli {

namespace {

struct Arguments {
    std::string scene, folder, shard, kinds;
    bool no_boxes = false;
    GoldenParameters parameters;
    GoldenOptions options;
};

/// Reads "i/n".
void parse_shard(const std::string& text, GoldenOptions& options) {
    const char *begin = text.data(), *end = text.data() + text.size();
    const auto first = std::from_chars(begin, end, options.shard);
    const bool slash = first.ec == std::errc() && first.ptr != end && *first.ptr == '/';
    const auto second = slash ? std::from_chars(first.ptr + 1, end, options.shards) : first;
    if (!slash || second.ec != std::errc() || second.ptr != end || options.shards == 0 ||
        options.shard > options.shards)
        throw InputError("bad --shard", {"", 0, text, "write i/n, i from 1 to n (or from 0 to n - 1)"});
}

void print(const SnapReport& report, const GoldenParameters& parameters) {
    std::printf("snapped to multiples of 2^%d%s: %zu vertices moved, at most by %.3g\n", -report.grid,
                parameters.binary32 ? " (binary32)" : "", report.moved, report.largest_move);
    if (!report.not_planar.empty()) std::printf("%zu polygons are no longer planar\n", report.not_planar.size());
    for (const std::int32_t id : report.now_invalid) std::printf("polygon %d became invalid\n", id);
}

void run(Arguments& arguments) {
    refuse_overwriting(arguments.folder + "/scene.obj", {arguments.scene});
    arguments.parameters.boxes = !arguments.no_boxes;
    if (!arguments.shard.empty()) parse_shard(arguments.shard, arguments.options);
    std::istringstream words(arguments.kinds);
    for (std::string kind; std::getline(words, kind, ',');) arguments.parameters.kinds.push_back(kind);
    arguments.options.progress = terminal_progress("golden");
    arguments.options.say = remark_on_terminal;

    const GoldenResult result = make_golden(arguments.scene, arguments.folder, arguments.parameters, arguments.options);
    if (result.snapped) print(*result.snapped, arguments.parameters);
    std::printf("%s: %llu boxes, %llu segments, %llu shards (%llu made now)\n", arguments.folder.c_str(),
                static_cast<unsigned long long>(result.boxes), static_cast<unsigned long long>(result.segments),
                static_cast<unsigned long long>(result.shards), static_cast<unsigned long long>(result.made));
    if (!result.finished)
        std::printf(
            "not finished: make the other shards, bring all together under %s/shards (or name the other\n"
            "folders with --merge) and repeat the command without --shard\n",
            arguments.folder.c_str());
}

}  // namespace

void add_golden(CLI::App& app) {
    auto arguments = std::make_shared<Arguments>();
    GoldenParameters& p = arguments->parameters;
    GoldenOptions& o = arguments->options;
    CLI::App* command = app.add_subcommand("golden", "Make a golden set: questions about a scene with exact answers");
    command->add_option("scene", arguments->scene, "Scene (OBJ with MTL)")->required();
    command->add_option("-o,--output", arguments->folder, "Folder of the set; created, or gone on with")->required();

    command->option_defaults()->group("Questions");
    command->add_option("--level", p.level, "Boxes: refinements of every element");
    command->add_option("--edge", p.edge, "Boxes: cut polygons into patches of this side first");
    command->add_flag("--no-boxes", arguments->no_boxes, "No boxes over elements");
    command->add_option("--margin", p.margin, "Boxes: widened by this fraction on each side");
    command->add_option("--height", p.height, "Boxes: height as a fraction of the shorter side");
    command->add_option("--segments", p.segments, "Segments between sample points of elements and lights")
        ->check(whole_number());
    command->add_option("--hard", p.hard, "So many boxes and so many segments aimed at the degenerate")
        ->check(whole_number());
    command->add_option("--kinds", arguments->kinds, "Kinds of the hard questions, separated by commas; none: all");
    command->add_option("--seed", p.seed, "Of sample points and hard questions")->check(whole_number());
    command->add_option("--grid", p.grid, "Snap the scene to multiples of 2^-K: all numbers are binary64")
        ->type_name("K");
    command->add_flag("--float", p.binary32,
                      "Snap the scene (to --grid, or as finely as possible): all numbers are binary32");
    command->add_flag("--skip-invalid", p.skip_invalid,
                      "Go on without polygons that cannot be used; they keep their numbers");

    command->option_defaults()->group("Work");
    command->add_option("--shard", arguments->shard, "Make every n-th shard only, the i-th of them; i from 1 (0 is n)")
        ->type_name("i/n");
    command->add_option("--merge", o.merge, "Take over the finished shards of these folders");
    command
        ->add_option("--shard-size", o.shard_size,
                     "Questions in memory at once; the next shard is made while one is written")
        ->check(whole_number());
    add_threads(*command, o.threads);
    command->footer("The same command gives the same bytes, whatever the options under Work. After a kill, repeat it.");
    command->callback([arguments] { run(*arguments); });
}

}  // namespace cob::cli
