// Form factors at the extremes beside an independent evaluation.
#include "cob/form_factor.hpp"
#include "cob/stress.hpp"
#include "report/stress_scene.hpp"
#include "report/text.hpp"

#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>

#include <algorithm>
#include <cmath>

namespace cob {
namespace {

using Wide = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<100>, boost::multiprecision::et_off>;
using WidePoint = Vector3<Wide>;

struct Question {
    std::string name;
    Point receiver, normal;
    stress::Loop polygon;
};

WidePoint wide(const Point& p) {
    return {Wide(p.x), Wide(p.y), Wide(p.z)};
}

/// Lambert's sum with 100 digits, in the form with the arc tangent and the horizon cut at its zero: shares nothing
/// with the library's.
Wide independent_form_factor(const Question& question) {
    const WidePoint n = wide(question.normal);
    std::vector<WidePoint> corners, kept;
    for (const Point& p : question.polygon) corners.push_back(wide(p) - wide(question.receiver));

    // The receiver must lie in front of the polygon.
    WidePoint newell{};
    for (std::size_t i = 0; i < corners.size(); ++i)
        newell = newell + cross(corners[i], corners[(i + 1) % corners.size()]);
    if (dot(newell, corners[0]) >= 0) return 0;

    // What lies in front of the receiver.
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const WidePoint &a = corners[i], &b = corners[(i + 1) % corners.size()];
        const Wide above_a = dot(n, a), above_b = dot(n, b);
        if (above_a >= 0) kept.push_back(a);
        if ((above_a < 0) != (above_b < 0)) kept.push_back(a + Wide(above_a / (above_a - above_b)) * (b - a));
    }

    // Half the sum of the sides' angles times the cosines of their planes; seen from the front it runs clockwise.
    Wide sum = 0;
    for (std::size_t i = 0; i < kept.size(); ++i) {
        const WidePoint &a = kept[i], &b = kept[(i + 1) % kept.size()];
        const WidePoint across = cross(a, b);
        const Wide length = sqrt(dot(across, across));
        if (length > 0) sum += atan2(length, dot(a, b)) * dot(n, across) / length;
    }
    return abs(sum) / sqrt(dot(n, n)) / (2 * boost::math::constants::pi<Wide>());
}

/// A square of this side at a height over the receiver, facing down, moved aside.
stress::Loop square(double side, double height, double aside = 0) {
    const double h = side / 2;
    return {{aside - h, -h, height}, {aside - h, h, height}, {aside + h, h, height}, {aside + h, -h, height}};
}

std::vector<Question> questions(bool quick) {
    const Point origin{0, 0, 0}, up{0, 0, 1};
    std::vector<Question> all;
    const auto add = [&](const std::string& name, const stress::Loop& polygon, const Point& normal) {
        all.push_back({name, origin, normal, polygon});
    };
    const auto text = [](const char* what, double value) { return printed("%s %.0e", what, value); };
    for (const double distance : {1e-8, 1e-4, 1.0, 1e4, 1e8})
        add(text("unit square overhead at", distance), square(1, distance), up);
    for (const double scale : {1e-150, 1e-100, 1e100, 1e150})
        add(text("square of side and distance", scale), square(scale, scale, scale / 3), up);
    if (quick) return all;
    for (const double width : {1e-4, 1e-8, 1e-12}) {
        const double w = width / 2;
        add(text("strip of length 1 and width", width), {{-0.5, -w, 1}, {-0.5, w, 1}, {0.5, w, 1}, {0.5, -w, 1}}, up);
    }
    for (const double height : {1e-3, 1e-6, 1e-9})
        add(text("grazing: standing strip above the horizon by", height),
            {{1, -0.5, 0}, {1, -0.5, height}, {1, 0.5, height}, {1, 0.5, 0}}, up);
    for (const double tilt : {1e-3, 1e-6, 1e-9})
        add(text("grazing: square seen at a sine of", tilt),
            {{1, -0.5, tilt}, {1, 0.5, tilt}, {2, 0.5, tilt}, {2, -0.5, tilt}}, up);
    for (const double gap : {1e-4, 1e-8, 1e-12})
        add(text("perpendicular wall, receiver away by", gap), {{gap, -1, 0}, {gap, -1, 2}, {gap, 1, 2}, {gap, 1, 0}},
            up);
    for (const double low : {0.1, 1e-8})
        add(text("square cut by the horizon, dips by", low), {{1, -1, -low}, {1, -1, 1}, {1, 1, 1}, {1, 1, -low}}, up);
    add("fills half the sky", {{0, -1e8, 1e-3}, {0, 1e8, 1e-3}, {1e8, 1e8, 1e-3}, {1e8, -1e8, 1e-3}}, up);
    return all;
}

std::string scientific(double value) {
    return printed("%.3e", value);
}

StressRow row_of(const Question& question) {
    const View<Point> polygon(question.polygon.data(), question.polygon.data() + question.polygon.size());
    const Wide truth = independent_form_factor(question);
    const FormFactor fast = form_factor(question.receiver, question.normal, polygon);
    const FormFactor precise = precise_form_factor(question.receiver, question.normal, polygon);
    const Wide fast_off = abs(Wide(fast.value) - truth), precise_off = abs(Wide(precise.value) - truth);
    const auto relative = [&](const Wide& off) { return truth > 0 ? static_cast<double>(off / truth) : 0.0; };

    StressRow row{"photometry", question.name, "finite; within its own error bound; precise within 1e-12, relative", "",
                  Verdict::pass};
    row.came_out = "form factor " + scientific(static_cast<double>(truth)) + "; binary64 off by " +
                   scientific(relative(fast_off)) + " relative (bound " + scientific(fast.error) +
                   " absolute); precise off by " + scientific(relative(precise_off));
    const bool finite = std::isfinite(fast.value) && std::isfinite(precise.value);
    const bool bounded = fast_off <= Wide(fast.error) || !std::isfinite(fast.error);
    if (!finite || !bounded || precise_off > Wide(1e-12) * truth) row.verdict = Verdict::failed;
    // Right within its bound, and yet of no use: the cancellation of Lambert's sum.
    else if (relative(fast_off) > 1e-6 || !std::isfinite(fast.error)) {
        row.verdict = Verdict::limit;
        row.came_out += "; the sum of the sides cancels, so ask precise_form_factor";
    }
    return row;
}

}  // namespace

std::vector<StressRow> stress_photometry(const StressOptions& options) {
    std::vector<StressRow> rows;
    for (const Question& question : questions(options.quick)) {
        if (options.progress) options.progress(rows.size(), 0);
        rows.push_back(row_of(question));
    }
    return rows;
}

}  // namespace cob
