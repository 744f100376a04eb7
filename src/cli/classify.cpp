// cob classify: the state of every element's buffer.
#include "arithmetic/process.hpp"
#include "cli/commands.hpp"
#include "cli/number_checks.hpp"
#include "cli/options.hpp"
#include "cli/terminal.hpp"
#include "cob/files.hpp"
#include "report/classify_scene.hpp"
#include "report/classify_summary.hpp"
#include "report/truth_report.hpp"

#include <cstdio>
#include <memory>
#include <string>

namespace cob::cli {
namespace {

struct ClassifyCommand {
    SceneOptions scene;
    MeshingOptions meshing;
    SourceOption source;
    KeepOptions keep;
    Choice<BufferLevels> levels{
        BufferLevels::automatic,
        {BufferLevels::automatic, BufferLevels::element, BufferLevels::polygon, BufferLevels::tree}};
    Choice<BufferMode> mode{BufferMode::strict, {BufferMode::strict, BufferMode::inherit}};
    std::string folder;
    int threads = 0;
    bool truth = false;
    std::uint64_t truth_pairs = TruthOptions{}.max_pairs;
    bool states_only = false, no_boxes = false, no_relations = false, no_ply = false;

    void add_to(CLI::App& command) {
        scene.add_to(command);
        meshing.add_to(command);
        levels.add_to(command, "--buffer",
                      "Buffers that an element's buffer is built from: none (element), that of its whole polygon's "
                      "piece (polygon), every level of the quadtree (tree), or the outermost that has few polygons "
                      "around, if any (auto; with --mode inherit as polygon)");
        mode.add_to(command, "--mode",
                    "Under an occluded buffer: test from the scene (strict), or the paper's: occluded, too (inherit), "
                    "and the difference is reported");
        source.add_to(command);
        keep.add_to(command);
        add_threads(command, threads);
        command.add_flag("--no-boxes", no_boxes, "Leave out boxes.csv");
        command.add_flag("--no-relations", no_relations, "Leave out relations.csv: then only what is close is tested");
        command.add_flag("--no-ply", no_ply, "Leave out elements.ply");
        command.add_flag("--states-only", states_only, "Leave out all three");
        command.add_flag("--truth", truth,
                         "Set the states beside what is truly seen of the lights: truth.csv, truth_summary.csv");
        command
            .add_option("--truth-pairs", truth_pairs,
                        "Most pairs of element and light for --truth; of more, elements at equal distances are taken")
            ->check(positive_whole_number());
        add_output_folder(command, folder);
    }

    void run() const {
        // Options.
        ClassifySceneOptions options;
        options.classify.levels = levels();
        options.classify.buffer.mode = mode();
        meshing.box.set(options.classify.buffer);
        const Meshing cut = meshing.meshing();
        options.threads = threads;
        options.boxes = !states_only && !no_boxes;
        options.relations = !states_only && !no_relations;
        options.ply = !states_only && !no_ply;
        options.progress = terminal_progress("classifying");

        // Scene, elements, candidates.
        ClassifySummary summary;
        Stopwatch watch;
        const Scene read_scene = scene.read();
        summary.read_seconds = watch.lap();
        const Roots roots(read_scene);
        const ElementList elements(read_scene, roots, cut);
        const Omissions omissions(read_scene, roots,
                                  {keep.set(), options.classify.buffer.margin, options.classify.buffer.height});
        omissions.apply_to(options.classify.buffer);
        if (levels() == BufferLevels::automatic && !omissions(Omission::levels))
            options.classify.levels = BufferLevels::polygon;
        options.classify.apart = omissions(Omission::buffers);
        summary.mesh_seconds = watch.lap();
        const auto candidates = make_candidates(read_scene, omissions(Omission::tree) ? Source::all : source());
        summary.tree_seconds = watch.lap();

        // Buffers.
        const OutputFolder created(folder);
        const double before = processor_seconds();
        summary.result = classify_scene(elements, *candidates, folder, options);
        summary.classify_seconds = watch.lap();
        summary.processor_seconds = processor_seconds() - before;

        // Truth.
        std::string truth_text;
        if (truth) {
            TruthOptions true_options;
            true_options.classify = options.classify;
            true_options.max_pairs = truth_pairs;
            true_options.threads = threads;
            true_options.progress = terminal_progress("truth");
            true_options.say = [](const std::string& line) { std::fprintf(stderr, "%s\n", line.c_str()); };
            truth_text = to_text(write_truth(elements, *candidates, folder, true_options));
        }

        // Summary.
        summary.parameters = {{"scene", scene.path},
                              {"level", std::to_string(meshing.level)},
                              {"edge", meshing.edge},
                              {"margin", meshing.box.margin},
                              {"height", meshing.box.height},
                              {"buffer", levels.name()},
                              {"mode", mode.name()},
                              {"source", source.name()},
                              {"threads", std::to_string(threads)}};
        summary.omissions = omissions;
        summary.polygons = static_cast<std::uint64_t>(read_scene.polygon_count());
        summary.skipped = read_scene.invalid().size();
        summary.tree_bytes = candidates->memory();
        summary.peak_bytes = peak_memory();
        write_file(folder + "/summary.json", to_json(summary));
        std::fputs(to_text(summary).c_str(), stdout);
        std::fputs(truth_text.c_str(), stdout);
    }
};

}  // namespace

void add_classify(CLI::App& app) {
    auto& command = *app.add_subcommand(
        "classify", "The state of every element's Close Object Buffer: tables, a PLY coloured by state, a summary");
    const auto options = std::make_shared<ClassifyCommand>();
    options->add_to(command);
    command.callback([options] { options->run(); });
}

}  // namespace cob::cli
