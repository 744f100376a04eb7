#include "radiosity/cells.hpp"

#include <algorithm>
#include <cmath>

namespace cob::radiosity {
namespace {

std::vector<Triangle2D> in_four(const Triangle2D& t) {
    const Point2D p = mix(t[0], t[1], 0.5), q = mix(t[1], t[2], 0.5), r = mix(t[2], t[0], 0.5);
    return {{t[0], p, r}, {p, t[1], q}, {r, q, t[2]}, {p, q, r}};
}

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

}  // namespace

double turn(const Triangle2D& t) {
    return (t[1].s - t[0].s) * (t[2].t - t[0].t) - (t[2].s - t[0].s) * (t[1].t - t[0].t);
}

double area(const Triangle2D& t) {
    return std::abs(turn(t)) / 2 * (1 + 0x1p-48);
}

Point2D mix(const Point2D& a, const Point2D& b, double f) {
    return {a.s + f * (b.s - a.s), a.t + f * (b.t - a.t)};
}

Point2D centroid(const Triangle2D& t) {
    return {(t[0].s + t[1].s + t[2].s) / 3, (t[0].t + t[1].t + t[2].t) / 3};
}

double reach(const Triangle2D& t) {
    const Point2D middle = centroid(t);
    double result = 0;
    for (const Point2D& corner : t) result = std::max(result, std::hypot(corner.s - middle.s, corner.t - middle.t));
    return result * (1 + 1e-9);
}

std::vector<Triangle2D> cut(const Triangle2D& t, const std::optional<UndecidedSign>& event) {
    return event && event->linear ? along(*event, t) : in_four(t);
}

double misfit_of_cut(const Triangle2D& t) {
    double size = 0;
    for (std::size_t k = 0; k < 3; ++k)
        size = std::max({size, std::abs(t[k].s - t[(k + 1) % 3].s), std::abs(t[k].t - t[(k + 1) % 3].t)});
    return 16 * 0x1p-52 * size * (size + std::abs(t[0].s) + std::abs(t[0].t));
}

}  // namespace cob::radiosity
