// The runs of a study.
#include "arithmetic/process.hpp"
#include "cob/census.hpp"
#include "cob/study.hpp"

#include <malloc.h>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>

namespace cob {
namespace {

/// So little is reflected that what is reflected twice is below a millionth.
constexpr double dimming = 1.0 / (1 << 20);

Scene dimmed(const Scene& scene) {
    Scene::Input input;
    input.name = scene.name();
    input.positions = scene.positions();
    input.materials = scene.materials();
    for (Material& material : input.materials)
        for (double& reflectance : material.reflectance) reflectance *= dimming;
    for (PolygonId id = 0; id < scene.polygon_count(); ++id) {
        Scene::Face face;
        face.material = scene.polygon(id).material;
        face.line = scene.polygon(id).line;
        for (const VertexId vertex : scene.loop(id)) face.corners.push_back(vertex);
        input.faces.push_back(std::move(face));
    }
    return Scene::build(std::move(input), Scene::Options{true});
}

std::uint64_t heap_in_use() {
    const struct mallinfo2 info = ::mallinfo2();
    return info.uordblks + info.hblkhd;
}

/// Sums of differences between the solution and the reference.
class ErrorSum {
public:
    void add(double value, double reference) {
        const double difference = std::fabs(value - reference);
        l1_ += difference;
        l2_ += difference * difference;
        most_ = std::max(most_, difference);
        sum_ += reference;
        squares_ += reference * reference;
        ++count_;
    }
    StudyErrors errors() const {
        if (!(sum_ > 0)) return {};
        return {l1_ / sum_, std::sqrt(l2_ / squares_), most_ * static_cast<double>(count_) / sum_};
    }

private:
    double l1_ = 0, l2_ = 0, most_ = 0, sum_ = 0, squares_ = 0;
    std::size_t count_ = 0;
};

RadiosityOptions options_of(const StudySettings& settings, const StudyReference& reference, int threads) {
    RadiosityOptions options;
    options.refinement = settings.refinement;
    options.patch_edge = settings.patch_edge;
    options.buffer.margin = settings.margin;
    options.buffer.height = settings.height;
    options.buffer.minimum_edge = settings.minimum_edge;
    options.gradient.minimum_edge = settings.minimum_edge;
    // The floor of gradients is a share of the mean exitance with the lights; here the lights would be nearly all of
    // it, so that the share is set to mean what it means for the exitance that is studied.
    const double reflected = dimming * reference.mean_exitance * reference.receiver_share;
    options.gradient.floor *= reflected / (reflected + reference.light_exitance);
    options.stop.shots = 1000000;
    options.stop.unshot = 4 * dimming;  // every light has shot, and nothing else
    options.threads = threads;
    return options;
}

}  // namespace

const char* to_text(Refinement refinement) {
    switch (refinement) {
        case Refinement::none:
            return "uniform";
        case Refinement::gradient:
            return "gradient";
        case Refinement::buffer:
            return "buffer";
        case Refinement::both:
            return "both";
    }
    return "";
}

std::string StudySettings::key() const {
    std::string text = series + "_" + to_text(refinement) + "_patch" + to_text(patch_edge) + "_least" +
                       to_text(minimum_edge) + "_margin" + to_text(margin) + "_height" + to_text(height);
    std::replace_if(
        text.begin(), text.end(), [](char c) { return c == '/' || c == ' ' || c == ','; }, '-');
    return text;
}

std::vector<StudySettings> study_plan(const Scene& scene, int budgets) {
    const Census census = take_census(scene);
    const Point size = census.highest - census.lowest;
    const double patch = std::max({size.x, size.y, size.z}) / 12;
    std::vector<StudySettings> plan;
    const auto add = [&](const char* series, Refinement refinement, double edge, double least) -> StudySettings& {
        StudySettings settings;
        settings.series = series;
        settings.refinement = refinement;
        settings.patch_edge = edge;
        settings.minimum_edge = least;
        plan.push_back(settings);
        return plan.back();
    };
    // Budgets: the smallest edge halves.
    for (int b = 0; b < budgets; ++b) {
        const double least = std::ldexp(patch, -b);
        add("budget", Refinement::none, least, least);
        if (b == 0) continue;
        for (const Refinement refinement : {Refinement::gradient, Refinement::buffer, Refinement::both})
            add("budget", refinement, patch, least);
    }
    // The rest, in the middle of them.
    const double least = std::ldexp(patch, -std::max(1, budgets / 2));
    for (const double edge : {2 * patch, patch, patch / 2})
        for (const Refinement refinement : {Refinement::gradient, Refinement::buffer, Refinement::both})
            add("initial mesh", refinement, edge, least);
    for (const int divisor : {16, 8, 4, 2, 1})
        add("height", Refinement::buffer, patch, least).height = Rational(1, divisor);
    for (const Rational& margin : {Rational(0), Rational(1, 8), Rational(1, 2), Rational(1)})
        add("margin", Refinement::buffer, patch, least).margin = margin;
    return plan;
}

StudyRun study_run(const Scene& scene, const StudyReference& reference, const StudySettings& settings, int repeats,
                   int threads) {
    const Scene dim = dimmed(scene);
    StudyRun run;
    run.settings = settings;
    std::vector<double> seconds;
    for (int repeat = 0; repeat < std::max(1, repeats); ++repeat) {
        const std::uint64_t before = heap_in_use();
        Stopwatch watch;
        RadiositySolver solver(dim, options_of(settings, reference, threads));
        while (solver.step()) {
        }
        seconds.push_back(watch.lap());
        if (repeat > 0) continue;  // the same every time

        const std::uint64_t after = heap_in_use();
        run.bytes = after > before ? after - before : 0;
        run.elements = static_cast<std::int64_t>(solver.element_count());
        run.shots = solver.counters().shots;
        run.segments = solver.counters().segments;
        run.form_factors = solver.counters().form_factors;
        run.buffers = static_cast<std::int64_t>(solver.buffer_count());
        const ExitanceField field(solver);
        ErrorSum all, band;
        for (const StudyPoint& point : reference.points) {
            const Rgb exitance = field.at(point.root, point.coordinates[0], point.coordinates[1]);
            const double value = (exitance[0] + exitance[1] + exitance[2]) / dimming;
            all.add(value, point.exitance);
            if (point.in_band) band.add(value, point.exitance);
        }
        run.all = all.errors();
        run.band = band.errors();
    }
    std::sort(seconds.begin(), seconds.end());
    run.seconds_least = seconds.front();
    run.seconds_median = seconds[seconds.size() / 2];
    return run;
}

std::string to_line(const StudyRun& run) {
    const StudySettings& s = run.settings;
    std::string line = s.series + "," + to_text(s.refinement) + "," + to_text(s.patch_edge) + "," +
                       to_text(s.minimum_edge) + "," + to_text(s.margin) + "," + to_text(s.height);
    for (const std::int64_t count :
         {run.elements, run.shots, run.segments, run.form_factors, run.buffers, static_cast<std::int64_t>(run.bytes)})
        line += "," + std::to_string(count);
    for (const double value : {run.seconds_least, run.seconds_median, run.all.l1, run.all.l2, run.all.most, run.band.l1,
                               run.band.l2, run.band.most})
        line += "," + to_text(value);
    return line;
}

std::optional<StudyRun> study_run_from_line(const std::string& line, const StudySettings& settings) {
    StudyRun run;
    run.settings = settings;
    // The settings must be these, to the letter; what follows are numbers.
    const std::string whole = to_line(run);
    std::size_t end = 0;
    for (int comma = 0; comma < 6; ++comma) end = whole.find(',', end) + 1;
    if (line.compare(0, end, whole, 0, end) != 0) return std::nullopt;
    std::istringstream rest(line.substr(end));
    std::vector<double> values;
    for (std::string cell; std::getline(rest, cell, ',');) {
        const std::optional<double> value = parse_binary64(cell);
        if (!value) return std::nullopt;
        values.push_back(*value);
    }
    if (values.size() != 14) return std::nullopt;
    std::size_t next = 0;
    for (std::int64_t* count : {&run.elements, &run.shots, &run.segments, &run.form_factors, &run.buffers})
        *count = static_cast<std::int64_t>(values[next++]);
    run.bytes = static_cast<std::uint64_t>(values[next++]);
    for (double* value : {&run.seconds_least, &run.seconds_median, &run.all.l1, &run.all.l2, &run.all.most,
                          &run.band.l1, &run.band.l2, &run.band.most})
        *value = values[next++];
    return run;
}

std::vector<bool> pareto_front(const std::vector<std::array<double, 2>>& time_and_error) {
    std::vector<bool> front;
    for (const auto& a : time_and_error)
        front.push_back(std::none_of(time_and_error.begin(), time_and_error.end(), [&](const auto& b) {
            return b[0] <= a[0] && b[1] <= a[1] && (b[0] < a[0] || b[1] < a[1]);
        }));
    return front;
}

}  // namespace cob
