// The runs that a study makes, and what they come to.
#include "cob/study.hpp"
#include "geometry/bounds.hpp"
#include "report/text.hpp"

#include <algorithm>
#include <cmath>

namespace cob {

std::vector<StudySettings> study_plan(const Scene& scene, StudyLight light, int budgets) {
    // Of full light every patch shoots, and time grows with the square of their number.
    const double patch = longest_extent(bounds_of(scene)) / (light == StudyLight::direct ? 12 : 6);
    std::vector<StudySettings> plan;
    const auto add = [&](const char* series, Refinement refinement, double edge, double least) -> StudySettings& {
        StudySettings settings;
        settings.series = series;
        settings.refinement = refinement;
        settings.patch_edge = edge;
        settings.light_edge = patch;  // all runs have the same lights; in direct light these alone shoot
        settings.minimum_edge = least;
        plan.push_back(settings);
        return plan.back();
    };
    constexpr std::array<Refinement, 3> refined{Refinement::gradient, Refinement::buffer, Refinement::both};
    // Budgets: the smallest edge halves. Refinement that knows where may go once further than uniform.
    for (int b = 0; b < budgets; ++b) add("budget", Refinement::none, std::ldexp(patch, -b), std::ldexp(patch, -b));
    for (int b = 1; b <= budgets; ++b)
        for (const Refinement refinement : refined) add("budget", refinement, patch, std::ldexp(patch, -b));
    // Thresholds: where light is smooth, what is left of the error is the gradient's to find.
    const double finest = std::ldexp(patch, -budgets), least = std::ldexp(patch, -std::max(1, budgets / 2));
    for (const double threshold : {0.1, 0.04, 0.016, 0.0064})
        for (const Refinement refinement : {Refinement::gradient, Refinement::both})
            add("threshold", refinement, patch, finest).threshold = threshold;
    // Receiving points: a gradient's child takes over all that its parent saw, and one point sees no boundary.
    for (int b = std::max(1, budgets - 1); b <= budgets; ++b)
        for (const Refinement refinement : refined)
            add("receiving points", refinement, patch, std::ldexp(patch, -b)).receiving_points = 4;
    // The rest, in the middle of the budgets.
    for (const double edge : {4 * patch, 2 * patch, patch, patch / 2})
        for (const Refinement refinement : refined) add("initial mesh", refinement, edge, least);
    for (const int divisor : {16, 8, 4, 2, 1})
        add("height", Refinement::buffer, patch, least).height = Rational(1, divisor);
    // Small elements have low boxes: what hovers is out of their reach unless these are made higher.
    for (int b = std::max(1, budgets - 1); b <= budgets; ++b)
        for (const int height : {1, 4, 16})
            for (const Refinement refinement : {Refinement::buffer, Refinement::both})
                add("height", refinement, patch, std::ldexp(patch, -b)).height = Rational(height);
    for (const Rational& margin : {Rational(0), Rational(1, 8), Rational(1, 2), Rational(1)})
        add("margin", Refinement::buffer, patch, least).margin = margin;
    return plan;
}

std::vector<bool> pareto_front(const std::vector<std::array<double, 2>>& time_and_error) {
    std::vector<bool> front;
    for (const auto& a : time_and_error)
        front.push_back(std::none_of(time_and_error.begin(), time_and_error.end(), [&](const auto& b) {
            return b[0] <= a[0] && b[1] <= a[1] && (b[0] < a[0] || b[1] < a[1]);
        }));
    return front;
}

namespace {

bool uses_buffer(const StudyRun& run) {
    return run.settings.refinement == Refinement::buffer || run.settings.refinement == Refinement::both;
}

/// Why the buffer needs more than a tenth of the elements, or does not get there at all: where its own error is.
std::string reason_of(const StudyBar& bar, const StudyReference& reference, const std::vector<StudyRun>& runs) {
    const auto error = [&](const StudyRun& run) { return bar.in_band ? run.band->l2 : run.all.l2; };
    const StudyRun* run = &bar.nearest;
    for (const StudyRun& other : runs)
        if (other.settings.refinement == Refinement::buffer && (!bar.in_band || other.band) &&
            (run->settings.refinement != Refinement::buffer || error(other) < error(*run)))
            run = &other;
    const auto in_band = std::count_if(reference.points.begin(), reference.points.end(),
                                       [](const StudyPoint& point) { return point.in_band; });
    return printed(
        "%s, %lld elements, errs by %.3g %%: %.0f %% of its squared error lies in the band (%td of %zu points; "
        "of uniform's %.0f %%) on finest elements, where only smaller ones help, %.0f %% in the band on larger "
        "ones, in shadows cast from further than the boxes reach, %.0f %% in smooth light, not what the buffer "
        "looks for",
        name_in_study(run->settings.refinement), static_cast<long long>(run->elements), 100 * error(*run),
        100 * run->shares.band_fine, in_band, reference.points.size(),
        100 * (bar.uniform.shares.band_fine + bar.uniform.shares.band_coarse), 100 * run->shares.band_coarse,
        100 * (run->shares.smooth_fine + run->shares.smooth_coarse));
}

}  // namespace

std::vector<StudyBar> study_bars(const StudyReference& reference, const std::vector<StudyRun>& runs) {
    std::vector<StudyBar> bars;
    for (const bool in_band : {false, true}) {
        const auto error = [&](const StudyRun& run) { return in_band ? run.band->l2 : run.all.l2; };
        StudyBar bar;
        bar.in_band = in_band;
        bool has_uniform = false, has_buffer = false;
        for (const StudyRun& run : runs) {
            if (in_band && !run.band) continue;
            if (run.settings.refinement == Refinement::none && (!has_uniform || run.elements > bar.uniform.elements)) {
                bar.uniform = run;
                has_uniform = true;
            }
            if (uses_buffer(run) && (!has_buffer || error(run) < error(bar.nearest))) {
                bar.nearest = run;
                has_buffer = true;
            }
        }
        if (!has_uniform || !has_buffer) continue;
        bar.target = error(bar.uniform);
        for (const StudyRun& run : runs)
            if (uses_buffer(run) && (!in_band || run.band) && error(run) <= bar.target &&
                (!bar.reached || run.elements < bar.reached->elements))
                bar.reached = run;
        if (bar.reached) {
            bar.elements_ratio = static_cast<double>(bar.uniform.elements) / static_cast<double>(bar.reached->elements);
            bar.time_ratio = bar.uniform.seconds_median / bar.reached->seconds_median;
        }
        bar.met = bar.elements_ratio >= 10 && bar.time_ratio >= 5;
        if (!bar.met) bar.reason = reason_of(bar, reference, runs);
        bars.push_back(std::move(bar));
    }
    return bars;
}

}  // namespace cob
