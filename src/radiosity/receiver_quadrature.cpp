#include "radiosity/receiver_quadrature.hpp"

#include "radiosity/cells.hpp"
#include "radiosity/gauss.hpp"

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

/// How far values at the points of a rule are from the nearest quadratic polynomial (least squares): the largest of the
/// distances. A rule with positive weights is off by at most twice the distance from the best polynomial that it
/// integrates exactly; and unlike the difference of two rules, this does not vanish by chance where the values bend.
class QuadraticResidual {
public:
    static constexpr std::size_t n = 4, points = n * n;
    using Vector = std::array<double, points>;

    QuadraticResidual() {
        // Gram and Schmidt over 1, x, y, x^2, x y, y^2; twice, for rounding.
        const TriangleRule<n>& rule = triangle_rule<n>();
        for (std::size_t j = 0; j < terms; ++j) {
            for (std::size_t k = 0; k < points; ++k) {
                const double y = rule.f[k] * rule.g[k], x = rule.f[k] - y;
                basis_[j][k] = std::array<double, terms>{1, x, y, x * x, x * y, y * y}[j];
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
    static constexpr std::size_t terms = 6;

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

/// What the samples of a cell of unknown structure may have missed, as shares of its area: a strip beside a line or a
/// region between curves, the less likely the smaller the cell, relative to the form factor; and what is narrow because
/// a side is near, by the square of the most that one side can change, up to `missed_most`.
constexpr double missed_at_line = 1e-3, missed_at_curve = 2e-4, missed_beside_side = 1e-6, missed_most = 0.01;
constexpr double small_cell = 1.0 / 16;  ///< Of the receiver's area.

/// A triangle and its share of the integral.
struct Cell {
    Triangle2D triangle;
    std::vector<const CornerLoop*> occluders;
    Integral visible{};
    std::optional<UndecidedSign> event{};
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
        double least_error() const { return std::min(visible.error, hidden.error); }
    };
    template <std::size_t n>
    Parts sample(const Cell& cell, std::array<PointValue, n * n>& values);
    /// With the distances from a quadratic polynomial as errors.
    Parts sampled(const Cell& cell);
    /// By a higher rule; errors from the differences.
    template <std::size_t n>
    Parts refined(const Cell& cell, const Parts& lower);
    double missed(const Cell& cell, double change, const Parts& parts) const;
    void evaluate(Cell& cell);
    void look(Cell cell);

    static bool smaller(const Cell& a, const Cell& b) { return a.visible.error < b.visible.error; }

    const ReceiverIntegrand& integrand_;
    const QuadratureOptions& options_;
    std::vector<Cell> cells_;  ///< A heap, the largest error first.
    double area_ = 0, error_ = 0;
    std::uint64_t evaluations_ = 0, looked_ = 0;
};

template <std::size_t n>
Cubature::Parts Cubature::sample(const Cell& cell, std::array<PointValue, n * n>& values) {
    const TriangleRule<n>& rule = triangle_rule<n>();
    Parts parts;
    for (std::size_t k = 0; k < n * n; ++k) {
        values[k] = integrand_.at_point(rule.point(cell.triangle, k), cell.occluders);
        parts.visible.value += rule.weight[k] * values[k].visible;
        parts.hidden.value += rule.weight[k] * (values[k].unobstructed - values[k].visible);
    }
    evaluations_ += n * n;
    const double all = area(cell.triangle);
    parts.visible.value *= all, parts.hidden.value *= all;
    return parts;
}

Cubature::Parts Cubature::sampled(const Cell& cell) {
    static const QuadraticResidual residual;
    std::array<PointValue, QuadraticResidual::points> values;
    Parts parts = sample<QuadraticResidual::n>(cell, values);
    QuadraticResidual::Vector visible, hidden;
    for (std::size_t k = 0; k < values.size(); ++k)
        visible[k] = values[k].visible, hidden[k] = values[k].unobstructed - values[k].visible;
    const double share = residual_share * area(cell.triangle);
    parts.visible.error = share * residual(visible), parts.hidden.error = share * residual(hidden);
    return parts;
}

template <std::size_t n>
Cubature::Parts Cubature::refined(const Cell& cell, const Parts& lower) {
    std::array<PointValue, n * n> values;
    Parts parts = sample<n>(cell, values);
    // A share of the lower rule's error stays: two rules may agree by chance.
    const auto error = [](const Integral& high, const Integral& low) {
        return std::max(2 * std::abs(high.value - low.value), low.error / 16);
    };
    parts.visible.error = error(parts.visible, lower.visible);
    parts.hidden.error = error(parts.hidden, lower.hidden);
    return parts;
}

double Cubature::missed(const Cell& cell, double change, const Parts& parts) const {
    const double all = area(cell.triangle), unlikely = std::min(1.0, all / (small_cell * area_));
    return (cell.event->linear ? missed_at_line : missed_at_curve) * unlikely *
               (parts.visible.value + parts.hidden.value) +
           std::min(missed_most, missed_beside_side * change * change) * all;
}

void Cubature::evaluate(Cell& cell) {
    Structure structure = integrand_.structure(cell.triangle, cell.occluders);
    cell.event = structure.event;
    cell.occluders = std::move(structure.occluders);
    const double share = options_.tolerance * area(cell.triangle) / area_ / 4;
    Parts parts = sampled(cell);
    // Of one structure, it is smooth: higher rules pay.
    if (!cell.event && parts.least_error() > share) parts = refined<5>(cell, parts);
    if (!cell.event && parts.least_error() > share) parts = refined<7>(cell, parts);
    if (parts.visible.error <= share || parts.visible.error <= parts.hidden.error) {
        cell.visible = parts.visible;
    } else {
        // The hidden part is smooth where the whole is not: beside a side that both polygons share.
        const Integral whole = integrand_.unobstructed(cell.triangle);
        cell.visible = {whole.value - parts.hidden.value, whole.error + parts.hidden.error};
    }
    if (cell.event) cell.visible.error += missed(cell, structure.change, parts);
}

void Cubature::look(Cell cell) {
    if (++looked_ % 16 == 0 && options_.pulse) options_.pulse();
    if (area(cell.triangle) == 0) return;
    evaluate(cell);
    error_ += cell.visible.error;
    cells_.push_back(std::move(cell));
    std::push_heap(cells_.begin(), cells_.end(), smaller);
}

QuadratureResult Cubature::run(const std::vector<Triangle2D>& triangles,
                               const std::vector<const CornerLoop*>& occluders) {
    for (const Triangle2D& triangle : triangles) area_ += area(triangle);
    for (const Triangle2D& triangle : triangles) look({triangle, occluders});
    while (!cells_.empty() && error_ > options_.tolerance && evaluations_ < options_.max_evaluations) {
        std::pop_heap(cells_.begin(), cells_.end(), smaller);
        const Cell cell = std::move(cells_.back());
        cells_.pop_back();
        error_ -= cell.visible.error;
        for (const Triangle2D& part : cut(cell.triangle, cell.event)) look({part, cell.occluders});
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

QuadratureResult integrate_visible(const std::vector<Triangle2D>& triangles,
                                   const std::vector<const CornerLoop*>& occluders, const ReceiverIntegrand& integrand,
                                   const QuadratureOptions& options) {
    return Cubature(integrand, options).run(triangles, occluders);
}

}  // namespace cob::radiosity
