#include "radiosity/receiver_quadrature.hpp"

#include "radiosity/cells.hpp"
#include "radiosity/gauss.hpp"
#include "radiosity/lambert.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace cob::radiosity {
namespace {

/// A product rule collapsed at corner 0: point k is corner 0 + f ((corner 1 - corner 0) + g (corner 2 - corner 1)).
template <std::size_t n>
struct TriangleRule {
    std::array<double, n * n> f, g, weight;  ///< Weights sum to 1.

    TriangleRule() {
        const GaussRule<n>& rule = gauss_rule<n>();
        for (std::size_t k = 0; k < n * n; ++k) {
            f[k] = rule.node[k / n], g[k] = rule.node[k % n];
            weight[k] = 2 * f[k] * rule.weight[k / n] * rule.weight[k % n];
        }
    }
    Point2D point(const Triangle2D& t, std::size_t k) const { return mix(t[0], mix(t[1], t[2], g[k]), f[k]); }
};

template <std::size_t n>
const TriangleRule<n>& triangle_rule() {
    static const TriangleRule<n> rule;
    return rule;
}

/// How far values at the points of a rule are from the nearest polynomial of a degree (least squares): the largest of
/// the distances. A rule with positive weights is off by at most twice the distance from the best polynomial that it
/// integrates exactly; and unlike the difference of two rules, this does not vanish by chance where the values bend.
template <std::size_t n, std::size_t degree>
class PolynomialResidual {
public:
    static constexpr std::size_t points = n * n;
    using Vector = std::array<double, points>;

    PolynomialResidual() {
        // Gram and Schmidt over 1, x, y, x^2, x y, y^2, ...; twice, for rounding.
        const TriangleRule<n>& rule = triangle_rule<n>();
        std::size_t j = 0;
        for (std::size_t total = 0; total <= degree; ++total)
            for (std::size_t power = 0; power <= total; ++power, ++j) {
                for (std::size_t k = 0; k < points; ++k) {
                    const double y = rule.f[k] * rule.g[k], x = rule.f[k] - y;
                    basis_[j][k] = std::pow(x, static_cast<int>(total - power)) * std::pow(y, static_cast<int>(power));
                }
                for (int twice = 0; twice < 2; ++twice)
                    for (std::size_t i = 0; i < j; ++i) remove(basis_[i], basis_[j]);
                const double size = std::sqrt(product(basis_[j], basis_[j]));
                for (double& b : basis_[j]) b /= size;
            }
    }

    double operator()(Vector values) const {
        for (const Vector& b : basis_) remove(b, values);
        double largest = 0;
        for (double v : values) largest = std::max(largest, std::abs(v));
        return largest;
    }

private:
    static constexpr std::size_t terms = (degree + 1) * (degree + 2) / 2;

    static double product(const Vector& a, const Vector& b) {
        double sum = 0;
        for (std::size_t k = 0; k < points; ++k) sum += a[k] * b[k];
        return sum;
    }
    static void remove(const Vector& unit, Vector& from) {
        const double along = product(unit, from);
        for (std::size_t k = 0; k < points; ++k) from[k] -= along * unit[k];
    }

    std::array<Vector, terms> basis_{};
};

/// Of the residual, what counts as the error: the integral of a bend is off by far less than its values. On single
/// cells of random scenes the true error was below a tenth of that, but for a few; over whole receivers below a
/// hundredth.
constexpr double residual_share = 0.25;

/// What the samples of a cell of unknown structure may have missed, as shares of what one side's motion over the cell
/// may change, and at most of what would be seen of the whole light. Cells are cut before this matters wherever cutting
/// tells their structure; smaller shares were found to be too small behind thin shadows of far lights.
constexpr double missed_by_motion = 0.002, missed_most = 0.02;

/// Larger cells of unknown structure, by their share of the receiver's area, are cut without a look.
constexpr double worth_sampling = 1e-3;

double distance(const Point2D& a, const Point2D& b) {
    return std::hypot(a.s - b.s, a.t - b.t);
}

/// The point of a triangle that is nearest to another.
Point2D nearest_in(const Triangle2D& t, const Point2D& p) {
    Point2D best = t[0];
    bool inside = true;
    for (std::size_t k = 0; k < 3; ++k) {
        const Point2D &a = t[k], &b = t[(k + 1) % 3], &c = t[(k + 2) % 3];
        const auto side = [&](const Point2D& q) { return (b.s - a.s) * (q.t - a.t) - (b.t - a.t) * (q.s - a.s); };
        inside = inside && side(p) * side(c) >= 0;
        const double length = (b.s - a.s) * (b.s - a.s) + (b.t - a.t) * (b.t - a.t);
        const double along = (b.s - a.s) * (p.s - a.s) + (b.t - a.t) * (p.t - a.t);
        const Point2D on = mix(a, b, length > 0 ? std::clamp(along / length, 0.0, 1.0) : 0);
        if (distance(on, p) < distance(best, p)) best = on;
    }
    return inside ? p : best;
}

/// A triangle and its share of the integral.
struct Cell {
    Triangle2D triangle;
    std::vector<const CornerLoop*> occluders;
    Integral visible{};
    std::optional<UndecidedSign> event{};  ///< Where to cut it; nothing where it is smooth.
    bool undecided = false;                ///< Of unknown structure, and nothing was sampled.
};

class Cubature {
public:
    Cubature(const ReceiverIntegrand& integrand, const QuadratureOptions& options)
        : integrand_(integrand), options_(options) {}

    QuadratureResult run(const std::vector<Triangle2D>& triangles, const std::vector<const CornerLoop*>& occluders);

private:
    /// Integrals over a cell of what is seen and of what is hidden.
    struct Parts {
        Integral visible, hidden;
        double least_hidden = 0, most_hidden = 0;  ///< At the points.
        double least_error() const { return std::min(visible.error, hidden.error); }
        /// What a lower rule's difference says may be less. A share of its error stays: two rules may agree by chance.
        Parts better_than(const Parts& lower) const {
            const auto better = [](const Integral& high, const Integral& low) {
                const double difference = std::max(2 * std::abs(high.value - low.value), low.error / 16);
                return Integral{high.value, std::min(high.error, difference)};
            };
            return {better(visible, lower.visible), better(hidden, lower.hidden), least_hidden, most_hidden};
        }
    };
    /// By the rule of n x n points, with the distances from a polynomial as errors.
    template <std::size_t n, std::size_t degree, class F>
    Parts sample(const Triangle2D& triangle, const F& value_at);
    double misfit(const Structure& structure, Cell& cell);
    double missed_peaks(const Triangle2D& cell, const Structure& structure, const Parts& parts);
    void evaluate(Cell& cell);
    void sample_undecided(Cell& cell, const Structure& structure);
    void look(Cell cell);
    bool is_done() const;

    static bool smaller(const Cell& a, const Cell& b) { return a.visible.error < b.visible.error; }

    const ReceiverIntegrand& integrand_;
    const QuadratureOptions& options_;
    std::vector<Cell> cells_;  ///< A heap, the largest error first.
    double area_ = 0, error_ = 0;
    std::uint64_t evaluations_ = 0, looked_ = 0, undecided_ = 0;
};

template <std::size_t n, std::size_t degree, class F>
Cubature::Parts Cubature::sample(const Triangle2D& triangle, const F& value_at) {
    static const PolynomialResidual<n, degree> residual;
    const TriangleRule<n>& rule = triangle_rule<n>();
    typename PolynomialResidual<n, degree>::Vector visible, hidden;
    Parts parts;
    for (std::size_t k = 0; k < n * n; ++k) {
        const PointValue value = value_at(rule.point(triangle, k));
        visible[k] = value.visible, hidden[k] = value.unobstructed - value.visible;
        parts.visible.value += rule.weight[k] * visible[k];
        parts.hidden.value += rule.weight[k] * hidden[k];
    }
    evaluations_ += n * n;
    const double all = area(triangle);
    parts.visible.value *= all, parts.hidden.value *= all;
    parts.visible.error = residual_share * all * residual(visible);
    parts.hidden.error = residual_share * all * residual(hidden);
    parts.least_hidden = *std::min_element(hidden.begin(), hidden.end());
    parts.most_hidden = *std::max_element(hidden.begin(), hidden.end());
    return parts;
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

/// Near an occluder what is hidden varies on the scale of its distance, and a peak may stand between the points of a
/// larger cell. So the places of the cell next to its middle, corners and sides are looked at: where more or less is
/// hidden than the points allow for, by as much again as they vary, that much may be missed under it, and around its
/// sides twice as far as they are away.
double Cubature::missed_peaks(const Triangle2D& cell, const Structure& structure, const Parts& parts) {
    const Point2D centre = centroid(cell);
    const double radius = reach(cell), spread = parts.most_hidden - parts.least_hidden, all = area(cell);
    struct Peak {
        double away, beyond;
    };
    const auto next_to = [&](const Vector3<double>& p) -> Peak {
        const Point2D place = nearest_in(cell, {p.x, p.y});
        const double away = std::hypot(distance(place, {p.x, p.y}), p.z);
        if (!(away < radius)) return {away, 0};
        const PointValue value = integrand_.by_contour(place, structure.contour);
        ++evaluations_;
        const double hidden = value.unobstructed - value.visible;
        return {away, std::max({0.0, hidden - parts.most_hidden - spread, parts.least_hidden - hidden - spread})};
    };
    double sum = 0;
    for (const CornerLoop* occluder : structure.occluders) {
        std::vector<Vector3<double>> corners;
        for (const VertexId v : occluder->corners) corners.push_back(integrand_.corner(v));
        Vector3<double> middle = corners[0], doubled_area{};
        double around_sides = 0;
        for (std::size_t k = 0; k < corners.size(); ++k) {
            const Vector3<double>&a = corners[k], &b = corners[(k + 1) % corners.size()];
            for (const Vector3<double>& p : {a, nearest_on_side(a, b, {centre.s, centre.t, 0})}) {
                const Peak peak = next_to(p);
                const double around = 2 * peak.away * (3 * peak.away + std::min(2 * radius, length(b - a)));
                around_sides = std::max(around_sides, peak.beyond * std::min(all, around));
            }
            middle = middle + (1 / static_cast<double>(k + 1)) * (a - middle);
            doubled_area = doubled_area + cross(a - corners[0], b - corners[0]);
        }
        sum += around_sides + next_to(middle).beyond * std::min(all, std::abs(doubled_area.z) / 2);
    }
    return sum;
}

void Cubature::evaluate(Cell& cell) {
    Structure structure = integrand_.structure(cell.triangle, cell.occluders);
    const double all = area(cell.triangle);
    if (structure.event) {
        cell.event = structure.event;
        cell.visible = integrand_.range(cell.triangle, structure.occluders);
        cell.undecided = true;
        if (all <= worth_sampling * area_) sample_undecided(cell, structure);
        cell.occluders = std::move(structure.occluders);
        return;
    }
    const double share = options_.tolerance * all / area_ / 4;
    double missed = misfit(structure, cell);
    const auto value_at = [&](const Point2D& point) { return integrand_.by_contour(point, structure.contour); };
    Parts parts = sample<4, 2>(cell.triangle, value_at);
    const double peaks = missed_peaks(cell.triangle, structure, parts);
    if (peaks > missed) cell.event.reset();
    missed += peaks;
    // Of one structure, it is smooth: higher rules pay.
    const auto falls_short = [&] { return missed <= share && parts.least_error() > share; };
    if (falls_short()) parts = sample<6, 4>(cell.triangle, value_at).better_than(parts);
    if (falls_short()) parts = sample<9, 7>(cell.triangle, value_at).better_than(parts);
    if (parts.visible.error <= share || parts.visible.error <= parts.hidden.error) {
        cell.visible = parts.visible;
    } else {
        // The hidden part is smooth where the whole is not: beside a side that both polygons share.
        const Integral whole = integrand_.unobstructed(cell.triangle);
        cell.visible = {whole.value - parts.hidden.value, whole.error + parts.hidden.error};
    }
    if (cell.visible.error > missed) cell.event.reset();
    cell.visible.error += missed;
    cell.occluders = std::move(structure.occluders);
}

/// Where the budget does not suffice to know the structure: as well as samples tell. Near an occluder whole shadows may
/// stand between the points: as long as a line is left there to cut along, nothing more is said than the range.
void Cubature::sample_undecided(Cell& cell, const Structure& structure) {
    if (structure.event->linear && !std::isfinite(structure.change)) return;
    const auto value_at = [&](const Point2D& point) { return integrand_.exact(point, structure); };
    const Parts parts = sample<4, 2>(cell.triangle, value_at);
    const double most = cell.visible.value + cell.visible.error;
    const double missed = std::min(missed_most * most, missed_by_motion * structure.change * area(cell.triangle));
    if (parts.visible.error + missed < cell.visible.error)
        cell.visible = {parts.visible.value, parts.visible.error + missed};
    cell.undecided = false;
}

void Cubature::look(Cell cell) {
    if (++looked_ % 16 == 0 && options_.pulse) options_.pulse();
    if (area(cell.triangle) == 0) return;
    evaluate(cell);
    error_ += cell.visible.error;
    undecided_ += cell.undecided;
    cells_.push_back(std::move(cell));
    std::push_heap(cells_.begin(), cells_.end(), smaller);
}

bool Cubature::is_done() const {
    const std::uint64_t reserved = 16 * undecided_;
    return cells_.empty() || error_ <= options_.tolerance || evaluations_ + reserved >= options_.max_evaluations ||
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
        undecided_ -= cell.undecided;
        for (const Triangle2D& part : cut(cell.triangle, cell.event)) look({part, cell.occluders});
    }
    QuadratureResult result;
    for (Cell& cell : cells_) {
        if (cell.undecided && error_ > options_.tolerance)
            sample_undecided(cell, integrand_.structure(cell.triangle, cell.occluders));
        result.visible.value += cell.visible.value;
        result.visible.error += cell.visible.error;
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
