// cob occlude: one segment, explained.
#include "cli/commands.hpp"
#include "cli/options.hpp"
#include "cob/candidates.hpp"
#include "cob/error.hpp"
#include "cob/visibility.hpp"
#include "report/segment_report.hpp"

#include <cstdio>
#include <memory>
#include <string>
#include <vector>

namespace cob::cli {
namespace {

struct OccludeArguments {
    SceneOptions scene;
    std::vector<std::string> coordinates;
};

ExactPoint exact_point(const std::vector<std::string>& texts, std::size_t first) {
    RationalPoint point;
    for (int axis = 0; axis < 3; ++axis) {
        const std::string& text = texts[first + static_cast<std::size_t>(axis)];
        const auto value = parse_exact(text);
        if (!value) throw InputError("not a coordinate", {"", 0, text, "write a decimal, a C hex-float or p/q"});
        point[axis] = *value;
    }
    return ExactPoint(point);
}

void run_occlude(const OccludeArguments& arguments) {
    const Segment segment{exact_point(arguments.coordinates, 0), exact_point(arguments.coordinates, 3)};
    const Scene scene = arguments.scene.read();
    // One question is answered sooner than a tree is built.
    const auto candidates = make_candidates(scene, Source::all);
    const VisibilityOracle oracle(scene, *candidates);
    const Explanation explanation = oracle.explain(segment);
    const std::string text = segment_text({scene, segment, explanation, oracle.nearest_blocker(segment)});
    std::fputs(text.c_str(), stdout);
}

}  // namespace

void add_occlude(CLI::App& app) {
    const auto arguments = std::make_shared<OccludeArguments>();
    CLI::App* command = app.add_subcommand(
        "occlude", "What the open segment between two points meets, in order, and why it is clear, grazing or blocked");
    arguments->scene.add_to(*command);
    command
        ->add_option("COORDINATES", arguments->coordinates,
                     "X0 Y0 Z0 X1 Y1 Z1, each a decimal, a C hex-float or a fraction p/q, taken exactly")
        ->expected(6)
        ->required();
    command->callback([arguments] { run_occlude(*arguments); });
}

}  // namespace cob::cli
