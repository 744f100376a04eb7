#include "cli/commands.hpp"
#include "cli/options.hpp"
#include "cli/terminal.hpp"
#include "cob/irradiance_table.hpp"
#include "cob/tables.hpp"

#include <cstdio>
#include <memory>

namespace cob::cli {
namespace {

struct Arguments {
    SceneOptions scene;
    SourceOption source;
    std::string points, out = ".";
    int threads = 0;
};

void run(const Arguments& arguments) {
    const Scene scene = arguments.scene.read();
    const auto candidates = make_candidates(scene, arguments.source());
    IrradianceTableOptions options;
    options.threads = arguments.threads;
    options.progress = terminal_progress("irradiance");
    options.tell_cost = [](const IrradianceCost& cost) {
        std::fprintf(stderr, "%llu points, %llu lights: about %.1f s of one core\n",
                     static_cast<unsigned long long>(cost.points), static_cast<unsigned long long>(cost.lights),
                     cost.seconds);
    };
    const TablePath table(arguments.out, table_name<IrradianceRow>());
    refuse_overwriting(table(), {arguments.scene.path, arguments.points});
    const IrradianceTableResult result = write_irradiance(scene, *candidates, arguments.points, table(), options);
    std::printf("%llu rows, %llu of them obstructed in part, %llu wholly\n",
                static_cast<unsigned long long>(result.rows), static_cast<unsigned long long>(result.partly),
                static_cast<unsigned long long>(result.wholly));
}

}  // namespace

void add_irradiance(CLI::App& app) {
    auto arguments = std::make_shared<Arguments>();
    CLI::App* command =
        app.add_subcommand("irradiance", "Exact irradiance at points from every light, behind whatever stands between");
    arguments->scene.add_to(*command);
    arguments->scene.add_emission_to(*command);
    arguments->source.add_to(*command);
    command->add_option("points", arguments->points, "CSV table: point,x,y,z,nx,ny,nz")->required();
    command->add_option("-o,--out", arguments->out, "CSV file, or folder for irradiance.csv");
    add_threads(*command, arguments->threads);
    command->callback([arguments] { run(*arguments); });
}

}  // namespace cob::cli
