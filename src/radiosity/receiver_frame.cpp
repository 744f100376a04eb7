#include "radiosity/receiver_frame.hpp"

#include "radiosity/lambert.hpp"

#include <algorithm>

namespace cob::radiosity {

ReceiverFrame::ReceiverFrame(const ConvexPolygon& receiver, double scale) : origin_(receiver[0]), scale_(scale) {
    for (int axis = 0; axis < 3; ++axis) nearest_origin_[axis] = to_nearest(origin_[axis]);
    offset_ = length(scale * nearest_origin_) > 64;
    // The axes need not be exact, only right-angled to rounding: they choose sample points, not answers.
    const RationalPoint up = area_vector(receiver);
    const Rational size = largest_component(up);
    for (int axis = 0; axis < 3; ++axis) normal_[axis] = to_nearest(Rational(up[axis] / size));
    normal_ = (1 / length(normal_)) * normal_;
    const Vector3<double> side = relative(receiver[1]);
    s_ = side - dot(side, normal_) * normal_;
    s_ = (1 / length(s_)) * s_;
    t_ = cross(normal_, s_);
}

Vector3<double> ReceiverFrame::relative(const RationalPoint& point) const {
    Vector3<double> result;
    for (int axis = 0; axis < 3; ++axis)
        result[axis] = to_nearest(Rational(Rational(scale_) * (point[axis] - origin_[axis])));
    return result;
}

ExactPoint ReceiverFrame::point_at(const Point2D& where) const {
    const Vector3<double> offset = (1 / scale_) * relative_at(where);
    if (!offset_) return ExactPoint(nearest_origin_ + offset);
    return ExactPoint(origin_ + to_rational(offset));
}

}  // namespace cob::radiosity
