// cob stress: stiff and extreme cases, each with what is expected and what came out.
#include "arithmetic/process.hpp"
#include "cli/commands.hpp"
#include "cli/options.hpp"
#include "cli/terminal.hpp"
#include "cob/files.hpp"
#include "report/stress_report.hpp"

#include <cstdio>
#include <memory>
#include <string>
#include <vector>

namespace cob::cli {
namespace {

struct StressCommand {
    SceneOptions scene;
    std::string folder;
    std::vector<std::string> scenes;
    bool quick = false;

    void run() {
        StressOptions options;
        options.quick = quick;
        options.progress = terminal_progress("stress case");
        std::vector<Scene> read_scenes;  // all of them before the work, so that a bad one is told at once
        for (const std::string& path : scenes) {
            scene.path = path;
            read_scenes.push_back(scene.read());
        }
        const OutputFolder created(folder);

        Stopwatch watch;
        report::StressResults results;
        results.geometry = stress_geometry(options);
        const auto append = [&results](const std::vector<StressRow>& rows) {
            results.others.insert(results.others.end(), rows.begin(), rows.end());
        };
        append(stress_photometry(options));
        append(stress_stiff(options));
        for (std::size_t i = 0; i < read_scenes.size(); ++i)
            append(stress_sensitivity(read_scenes[i], scenes[i], options));
        results.seconds = watch.lap();

        const std::string text = report::stress_text(results);
        write_file(folder + "/stress.csv", report::stress_csv(results));
        write_file(folder + "/geometry.csv", report::stress_geometry_csv(results));
        write_file(folder + "/stress.txt", text);
        write_file(folder + "/stress.html", report::stress_html(results));
        std::fputs(text.c_str(), stdout);
        if (!results.pass()) throw CLI::RuntimeError(1);
    }
};

}  // namespace

void add_stress(CLI::App& app) {
    auto& command = *app.add_subcommand(
        "stress", "Stiff and extreme cases, each with what is expected and what came out; exit code 1 where one fails");
    const auto options = std::make_shared<StressCommand>();
    add_output_folder(command, options->folder);
    command.add_option("--scene", options->scenes,
                       "OBJ file; repeatable: how many answers change when every coordinate moves by one ulp");
    options->scene.add_skip_invalid_to(command);
    command.add_flag("--quick", options->quick, "A subset of the cases, in seconds");
    command.callback([options] { options->run(); });
}

}  // namespace cob::cli
