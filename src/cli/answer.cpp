// cob answer: answers the questions of a set.
#include "cob/answer.hpp"

#include "cli/commands.hpp"
#include "cli/options.hpp"
#include "cli/terminal.hpp"

#include <cstdio>
#include <map>
#include <memory>
#include <string>

namespace cob::cli {
namespace {

const std::map<std::string, Arithmetic>& arithmetics() {
    static const std::map<std::string, Arithmetic> names = {
        {"exact", Arithmetic::exact},     {"float", Arithmetic::binary32},    {"double", Arithmetic::binary64},
        {"epsilon", Arithmetic::epsilon}, {"interval", Arithmetic::interval}, {"rational", Arithmetic::rational}};
    return names;
}

const std::map<std::string, Peer>& peers() {
    static const std::map<std::string, Peer> names = {
        {"embree", Peer::embree}, {"cgal-epick", Peer::cgal_epick}, {"cgal-epeck", Peer::cgal_epeck}};
    return names;
}

struct AnswerCommand {
    std::string set, folder, arithmetic = "exact";
    SourceOption source;
    AnswerOptions options;

    void add_to(CLI::App& command) {
        command.add_option("SET", set, "Folder with scene.obj and boxes.csv, segments.csv or points.csv")->required();
        command
            .add_option(
                "--arithmetic", arithmetic,
                "Arithmetic of the answers; exact: filter first, then exactly; rational: fractions alone; or other "
                "people's yes or no: embree of segments (hidden?), cgal-* of axis-aligned boxes (closed box met?)")
            ->check(CLI::IsMember(
                {"exact", "float", "double", "epsilon", "interval", "rational", "embree", "cgal-epick", "cgal-epeck"}));
        source.add_to(command);
        add_threads(command, options.threads);
        command.add_flag("--skip-invalid", options.skip_invalid,
                         "Go on where polygons are refused: they keep their numbers and occur in no answer");
        add_output_folder(command, folder);
    }

    void run() {
        if (const auto peer = peers().find(arithmetic); peer != peers().end())
            options.peer = peer->second;
        else
            options.arithmetic = arithmetics().at(arithmetic);
        options.source = source();
        options.progress = terminal_progress("answering");
        options.say = remark_on_terminal;
        const AnswerSummary summary = answer_set(set, folder, options);
        const auto whole = [](std::uint64_t value) { return static_cast<unsigned long long>(value); };
        if (summary.has_boxes)
            std::printf("boxes %llu, relations %llu\n", whole(summary.boxes), whole(summary.relations));
        if (summary.has_segments) std::printf("segments %llu\n", whole(summary.segments));
        if (summary.has_points) std::printf("irradiances %llu\n", whole(summary.irradiances));
        if (summary.undecided > 0) std::printf("undecided %llu\n", whole(summary.undecided));
        std::printf("predicates: %llu filtered, %llu integer, %llu rational\n", whole(summary.predicates.filtered),
                    whole(summary.predicates.integer), whole(summary.predicates.rational));
    }
};

}  // namespace

void add_answer(CLI::App& app) {
    auto& command = *app.add_subcommand("answer",
                                        "Answers the questions of a set: states.csv and relations.csv for boxes, "
                                        "visibility.csv for segments, irradiance.csv for "
                                        "points");
    const auto options = std::make_shared<AnswerCommand>();
    options->add_to(command);
    command.callback([options] { options->run(); });
}

}  // namespace cob::cli
