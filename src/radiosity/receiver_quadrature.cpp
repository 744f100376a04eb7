#include "radiosity/receiver_quadrature.hpp"

#include "radiosity/cells.hpp"
#include "radiosity/lambert.hpp"
#include "radiosity/nearby_sides.hpp"
#include "radiosity/triangle_rule.hpp"

#include <algorithm>
#include <cmath>

namespace cob::radiosity {
namespace {

/// Of the residual, what counts as the error: the integral of a bend is off by far less than its values. On single
/// cells of random scenes the true error was below a tenth of that, but for a few; over whole receivers below a
/// hundredth.
constexpr double residual_share = 0.25;

/// Closed forms are bisected until two rules agree to this share of a cell's error: with less, some agreed by chance.
constexpr double closed_form_share = 0x1p-12;

/// What the samples of a cell of unknown structure may have missed, as shares of what one side's motion over the cell
/// may change, and at most of what would be seen of the whole light. Cells are cut before this matters wherever cutting
/// tells their structure; smaller shares were found to be too small behind thin shadows of far lights, and of the whole
/// light for cells that are still large when the budget ends.
constexpr double missed_by_motion = 0.002, missed_most = 0.02, missed_most_if_large = 0.25;

/// Larger cells of unknown structure, by their share of the receiver's area, are cut without a look.
constexpr double worth_sampling = 1e-3;

/// Where nothing is known but a range, the truth is most often one of its ends: the value is put so far from the
/// likelier one, in widths of the range.
constexpr double from_likelier_end = 0.25;

/// A triangle and its share of the integral.
struct Cell {
    Triangle2D triangle;
    std::vector<const CornerLoop*> occluders;
    Integral visible{};
    std::optional<UndecidedSign> event{};  ///< Where to cut it; nothing where it is smooth.
    std::optional<FluxRange> range{};      ///< Of unknown structure, and nothing was sampled.
    std::uint64_t reserved = 0;            ///< Evaluations that it will take at the end, if it is not cut.
};

class Cubature {
public:
    Cubature(const ReceiverIntegrand& integrand, const QuadratureOptions& options)
        : integrand_(integrand), options_(options) {}

    QuadratureResult run(const std::vector<Triangle2D>& triangles, const std::vector<const CornerLoop*>& occluders);

private:
    /// An integral over a cell, and the range of the values at the points.
    struct Part {
        Integral integral;
        double least = 0, most = 0;
        double missed = 0;  ///< At most, of peaks between the points.
        double error() const { return integral.error + missed; }
        /// What a lower rule's difference says may be less. A share of its error stays: two rules may agree by chance.
        Part better_than(const Part& lower) const {
            const double difference =
                std::max(2 * std::abs(integral.value - lower.integral.value), lower.integral.error / 16);
            return {{integral.value, std::min(integral.error, difference)}, least, most, lower.missed};
        }
    };
    /// Of what is seen and of what is hidden.
    struct Parts {
        Part visible, hidden;
        Parts better_than(const Parts& lower) const {
            return {visible.better_than(lower.visible), hidden.better_than(lower.hidden)};
        }
    };
    /// By the rule of n x n points, with the distances from a polynomial as errors.
    template <std::size_t n, std::size_t degree, class F>
    Parts sample(const Triangle2D& triangle, const F& value_at);
    double misfit(const Structure& structure, Cell& cell);
    template <class F>
    void add_missed_peaks(const Triangle2D& cell, const SplitContour& split, const F& value_at, Parts& parts);
    /// What the sides add that are not integrated in closed form, or what is hidden but for these: what is known
    /// better.
    struct Sampled {
        Part part;
        bool of_hidden = false;
    };
    Sampled sample_others(const Triangle2D& triangle, const SplitContour& split, double misfit, double goal);
    /// The cell's share where its structure is certain, and where it is not. The goal: an error that will do.
    void integrate(Cell& cell, const Structure& structure, double goal);
    void bound(Cell& cell, const Structure& structure, double goal);
    void evaluate(Cell& cell);
    static bool may_be_sampled(const Structure& structure);
    void sample_undecided(Cell& cell, const Structure& structure);
    void choose_in_range(Cell& cell, const Structure& structure);
    void look(Cell cell);
    bool is_done() const;

    static bool smaller(const Cell& a, const Cell& b) { return a.visible.error < b.visible.error; }

    const ReceiverIntegrand& integrand_;
    const QuadratureOptions& options_;
    std::vector<Cell> cells_;  ///< A heap, the largest error first.
    double area_ = 0, error_ = 0;
    std::uint64_t evaluations_ = 0, looked_ = 0, reserved_ = 0;
};

template <std::size_t n, std::size_t degree, class F>
Cubature::Parts Cubature::sample(const Triangle2D& triangle, const F& value_at) {
    static const PolynomialResidual<n, degree> residual;
    const TriangleRule<n>& rule = triangle_rule<n>();
    typename PolynomialResidual<n, degree>::Vector visible, hidden;
    for (std::size_t k = 0; k < n * n; ++k) {
        const PointValue value = value_at(rule.point(triangle, k));
        visible[k] = value.visible, hidden[k] = value.unobstructed - value.visible;
    }
    evaluations_ += n * n;
    const double all = area(triangle);
    const auto part_of = [&](const auto& values) {
        double sum = 0;
        for (std::size_t k = 0; k < n * n; ++k) sum += rule.weight[k] * values[k];
        const auto [least, most] = std::minmax_element(values.begin(), values.end());
        return Part{{all * sum, residual_share * all * residual(values)}, *least, *most};
    };
    return {part_of(visible), part_of(hidden)};
}

/// What the contour may be off by, integrated, where it is not certain: for each doubtful sign the difference where
/// that is wrong most, on the share of the cell where it is wrong at all. What is seen wrongly is a triangle whose
/// sides grow with the determinant. The cell is to be cut at the worst of them.
double Cubature::misfit(const Structure& structure, Cell& cell) {
    double sum = 0, largest = 0;
    for (const DoubtfulSign& doubtful : structure.contour.doubtful) {
        const double off = std::abs(integrand_.exact(doubtful.worst, structure).visible -
                                    integrand_.by_contour(doubtful.worst, structure.contour).visible);
        ++evaluations_;
        const double missed = off * doubtful.beyond * doubtful.beyond * doubtful.share * area(cell.triangle);
        sum += missed;
        if (missed > largest) largest = missed, cell.event = doubtful.sign;
    }
    return sum;
}

/// Near a side what is seen varies on the scale of its distance, and a peak may stand between the points of a larger
/// cell. So the places of the cell next to the ends of the sides and in between are looked at, and places from there
/// towards the middle, for sides that touch the cell have no distance: where a value is beyond those at the points, by
/// more than they vary, as much may be missed around, twice as far as it is away.
template <class F>
void Cubature::add_missed_peaks(const Triangle2D& cell, const SplitContour& split, const F& value_at, Parts& parts) {
    const Point2D centre = centroid(cell);
    const double radius = reach(cell), all = area(cell);
    for (const auto& [from, to] : split.rough) {
        const Vector3<double> a = integrand_.corner(from), b = integrand_.corner(to);
        double missed_visible = 0, missed_hidden = 0;
        for (const Vector3<double>& p : {a, b, nearest_on_side(a, b, {centre.s, centre.t, 0})}) {
            const Point2D nearest = nearest_in(cell, {p.x, p.y});
            for (const double f : {0.0, 0x1p-8, 0x1p-6, 0x1p-4, 0x1p-2}) {
                const Point2D place = mix(nearest, centre, f);
                const double away = std::hypot(distance(place, {p.x, p.y}), p.z);
                if (!(away < radius)) break;
                const PointValue value = value_at(place);
                ++evaluations_;
                const double around = std::min(all, 2 * away * (3 * away + std::min(2 * radius, length(b - a))));
                const auto missed = [&](double found, const Part& part) {
                    return around * (std::max(found - part.most, part.least - found) - (part.most - part.least));
                };
                missed_visible = std::max(missed_visible, missed(value.visible, parts.visible));
                missed_hidden = std::max(missed_hidden, missed(value.unobstructed - value.visible, parts.hidden));
            }
        }
        // What is hidden unnoticed is seen too little of.
        parts.visible.missed += std::max(missed_visible, missed_hidden), parts.hidden.missed += missed_hidden;
    }
}

void Cubature::evaluate(Cell& cell) {
    Structure structure = integrand_.structure(cell.triangle, cell.occluders);
    const double goal = options_.tolerance * area(cell.triangle) / area_ / 4;
    if (structure.event)
        bound(cell, structure, goal);
    else
        integrate(cell, structure, goal);
    cell.occluders = std::move(structure.occluders);
}

void Cubature::bound(Cell& cell, const Structure& structure, double goal) {
    cell.event = structure.event;
    cell.range = integrand_.range(cell.triangle, structure.occluders, goal * closed_form_share);
    cell.visible.error = (1 - from_likelier_end) * (cell.range->high - cell.range->low);
    if (area(cell.triangle) <= worth_sampling * area_) sample_undecided(cell, structure);
    if (cell.range) cell.reserved = may_be_sampled(structure) ? 17 : 1;
}

void Cubature::integrate(Cell& cell, const Structure& structure, double goal) {
    const double misfit = this->misfit(structure, cell), of_closed_forms = goal * closed_form_share;
    const SplitContour split =
        split_off_nearby_sides(structure.contour, cell.triangle, integrand_.corner, of_closed_forms);
    const Sampled sampled = sample_others(cell.triangle, split, misfit, goal);
    cell.visible = split.over_occluder_sides;
    if (sampled.of_hidden) {
        cell.visible += integrand_.unobstructed(cell.triangle, of_closed_forms);
        cell.visible -= sampled.part.integral;
    } else {
        cell.visible += sampled.part.integral;
        cell.visible += split.over_light_sides;
    }
    cell.visible.error += sampled.part.missed;
    if (cell.visible.error > misfit) cell.event.reset();
    cell.visible.error += misfit;
}

Cubature::Sampled Cubature::sample_others(const Triangle2D& triangle, const SplitContour& split, double misfit,
                                          double goal) {
    const auto value_at = [&](const Point2D& point) {
        PointValue value = integrand_.by_contour(point, split.others);
        if (!split.light_sides.arcs.empty())
            value.unobstructed -= integrand_.by_contour(point, split.light_sides).visible;
        return value;
    };
    Parts parts = sample<4, 2>(triangle, value_at);
    add_missed_peaks(triangle, split, value_at, parts);
    // Beside a side that both polygons share only the hidden part is smooth.
    const auto of_hidden = [&] {
        return !split.rough.empty() && (split.hidden_is_smooth || !(parts.visible.error() <= parts.hidden.error()));
    };
    const auto taken = [&] { return of_hidden() ? parts.hidden : parts.visible; };
    // Of one structure, it is smooth: higher rules pay, unless what they do not lessen is too much by itself.
    const auto falls_short = [&] { return misfit + taken().missed <= goal && taken().error() > goal; };
    if (falls_short()) parts = sample<6, 4>(triangle, value_at).better_than(parts);
    if (falls_short()) parts = sample<9, 7>(triangle, value_at).better_than(parts);
    return {taken(), of_hidden()};
}

/// Near an occluder whole shadows may stand between the points: as long as a line is left there to cut along, nothing
/// more is said than the range.
bool Cubature::may_be_sampled(const Structure& structure) {
    return !structure.event->linear || std::isfinite(structure.change);
}

/// Where the budget does not suffice to know the structure: as well as samples tell.
void Cubature::sample_undecided(Cell& cell, const Structure& structure) {
    if (!may_be_sampled(structure)) return;
    const auto value_at = [&](const Point2D& point) { return integrand_.exact(point, structure); };
    const Integral visible = sample<4, 2>(cell.triangle, value_at).visible.integral;
    const bool is_large = area(cell.triangle) > worth_sampling * area_;
    const double most = (is_large ? missed_most_if_large : missed_most) * cell.range->high;
    const double missed = std::min(most, missed_by_motion * structure.change * area(cell.triangle));
    if (!(visible.error + missed < cell.visible.error)) return;
    cell.visible = {visible.value, visible.error + missed};
    cell.range.reset();
}

/// As seen from the middle.
void Cubature::choose_in_range(Cell& cell, const Structure& structure) {
    const PointValue value = integrand_.exact(centroid(cell.triangle), structure);
    ++evaluations_;
    const bool mostly_visible = value.visible >= value.unobstructed / 2;
    const double f = mostly_visible ? 1 - from_likelier_end : from_likelier_end;
    cell.visible.value = cell.range->low + f * (cell.range->high - cell.range->low);
}

void Cubature::look(Cell cell) {
    if (++looked_ % 16 == 0 && options_.pulse) options_.pulse();
    if (area(cell.triangle) == 0) return;
    evaluate(cell);
    error_ += cell.visible.error;
    reserved_ += cell.reserved;
    cells_.push_back(std::move(cell));
    std::push_heap(cells_.begin(), cells_.end(), smaller);
}

bool Cubature::is_done() const {
    return cells_.empty() || error_ <= options_.tolerance || evaluations_ + reserved_ >= options_.max_evaluations ||
           looked_ >= options_.max_evaluations;
}

QuadratureResult Cubature::run(const std::vector<Triangle2D>& triangles,
                               const std::vector<const CornerLoop*>& occluders) {
    for (const Triangle2D& triangle : triangles) area_ += area(triangle);
    for (const Triangle2D& triangle : triangles) look({triangle, occluders});
    while (!is_done()) {
        std::pop_heap(cells_.begin(), cells_.end(), smaller);
        const Cell cell = std::move(cells_.back());
        cells_.pop_back();
        error_ -= cell.visible.error;
        reserved_ -= cell.reserved;
        for (const Triangle2D& part : cut(cell.triangle, cell.event)) look({part, cell.occluders});
    }
    QuadratureResult result;
    for (Cell& cell : cells_) {
        if (cell.range) {
            const Structure structure = integrand_.structure(cell.triangle, cell.occluders);
            if (error_ > options_.tolerance) sample_undecided(cell, structure);
            if (cell.range) choose_in_range(cell, structure);
        }
        result.visible += cell.visible;
    }
    result.evaluations = evaluations_;
    return result;
}

}  // namespace

QuadratureResult integrate_visible(const std::vector<Triangle2D>& triangles,
                                   const std::vector<const CornerLoop*>& occluders, const ReceiverIntegrand& integrand,
                                   const QuadratureOptions& options) {
    return Cubature(integrand, options).run(triangles, occluders);
}

}  // namespace cob::radiosity
