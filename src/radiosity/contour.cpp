#include "radiosity/contour.hpp"

#include "radiosity/gauss.hpp"
#include "radiosity/lambert.hpp"

#include <algorithm>
#include <cmath>

namespace cob::radiosity {
namespace {

using Vector = Vector3<double>;
using Corners = std::vector<Vector>;

/// Integral over [0, length] of ln |w + t v|, v of length 1.
double inner_integral(const Vector& w, const Vector& v, double length_v) {
    const double begin = dot(w, v), end = begin + length_v, d = length(cross(w, v));
    const auto primitive = [d](double x) {
        const double square = x * x + d * d;
        if (square == 0) return 0.0;
        return x * (std::log(square) / 2 - 1) + d * std::atan2(x, d);
    };
    return primitive(end) - primitive(begin);
}

/// Outer integral over [begin, end], bisected until two rules agree as well as rounding lets them.
template <class F>
Integral adaptive(const F& f, double begin, double end, int depth) {
    const auto& fine = gauss_rule<12>();
    const auto& coarse = gauss_rule<8>();
    double a = 0, b = 0, size = 0;
    for (std::size_t k = 0; k < 12; ++k) {
        const double value = fine.weight[k] * f(begin + fine.node[k] * (end - begin));
        a += value, size += std::abs(value);
    }
    for (std::size_t k = 0; k < 8; ++k) b += coarse.weight[k] * f(begin + coarse.node[k] * (end - begin));
    a *= end - begin, b *= end - begin, size *= end - begin;
    const double difference = std::abs(a - b);
    if (!(difference > std::max(2e-16, 2e-15 * size)) || depth == 0) return {a, difference};  // also with NaN
    const double middle = (begin + end) / 2;
    const Integral left = adaptive(f, begin, middle, depth - 1), right = adaptive(f, middle, end, depth - 1);
    return {left.value + right.value, left.error + right.error};
}

/// Sides u from p and v from q: (u . v) times the mean of ln r over both.
Integral side_pair(const Vector& p, const Vector& u, const Vector& q, const Vector& v) {
    const double along = dot(u, v), lu = length(u), lv = length(v);
    if (along == 0 || lu == 0 || lv == 0) return {};
    const Vector direction = (1 / lv) * v;
    const auto f = [&](double s) { return inner_integral(q - (p + s * u), direction, lv) / lv; };
    // Where the outer side passes an end of the inner one nearest, the integrand may turn sharply.
    std::vector<double> cuts{0, 1};
    for (const Vector& end : {q, q + v}) {
        const double s = dot(end - p, u) / (lu * lu);
        if (s > 0 && s < 1) cuts.push_back(s);
    }
    std::sort(cuts.begin(), cuts.end());
    Integral sum;
    for (std::size_t k = 1; k < cuts.size(); ++k) {
        const Integral part = adaptive(f, cuts[k - 1], cuts[k], 48);
        sum.value += part.value, sum.error += part.error;
    }
    return {along * sum.value, std::abs(along) * (sum.error + 1e-15)};
}

/// Far apart the sides' logarithms cancel, and the kernel itself is smooth: product rules over triangles.
double by_kernel(const Corners& a, const Corners& b) {
    struct Node {
        Vector position;
        double weight;
    };
    const auto nodes = [](const Corners& corners) {
        const auto& rule = gauss_rule<8>();
        std::vector<Node> result;
        for (std::size_t k = 2; k < corners.size(); ++k) {
            const Vector u = corners[k - 1] - corners[0], v = corners[k] - corners[k - 1];
            const double doubled = length(cross(u, v));
            for (std::size_t i = 0; i < 8; ++i)
                for (std::size_t j = 0; j < 8; ++j) {
                    const double s = rule.node[i], t = rule.node[j];
                    result.push_back({corners[0] + s * u + (s * t) * v, rule.weight[i] * rule.weight[j] * s * doubled});
                }
        }
        return result;
    };
    const auto normal = [](const Corners& corners) {
        Vector sum;
        for (std::size_t k = 2; k < corners.size(); ++k)
            sum = sum + cross(corners[k - 1] - corners[0], corners[k] - corners[0]);
        return (1 / length(sum)) * sum;
    };
    const Vector na = normal(a), nb = normal(b);
    double sum = 0;
    const std::vector<Node> nodes_b = nodes(b);
    for (const Node& x : nodes(a))
        for (const Node& y : nodes_b) {
            const Vector d = y.position - x.position;
            const double square = dot(d, d);
            sum += x.weight * y.weight * std::max(0.0, dot(na, d)) * std::max(0.0, -dot(nb, d)) / (square * square);
        }
    return sum / boost::math::constants::pi<double>();
}

struct Ball {
    Vector centre;
    double radius = 0;
};

Ball ball_around(const Corners& corners) {
    Ball ball;
    for (const Vector& corner : corners)
        ball.centre = ball.centre + (1.0 / static_cast<double>(corners.size())) * corner;
    for (const Vector& corner : corners) ball.radius = std::max(ball.radius, length(corner - ball.centre));
    return ball;
}

}  // namespace

Integral mutual_flux(const Corners& a, const Corners& b) {
    const Ball ball_a = ball_around(a), ball_b = ball_around(b);
    const double distance = length(ball_b.centre - ball_a.centre);
    if (distance > 8 * (ball_a.radius + ball_b.radius)) {
        const double value = by_kernel(a, b);
        return {value, 1e-12 * value};
    }
    // In units of the distance: a constant added to ln r changes nothing but the cancellation.
    const double unit = 1 / (distance > 0 ? distance : ball_a.radius + ball_b.radius);
    Integral sum;
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t j = 0; j < b.size(); ++j) {
            const Integral part = side_pair(unit * a[i], unit * (a[(i + 1) % a.size()] - a[i]), unit * b[j],
                                            unit * (b[(j + 1) % b.size()] - b[j]));
            sum.value += part.value, sum.error += part.error;
        }
    const double scale = 1 / (2 * boost::math::constants::pi<double>() * unit * unit);
    return {std::max(0.0, scale * sum.value), scale * sum.error};
}

}  // namespace cob::radiosity
