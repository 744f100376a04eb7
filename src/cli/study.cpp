// cob study: error of exitance against time and elements, and the paper's claims.
#include "arithmetic/threads.hpp"
#include "cli/commands.hpp"
#include "cli/number_checks.hpp"
#include "cli/options.hpp"
#include "cli/terminal.hpp"
#include "cob/error.hpp"
#include "cob/files.hpp"
#include "golden/scene_writer.hpp"
#include "golden/sha256.hpp"
#include "radiosity/photometric_range.hpp"
#include "report/claims_report.hpp"
#include "report/study_report.hpp"

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>

namespace cob::cli {
namespace {

struct StudyCommand {
    SceneOptions scene;
    std::string folder, light = "direct", data = COB_DATA_FOLDER;
    bool claims = false, quick = false;
    std::vector<std::string> only;
    std::vector<double> within;
    std::size_t points = 2000, unknowns = 400;
    int budgets = 0, repeats = 3, threads = 0, shots = 60;

    void run() const {
        if (claims != scene.path.empty())
            throw InputError(claims ? "--claims takes no scene: it measures on those of --data" : "no scene is given",
                             {"", 0, scene.path, claims ? "leave SCENE out" : "give an OBJ file, or --claims"});
        claims ? run_claims() : run_study();
    }

    /// Runs are kept by what they depend on: another scene, materials and all, reference or commit are other runs.
    std::string kept(const Scene& read_scene, const BenchMachine& machine) const {
        const SceneText text = write_scene(read_scene);
        Sha256 hash;
        hash.update(text.obj);
        hash.update(text.mtl);
        for (const std::string& word : {light, std::to_string(points), std::to_string(unknowns),
                                        std::to_string(repeats), std::to_string(threads), machine.commit})
            hash.update(word + "\n");
        for (const double bound : within) hash.update(to_text(bound) + "\n");
        return folder + "/runs/" + hash.finish().substr(0, 16);
    }

    /// Nothing where the line is cut off: the last number of a part of it would be another.
    static std::optional<StudyRun> kept_run(const std::string& file, const StudySettings& settings) {
        std::string line = read_file(file);
        if (line.empty() || line.back() != '\n') return std::nullopt;
        line.pop_back();
        return study_run_from_line(line, settings);
    }

    void run_study() const {
        const Scene read_scene = scene.read();
        report::StudyResults results;
        results.scene = std::filesystem::path(scene.path).stem().string();
        results.machine = bench_machine();
        results.threads = thread_count(threads);
        const std::string runs = kept(read_scene, results.machine);
        const bool full = light == "full";
        // Before the work; with dimmed reflectances even a mirror has direct light.
        full || shots > 0 ? radiosity::check_solvable(read_scene) : radiosity::check_photometric_range(read_scene);
        const OutputFolder created(runs);

        StudyRegion region;
        if (!within.empty()) {
            region.bounds.emplace();
            std::copy(within.begin(), within.end(), region.bounds->begin());
        }
        const Progress reference = terminal_progress("reference");
        results.reference = full ? study_transport_reference(read_scene, points, unknowns, threads, reference, region)
                                 : study_reference(read_scene, points, reference, region);
        const std::vector<StudySettings> plan = study_plan(read_scene, results.reference.light,
                                                           budgets > 0 ? budgets
                                                           : full      ? 2
                                                                       : 5);
        std::fprintf(stderr, "cob: %zu runs, %d times each; Ctrl-C ends, and a rerun goes on\n", plan.size(), repeats);
        const Progress progress = terminal_progress("runs");
        const Progress alive = [&](std::uint64_t, std::uint64_t) { progress(results.runs.size(), plan.size()); };
        for (const StudySettings& settings : plan) {
            const std::string file = runs + "/" + settings.key() + ".csv";
            std::optional<StudyRun> run;
            if (exists(file)) run = kept_run(file, settings);
            if (!run) {
                run = study_run(read_scene, results.reference, settings, repeats, threads, alive);
                write_file(file, to_line(*run) + "\n");
            }
            results.runs.push_back(*run);
            alive(0, 0);
        }
        if (shots > 0) {
            const std::optional<std::string> view = report::view_beside(scene.path);
            results.pictures =
                report::draw_study(read_scene, view ? report::read_view(*view) : report::default_camera(read_scene),
                                   results.runs.back().settings, shots, threads, folder, alive);
        }
        report::write_study(results, folder);
        std::fputs(report::study_text(results).c_str(), stdout);
    }

    void run_claims() const {
        const OutputFolder created(folder);
        ClaimOptions options;
        options.data = data;
        options.folder = folder;
        options.quick = quick;
        options.threads = threads;
        options.progress = terminal_progress("claims: case");
        const std::vector<ClaimResult> results = measure_claims(only, options);
        report::write_claims(results, {bench_machine(), thread_count(threads), quick}, folder);
        std::fputs(report::claims_text(results).c_str(), stdout);
    }
};

}  // namespace

void add_study(CLI::App& app) {
    auto& command = *app.add_subcommand("study",
                                        "Error against time and elements: uniform, gradient, buffer and both, over "
                                        "budgets; or, with --claims, the paper's claims, measured");
    const auto options = std::make_shared<StudyCommand>();
    options->scene.add_to(command)->required(false)->description(
        "OBJ file of the scene, without --claims; a .view file beside it is the camera");
    command.add_option("--light", options->light, "direct: from the lights alone; full: reflected any number of times")
        ->check(CLI::IsMember({"direct", "full"}));
    command.add_option("--points", options->points, "Points of the reference")->check(CLI::Range(1, 1000000));
    command.add_option("--unknowns", options->unknowns, "Patches of the reference of full transport, at least")
        ->check(CLI::Range(1, 20000));
    command
        .add_option("--within", options->within,
                    "XMIN YMIN ZMIN XMAX YMAX ZMAX: points of the reference in this box only")
        ->expected(6)
        ->check(finite());
    command
        .add_option("--budgets", options->budgets,
                    "How many uniform meshes, each with half the edge of the one before; 0: 5, of full light 2")
        ->check(CLI::Range(0, 10));
    command.add_option("--repeats", options->repeats, "Runs of each setting, for the times")
        ->check(CLI::Range(1, 1000));
    command.add_option("--picture-shots", options->shots, "Shots of the pictures; 0: no pictures")
        ->check(whole_number());
    add_threads(command, options->threads);
    command.add_flag("--claims", options->claims, "The paper's claims instead: what was measured, and the verdict");
    command.add_option("--only", options->only, "Of the claims only these")->check(CLI::IsMember(claim_ids()));
    command.add_option("--data", options->data, "Folder of the shipped scenes, for --claims");
    command.add_flag("--quick", options->quick, "Claims on the smallest scenes and meshes, in seconds");
    command
        .add_option("-o,--output", options->folder,
                    "Folder for study.html, study.csv, bar.csv, plots and the kept runs; or claims.html, claims.csv")
        ->required();
    command.callback([options] { options->run(); });
}

}  // namespace cob::cli
