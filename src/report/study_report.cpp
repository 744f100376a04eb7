#include "report/study_report.hpp"

#include "cob/files.hpp"
#include "report/gnuplot.hpp"
#include "report/page.hpp"
#include "report/text.hpp"

#include <algorithm>

namespace cob::report {
namespace {

constexpr std::array<Refinement, 4> refinements{Refinement::none, Refinement::gradient, Refinement::buffer,
                                                Refinement::both};

std::vector<StudyRun> of_series(const std::vector<StudyRun>& runs, const std::string& series) {
    std::vector<StudyRun> found;
    std::copy_if(runs.begin(), runs.end(), std::back_inserter(found),
                 [&](const StudyRun& run) { return run.settings.series == series; });
    return found;
}

std::string percent(double share) {
    return printed("%.2f", 100 * share);
}

Table table_of(const std::vector<StudyRun>& runs) {
    Table table{{"refinement",     "patch edge", "smallest edge", "threshold", "points",           "margin",
                 "height",         "elements",   "shots",         "segments",  "time, ms (least)", "time, ms (median)",
                 "peak, kB",       "L1 %",       "L2 %",          "largest %", "band L1 %",        "band L2 %",
                 "band largest %", "on a front"},
                {}};
    // Runs of which there is no error in the band are no part of that front.
    std::vector<std::array<double, 2>> pairs, band_pairs;
    for (const StudyRun& run : runs) {
        pairs.push_back({run.seconds_median, run.all.l2});
        if (run.band) band_pairs.push_back({run.seconds_median, run.band->l2});
    }
    const std::vector<bool> all = pareto_front(pairs), band = pareto_front(band_pairs);
    std::size_t next_in_band = 0;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const StudyRun& run = runs[i];
        std::vector<std::string> cells{name_in_study(run.settings.refinement),
                                       printed("%.4g", run.settings.patch_edge),
                                       printed("%.4g", run.settings.minimum_edge),
                                       printed("%.4g", run.settings.threshold),
                                       std::to_string(run.settings.receiving_points),
                                       to_text(run.settings.margin),
                                       to_text(run.settings.height)};
        for (const std::int64_t count : {run.elements, run.shots, run.segments}) cells.push_back(std::to_string(count));
        cells.push_back(printed("%.2f", 1e3 * run.seconds_least));
        cells.push_back(printed("%.2f", 1e3 * run.seconds_median));
        cells.push_back(printed("%.0f", static_cast<double>(run.peak_bytes) / 1024));
        for (const double error : {run.all.l1, run.all.l2, run.all.most}) cells.push_back(percent(error));
        for (const auto error : {&StudyErrors::l1, &StudyErrors::l2, &StudyErrors::most})
            cells.push_back(run.band ? percent(*run.band.*error) : "");
        const bool on_band = run.band && band[next_in_band++];
        cells.push_back(all[i] && on_band ? "both" : all[i] ? "whole" : on_band ? "band" : "");
        table.rows.push_back(std::move(cells));
    }
    return table;
}

/// Ten times fewer elements and five times less time, over all points and in the band.
Table bar_table(const std::vector<StudyBar>& bars) {
    Table table{{"error", "L2 % of the finest uniform mesh", "its elements", "its time, ms", "reached by", "elements",
                 "time, ms", "times fewer elements", "times less time", "10 and 5", "why not"},
                {}};
    for (const StudyBar& bar : bars) {
        std::vector<std::string> cells{bar.in_band ? "in the band" : "over all points", percent(bar.target),
                                       std::to_string(bar.uniform.elements),
                                       printed("%.2f", 1e3 * bar.uniform.seconds_median)};
        if (bar.reached) {
            const StudySettings& s = bar.reached->settings;
            cells.push_back(std::string(name_in_study(s.refinement)) + ", smallest edge " +
                            printed("%.4g", s.minimum_edge) + ", threshold " + printed("%.4g", s.threshold) +
                            ", height " + to_text(s.height) +
                            (s.receiving_points > 1 ? ", " + std::to_string(s.receiving_points) + " points" : ""));
            cells.push_back(std::to_string(bar.reached->elements));
            cells.push_back(printed("%.2f", 1e3 * bar.reached->seconds_median));
            cells.push_back(printed("%.1f", bar.elements_ratio));
            cells.push_back(printed("%.1f", bar.time_ratio));
        } else {
            cells.insert(cells.end(), {"none", "", "", "", ""});
        }
        cells.push_back(bar.met ? "met" : "not met");
        cells.push_back(bar.reason);
        table.rows.push_back(std::move(cells));
    }
    return table;
}

/// One curve for each refinement and one for the Pareto front.
bool draw_budgets(const std::vector<StudyRun>& runs, bool in_band, bool against_time, const std::string& base) {
    Plot plot;
    plot.title = std::string("Error of exitance ") + (in_band ? "in the band" : "over all points") + " against " +
                 (against_time ? "time" : "elements");
    plot.x_label = against_time ? "time, s (median)" : "elements";
    plot.y_label = "relative L2 error";
    plot.logarithmic_x = plot.logarithmic_y = true;
    std::vector<std::array<double, 2>> all;
    for (const Refinement refinement : refinements) {
        Curve curve;
        curve.title = name_in_study(refinement);
        for (const StudyRun& run : runs)
            if (run.settings.refinement == refinement && (run.band || !in_band))
                curve.points.push_back({against_time ? run.seconds_median : static_cast<double>(run.elements),
                                        in_band ? run.band->l2 : run.all.l2});
        all.insert(all.end(), curve.points.begin(), curve.points.end());
        plot.curves.push_back(std::move(curve));
    }
    Curve front;
    front.title = "Pareto front";
    front.style = Curve::Style::dashed;
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
    const StudyReference& reference = results.reference;
    const bool full = reference.light == StudyLight::full;
    std::string text = (full ? "All light of " : "Direct light of ") + results.scene + " at " +
                       std::to_string(reference.points.size()) + " points, spread by area over " +
                       printed("%.0f", 100 * reference.receiver_share) + " % of all surfaces, against ";
    if (full)
        text += "a direct solution on " + std::to_string(reference.unknowns) +
                " patches with form factors from exact visibility, which differs from that on a mesh twice as coarse "
                "by " +
                printed("%.2g", 100 * reference.own_error) + " % (relative L2); ";
    else
        text += "the exact irradiance there; ";
    return text + std::to_string(points_in_band(reference)) +
           " of them lie in the band around shadow boundaries: in a penumbra, or within " +
           printed("%.3g", results.reference.band_width) + " of where another share of a light is seen.";
}

/// Which refinement leads: how many runs of each are on the Pareto front of error against elements.
std::string leaders(const std::vector<StudyRun>& runs) {
    std::string text;
    for (const bool in_band : {false, true}) {
        std::vector<std::array<double, 2>> pairs;
        std::vector<Refinement> kinds;
        for (const StudyRun& run : runs) {
            if (in_band && !run.band) continue;
            pairs.push_back({static_cast<double>(run.elements), in_band ? run.band->l2 : run.all.l2});
            kinds.push_back(run.settings.refinement);
        }
        if (pairs.empty()) continue;
        const std::vector<bool> front = pareto_front(pairs);
        std::array<int, 4> count{};
        for (std::size_t k = 0; k < kinds.size(); ++k) count[static_cast<std::size_t>(kinds[k])] += front[k] ? 1 : 0;
        text += std::string(in_band ? "; in the band: "
                                    : "Runs on the front of L2 error against elements, over all points: ");
        for (const Refinement refinement : refinements)
            text += (refinement == refinements[0] ? "" : ", ") + std::string(name_in_study(refinement)) + " " +
                    std::to_string(count[static_cast<std::size_t>(refinement)]);
    }
    return text + ".";
}

constexpr std::array<const char*, 6> series_names{"budget",       "threshold", "receiving points",
                                                  "initial mesh", "height",    "margin"};

}  // namespace

std::string study_csv(const StudyResults& results) {
    std::string text =
        "series,refinement,patch_edge,light_edge,minimum_edge,threshold,receiving_points,margin,height,elements,shots,"
        "segments,"
        "form_factors,buffers,peak_bytes,seconds_least,seconds_median,l1,l2,largest,band_fine,band_coarse,smooth_fine,"
        "smooth_coarse,band_l1,band_l2,band_largest\n";
    for (const StudyRun& run : results.runs) text += to_line(run) + "\n";
    return text;
}

std::string study_text(const StudyResults& results) {
    std::string text = about(results) + "\n";
    for (const char* series : series_names) {
        const std::vector<StudyRun> runs = of_series(results.runs, series);
        if (!runs.empty()) text += "\n" + std::string(series) + "\n" + table_of(runs).text();
    }
    text += "\n" + leaders(results.runs) + "\n";
    return text + "\nthe bar\n" + bar_table(study_bars(results.reference, results.runs)).text();
}

void write_study(const StudyResults& results, const std::string& folder) {
    write_file(folder + "/study.csv", study_csv(results));
    const std::vector<StudyBar> bars = study_bars(results.reference, results.runs);
    write_file(folder + "/bar.csv", bar_table(bars).csv());

    Page page("Error against time: " + results.scene);
    page.paragraph(about(results));
    page.paragraph(results.machine.processor + ", " + std::to_string(results.threads) + " threads; " +
                   results.machine.compiler + "; commit " + results.machine.commit + ".");
    page.paragraph(
        "Errors are relative: of the difference over that of the reference (L1, L2), and the largest difference over "
        "the reference's mean. On a front: no other run of the table has both less time and less L2 error, over all "
        "points or in the band. Uniform means that every patch has the smallest edge; the others begin with the patch "
        "edge and refine down to the smallest.");
    for (const StudyPicture& picture : results.pictures) page.picture(picture.path, picture.caption);
    page.heading("the bar: 10 times fewer elements and 5 times less time than the finest uniform mesh");
    page.table(bar_table(bars));
    page.paragraph(leaders(results.runs));
    for (const char* series : series_names) {
        const std::vector<StudyRun> runs = of_series(results.runs, series);
        if (runs.empty()) continue;
        page.heading(series);
        if (series == series_names[0])
            for (const bool against_time : {true, false})
                for (const bool band : {false, true}) {
                    if (band && !runs.front().band) continue;
                    const std::string base =
                        folder + "/" + (band ? "band" : "all") + (against_time ? "_time" : "_elements");
                    draw_budgets(runs, band, against_time, base);
                    page.picture(base + ".svg", band ? "In the band around shadow boundaries." : "Over all points.");
                }
        page.table(table_of(runs));
    }
    write_file(folder + "/study.html", page.html());
}

}  // namespace cob::report
