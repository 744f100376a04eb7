#include "cob/bench.hpp"

#include "cli/commands.hpp"
#include "cli/number_checks.hpp"
#include "cli/terminal.hpp"
#include "cob/files.hpp"
#include "report/bench_report.hpp"
#include "report/disagreement_report.hpp"

#include <cstdio>
#include <memory>
#include <string>
#include <vector>

namespace cob::cli {

namespace {

struct Arguments {
    std::vector<std::string> sets;
    std::string folder;
    BenchOptions options;
};

void draw(const report::Plot& plot, const std::string& base, const char* what) {
    if (report::draw(plot, base))
        std::printf("%s.svg and .png: %s\n", base.c_str(), what);
    else
        std::fprintf(stderr, "cob: no plot %s: gnuplot is missing or failed; install gnuplot-nox\n", base.c_str());
}

/// Where Embree's triangles are wrong about a set: the counts, and a picture of each kind.
void show_disagreements(const std::string& set, const BenchOptions& options, const std::string& base) {
    const std::vector<EmbreeDisagreement> wrong = embree_disagreements(set, options);
    if (wrong.empty()) return;
    const Scene scene = read_obj(set + "/scene.obj", {true, false});
    std::fputs(report::disagreement_table(scene, wrong).c_str(), stdout);
    for (const EmbreeDisagreement& worst : report::worst_of_each_kind(wrong))
        draw(report::disagreement_plot(scene, worst), base + worst.kind, "where Embree is wrong most plainly");
}

void run(Arguments& arguments) {
    arguments.options.progress = terminal_progress("bench");
    const OutputFolder created(arguments.folder);
    const std::vector<BenchRow> rows = bench_sets(arguments.sets, arguments.options);
    const BenchMachine machine = bench_machine();
    std::fputs(report::bench_table(rows, machine).c_str(), stdout);
    write_file(arguments.folder + "/bench.csv", report::bench_csv(rows, machine));

    for (const char* question : {"box", "segment"}) {
        const report::Plot plot = report::bench_plot(rows, machine, question);
        if (!plot.curves.empty()) draw(plot, arguments.folder + "/bench_" + question, "error rate against time");
    }
    for (std::size_t k = 0; k < arguments.sets.size(); ++k) {
        const std::string number = arguments.sets.size() > 1 ? std::to_string(k) + "_" : "";
        show_disagreements(arguments.sets[k], arguments.options, arguments.folder + "/bench_embree_" + number);
    }
}

}  // namespace

void add_bench(CLI::App& app) {
    auto arguments = std::make_shared<Arguments>();
    CLI::App* command = app.add_subcommand(
        "bench", "Error against run time on a golden set: our formula in several arithmetics, CGAL, Embree");
    command->add_option("sets", arguments->sets, "Folders of golden sets; their questions are summed up by kind")
        ->required();
    command->add_option("-o,--output", arguments->folder, "Folder for bench.csv and the plots; created")->required();
    command->add_option("--repetitions", arguments->options.repetitions, "Runs over the questions of each kind")
        ->check(CLI::Range(1, 1000000));
    command->add_option("--most", arguments->options.most_of_kind, "Questions of each kind: the first so many")
        ->check(positive_whole_number());
    command->callback([arguments] { run(*arguments); });
}

}  // namespace cob::cli
