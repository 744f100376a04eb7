#include "report/bench_report.hpp"
#include "report/text.hpp"

#include <algorithm>

namespace cob::report {

namespace {

std::string describe(const BenchMachine& machine) {
    return machine.processor + ", " + machine.compiler + ", commit " + machine.commit + ", one thread";
}

std::string line(const BenchRow& row) {
    return printed("%-8s %-11s %-11s %9llu %8llu %9llu %12.1f %12.1f %11llu\n", row.question.c_str(),
                   row.variant.c_str(), row.kind.c_str(), static_cast<unsigned long long>(row.questions),
                   static_cast<unsigned long long>(row.wrong), static_cast<unsigned long long>(row.undecided),
                   row.nanoseconds_min, row.nanoseconds_median, static_cast<unsigned long long>(row.bytes));
}

}  // namespace

std::string bench_table(const std::vector<BenchRow>& rows, const BenchMachine& machine) {
    std::string text = describe(machine) + "\n";
    text += printed("%-8s %-11s %-11s %9s %8s %9s %12s %12s %11s\n", "question", "variant", "kind", "questions",
                    "wrong", "undecided", "ns min", "ns median", "bytes");
    for (const bool sums : {true, false})
        for (const BenchRow& row : rows)
            if ((row.kind == "all") == sums) text += line(row);
    return text;
}

std::string bench_csv(const std::vector<BenchRow>& rows, const BenchMachine& machine) {
    std::string text =
        "# " + describe(machine) + "\nquestion,variant,kind,questions,wrong,undecided,ns_min,ns_median,bytes\n";
    for (const BenchRow& row : rows) {
        text += row.question + "," + row.variant + "," + row.kind + "," +
                printed("%llu,%llu,%llu,%.1f,%.1f,%llu\n", static_cast<unsigned long long>(row.questions),
                        static_cast<unsigned long long>(row.wrong), static_cast<unsigned long long>(row.undecided),
                        row.nanoseconds_min, row.nanoseconds_median, static_cast<unsigned long long>(row.bytes));
    }
    return text;
}

Plot bench_plot(const std::vector<BenchRow>& rows, const BenchMachine& machine, const std::string& question) {
    Plot plot;
    plot.title = "Error against run time, " + question + " questions by kind (" + machine.processor + ")";
    plot.x_label = "nanoseconds per question, median";
    plot.y_label = "wrong or undecided, % (none: at the bottom)";
    plot.logarithmic_x = plot.logarithmic_y = true;
    plot.least_y = 0.05;
    for (const BenchRow& row : rows) {
        if (row.question != question || row.kind == "all" || row.questions == 0) continue;
        auto curve = std::find_if(plot.curves.begin(), plot.curves.end(),
                                  [&](const Curve& known) { return known.title == row.variant; });
        if (curve == plot.curves.end()) curve = plot.curves.insert(curve, {row.variant, {}, Curve::Style::points});
        const double bad = 100 * static_cast<double>(row.wrong + row.undecided) / static_cast<double>(row.questions);
        curve->points.push_back({row.nanoseconds_median, bad});
    }
    return plot;
}

}  // namespace cob::report
