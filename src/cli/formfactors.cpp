#include "cli/commands.hpp"
#include "cli/number_checks.hpp"
#include "cli/options.hpp"
#include "cli/terminal.hpp"
#include "cob/error.hpp"
#include "cob/form_factors.hpp"
#include "cob/tables.hpp"

#include <charconv>
#include <cstdio>
#include <memory>

namespace cob::cli {
namespace {

struct Arguments {
    SceneOptions scene;
    SourceOption source;
    FormFactorOptions options;
    std::vector<std::string> pairs;
    std::string out;
};

/// "I,J"
std::pair<PolygonId, PolygonId> parse_pair(const std::string& text) {
    std::pair<PolygonId, PolygonId> pair;
    const char* end = text.data() + text.size();
    auto [first_end, first_error] = std::from_chars(text.data(), end, pair.first);
    if (first_error == std::errc() && first_end != end && *first_end == ',') {
        const auto [last, error] = std::from_chars(first_end + 1, end, pair.second);
        if (error == std::errc() && last == end) return pair;
    }
    throw InputError("unreadable --pairs", {"", 0, text, "give two polygon numbers as I,J"});
}

void say_plan(const FormFactorPlan& plan) {
    const auto count = [](std::uint64_t n) { return static_cast<unsigned long long>(n); };
    std::fprintf(stderr,
                 "%llu pairs: %llu do not face each other, %llu hidden, %llu free (closed form), %llu obstructed",
                 count(plan.pairs), count(plan.not_facing), count(plan.hidden), count(plan.unobstructed),
                 count(plan.obstructed));
    if (plan.obstructed > 0)
        std::fprintf(stderr, " by %.1f pieces on average: about %.1f s of one core", plan.occluders, plan.seconds);
    std::fprintf(stderr, "\n");
}

void run(const Arguments& arguments) {
    std::vector<std::pair<PolygonId, PolygonId>> pairs;
    for (const std::string& text : arguments.pairs) pairs.push_back(parse_pair(text));
    if (!(arguments.options.tolerance > 0))
        throw InputError("bad --tolerance", {"", 0, to_text(arguments.options.tolerance), "give a number above 0"});
    const Scene scene = arguments.scene.read();
    const auto candidates = make_candidates(scene, arguments.source());

    FormFactorMatrix matrix(scene, *candidates, arguments.options);
    say_plan(matrix.plan(pairs, terminal_progress("shafts")));
    // Opened before the work: a folder that is not writable is told now.
    const TablePath path(arguments.out, table_name<FormFactorRow>());
    refuse_overwriting(path(), {arguments.scene.path});
    TableWriter<FormFactorRow> table(path());
    const FormFactorResult result = matrix.compute(terminal_progress("form factors"));

    for (const PolygonFormFactor& value : result.values) table.write({value.from, value.to, value.value, value.error});
    table.commit();

    std::printf("%zu form factors, %llu exact values of points\n", result.values.size(),
                static_cast<unsigned long long>(result.evaluations));
    if (result.above_goal > 0)
        std::printf("%llu of them with an error above the tolerance: raise --evaluations\n",
                    static_cast<unsigned long long>(result.above_goal));
    if (arguments.options.both_sides)
        std::printf("reciprocity: both sides differ by at most %.2g, %.2g of the sum of their errors\n",
                    result.reciprocity, result.reciprocity_in_errors);
    else
        std::printf(
            "reciprocity: used, each pair computed at the smaller polygon, at both where that falls short "
            "(--both-sides checks "
            "it)\n");
}

}  // namespace

void add_formfactors(CLI::App& app) {
    auto arguments = std::make_shared<Arguments>();
    CLI::App* command =
        app.add_subcommand("formfactors", "Obstructed form factors from polygon to polygon, each with its error");
    arguments->scene.add_to(*command);
    arguments->source.add_to(*command);
    command->add_option("--pairs", arguments->pairs, "Only these pairs of polygons, both ways: I,J ... (default: all)");
    command->add_option("--tolerance", arguments->options.tolerance, "Goal of the error of each form factor");
    command
        ->add_option("--evaluations", arguments->options.max_evaluations,
                     "At most so many exact point values for a pair of pieces, from each side")
        ->check(positive_whole_number());
    command->add_flag("--certified", arguments->options.certified,
                      "Guaranteed bounds: the true value is within error of form_factor");
    command
        ->add_option("--subdivisions", arguments->options.max_subdivisions,
                     "At most so many triangles for a pair of pieces, from each side (--certified)")
        ->check(positive_whole_number());
    command->add_flag("--both-sides", arguments->options.both_sides,
                      "Compute F_ij and F_ji on their own and report how well A_i F_ij = A_j F_ji holds");
    add_threads(*command, arguments->options.threads);
    command->add_option("-o,--out", arguments->out, "CSV file, or folder for formfactors.csv")->required();
    command->callback([arguments] { run(*arguments); });
}

}  // namespace cob::cli
