/// \file
/// Gauss's product rules on triangles, and how far values at their points are from polynomials.
#pragma once

#include "radiosity/cells.hpp"
#include "radiosity/gauss.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace cob::radiosity {

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

}  // namespace cob::radiosity
