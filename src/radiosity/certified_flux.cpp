#include "radiosity/certified_flux.hpp"

#include "radiosity/cell_flux.hpp"
#include "radiosity/cells.hpp"
#include "radiosity/certified_contour.hpp"

#include <algorithm>
#include <cmath>

namespace cob::radiosity {
namespace {

/// A triangle of the receiver and what is known of the flux that it gets.
struct Cell {
    Triangle2D triangle;
    std::vector<const CornerLoop*> occluders;
    Interval flux{};
    std::optional<UndecidedSign> event{};  ///< Why the structure is not known.

    double width() const { return flux.high() - flux.low(); }
};

class CertifiedCubature {
public:
    CertifiedCubature(const PairShapes& shapes, const std::vector<CornerLoop>& lights, const CertifiedOptions& options)
        : shapes_(shapes), lights_(lights), options_(options) {}

    CertifiedFlux run(const std::vector<ConvexPolygon>& receiving, const std::vector<const CornerLoop*>& occluders);

private:
    void look(Cell cell);
    void evaluate(Cell& cell) const;
    void tighten(Cell& cell) const;
    /// With nothing between.
    Interval unobstructed(const Triangle2D& triangle) const;
    /// Of the polygon and the lights, nothing between.
    Interval mutual_flux(const std::vector<IntervalPoint>& polygon, double width) const;

    static bool narrower(const Cell& a, const Cell& b) { return a.width() < b.width(); }

    const PairShapes& shapes_;
    const std::vector<CornerLoop>& lights_;
    const CertifiedOptions& options_;
    std::vector<Cell> cells_;  ///< A heap, the widest first.
    double area_ = 0, width_ = 0;
    double misfit_ = 0;  ///< Area at most by which rounded corners make cells differ from what they are parts of.
    std::uint64_t looked_ = 0;
};

void CertifiedCubature::evaluate(Cell& cell) const {
    const double all = area(cell.triangle);
    const Interval bounds{0, all};
    double sliver = 0;
    try {
        CellView view(shapes_, cell.triangle);
        cell.occluders = view.between(lights_, cell.occluders);
        const Contour contour = view.visible_contour(lights_, cell.occluders);
        cell.flux = flux_over_cell(shapes_, cell.triangle, contour);
        sliver = contour.sliver;
    } catch (const UndecidedSign& event) {
        cell.event = event;
        cell.flux = {0, std::min(all, unobstructed(cell.triangle).high())};
        return;
    }
    const double share = options_.width * all / area_ / 2;
    if (cell.occluders.empty() && !(cell.width() <= share)) {
        std::vector<IntervalPoint> corners;
        for (const Point2D& p : left_around(cell.triangle))
            corners.push_back({Interval(p.s), Interval(p.t), Interval(0)});
        const Interval closed = mutual_flux(corners, share / 2);
        cell.flux = {std::max(cell.flux.low(), closed.low()), std::min(cell.flux.high(), closed.high())};
    }
    const Interval paid = cell.flux + Interval(-1, 1) * Interval(sliver * all);
    cell.flux = {std::max(bounds.low(), paid.low()), std::min(bounds.high(), paid.high())};
}

Interval CertifiedCubature::unobstructed(const Triangle2D& triangle) const {
    try {
        const Contour contour = CellView(shapes_, triangle).visible_contour(lights_, {});
        return flux_over_cell(shapes_, triangle, contour) + Interval(-1, 1) * Interval(contour.sliver * area(triangle));
    } catch (const UndecidedSign&) {
        return Interval::unknown();
    }
}

Interval CertifiedCubature::mutual_flux(const std::vector<IntervalPoint>& polygon, double width) const {
    Interval sum = 0;
    for (const CornerLoop& light : lights_) {
        std::vector<IntervalPoint> corners;
        for (VertexId v : light.corners) corners.push_back(shapes_.corner(v));
        sum += certified_mutual_flux(polygon, corners, width / static_cast<double>(lights_.size()));
    }
    return sum;
}

/// Where the structure is not known: from the value in the middle, where it is, as far as it can change.
void CertifiedCubature::tighten(Cell& cell) const {
    if (!cell.event) return;
    const Triangle2D& t = cell.triangle;
    const Point2D middle = centroid(t);
    try {
        const Triangle2D point{middle, middle, middle};
        const Interval value =
            range_over_cell(shapes_, point, CellView(shapes_, point).visible_contour(lights_, cell.occluders));
        const double change =
            motion_over_cell(shapes_, t, lights_, cell.occluders).of_all_sides * reach(t) * (1 + 1e-9);
        const double all = area(t), less = all * (1 - 0x1p-46);
        cell.flux = {std::max(cell.flux.low(), less * (value.low() - change)),
                     std::min(cell.flux.high(), all * (value.high() + change) * (1 + 0x1p-50))};
    } catch (const UndecidedSign&) {
    }
}

void CertifiedCubature::look(Cell cell) {
    if (++looked_ % 64 == 0 && options_.pulse) options_.pulse();
    if (area(cell.triangle) == 0) return;
    evaluate(cell);
    width_ += cell.width();
    cells_.push_back(std::move(cell));
    std::push_heap(cells_.begin(), cells_.end(), narrower);
}

CertifiedFlux CertifiedCubature::run(const std::vector<ConvexPolygon>& receiving,
                                     const std::vector<const CornerLoop*>& occluders) {
    // Nothing between: in closed form but for one integral. What is between takes of it.
    Interval closed(0);
    for (const ConvexPolygon& part : receiving) {
        std::vector<IntervalPoint> corners;
        for (const RationalPoint& corner : part) corners.push_back(shapes_.local(corner));
        closed += mutual_flux(corners, occluders.empty() ? 0 : options_.width / 4);
    }
    if (!occluders.empty()) closed = {0, closed.high()};
    if (closed.width() <= options_.width) return {std::max(0.0, closed.low()), closed.high(), 1};

    std::vector<Triangle2D> triangles;
    for (const ConvexPolygon& part : receiving) {
        std::vector<Point2D> corners;
        for (const RationalPoint& corner : part) {
            const IntervalPoint local = shapes_.local(corner);
            corners.push_back({local.x.middle(), local.y.middle()});
            const double off = std::max(local.x.width(), local.y.width());
            misfit_ += 4 * off * (std::abs(corners.back().s) + std::abs(corners.back().t) + 4);
        }
        for (std::size_t k = 2; k < corners.size(); ++k) {
            triangles.push_back({corners[0], corners[k - 1], corners[k]});
            area_ += area(triangles.back());
        }
    }
    for (const Triangle2D& triangle : triangles) look({triangle, occluders});
    while (!cells_.empty() && width_ > options_.width && looked_ < options_.max_cells) {
        std::pop_heap(cells_.begin(), cells_.end(), narrower);
        const Cell cell = std::move(cells_.back());
        cells_.pop_back();
        width_ -= cell.width();
        misfit_ += misfit_of_cut(cell.triangle);
        // Along lines only: what a chord leaves beside a curve is not certain, either.
        const bool on_line = cell.event && cell.event->linear;
        for (const Triangle2D& part : cut(cell.triangle, on_line ? cell.event : std::nullopt))
            look({part, cell.occluders});
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
