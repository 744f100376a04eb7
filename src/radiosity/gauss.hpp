/// \file
/// Gauss-Legendre rules on [0, 1].
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace cob::radiosity {

template <std::size_t n>
struct GaussRule {
    std::array<double, n> node, weight;
};

/// Nodes by Newton's iteration from Tricomi's estimate; the same bits on every run.
template <std::size_t n>
GaussRule<n> make_gauss_rule() {
    GaussRule<n> rule;
    const double pi = std::acos(-1.0);
    for (std::size_t k = 0; k < n; ++k) {
        double x = std::cos(pi * (static_cast<double>(k) + 0.75) / (static_cast<double>(n) + 0.5)), slope = 1;
        for (int step = 0; step < 60; ++step) {
            double p = 1, previous = 0;  // Legendre polynomials by their recurrence
            for (std::size_t j = 1; j <= n; ++j) {
                const double m = static_cast<double>(j), next = ((2 * m - 1) * x * p - (m - 1) * previous) / m;
                previous = p, p = next;
            }
            slope = static_cast<double>(n) * (x * p - previous) / (x * x - 1);
            const double move = p / slope;
            x -= move;
            if (std::abs(move) < 1e-16) break;
        }
        rule.node[n - 1 - k] = (1 + x) / 2;
        rule.weight[n - 1 - k] = 1 / ((1 - x * x) * slope * slope);
    }
    return rule;
}

template <std::size_t n>
const GaussRule<n>& gauss_rule() {
    static const GaussRule<n> rule = make_gauss_rule<n>();
    return rule;
}

}  // namespace cob::radiosity
