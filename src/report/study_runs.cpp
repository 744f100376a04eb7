// The runs of a study.
#include "arithmetic/process.hpp"
#include "cob/study.hpp"
#include "radiosity/mesh.hpp"
#include "report/study_points.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace cob {
namespace {

/// Sums of differences between the solution and the reference, both times a power of two near 1 over the mean: squares
/// of exitance may leave binary64 where exitance does not.
class ErrorSum {
public:
    explicit ErrorSum(double mean) : exponent_(-std::ilogb(mean)) {}
    void add(double value, double reference) {
        value = std::scalbn(value, exponent_);
        reference = std::scalbn(reference, exponent_);
        const double difference = std::fabs(value - reference);
        l1_ += difference;
        l2_ += difference * difference;
        most_ = std::max(most_, difference);
        sum_ += reference;
        squares_ += reference * reference;
        ++count_;
    }
    /// Nothing where the reference is dark, or has no point.
    std::optional<StudyErrors> errors() const {
        if (!(sum_ > 0)) return std::nullopt;
        return StudyErrors{l1_ / sum_, std::sqrt(l2_ / squares_), most_ * static_cast<double>(count_) / sum_};
    }

private:
    int exponent_;
    double l1_ = 0, l2_ = 0, most_ = 0, sum_ = 0, squares_ = 0;
    std::size_t count_ = 0;
};

/// The squared error by place; shares of the whole.
class ShareSum {
public:
    void add(bool in_band, bool fine, double squared_error) {
        double& share = in_band ? (fine ? shares_.band_fine : shares_.band_coarse)
                                : (fine ? shares_.smooth_fine : shares_.smooth_coarse);
        share += squared_error;
        whole_ += squared_error;
    }
    StudyShares shares() const {
        if (!(whole_ > 0)) return {};
        return {shares_.band_fine / whole_, shares_.band_coarse / whole_, shares_.smooth_fine / whole_,
                shares_.smooth_coarse / whole_};
    }

private:
    StudyShares shares_;
    double whole_ = 0;
};

RadiosityOptions options_of(const StudySettings& settings, const StudyReference& reference, int threads) {
    RadiosityOptions options;
    options.refinement = settings.refinement;
    options.patch_edge = settings.patch_edge;
    options.light_edge = settings.light_edge;
    options.buffer.margin = settings.margin;
    options.buffer.height = settings.height;
    options.buffer.minimum_edge = settings.minimum_edge;
    options.gradient.minimum_edge = settings.minimum_edge;
    options.gradient.threshold.fill(settings.threshold);
    options.receiving_points = settings.receiving_points;
    options.stop.shots = std::numeric_limits<std::int64_t>::max();
    options.threads = threads;
    if (reference.light == StudyLight::direct) {
        // The floor of gradients is a share of the mean exitance with the lights; here the lights would be nearly all
        // of it, so that the share is set to mean what it means for the exitance that is studied.
        const double reflected = dimming * reference.mean_exitance * reference.receiver_share;
        options.gradient.floor *= reflected / (reflected + reference.light_exitance);
        options.stop.unshot = 4 * dimming;  // every light has shot, and nothing else
    } else {
        // A thousandth is far below the error of the reference; overshooting halves the number of shots.
        options.stop.unshot = 1e-3;
        options.overshoot = true;
    }
    return options;
}

/// Compares the solution with the reference, point by point.
void measure_errors(const RadiositySolver& solver, const StudyReference& reference, StudyRun& run) {
    const ExitanceField field(solver);
    const radiosity::Mesh& mesh = solver.mesh();
    const double scale = reference.light == StudyLight::direct ? 1 / dimming : 1;
    const double fine_edge = std::scalbn(2 * run.settings.minimum_edge, -mesh.exponent());
    const double mean = reference.mean_exitance;
    ErrorSum all(mean), band(mean);
    ShareSum shares;
    for (const StudyPoint& point : reference.points) {
        const auto [u, v] = point.coordinates;
        const Rgb exitance = field.at(point.root, u, v);
        const double value = scale * (exitance[0] + exitance[1] + exitance[2]);
        const double error = (value - point.exitance) / mean;
        all.add(value, point.exitance);
        if (point.in_band) band.add(value, point.exitance);
        shares.add(point.in_band, mesh.longest_side(mesh.leaf_at(point.root, u, v)) <= fine_edge, error * error);
    }
    run.all = all.errors().value_or(StudyErrors{});
    run.band = band.errors();
    run.shares = shares.shares();
}

}  // namespace

const char* name_in_study(Refinement refinement) {
    return refinement == Refinement::none ? "uniform" : to_text(refinement);
}

std::string StudySettings::key() const {
    std::string text = series + "_" + name_in_study(refinement) + "_patch" + to_text(patch_edge) + "_light" +
                       to_text(light_edge) + "_least" + to_text(minimum_edge) + "_threshold" + to_text(threshold) +
                       "_points" + std::to_string(receiving_points) + "_margin" + to_text(margin) + "_height" +
                       to_text(height);
    std::replace_if(
        text.begin(), text.end(), [](char c) { return c == '/' || c == ' ' || c == ','; }, '-');
    return text;
}

StudyRun study_run(const Scene& scene, const StudyReference& reference, const StudySettings& settings, int repeats,
                   int threads, const Progress& alive) {
    const bool direct = reference.light == StudyLight::direct;
    const std::optional<Scene> dim = direct ? std::optional(dimmed(scene)) : std::nullopt;
    StudyRun run;
    run.settings = settings;
    std::vector<double> seconds;
    for (int repeat = 0; repeat < std::max(1, repeats); ++repeat) {
        MemoryWatch memory;
        Stopwatch watch;
        RadiositySolver solver(direct ? *dim : scene, options_of(settings, reference, threads));
        while (solver.step())
            if (alive) alive(static_cast<std::uint64_t>(solver.counters().shots), 0);
        seconds.push_back(watch.lap());
        if (repeat > 0) continue;  // the same every time

        run.peak_bytes = memory.peak();
        run.elements = static_cast<std::int64_t>(solver.element_count());
        run.shots = solver.counters().shots;
        run.segments = solver.counters().segments;
        run.form_factors = solver.counters().form_factors;
        for (const std::int64_t built : solver.counters().buffers) run.buffers += built;
        measure_errors(solver, reference, run);
    }
    std::sort(seconds.begin(), seconds.end());
    run.seconds_least = seconds.front();
    run.seconds_median = seconds[seconds.size() / 2];
    return run;
}

std::string to_line(const StudyRun& run) {
    const StudySettings& s = run.settings;
    std::string line = s.series + "," + name_in_study(s.refinement);
    for (const double value : {s.patch_edge, s.light_edge, s.minimum_edge, s.threshold}) line += "," + to_text(value);
    line += "," + std::to_string(s.receiving_points) + "," + to_text(s.margin) + "," + to_text(s.height);
    for (const std::int64_t count : {run.elements, run.shots, run.segments, run.form_factors, run.buffers,
                                     static_cast<std::int64_t>(run.peak_bytes)})
        line += "," + std::to_string(count);
    for (const double value :
         {run.seconds_least, run.seconds_median, run.all.l1, run.all.l2, run.all.most, run.shares.band_fine,
          run.shares.band_coarse, run.shares.smooth_fine, run.shares.smooth_coarse})
        line += "," + to_text(value);
    if (!run.band) return line + ",,,";
    for (const double value : {run.band->l1, run.band->l2, run.band->most}) line += "," + to_text(value);
    return line;
}

std::optional<StudyRun> study_run_from_line(const std::string& line, const StudySettings& settings) {
    StudyRun run;
    run.settings = settings;
    // The settings must be these, to the letter; what follows are numbers, the last three of them or none.
    const std::string whole = to_line(run);
    std::size_t end = 0;
    for (int comma = 0; comma < 9; ++comma) end = whole.find(',', end) + 1;
    if (line.compare(0, end, whole, 0, end) != 0) return std::nullopt;
    std::string rest = line.substr(end);
    const std::string no_band = ",,,";
    const bool banded =
        rest.size() < no_band.size() || rest.compare(rest.size() - no_band.size(), no_band.size(), no_band) != 0;
    if (!banded) rest.resize(rest.size() - no_band.size());
    std::vector<double> values;
    std::istringstream cells(rest);
    for (std::string cell; std::getline(cells, cell, ',');) {
        const std::optional<double> value = parse_binary64(cell);
        if (!value || *value < 0) return std::nullopt;
        values.push_back(*value);
    }
    if (values.size() != (banded ? 18 : 15)) return std::nullopt;
    constexpr std::size_t counts = 6;
    constexpr double most_counted = 1e18;
    for (std::size_t k = 0; k < counts; ++k)
        if (values[k] > most_counted || values[k] != std::floor(values[k])) return std::nullopt;
    std::size_t next = 0;
    for (std::int64_t* count : {&run.elements, &run.shots, &run.segments, &run.form_factors, &run.buffers})
        *count = static_cast<std::int64_t>(values[next++]);
    run.peak_bytes = static_cast<std::uint64_t>(values[next++]);
    for (double* value :
         {&run.seconds_least, &run.seconds_median, &run.all.l1, &run.all.l2, &run.all.most, &run.shares.band_fine,
          &run.shares.band_coarse, &run.shares.smooth_fine, &run.shares.smooth_coarse})
        *value = values[next++];
    if (banded) run.band = StudyErrors{values[next], values[next + 1], values[next + 2]};
    return run;
}

}  // namespace cob
