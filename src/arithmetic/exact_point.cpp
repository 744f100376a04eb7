#include "cob/arithmetic.hpp"

#include <cmath>

namespace cob {

RationalPoint to_rational(const Point& point) {
    return {Rational(point.x), Rational(point.y), Rational(point.z)};
}

ExactPoint::ExactPoint(const RationalPoint& point) {
    bool pair = true;
    for (int axis = 0; axis < 3; ++axis) {
        nearest_[axis] = to_nearest(point[axis]);
        if (!std::isfinite(nearest_[axis])) {
            pair = false;
            continue;
        }
        const Rational rest = point[axis] - Rational(nearest_[axis]);
        rest_[axis] = to_nearest(rest);
        pair = pair && Rational(rest_[axis]) == rest;
    }
    if (!pair) fraction_ = std::make_shared<const RationalPoint>(point);
}

RationalPoint ExactPoint::rational() const {
    if (fraction_) return *fraction_;
    return to_rational(nearest_) + to_rational(rest_);
}

bool operator==(const ExactPoint& a, const ExactPoint& b) {
    // The pair is unique: nearest() is rounded to nearest, and rest() is what remains.
    if (a.has_fraction() || b.has_fraction()) return a.rational() == b.rational();
    return a.nearest_ == b.nearest_ && a.rest_ == b.rest_;
}

}  // namespace cob
