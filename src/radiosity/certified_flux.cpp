#include "radiosity/certified_flux.hpp"

#include "radiosity/cell_flux.hpp"
#include "radiosity/certified_contour.hpp"

#include <algorithm>
#include <cmath>

namespace cob::radiosity {
namespace {

double turn(const Triangle2D& t) {
    return (t[1].s - t[0].s) * (t[2].t - t[0].t) - (t[2].s - t[0].s) * (t[1].t - t[0].t);
}

/// Not below the true area unless that is lost in the corners' rounding (see misfit_).
double area(const Triangle2D& t) {
    return std::abs(turn(t)) / 2 * (1 + 0x1p-48);
}

Point2D mix(const Point2D& a, const Point2D& b, double f) {
    return {a.s + f * (b.s - a.s), a.t + f * (b.t - a.t)};
}

double size_of(const Triangle2D& t) {
    double size = 0;
    for (std::size_t k = 0; k < 3; ++k)
        size = std::max({size, std::abs(t[k].s - t[(k + 1) % 3].s), std::abs(t[k].t - t[(k + 1) % 3].t)});
    return size;
}

/// A triangle of the receiver and what is known of the flux that it gets.
struct Cell {
    Triangle2D triangle;
    std::vector<const CornerLoop*> occluders;
    Interval flux{};
    std::optional<UndecidedSign> event{};  ///< Why the structure is not known.

    double width() const { return flux.high() - flux.low(); }
};

std::vector<Triangle2D> in_four(const Triangle2D& t) {
    const Point2D p = mix(t[0], t[1], 0.5), q = mix(t[1], t[2], 0.5), r = mix(t[2], t[0], 0.5);
    return {{t[0], p, r}, {p, t[1], q}, {r, q, t[2]}, {p, q, r}};
}

/// Along the line on which the event's determinant vanishes, where that cuts the cell well.
std::vector<Triangle2D> along(const UndecidedSign& event, const Triangle2D& t) {
    const std::array<double, 3>& h = event.at_corners;
    double largest = 0;
    for (double value : h) largest = std::max(largest, std::abs(value));
    const auto sign = [&](std::size_t k) { return std::abs(h[k]) <= 1e-9 * largest ? 0 : h[k] > 0 ? 1 : -1; };
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t a = k, b = (k + 1) % 3, c = (k + 2) % 3;
        if (sign(a) == 0 && sign(b) * sign(c) < 0) {
            const Point2D m = mix(t[b], t[c], h[b] / (h[b] - h[c]));
            return {{t[a], t[b], m}, {t[a], m, t[c]}};
        }
        if (sign(a) * sign(b) < 0 && sign(a) * sign(c) < 0) {
            const Point2D p = mix(t[a], t[b], h[a] / (h[a] - h[b])), q = mix(t[a], t[c], h[a] / (h[a] - h[c]));
            return {{t[a], p, q}, {p, t[b], t[c]}, {p, t[c], q}};
        }
    }
    return in_four(t);
}

class CertifiedCubature {
public:
    CertifiedCubature(const PairShapes& shapes, const std::vector<CornerLoop>& lights, const CertifiedOptions& options)
        : shapes_(shapes), lights_(lights), options_(options) {}

    CertifiedFlux run(const std::vector<ConvexPolygon>& receiving, const std::vector<const CornerLoop*>& occluders);

private:
    void look(Cell cell);
    void evaluate(Cell& cell) const;
    void tighten(Cell& cell) const;
    /// Of the polygon and the lights, nothing between.
    Interval mutual_flux(const std::vector<IntervalPoint>& polygon) const;

    static bool narrower(const Cell& a, const Cell& b) { return a.width() < b.width(); }

    const PairShapes& shapes_;
    const std::vector<CornerLoop>& lights_;
    const CertifiedOptions& options_;
    std::vector<Cell> cells_;  ///< A heap, the widest first.
    double width_ = 0;
    double misfit_ = 0;  ///< Area at most by which rounded corners make cells differ from what they are parts of.
    std::uint64_t looked_ = 0;
};

void CertifiedCubature::evaluate(Cell& cell) const {
    const double all = area(cell.triangle);
    cell.flux = {0, all};
    const Interval bounds = cell.flux;
    double sliver = 0;
    try {
        cell.occluders = between(shapes_, cell.triangle, lights_, cell.occluders);
        const Contour contour = visible_contour(shapes_, cell.triangle, lights_, cell.occluders);
        cell.flux = flux_over_cell(shapes_, cell.triangle, contour);
        sliver = contour.sliver;
    } catch (const UndecidedSign& event) {
        cell.event = event;
        return;
    }
    if (cell.occluders.empty() && !(cell.width() <= 1e-9 * all)) {
        const auto at = [&](std::size_t k) {
            return IntervalPoint{Interval(cell.triangle[k].s), Interval(cell.triangle[k].t), Interval(0)};
        };
        const bool left = turn(cell.triangle) > 0;
        const Interval closed = mutual_flux({at(0), at(left ? 1 : 2), at(left ? 2 : 1)});
        cell.flux = {std::max(cell.flux.low(), closed.low()), std::min(cell.flux.high(), closed.high())};
    }
    const Interval paid = cell.flux + Interval(-1, 1) * Interval(sliver * all);
    cell.flux = {std::max(bounds.low(), paid.low()), std::min(bounds.high(), paid.high())};
}

Interval CertifiedCubature::mutual_flux(const std::vector<IntervalPoint>& polygon) const {
    Interval sum = 0;
    for (const CornerLoop& light : lights_) {
        std::vector<IntervalPoint> corners;
        for (VertexId v : light) corners.push_back(shapes_.corner(v));
        sum += certified_mutual_flux(polygon, corners);
    }
    return sum;
}

/// Where the structure is not known: from the value in the middle, where it is, as far as it can change.
void CertifiedCubature::tighten(Cell& cell) const {
    if (!cell.event) return;
    const Triangle2D& t = cell.triangle;
    const Point2D middle{(t[0].s + t[1].s + t[2].s) / 3, (t[0].t + t[1].t + t[2].t) / 3};
    try {
        const Triangle2D point{middle, middle, middle};
        const Interval value =
            range_over_cell(shapes_, point, visible_contour(shapes_, point, lights_, cell.occluders));
        double reach = 0;
        for (const Point2D& corner : t) reach = std::max(reach, std::hypot(corner.s - middle.s, corner.t - middle.t));
        const double change = lipschitz_bound(shapes_, t, lights_, cell.occluders) * reach * (1 + 1e-9);
        const double all = area(t), less = all * (1 - 0x1p-46);
        cell.flux = {std::max(cell.flux.low(), less * (value.low() - change)),
                     std::min(cell.flux.high(), all * (value.high() + change) * (1 + 0x1p-50))};
    } catch (const UndecidedSign&) {
    }
}

void CertifiedCubature::look(Cell cell) {
    ++looked_;
    if (area(cell.triangle) == 0) return;
    evaluate(cell);
    width_ += cell.width();
    cells_.push_back(std::move(cell));
    std::push_heap(cells_.begin(), cells_.end(), narrower);
}

CertifiedFlux CertifiedCubature::run(const std::vector<ConvexPolygon>& receiving,
                                     const std::vector<const CornerLoop*>& occluders) {
    // Nothing between: in closed form but for one integral.
    Interval closed{0, HUGE_VAL};
    if (occluders.empty()) {
        closed = Interval(0);
        for (const ConvexPolygon& part : receiving) {
            std::vector<IntervalPoint> corners;
            for (const RationalPoint& corner : part) corners.push_back(shapes_.local(corner));
            closed += mutual_flux(corners);
        }
        if (closed.width() <= options_.width) return {std::max(0.0, closed.low()), closed.high(), 1};
    }

    for (const ConvexPolygon& part : receiving) {
        std::vector<Point2D> corners;
        for (const RationalPoint& corner : part) {
            const IntervalPoint local = shapes_.local(corner);
            corners.push_back({local.x.middle(), local.y.middle()});
            const double off = std::max(local.x.width(), local.y.width());
            misfit_ += 4 * off * (std::abs(corners.back().s) + std::abs(corners.back().t) + 4);
        }
        for (std::size_t k = 2; k < corners.size(); ++k) look({{corners[0], corners[k - 1], corners[k]}, occluders});
    }
    while (!cells_.empty() && width_ > options_.width && looked_ < options_.max_cells) {
        std::pop_heap(cells_.begin(), cells_.end(), narrower);
        const Cell cell = std::move(cells_.back());
        cells_.pop_back();
        width_ -= cell.width();
        const double size = size_of(cell.triangle);
        misfit_ += 16 * 0x1p-52 * size * (size + std::abs(cell.triangle[0].s) + std::abs(cell.triangle[0].t));
        const auto parts = cell.event && cell.event->linear ? along(*cell.event, cell.triangle) : in_four(cell.triangle);
        for (const Triangle2D& part : parts) look({part, cell.occluders});
    }
    Interval sum = Interval(-1, 1) * Interval(misfit_);
    for (Cell& cell : cells_) {
        tighten(cell);
        sum += cell.flux;
    }
    return {std::max(closed.low(), sum.low()), std::min(closed.high(), std::max(0.0, sum.high())), looked_};
}

}  // namespace

CertifiedFlux certified_flux(const PairShapes& shapes, const std::vector<ConvexPolygon>& receiving,
                             const std::vector<CornerLoop>& lights, const std::vector<CornerLoop>& occluders,
                             const CertifiedOptions& options) {
    std::vector<const CornerLoop*> all;
    for (const CornerLoop& occluder : occluders) all.push_back(&occluder);
    return CertifiedCubature(shapes, lights, options).run(receiving, all);
}

}  // namespace cob::radiosity
