#include "cli/commands.hpp"
#include "cli/number_checks.hpp"
#include "cob/error.hpp"
#include "cob/files.hpp"
#include "cob/golden.hpp"
#include "cob/verify/report.hpp"

#include <algorithm>
#include <cstdio>
#include <memory>
#include <sstream>

namespace cob::cli {

namespace {

struct Arguments {
    std::string set, answers, junit, json;
    std::string hit = "crossing,boundary";
    int band = 53;
    verify::Options options;
};

std::vector<verify::Relation> parse_hits(const std::string& text) {
    static const std::vector<std::string> allowed{"base", "coplanar", "boundary", "crossing"};
    std::vector<verify::Relation> hits;
    std::istringstream words(text);
    for (std::string word; std::getline(words, word, ',');) {
        const auto found = std::find(allowed.begin(), allowed.end(), word);
        if (found == allowed.end())
            throw InputError("unknown relation in --hit",
                             {"", 0, word, "name some of crossing,boundary,coplanar,base, separated by commas"});
        hits.push_back(static_cast<verify::Relation>(found - allowed.begin() + 1));
    }
    return hits;
}

void run(Arguments& arguments) {
    if (!arguments.json.empty() && arguments.json == arguments.junit)
        throw InputError("--json and --junit are one file", {"", 0, arguments.json, "choose two"});
    arguments.options.hit = parse_hits(arguments.hit);
    if (arguments.band <= 52) arguments.options.near_band = arguments.band;

    const verify::Report report = verify_answers(arguments.set, arguments.answers, arguments.options);
    std::fputs(to_text(report).c_str(), stdout);
    if (!arguments.json.empty()) write_file(arguments.json, to_json(report));
    if (!arguments.junit.empty()) write_file(arguments.junit, to_junit(report));
    if (!report.agree()) throw CLI::RuntimeError(1);
}

}  // namespace

void add_verify(CLI::App& app) {
    auto arguments = std::make_shared<Arguments>();
    CLI::App* command = app.add_subcommand("verify", "Compare a variant's answer tables with a golden set");
    command->add_option("set", arguments->set, "Folder of the golden set")->required();
    command
        ->add_option("answers", arguments->answers,
                     "Folder of the variant's relations.csv, states.csv and visibility.csv, or fewer; "
                     "relations.csv may have the columns box,polygon,close and visibility.csv segment,hidden (0 or 1)")
        ->required();
    command->add_flag("--strict", arguments->options.strict,
                      "Grazing segments must be answered grazing (hidden: 0); else either way is accepted");
    command
        ->add_option("--band", arguments->band,
                     "Count disagreements on questions of this band or more apart, as near (53: none). A question's "
                     "band is the smallest k from 8 to 52 such that its box grown and shrunk by 2^-k of its size, or "
                     "its segment with the ends moved by as much, has the same answers: 52 is on a switch")
        ->check(CLI::Range(0, 53));
    command->add_option("--hit", arguments->hit, "Relations that close = 1 stands for, separated by commas");
    command->add_option("--list", arguments->options.listed, "Disagreements to describe, of each table")
        ->check(whole_number());
    command->add_option("--junit", arguments->junit, "Write a JUnit report to this file");
    command->add_option("--json", arguments->json, "Write all counts to this file as JSON");
    command->footer("Exit code: 0 all answers agree, 1 some disagree or are missing, 2 bad input.");
    command->callback([arguments] { run(*arguments); });
}

}  // namespace cob::cli
