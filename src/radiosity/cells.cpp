#include "radiosity/cells.hpp"

#include <algorithm>
#include <cmath>

namespace cob::radiosity {
namespace {

constexpr double most_bent = 0.25;

std::vector<Triangle2D> in_four(const Triangle2D& t) {
    const Point2D p = mix(t[0], t[1], 0.5), q = mix(t[1], t[2], 0.5), r = mix(t[2], t[0], 0.5);
    return {{t[0], p, r}, {p, t[1], q}, {r, q, t[2]}, {p, q, r}};
}

double largest_of(const UndecidedSign& event) {
    double largest = 0;
    for (const double c : event.coefficients) largest = std::max(largest, std::abs(c));
    return largest;
}

std::vector<Triangle2D> along(const UndecidedSign& event, const Triangle2D& t) {
    const std::array<double, 6>& h = event.coefficients;
    const double largest = largest_of(event);
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

/// Where on the side from corner k it vanishes, as shares of the side: nothing, or all zeros.
std::vector<double> zeros_on_side(const UndecidedSign& event, std::size_t k) {
    const double a = event.coefficients[k], b = event.coefficients[k + 3], c = event.coefficients[(k + 1) % 3];
    const double bend = a - 2 * b + c, half = a - b, discriminant = half * half - a * bend;
    std::vector<double> zeros;
    if (!(discriminant > 0)) return zeros;
    // bend f^2 - 2 half f + a = 0
    const double q = half + std::copysign(std::sqrt(discriminant), half);
    for (const double f : {q / bend, a / q})
        if (f > 0 && f < 1) zeros.push_back(f);
    return zeros;
}

/// Along the chord of the conic on which a quadratic determinant vanishes, where that comes in and goes out once and is
/// not bent much between.
std::vector<Triangle2D> along_chord(const UndecidedSign& event, const Triangle2D& t) {
    const double largest = largest_of(event);
    const auto is_zero = [&](std::size_t k) { return std::abs(event.coefficients[k]) <= 1e-9 * largest; };
    std::array<std::optional<double>, 3> crossing;
    int crossings = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        std::vector<double> zeros = zeros_on_side(event, k);
        const auto at_corner = [](double f) { return f < 1e-6 || f > 1 - 1e-6; };
        zeros.erase(std::remove_if(zeros.begin(), zeros.end(), at_corner), zeros.end());
        if (zeros.size() > 1) return in_four(t);
        if (!zeros.empty()) crossing[k] = zeros[0], ++crossings;
    }
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t a = k, b = (k + 1) % 3, c = (k + 2) % 3;
        if (crossings == 1 && is_zero(a) && !is_zero(b) && !is_zero(c) && crossing[b]) {
            const Point2D m = mix(t[b], t[c], *crossing[b]);
            return {{t[a], t[b], m}, {t[a], m, t[c]}};
        }
        if (crossings == 2 && crossing[a] && crossing[c]) {
            const double f = *crossing[a], g = 1 - *crossing[c];  // from corner a
            // At the chord's middle, by barycentric coordinates.
            const double y = f / 2, z = g / 2, x = 1 - y - z;
            const std::array<double, 6>& h = event.coefficients;
            const double middle = h[a] * x * x + h[b] * y * y + h[c] * z * z +
                                  2 * (h[a + 3] * x * y + h[b + 3] * y * z + h[c + 3] * z * x);
            if (!(std::abs(middle) <= most_bent * largest)) return in_four(t);
            const Point2D p = mix(t[a], t[b], f), q = mix(t[a], t[c], g);
            return {{t[a], p, q}, {p, t[b], t[c]}, {p, t[c], q}};
        }
    }
    return in_four(t);
}

}  // namespace

Polygon2D left_around(const Triangle2D& t) {
    return turn(t) < 0 ? Polygon2D{t[0], t[2], t[1]} : Polygon2D{t[0], t[1], t[2]};
}

std::vector<Vector3<double>> in_space(const Polygon2D& polygon) {
    std::vector<Vector3<double>> corners;
    for (const Point2D& p : polygon) corners.push_back({p.s, p.t, 0});
    return corners;
}

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

double distance(const Point2D& a, const Point2D& b) {
    return std::hypot(a.s - b.s, a.t - b.t);
}

Point2D nearest_in(const Triangle2D& t, const Point2D& p) {
    Point2D best = t[0];
    bool inside = true;
    for (std::size_t k = 0; k < 3; ++k) {
        const Point2D &a = t[k], &b = t[(k + 1) % 3], &c = t[(k + 2) % 3];
        inside = inside && turn({a, b, p}) * turn({a, b, c}) >= 0;
        const double squared = (b.s - a.s) * (b.s - a.s) + (b.t - a.t) * (b.t - a.t);
        const double along = (b.s - a.s) * (p.s - a.s) + (b.t - a.t) * (p.t - a.t);
        const Point2D on = mix(a, b, squared > 0 ? std::clamp(along / squared, 0.0, 1.0) : 0);
        if (distance(on, p) < distance(best, p)) best = on;
    }
    return inside ? p : best;
}

Vector3<double> nearest_on_side(const Vector3<double>& a, const Vector3<double>& b, const Vector3<double>& p) {
    const Vector3<double> d = b - a;
    const double squared = dot(d, d);
    return squared > 0 ? a + std::clamp(dot(p - a, d) / squared, 0.0, 1.0) * d : a;
}

std::vector<Triangle2D> cut(const Triangle2D& t, const std::optional<UndecidedSign>& event) {
    return !event ? in_four(t) : event->linear ? along(*event, t) : along_chord(*event, t);
}

double misfit_of_cut(const Triangle2D& t) {
    double size = 0;
    for (std::size_t k = 0; k < 3; ++k)
        size = std::max({size, std::abs(t[k].s - t[(k + 1) % 3].s), std::abs(t[k].t - t[(k + 1) % 3].t)});
    return 16 * 0x1p-52 * size * (size + std::abs(t[0].s) + std::abs(t[0].t));
}

}  // namespace cob::radiosity
