#include "radiosity/certified_contour.hpp"

#include "radiosity/taylor.hpp"

#include <algorithm>
#include <cmath>

namespace cob::radiosity {
namespace {

constexpr int order = 12;
constexpr double finest = 1e-13;          ///< Width of a panel's integral over its length, at least.
constexpr std::size_t most_panels = 400;  ///< Of one pair of sides.

using Series = Taylor<1, order>;

/// The inner integral along one side, of ln r, as a function of the place s on the other; letters as in contour.cpp:
/// x the places of the side's ends along it, from the foot of the perpendicular, D that one's squared length.
class InnerIntegral {
public:
    InnerIntegral(const IntervalPoint& p, const IntervalPoint& u, const IntervalPoint& q, const IntervalPoint& v)
        : length_(sqrt(square(v.x) + square(v.y) + square(v.z))),
          direction_((Interval(1) / length_) * v),
          offset_(q - p),
          u_(u) {}

    const Interval& length() const { return length_; }

    /// The integral over [from, to] by the series around its middle.
    Interval over(double from, double to) const {
        const Interval width = Interval(to) - Interval(from);
        // Sides of one line: their distance is nothing but rounding, and so is what it adds.
        const Places at = places(Series(Interval(from, to)));
        const Interval d = sqrt(at.squared.at(0));
        const bool one_line = d.high() < finest / 16;
        const Series middle = series(Interval(0.5) * (Interval(from) + Interval(to)), width, one_line);
        const Series all = series(Interval(from, to), width, one_line);
        Interval sum = 0;
        if (one_line) {
            // d times an angle, and x / 2 times ln(1 + D / x^2).
            const auto more = [&](const Interval& x) {
                return Interval(0.5 * x.magnitude()) * (at.squared.at(0) / square(x));
            };
            sum = Interval(-1, 1) * (Interval(d.high() * 3.15) + more(at.begin.at(0)) + more(at.end.at(0)));
        }
        double half_power = 1;
        for (int k = 0; k <= order; k += 2, half_power /= 4)  // of tau^k over [-1/2, 1/2]; odd powers vanish
            sum += (k < order ? middle : all).at(k) * (Interval(half_power) / Interval(k + 1));
        return sum * width;
    }

    /// The same from bounds of the integrand alone: r |ln r| is bounded where ln r is not.
    Interval bounds_over(double from, double to) const {
        const Places at = places(Series(Interval(from, to)));
        const Interval d = sqrt(at.squared.at(0));
        const auto term = [&](const Interval& x) {
            const double r = sqrt(square(x) + square(d)).high();
            return r < 1 ? r * (1 - std::log(r > 0 ? r : 1)) * (1 + 1e-12) : r * (1 + std::log(r)) * (1 + 1e-12);
        };
        const double most = term(at.begin.at(0)) + term(at.end.at(0)) + d.high() * 3.15;
        return Interval(-most, most) * (Interval(to) - Interval(from));
    }

private:
    struct Places {
        Series begin, end, squared;
    };
    Places places(const Series& s) const {
        const Vector3<Series> w{Series(offset_.x) - s * Series(u_.x), Series(offset_.y) - s * Series(u_.y),
                                Series(offset_.z) - s * Series(u_.z)};
        const Vector3<Series> along{Series(direction_.x), Series(direction_.y), Series(direction_.z)};
        const Series begin = dot(w, along);
        const Vector3<Series> across = cross(w, along);
        Series squared = dot(across, across);
        squared.set(0, 0, Interval(std::max(0.0, squared.at(0).low()), squared.at(0).high()));
        return {begin, begin + Series(length_), squared};
    }

    Series series(const Interval& base, const Interval& width, bool one_line) const {
        Series s(base);
        s.set(1, 0, width);
        const Places at = places(s);
        const auto term = [&](const Series& x) {
            return x * (log(one_line ? x * x : x * x + at.squared) * Series(0.5) - Series(1.0));
        };
        const Series sum = term(at.end) - term(at.begin);
        if (one_line) return sum;
        const Series distance = sqrt(at.squared);
        return sum + distance * atan2(distance * Series(length_), at.squared + at.begin * at.end);
    }

    Interval length_;
    IntervalPoint direction_, offset_, u_;
};

/// The best of both enclosures.
Interval enclose(const InnerIntegral& inner, double from, double to) {
    const Interval panel = inner.over(from, to), bounds = inner.bounds_over(from, to);
    return panel.is_bounded() && panel.width() <= bounds.width() ? panel : bounds;
}

/// Over [0, 1]: the widest panel is bisected until all are narrow or there are too many.
Interval integrate(const InnerIntegral& inner, double wanted) {
    struct Panel {
        double from, to;
        Interval integral;
    };
    const auto excess = [wanted](const Panel& p) { return p.integral.width() - wanted * (p.to - p.from); };
    const auto narrower = [&](const Panel& p, const Panel& q) { return excess(p) < excess(q); };
    std::vector<Panel> panels{{0, 1, enclose(inner, 0, 1)}};
    while (panels.size() < most_panels && excess(panels.front()) > 0) {
        std::pop_heap(panels.begin(), panels.end(), narrower);
        const Panel panel = panels.back();
        panels.pop_back();
        const double middle = panel.from + (panel.to - panel.from) / 2;
        for (const auto& [from, to] : {std::pair{panel.from, middle}, std::pair{middle, panel.to}}) {
            panels.push_back({from, to, enclose(inner, from, to)});
            std::push_heap(panels.begin(), panels.end(), narrower);
        }
    }
    Interval sum = 0;
    for (const Panel& panel : panels) sum += panel.integral;
    return sum;
}

}  // namespace

Interval certified_mutual_flux(const std::vector<IntervalPoint>& a, const std::vector<IntervalPoint>& b, double width) {
    const double share = 6 * width / static_cast<double>(a.size() * b.size());
    Interval sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t j = 0; j < b.size(); ++j) {
            const IntervalPoint u = a[(i + 1) % a.size()] - a[i], v = b[(j + 1) % b.size()] - b[j];
            const Interval along = dot(u, v);
            if (along.low() == 0 && along.high() == 0) continue;
            const InnerIntegral inner(a[i], u, b[j], v);
            // What is almost perpendicular weighs nothing but may not be bisected for it.
            const Interval mean =
                along.magnitude() < 1e-14
                    ? inner.bounds_over(0, 1)
                    : integrate(inner, std::max(finest, share / along.magnitude() * inner.length().low()));
            sum += along / inner.length() * mean;
        }
    const Interval flux = sum / (Interval(2) * pi_interval());
    return {std::max(0.0, flux.low()), std::max(0.0, flux.high())};
}

}  // namespace cob::radiosity
