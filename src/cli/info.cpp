// cob info: what is in a scene.
#include "cli/commands.hpp"
#include "cob/files.hpp"
#include "report/census_report.hpp"

#include <nlohmann/json.hpp>

#include <cstdio>
#include <memory>

namespace cob::cli {
namespace {

struct InfoArguments {
    std::string scene, json;
    bool skip_invalid = false, emission_is_radiance = false;
};

void run_info(const InfoArguments& arguments) {
    // Invalid polygons are part of the answer here, so they never end it.
    ReadReport read;
    const Scene scene = read_obj(arguments.scene, {true, arguments.emission_is_radiance}, &read);
    const Census census = take_census(scene);
    const std::vector<PolygonId> decimal = planar_as_decimal(scene, arguments.scene);
    const SceneInfo info{scene, read, census, decimal};
    if (!arguments.json.empty()) {
        // Names in files may be in any encoding; JSON is UTF-8.
        constexpr auto replace = nlohmann::ordered_json::error_handler_t::replace;
        write_file(arguments.json, info_json(info).dump(2, ' ', false, replace) + "\n");
    }
    std::fputs(info_text(info).c_str(), stdout);
}

}  // namespace

void add_info(CLI::App& app) {
    const auto arguments = std::make_shared<InfoArguments>();
    CLI::App* command = app.add_subcommand(
        "info", "What is in a scene, exactly: polygons, pieces, contacts, and what they need of the machinery");
    command->add_option("SCENE", arguments->scene, "OBJ file")->required();
    command->add_flag("--skip-invalid", arguments->skip_invalid,
                      "Accepted as by every command; info lists invalid polygons in any case");
    command->add_flag("--emission-is-radiance", arguments->emission_is_radiance,
                      "Ke is radiance: the emitted exitance is pi times Ke");
    command->add_option("--json", arguments->json, "Write everything, all lists complete, to this file, too");
    command->callback([arguments] { run_info(*arguments); });
}

}  // namespace cob::cli
