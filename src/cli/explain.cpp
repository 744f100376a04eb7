// cob explain: one element in words.
#include "report/explain.hpp"

#include "cli/commands.hpp"
#include "cli/options.hpp"
#include "cob/error.hpp"

#include <algorithm>
#include <cstdio>
#include <memory>
#include <string>

namespace cob::cli {
namespace {

/// A box number of the meshing, or nothing.
std::optional<std::uint64_t> parse_number(const std::string& text) {
    const bool digits = !text.empty() && text.size() <= 15 &&
                        std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
    return digits ? std::optional<std::uint64_t>(std::stoull(text)) : std::nullopt;
}

struct ExplainCommand {
    SceneOptions scene;
    MeshingOptions meshing;
    std::string element;

    void add_to(CLI::App& command) {
        scene.add_to(command);
        command
            .add_option("ELEMENT", element,
                        "A box number as classify gives it with the same --level and --edge, or an address: "
                        "POLYGON.ROOT, POLYGON.ROOT/PATH (which child, 0 to 3, at each refinement) or "
                        "POLYGON.ROOT:LEVEL_I,LEVEL_J:I,J")
            ->required();
        meshing.add_to(command);
    }

    void run() const {
        BufferOptions buffer;
        meshing.box.set(buffer);
        const Meshing cut = meshing.meshing();
        const Scene read_scene = scene.read();
        const Roots roots(read_scene);

        ExplainedElement what;
        what.margin = buffer.margin;
        what.height = buffer.height;
        what.number = parse_number(element);
        if (what.number) {
            const ElementList elements(read_scene, roots, cut);
            if (elements.size() == 0)
                throw InputError("the scene has no elements", {scene.path, 0, "", "give one with valid polygons"});
            if (*what.number >= elements.size())
                throw InputError(
                    "no such box",
                    {"", 0, element, "give 0 to " + std::to_string(elements.size() - 1) + " or an address"});
            what.element = elements[*what.number];
        } else {
            what.element = parse_address(read_scene, roots, element);
        }
        const auto candidates = make_candidates(read_scene, Source::all);
        std::fputs(explain(read_scene, roots, *candidates, what).c_str(), stdout);
    }
};

}  // namespace

void add_explain(CLI::App& app) {
    auto& command = *app.add_subcommand(
        "explain", "One element in words: its box, every polygon near it, and why its buffer's state follows");
    const auto options = std::make_shared<ExplainCommand>();
    options->add_to(command);
    command.callback([options] { options->run(); });
}

}  // namespace cob::cli
