// cob info: what is in a scene.
#include "cli/commands.hpp"
#include "cli/options.hpp"
#include "cob/files.hpp"
#include "report/census_report.hpp"
#include "scene/json_text.hpp"

#include <cstdio>
#include <memory>

namespace cob::cli {
namespace {

struct InfoArguments {
    SceneOptions scene;
    std::string json;
};

void run_info(const InfoArguments& arguments) {
    // Invalid polygons are part of the answer here, so they never end it.
    ReadReport read;
    const std::string& path = arguments.scene.path;
    refuse_overwriting(arguments.json, {path});
    const Scene scene = read_obj(path, {true, arguments.scene.emission == "radiance"}, &read);
    const Census census = take_census(scene);
    const std::vector<PolygonId> decimal = planar_as_decimal(scene, path);
    const Omissions omissions(scene, Roots(scene), {});
    const SceneInfo info{scene, read, census, decimal, omissions};
    if (!arguments.json.empty()) write_file(arguments.json, json_text(info_json(info)));
    std::fputs(info_text(info).c_str(), stdout);
}

}  // namespace

void add_info(CLI::App& app) {
    const auto arguments = std::make_shared<InfoArguments>();
    CLI::App* command = app.add_subcommand(
        "info",
        "What is in a scene, exactly: polygons, pieces, contacts, what they need of the machinery, and what not");
    arguments->scene.add_to(*command);
    command->get_option("--skip-invalid")->description("No need to: info lists invalid polygons in any case");
    arguments->scene.add_emission_to(*command);
    command->add_option("--json", arguments->json, "Write everything, all lists complete, to this file, too");
    command->callback([arguments] { run_info(*arguments); });
}

}  // namespace cob::cli
