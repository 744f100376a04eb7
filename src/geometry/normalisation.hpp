/// \file
/// The map of a scene into [-1, 1], where binary32 is near enough to reject with, and segments in it.
#pragma once

#include "geometry/bounds.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace cob {

/// p -> (p - centre) scale, a power of two.
class Normalisation {
public:
    /// Segments are cut to this cube of the moved and scaled scene, which itself lies in [-1, 1].
    static constexpr double reach = 4;

    explicit Normalisation(const Bounds& all) {
        double extent = 0, greatest = 0;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            centre_[static_cast<int>(axis)] = all.middle(axis);
            extent = std::max(extent, all.high[axis] / 2 - all.low[axis] / 2);
            greatest = std::max({greatest, std::abs(all.high[axis]), std::abs(all.low[axis])});
        }
        // Scenes smaller than 2^-1000 stay small: nothing is certain there, and everything a candidate.
        scale_ = std::ldexp(1.0, -std::max(-1000, std::ilogb(extent) + 1));
        error_ = 16 * 0x1p-53 * (greatest * scale_ + reach);
    }
    Point operator()(const Point& p) const {
        return {(p.x - centre_.x) * scale_, (p.y - centre_.y) * scale_, (p.z - centre_.z) * scale_};
    }
    /// How far a mapped point is off in each coordinate, at most, within `reach`: p may be off by half an ulp, and the
    /// difference is rounded.
    double error() const { return error_; }
    /// The same of every point that normalised() gives.
    double greatest_error() const { return error_ + cutting; }
    /// What cutting a segment adds, see normalised().
    static constexpr double cutting = 0x1p-27;

private:
    Point centre_;
    double scale_ = 1;
    double error_ = 0;
};

/// A segment in a normalised scene: all of it that lies within reach.
struct NormalSegment {
    enum class Kind : std::uint8_t {
        within,   ///< The rest holds.
        outside,  ///< No part of it is within reach.
        far_off   ///< Nothing is known: an end is too far off, or known too roughly, to be cut in binary64.
    };
    Kind kind = Kind::within;
    Point from, to;
    double error = 0;  ///< How far either end is off in each coordinate, at most, and the line between them.
};

/// Of a segment whose exact ends lie within half an ulp of these points.
inline NormalSegment normalised(const Normalisation& normalise, const Point& from, const Point& to) {
    constexpr double reach = Normalisation::reach;
    // An end this far off is itself wrong by 2^-31 more than error() says; a parameter of a cut by 4 roundings, which
    // move the end by 2^-30; and so does the end's sum. Together less than
    // `cutting`.
    constexpr double farthest = 0x1p20;
    const auto within = [](const Point& p, double limit) {  // false for NaN
        return std::abs(p.x) <= limit && std::abs(p.y) <= limit && std::abs(p.z) <= limit;
    };
    NormalSegment result{NormalSegment::Kind::within, normalise(from), normalise(to), normalise.error()};
    const Point x = result.from, y = result.to;
    if (within(x, reach) && within(y, reach)) return result;
    // Where half an ulp of an end is as large as the scene, an end outside may be inside.
    if (!within(x, farthest) || !within(y, farthest) || !(normalise.error() < 1)) {
        result.kind = NormalSegment::Kind::far_off;
        return result;
    }
    double first = 0, last = 1;
    for (int axis = 0; axis < 3; ++axis) {
        const double d = y[axis] - x[axis];
        if (d == 0) {
            if (std::abs(x[axis]) > reach) result.kind = NormalSegment::Kind::outside;
            continue;
        }
        const double a = (-reach - x[axis]) / d, b = (reach - x[axis]) / d;
        first = std::max(first, std::min(a, b));
        last = std::min(last, std::max(a, b));
    }
    if (!(first < last)) result.kind = NormalSegment::Kind::outside;
    const Point d = y - x;
    result.from = x + first * d;
    result.to = x + last * d;
    result.error = normalise.greatest_error();
    return result;
}

}  // namespace cob
