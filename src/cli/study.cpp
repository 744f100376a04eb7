// cob study: error of exitance against time and elements.
#include "cli/commands.hpp"
#include "cli/terminal.hpp"
#include "cob/files.hpp"
#include "golden/sha256.hpp"
#include "report/study_report.hpp"

#include <sys/utsname.h>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>

namespace cob::cli {
namespace {

std::string machine() {
    utsname name{};
    ::uname(&name);
    return std::string(name.sysname) + " " + name.release + " " + name.machine + ", " +
           std::to_string(std::thread::hardware_concurrency()) + " processors";
}

struct StudyCommand {
    std::string scene, folder, commit;
    bool skip_invalid = false;
    std::size_t points = 2000;
    int budgets = 5, repeats = 3, threads = 0;

    /// Runs are kept by what they depend on: another scene, or other points, are other runs.
    std::string kept() const {
        Sha256 hash;
        hash.update(read_file(scene));
        return folder + "/runs/" + hash.finish().substr(0, 16) + "_" + std::to_string(points) + "points_" +
               std::to_string(repeats) + "times_" + std::to_string(threads) + "threads";
    }

    void run() const {
        const Scene read_scene = read_obj(scene, ReadOptions{skip_invalid, false});
        const std::string name = std::filesystem::path(scene).stem().string();
        const std::string runs = kept();
        create_folder(runs);

        report::StudyResults results;
        results.scene = name;
        results.machine = machine();
        results.commit = commit;
        results.reference = study_reference(read_scene, points, terminal_progress("exact irradiance"));

        const std::vector<StudySettings> plan = study_plan(read_scene, budgets);
        const Progress progress = terminal_progress("runs");
        for (const StudySettings& settings : plan) {
            progress(results.runs.size(), plan.size());
            const std::string file = runs + "/" + settings.key() + ".csv";
            std::optional<StudyRun> run;
            if (std::filesystem::exists(file)) run = study_run_from_line(read_file(file), settings);
            if (!run) {
                run = study_run(read_scene, results.reference, settings, repeats, threads);
                write_file(file, to_line(*run));
            }
            results.runs.push_back(*run);
        }
        report::write_study(results, folder);
        std::fputs(report::study_text(results).c_str(), stdout);
    }
};

}  // namespace

void add_study(CLI::App& app) {
    auto& command = *app.add_subcommand(
        "study", "Error of direct light against time and elements: uniform, gradient, buffer and both, over budgets");
    const auto options = std::make_shared<StudyCommand>();
    command.add_option("SCENE", options->scene, "OBJ file")->required();
    command.add_flag("--skip-invalid", options->skip_invalid, "Leave polygons out that SPEC 2 refuses");
    command.add_option("--points", options->points, "Points of the reference")->check(CLI::Range(1, 1000000));
    command.add_option("--budgets", options->budgets, "How often the smallest edge halves")->check(CLI::Range(1, 10));
    command.add_option("--repeats", options->repeats, "Runs of each setting, for the times")
        ->check(CLI::Range(1, 1000));
    command.add_option("--commit", options->commit, "What the page says about the version of the program");
    command.add_option("--threads", options->threads, "0: all")->check(CLI::NonNegativeNumber);
    command.add_option("-o,--output", options->folder, "Folder for study.html, study.csv, plots and the kept runs")
        ->required();
    command.callback([options] { options->run(); });
}

}  // namespace cob::cli
