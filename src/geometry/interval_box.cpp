#include "geometry/interval_box.hpp"

#include <algorithm>
#include <cmath>

namespace cob {
namespace {

Interval enclosure(const Rational& value) {
    const double nearest = to_nearest(value);
    if (std::isfinite(nearest) && Rational(nearest) == value) return nearest;
    return {std::nextafter(nearest, -INFINITY), std::nextafter(nearest, INFINITY)};
}

}  // namespace

IntervalBox::IntervalBox(const ExactBox& box) : origin(box.origin) {
    for (int k = 0; k < 3; ++k) {
        const auto axis = static_cast<std::size_t>(k);
        Integer largest = 1;
        for (int c = 0; c < 3; ++c) largest = std::max(largest, Integer(abs(box.directions[axis][c])));
        const Rational scale(Integer(1), Integer(1) << static_cast<unsigned>(msb(largest)));
        for (int c = 0; c < 3; ++c) directions[axis][c] = enclosure(Rational(box.directions[axis][c]) * scale);
        frame.low[k] = enclosure(box.frame.low[k] * scale);
        frame.high[k] = enclosure(box.frame.high[k] * scale);
        if (k == 2 && !box.height) {
            const Interval square = enclosure(box.height_squared * scale * scale);
            const Interval rise(std::nextafter(std::sqrt(square.low()), 0),
                                std::nextafter(std::sqrt(square.high()), INFINITY));
            frame.high.z = frame.low.z + rise;
        }
    }
}

}  // namespace cob
