#include "radiosity/contour.hpp"

#include "radiosity/gauss.hpp"
#include "radiosity/lambert.hpp"

#include <algorithm>
#include <cmath>

namespace cob::radiosity {
namespace {

using Vector = Vector3<double>;
using Corners = std::vector<Vector>;

/// A sum and the sum of its terms' magnitudes: what it is off by is some roundings of that.
struct Sum {
    double value = 0, size = 0;
};

/// Integral over [0, length] of ln |w + t v|, v of length 1.
Sum inner_integral(const Vector& w, const Vector& v, double length_v) {
    const double begin = dot(w, v), end = begin + length_v, d = length(cross(w, v));
    Sum sum;
    const auto add_primitive = [&](double x, double sign) {
        const double square = x * x + d * d;
        if (square == 0) return;
        const double one = x * (std::log(square) / 2 - 1), other = d * std::atan2(x, d);
        sum.value += sign * (one + other), sum.size += std::abs(one) + std::abs(other);
    };
    add_primitive(end, 1), add_primitive(begin, -1);
    return sum;
}

/// Outer integral over [begin, end], bisected until two rules agree within the error that may be, or as well as
/// rounding lets them. That much counts as error even where they agree better: they may by chance.
template <class F>
Integral adaptive(const F& f, double begin, double end, double may_be_off, int depth) {
    const auto& fine = gauss_rule<12>();
    const auto& coarse = gauss_rule<8>();
    double a = 0, b = 0, size = 0;
    for (std::size_t k = 0; k < 12; ++k) {
        const Sum sum = f(begin + fine.node[k] * (end - begin));
        a += fine.weight[k] * sum.value, size += fine.weight[k] * sum.size;
    }
    for (std::size_t k = 0; k < 8; ++k) b += coarse.weight[k] * f(begin + coarse.node[k] * (end - begin)).value;
    a *= end - begin, b *= end - begin, size *= end - begin;
    const double difference = std::abs(a - b);
    const bool agree = !(difference > std::max({2e-16, 2e-15 * size, may_be_off}));  // also with NaN
    if (agree || depth == 0) return {a, difference + may_be_off + 0x1p-52 * size};
    const double middle = (begin + end) / 2;
    Integral sum = adaptive(f, begin, middle, may_be_off / 2, depth - 1);
    sum += adaptive(f, middle, end, may_be_off / 2, depth - 1);
    return sum;
}

/// Sides u from p and v from q: (u . v) times the mean of ln r over both.
Integral side_pair(const Vector& p, const Vector& u, const Vector& q, const Vector& v, double may_be_off) {
    const double along = dot(u, v), lu = length(u), lv = length(v);
    if (along == 0 || lu == 0 || lv == 0) return {};
    const Vector direction = (1 / lv) * v;
    const auto f = [&](double s) {
        const Sum sum = inner_integral(q - (p + s * u), direction, lv);
        return Sum{sum.value / lv, sum.size / lv};
    };
    // Where the outer side passes an end of the inner one nearest, the integrand may turn sharply.
    std::vector<double> cuts{0, 1};
    for (const Vector& end : {q, q + v}) {
        const double s = dot(end - p, u) / (lu * lu);
        if (s > 0 && s < 1) cuts.push_back(s);
    }
    std::sort(cuts.begin(), cuts.end());
    Integral sum;
    for (std::size_t k = 1; k < cuts.size(); ++k)
        sum += adaptive(f, cuts[k - 1], cuts[k], may_be_off / std::abs(along), 48);
    return {along * sum.value, std::abs(along) * (sum.error + 1e-15)};
}

/// Contour integrals of ln r along a and along the side from p to q. Lengths are counted in the unit: a constant added
/// to ln r changes nothing but the cancellation.
Integral flux_of_side(const Corners& a, const Vector& p, const Vector& q, double unit, double may_be_off) {
    const double scale = unit * unit / (2 * boost::math::constants::pi<double>());
    const double share = may_be_off / scale / static_cast<double>(a.size());
    Integral sum;
    for (std::size_t i = 0; i < a.size(); ++i)
        sum += side_pair(1 / unit * a[i], 1 / unit * (a[(i + 1) % a.size()] - a[i]), 1 / unit * p, 1 / unit * (q - p),
                         share);
    return {scale * sum.value, scale * sum.error};
}

/// Far apart the sides' logarithms cancel, and the kernel itself is smooth: product rules over triangles.
double by_kernel(const Corners& a, const Corners& b) {
    struct Node {
        Vector position;
        double weight;
    };
    const auto length_of = [](const Vector& v) { return std::hypot(v.x, v.y, v.z); };  // of areas: squares underflow
    const auto nodes = [&](const Corners& corners) {
        const auto& rule = gauss_rule<8>();
        std::vector<Node> result;
        for (std::size_t k = 2; k < corners.size(); ++k) {
            const Vector u = corners[k - 1] - corners[0], v = corners[k] - corners[k - 1];
            const double doubled = length_of(cross(u, v));
            for (std::size_t i = 0; i < 8; ++i)
                for (std::size_t j = 0; j < 8; ++j) {
                    const double s = rule.node[i], t = rule.node[j];
                    result.push_back({corners[0] + s * u + (s * t) * v, rule.weight[i] * rule.weight[j] * s * doubled});
                }
        }
        return result;
    };
    const auto normal = [&](const Corners& corners) {
        Vector sum;
        for (std::size_t k = 2; k < corners.size(); ++k)
            sum = sum + cross(corners[k - 1] - corners[0], corners[k] - corners[0]);
        return (1 / length_of(sum)) * sum;
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

Integral mutual_flux(const Corners& a, const Corners& b, double may_be_off) {
    const Ball ball_a = ball_around(a), ball_b = ball_around(b);
    const double distance = length(ball_b.centre - ball_a.centre);
    if (distance > 8 * (ball_a.radius + ball_b.radius)) {
        const double value = by_kernel(a, b);
        return {value, 1e-12 * value};
    }
    const double unit = distance > 0 ? distance : ball_a.radius + ball_b.radius;
    Integral sum;
    for (std::size_t j = 0; j < b.size(); ++j)
        sum += flux_of_side(a, b[j], b[(j + 1) % b.size()], unit, may_be_off / static_cast<double>(b.size()));
    return {std::max(0.0, sum.value), sum.error};
}

Integral mutual_flux_of_side(const Corners& a, const Vector& p, const Vector& q, double may_be_off) {
    return flux_of_side(a, p, q, ball_around(a).radius, may_be_off);
}

}  // namespace cob::radiosity
