#include "report/study_report.hpp"

#include "cob/files.hpp"
#include "report/gnuplot.hpp"
#include "report/page.hpp"

#include <algorithm>
#include <cstdio>

namespace cob::report {
namespace {

constexpr std::array<Refinement, 4> refinements{Refinement::none, Refinement::gradient, Refinement::buffer,
                                                Refinement::both};

std::string number(const char* format, double value) {
    char text[32];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

std::vector<StudyRun> of_series(const std::vector<StudyRun>& runs, const std::string& series) {
    std::vector<StudyRun> found;
    std::copy_if(runs.begin(), runs.end(), std::back_inserter(found),
                 [&](const StudyRun& run) { return run.settings.series == series; });
    return found;
}

Table table_of(const std::vector<StudyRun>& runs) {
    Table table{{"refinement", "patch edge", "smallest edge", "margin", "height", "elements", "shots", "segments",
                 "time, ms (least)", "time, ms (median)", "held, kB", "L1 %", "L2 %", "largest %", "band L1 %",
                 "band L2 %", "band largest %", "on a front"},
                {}};
    const auto front = [&](StudyErrors StudyRun::*errors) {
        std::vector<std::array<double, 2>> pairs;
        for (const StudyRun& run : runs) pairs.push_back({run.seconds_median, (run.*errors).l2});
        return pareto_front(pairs);
    };
    const std::vector<bool> all = front(&StudyRun::all), band = front(&StudyRun::band);
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const StudyRun& run = runs[i];
        std::vector<std::string> cells{to_text(run.settings.refinement), number("%.4g", run.settings.patch_edge),
                                       number("%.4g", run.settings.minimum_edge), to_text(run.settings.margin),
                                       to_text(run.settings.height)};
        for (const std::int64_t count : {run.elements, run.shots, run.segments}) cells.push_back(std::to_string(count));
        cells.push_back(number("%.2f", 1e3 * run.seconds_least));
        cells.push_back(number("%.2f", 1e3 * run.seconds_median));
        cells.push_back(number("%.0f", static_cast<double>(run.bytes) / 1024));
        for (const StudyErrors* errors : {&run.all, &run.band})
            for (const double error : {errors->l1, errors->l2, errors->most})
                cells.push_back(number("%.2f", 100 * error));
        cells.push_back(all[i] && band[i] ? "both" : all[i] ? "whole" : band[i] ? "band" : "");
        table.rows.push_back(std::move(cells));
    }
    return table;
}

/// One curve for each refinement and one for the Pareto front.
bool draw_budgets(const std::vector<StudyRun>& runs, StudyErrors StudyRun::*errors, bool against_time,
                  const std::string& where, const std::string& base) {
    Plot plot;
    plot.title = "Error of exitance " + where + " against " + (against_time ? "time" : "elements");
    plot.x_label = against_time ? "time, s (median)" : "elements";
    plot.y_label = "relative L2 error";
    plot.logarithmic_x = plot.logarithmic_y = true;
    std::vector<std::array<double, 2>> all;
    const auto place = [&](const StudyRun& run) -> std::array<double, 2> {
        return {against_time ? run.seconds_median : static_cast<double>(run.elements), (run.*errors).l2};
    };
    for (const Refinement refinement : refinements) {
        Curve curve;
        curve.title = to_text(refinement);
        for (const StudyRun& run : runs)
            if (run.settings.refinement == refinement) curve.points.push_back(place(run));
        all.insert(all.end(), curve.points.begin(), curve.points.end());
        plot.curves.push_back(std::move(curve));
    }
    Curve front;
    front.title = "Pareto front";
    front.style = Curve::Style::lines;
    const std::vector<bool> on_front = pareto_front(all);
    for (std::size_t i = 0; i < all.size(); ++i)
        if (on_front[i]) front.points.push_back(all[i]);
    std::sort(front.points.begin(), front.points.end());
    plot.curves.push_back(std::move(front));
    return draw(plot, base);
}

std::size_t points_in_band(const StudyReference& reference) {
    return static_cast<std::size_t>(std::count_if(reference.points.begin(), reference.points.end(),
                                                  [](const StudyPoint& point) { return point.in_band; }));
}

std::string about(const StudyResults& results) {
    return "Direct light of " + results.scene + " at " + std::to_string(results.reference.points.size()) +
           " points, spread by area over " + number("%.0f", 100 * results.reference.receiver_share) +
           " % of all surfaces, against the exact irradiance there; " +
           std::to_string(points_in_band(results.reference)) +
           " of them lie in the band around shadow boundaries: in a penumbra, where some of a light is seen, but not "
           "all of it.";
}

constexpr std::array<const char*, 4> series_names{"budget", "initial mesh", "height", "margin"};

}  // namespace

std::string study_csv(const StudyResults& results) {
    std::string text =
        "series,refinement,patch_edge,minimum_edge,margin,height,elements,shots,segments,form_factors,buffers,bytes,"
        "seconds_least,seconds_median,l1,l2,largest,band_l1,band_l2,band_largest\n";
    for (const StudyRun& run : results.runs) text += to_line(run) + "\n";
    return text;
}

std::string study_text(const StudyResults& results) {
    std::string text = about(results) + "\n";
    for (const char* series : series_names) {
        const std::vector<StudyRun> runs = of_series(results.runs, series);
        if (!runs.empty()) text += "\n" + std::string(series) + "\n" + table_of(runs).text();
    }
    return text;
}

void write_study(const StudyResults& results, const std::string& folder) {
    write_file(folder + "/study.csv", study_csv(results));
    Page page("Error against time: " + results.scene);
    page.paragraph(about(results));
    page.paragraph(results.machine + "; compiler " + __VERSION__ + (results.commit.empty() ? "" : "; ") +
                   results.commit + ".");
    page.paragraph(
        "Errors are relative: of the difference over that of the reference (L1, L2), and the largest difference over "
        "the reference's mean. On a front: no other run of the table has both less time and less L2 error, over all "
        "points or in the band.");
    for (const char* series : series_names) {
        const std::vector<StudyRun> runs = of_series(results.runs, series);
        if (runs.empty()) continue;
        page.heading(series);
        if (series == series_names[0])
            for (const bool against_time : {true, false})
                for (const bool band : {false, true}) {
                    const std::string base =
                        folder + "/" + (band ? "band" : "all") + (against_time ? "_time" : "_elements");
                    draw_budgets(runs, band ? &StudyRun::band : &StudyRun::all, against_time,
                                 band ? "in the band" : "over all points", base);
                    page.picture(base + ".svg", band ? "In the band around shadow boundaries." : "Over all points.");
                }
        page.table(table_of(runs));
    }
    write_file(folder + "/study.html", page.html());
}

}  // namespace cob::report
