#include "cli/options.hpp"

#include "cli/terminal.hpp"
#include "cob/error.hpp"
#include "scene/remarks.hpp"

#include <filesystem>

namespace cob::cli {

Rational exact_option(const char* option, const std::string& text, bool positive) {
    const auto value = parse_exact(text);
    if (!value || *value < 0 || (positive && *value == 0))
        throw InputError(std::string(option) + " is no number " + (positive ? "above 0" : "from 0 up"),
                         {"", 0, text.empty() ? "(nothing)" : text, "give a decimal, a C hex-float or a fraction p/q"});
    return *value;
}

CLI::Option* SceneOptions::add_to(CLI::App& command) {
    CLI::Option* scene = command.add_option("SCENE", path, "OBJ file of the scene")->required()->capture_default_str();
    add_skip_invalid_to(command);
    return scene;
}

void SceneOptions::add_skip_invalid_to(CLI::App& command) {
    command.add_flag("--skip-invalid", skip_invalid,
                     "Go on where polygons are refused: they are listed, keep their numbers and occur in no answer");
}

void SceneOptions::add_emission_to(CLI::App& command) {
    command.add_option("--emission", emission, "What Ke means, exitance or radiance (exitance = pi radiance)")
        ->check(CLI::IsMember({"exitance", "radiance"}));
}

Scene SceneOptions::read() const {
    ReadOptions options;
    options.skip_invalid = skip_invalid;
    options.emission_is_radiance = emission == "radiance";
    ReadReport report;
    Scene scene = read_obj(path, options, &report);
    for (const std::string& remark : remarks_on(scene, report, path)) remark_on_terminal(remark);
    return scene;
}

void refuse_overwriting(const std::string& output, const std::vector<std::string>& inputs) {
    for (const std::string& input : inputs) {
        std::error_code missing;
        if (std::filesystem::equivalent(output, input, missing))
            throw InputError("output would overwrite an input", {output, 0, "", "choose another file or folder"});
    }
}

TablePath::TablePath(const std::string& out, const std::string& name) : path_(out) {
    const std::string ending = ".csv";
    if (out.size() > ending.size() && out.compare(out.size() - ending.size(), ending.size(), ending) == 0) {
        const std::string parent = std::filesystem::path(out).parent_path().string();
        if (!parent.empty()) folder_.emplace(parent);
        return;
    }
    folder_.emplace(out);
    path_ = out + "/" + name;
}

void BoxOptions::add_to(CLI::App& command) {
    command.add_option("--margin", margin, "Widening of the box on each side, as a fraction of the element's extent");
    command.add_option("--height", height, "Height of the box, as a fraction of its shorter widened extent");
}

void MeshingOptions::add_to(CLI::App& command) {
    command.add_option("--level", level, "Refinements below the patches; each makes 4 elements of one")
        ->check(CLI::Range(0, 20));
    command.add_option("--edge", edge, "Longest side of a patch, in the scene's unit; 0: every piece is one patch");
    box.add_to(command);
}

Meshing MeshingOptions::meshing() const {
    const auto length = to_binary64(exact_option("--edge", edge, false));
    if (!length) throw InputError("--edge is no binary64 number", {"", 0, edge, "give a decimal"});
    return {*length, level};
}

void SourceOption::add_to(CLI::App& command) {
    Choice::add_to(command, "--source",
                   "Where candidates come from: a CGAL AABB tree, Embree, an octree, or all polygons");
}

void KeepOptions::add_to(CLI::App& command) {
    command.add_option(
        "--keep", names,
        "Do what this scene does not need, of " + OmissionSet::all().to_text() + "; same result, slower");
    command.add_flag("--keep-all", all, "Leave nothing out: same result, slower");
}

OmissionSet KeepOptions::set() const {
    return all ? OmissionSet::all() : OmissionSet::parse(names);
}

void add_threads(CLI::App& command, int& threads) {
    command.add_option("--threads", threads, "Number of threads; 0: one for each processor")
        ->check(CLI::Range(0, 1024));
}

void add_output_folder(CLI::App& command, std::string& folder) {
    command.add_option("-o,--output", folder, "Folder for the results; it is created")->required();
}

}  // namespace cob::cli
