#include "radiosity/receiver_quadrature.hpp"

#include "radiosity/gauss.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace cob::radiosity {
namespace {

double turn(const Point2D& a, const Point2D& b, const Point2D& c) {
    return (b.s - a.s) * (c.t - a.t) - (c.s - a.s) * (b.t - a.t);
}
double area(const Triangle2D& t) {
    return std::abs(turn(t[0], t[1], t[2])) / 2;
}
Point2D mix(const Point2D& a, const Point2D& b, double f) {
    return {a.s + f * (b.s - a.s), a.t + f * (b.t - a.t)};
}
double distance(const Point2D& a, const Point2D& b) {
    return std::hypot(a.s - b.s, a.t - b.t);
}

/// The length of a segment inside a triangle (counter-clockwise).
double chord(const ShadowLine& line, const Triangle2D& t) {
    double enter = 0, leave = 1;
    for (int k = 0; k < 3; ++k) {
        const double from = turn(t[k], t[(k + 1) % 3], line.from), to = turn(t[k], t[(k + 1) % 3], line.to);
        if (from < 0 && to < 0) return 0;
        if (from < 0) enter = std::max(enter, from / (from - to));
        if (to < 0) leave = std::min(leave, from / (from - to));
    }
    return std::max(0.0, leave - enter) * distance(line.from, line.to);
}

/// Splits a triangle along the line through the segment; nothing where that leaves a part too thin to matter.
std::optional<std::vector<Triangle2D>> split_along(const ShadowLine& line, const Triangle2D& t) {
    std::array<double, 3> side{};
    double size = 0;
    for (int k = 0; k < 3; ++k) size = std::max(size, std::abs(side[k] = turn(line.from, line.to, t[k])));
    bool left = false, right = false;
    for (double& s : side) {
        if (std::abs(s) <= 1e-9 * size) s = 0;
        left = left || s > 0;
        right = right || s < 0;
    }
    if (!left || !right) return std::nullopt;
    // Turn it so that corner 0 is alone on its side or the line passes through it.
    int lone = 0;
    for (int k = 0; k < 3; ++k) {
        const double a = side[k], b = side[(k + 1) % 3], c = side[(k + 2) % 3];
        if ((a == 0 && b * c < 0) || (a != 0 && a * b <= 0 && a * c <= 0 && b * c != 0)) lone = k;
    }
    const Point2D &a = t[lone], &b = t[(lone + 1) % 3], &c = t[(lone + 2) % 3];
    const double ha = side[lone], hb = side[(lone + 1) % 3], hc = side[(lone + 2) % 3];
    if (ha == 0) {
        const Point2D m = mix(b, c, hb / (hb - hc));
        return std::vector<Triangle2D>{{a, b, m}, {a, m, c}};
    }
    const Point2D p = mix(a, b, ha / (ha - hb)), q = mix(a, c, ha / (ha - hc));
    return std::vector<Triangle2D>{{a, p, q}, {p, b, c}, {p, c, q}};
}

std::vector<Triangle2D> split_in_four(const Triangle2D& t) {
    const Point2D p = mix(t[0], t[1], 0.5), q = mix(t[1], t[2], 0.5), r = mix(t[2], t[0], 0.5);
    return {{t[0], p, r}, {p, t[1], q}, {r, q, t[2]}, {p, q, r}};
}

/// A triangle, the lines that still cross it, and its share of the integral.
struct Cell {
    Triangle2D triangle;
    std::vector<std::uint32_t> lines;
    Integral visible;
};

/// Of a cell whose samples see one outline, what they may have missed, as a share of its area: `turning` times the
/// square of what the form factor may change by at most in it, for it is smooth but for its second derivatives where
/// vertices and edges pass each other, and that bound counts every edge; but not more than `missed`.
constexpr double turning = 1e-6, missed = 0.01;

class Cubature {
public:
    Cubature(const std::vector<ShadowLine>& lines, const ReceiverIntegrand& integrand, const QuadratureOptions& options)
        : lines_(lines), integrand_(integrand), options_(options) {}

    QuadratureResult run(const std::vector<std::vector<Point2D>>& regions);

private:
    static constexpr std::size_t first_cells = 16;

    std::vector<std::uint32_t> crossing(const Triangle2D& triangle, const std::vector<std::uint32_t>& lines) const;
    std::vector<Cell> split(const Cell& cell) const;
    void begin(const std::vector<std::vector<Point2D>>& regions);
    void evaluate(Cell& cell);
    struct Samples {
        double visible = 0, hidden = 0;              ///< The last rule's integrals,
        double error_visible = 0, error_hidden = 0;  ///< and how far they may be off.
        bool empty = true, some_visible = false, one_outline = true;
        std::uint64_t outline = 0;
    };
    template <std::size_t n>
    void sample(const Triangle2D& triangle, Samples& samples);

    const std::vector<ShadowLine>& lines_;
    const ReceiverIntegrand& integrand_;
    const QuadratureOptions& options_;
    std::vector<Cell> cells_;
    double area_ = 0;
    std::uint64_t evaluations_ = 0, looked_ = 0;
};

std::vector<std::uint32_t> Cubature::crossing(const Triangle2D& triangle,
                                              const std::vector<std::uint32_t>& lines) const {
    const double size = std::max(
        {distance(triangle[0], triangle[1]), distance(triangle[1], triangle[2]), distance(triangle[2], triangle[0])});
    std::vector<std::uint32_t> result;
    for (std::uint32_t k : lines)
        if (chord(lines_[k], triangle) > 1e-6 * size && split_along(lines_[k], triangle)) result.push_back(k);
    return result;
}

std::vector<Cell> Cubature::split(const Cell& cell) const {
    std::vector<Triangle2D> parts;
    std::uint32_t along = 0;
    double longest = 0;
    for (std::uint32_t k : cell.lines)
        if (const double length = chord(lines_[k], cell.triangle); length > longest) longest = length, along = k;
    if (longest > 0) parts = *split_along(lines_[along], cell.triangle);
    if (parts.empty()) parts = split_in_four(cell.triangle);
    std::vector<std::uint32_t> rest;
    for (std::uint32_t k : cell.lines)
        if (longest == 0 || k != along) rest.push_back(k);
    std::vector<Cell> cells;
    for (const Triangle2D& part : parts)
        if (area(part) > 0) cells.push_back({part, crossing(part, rest), {}});
    return cells;
}

/// Integrates both parts by a product rule collapsed at corner 0.
template <std::size_t n>
void Cubature::sample(const Triangle2D& t, Samples& samples) {
    const auto& rule = gauss_rule<n>();
    const double doubled = 2 * area(t);
    double visible = 0, hidden = 0;
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j) {
            const double f = rule.node[i];
            const Point2D point = mix(t[0], mix(t[1], t[2], rule.node[j]), f);
            const double weight = rule.weight[i] * rule.weight[j] * f * doubled;
            const PointValue value = integrand_.at_point(point);
            visible += weight * value.visible;
            hidden += weight * (value.unobstructed - value.visible);
            samples.some_visible = samples.some_visible || value.visible > 0;
            samples.one_outline = samples.one_outline && (samples.empty || samples.outline == value.outline);
            samples.outline = value.outline;
            samples.empty = false;
        }
    evaluations_ += n * n;
    // The lower rule's difference counts a little, too: across a bend, two rules may agree by chance.
    samples.error_visible = std::max(2 * std::abs(visible - samples.visible), samples.error_visible / 16);
    samples.error_hidden = std::max(2 * std::abs(hidden - samples.hidden), samples.error_hidden / 16);
    samples.visible = visible, samples.hidden = hidden;
}

void Cubature::evaluate(Cell& cell) {
    if (++looked_ % 16 == 0 && options_.pulse) options_.pulse();
    const double share = options_.tolerance * area(cell.triangle) / area_ / 4;
    Samples samples;
    sample<3>(cell.triangle, samples);
    samples.error_visible = samples.error_hidden = 0;
    sample<5>(cell.triangle, samples);
    if (!samples.one_outline || std::min(samples.error_visible, samples.error_hidden) > share)
        sample<7>(cell.triangle, samples);

    if (!samples.some_visible) {
        cell.visible = {0, 0};
    } else if (samples.error_visible <= share || samples.error_visible <= samples.error_hidden) {
        cell.visible = {samples.visible, samples.error_visible};
    } else {
        // The hidden part is smooth where the whole is not: beside a side that both polygons share.
        const Integral whole = integrand_.unobstructed(cell.triangle);
        cell.visible = {whole.value - samples.hidden, whole.error + samples.error_hidden};
    }

    // What the samples may not have met. Where the structure is certainly one, nothing; where all of them see one
    // outline, long lines change nothing, most likely, unless the structure does change at a line.
    const Structure structure = samples.one_outline ? integrand_.structure(cell.triangle) : Structure{};
    if (samples.one_outline && structure.kind == Structure::Kind::one) {
        cell.lines.clear();
        return;
    }
    if (samples.one_outline && structure.kind == Structure::Kind::curves) {
        const double long_enough = std::sqrt(area(cell.triangle)) / 2;
        auto& lines = cell.lines;
        lines.erase(std::remove_if(lines.begin(), lines.end(),
                                   [&](std::uint32_t k) { return chord(lines_[k], cell.triangle) > long_enough; }),
                    lines.end());
    }
    if (samples.one_outline)
        cell.visible.error += std::min(missed, turning * structure.change * structure.change) * area(cell.triangle);
    if (!cell.lines.empty()) {
        const double size = std::min(1.0, 64 * area(cell.triangle) / area_);
        cell.visible.error += 0.05 * size * (samples.visible + samples.hidden);
    }
}

void Cubature::begin(const std::vector<std::vector<Point2D>>& regions) {
    std::vector<std::uint32_t> all(lines_.size());
    for (std::uint32_t k = 0; k < all.size(); ++k) all[k] = k;
    for (const auto& region : regions)
        for (std::size_t k = 2; k < region.size(); ++k) {
            Triangle2D triangle{region[0], region[k - 1], region[k]};
            if (turn(triangle[0], triangle[1], triangle[2]) < 0) std::swap(triangle[1], triangle[2]);
            if (area(triangle) == 0) continue;
            area_ += area(triangle);
            cells_.push_back({triangle, crossing(triangle, all), {}});
        }
    // The first cells follow the lines before anything is evaluated, the largest first.
    const auto smaller = [](const Cell& a, const Cell& b) {
        const double weight_a = a.lines.empty() ? 0 : area(a.triangle),
                     weight_b = b.lines.empty() ? 0 : area(b.triangle);
        return weight_a < weight_b;
    };
    std::make_heap(cells_.begin(), cells_.end(), smaller);
    while (!cells_.empty() && cells_.size() < first_cells && !cells_.front().lines.empty()) {
        std::pop_heap(cells_.begin(), cells_.end(), smaller);
        const Cell cell = std::move(cells_.back());
        cells_.pop_back();
        for (Cell& part : split(cell)) {
            cells_.push_back(std::move(part));
            std::push_heap(cells_.begin(), cells_.end(), smaller);
        }
    }
}

QuadratureResult Cubature::run(const std::vector<std::vector<Point2D>>& regions) {
    begin(regions);
    double error = 0;
    for (Cell& cell : cells_) {
        evaluate(cell);
        error += cell.visible.error;
    }
    const auto smaller = [](const Cell& a, const Cell& b) { return a.visible.error < b.visible.error; };
    std::make_heap(cells_.begin(), cells_.end(), smaller);
    while (!cells_.empty() && error > options_.tolerance && evaluations_ < options_.max_evaluations) {
        std::pop_heap(cells_.begin(), cells_.end(), smaller);
        const Cell cell = std::move(cells_.back());
        cells_.pop_back();
        error -= cell.visible.error;
        for (Cell& part : split(cell)) {
            evaluate(part);
            error += part.visible.error;
            cells_.push_back(std::move(part));
            std::push_heap(cells_.begin(), cells_.end(), smaller);
        }
    }
    QuadratureResult result;
    for (const Cell& cell : cells_) {
        result.visible.value += cell.visible.value;
        result.visible.error += cell.visible.error;
    }
    result.evaluations = evaluations_;
    return result;
}

}  // namespace

QuadratureResult integrate_visible(const std::vector<std::vector<Point2D>>& regions,
                                   const std::vector<ShadowLine>& lines, const ReceiverIntegrand& integrand,
                                   const QuadratureOptions& options) {
    return Cubature(lines, integrand, options).run(regions);
}

}  // namespace cob::radiosity
