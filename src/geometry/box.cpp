#include "arithmetic/orientation.hpp"
#include "arithmetic/wide_integer.hpp"
#include "geometry/interval_box.hpp"
#include "geometry/prepared_box.hpp"

#include <algorithm>
#include <cfloat>
#include <cmath>

namespace cob {
namespace {

constexpr double unit_roundoff = 0x1p-53;

/// c - o, wrong by at most 4 unit roundoffs of the result's parts.
Vector3<double> relative_to(const ExactPoint& c, const Point& origin) {
    return (c.nearest() - origin) + c.rest();
}

double norm(const Vector3<double>& v) {
    return std::sqrt(dot(v, v));
}

double largest_component(const Vector3<double>& v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

/// v divided by a power of two so that its largest component is in [1/2, 1).
Vector3<double> normalised_exponent(const Vector3<double>& v) {
    int exponent;
    std::frexp(largest_component(v), &exponent);
    return {std::ldexp(v.x, -exponent), std::ldexp(v.y, -exponent), std::ldexp(v.z, -exponent)};
}

/// The coordinate axis along which n is largest.
int largest_axis(const Vector3<double>& n) {
    const double x = std::abs(n.x), y = std::abs(n.y), z = std::abs(n.z);
    return x >= y && x >= z ? 0 : y >= z ? 1 : 2;
}

/// Proves without fractions what SPEC 4 asks of corners and u; false: not proven, which is rare for boxes that
/// are not refused. rough_normal need not be right.
bool proven_valid(const BoxQuestion& question, const Vector3<double>& rough_normal) {
    const auto& c = question.corners.points;
    const int count = question.corners.count;
    if (question.margin < 0 || question.height <= 0) return false;
    if (question.u.nearest() == Point{}) return false;
    if (count == 4 && orientation(c[0], c[1], c[2], c[3]) != Sign::zero) return false;
    // Convex: seen along some axis, every turn is strict and to one side.
    const int axis = largest_axis(rough_normal), first = (axis + 1) % 3, second = (axis + 2) % 3;
    const Sign side = orientation_seen(c[0], c[1], c[2], first, second);
    if (side == Sign::zero) return false;
    for (std::size_t i = 1; i < static_cast<std::size_t>(count) && count == 4; ++i)
        if (orientation_seen(c[i], c[(i + 1) % 4], c[(i + 2) % 4], first, second) != side) return false;
    return orientation_of_direction(c[0], c[1], c[2], question.u) == Sign::zero;
}

}  // namespace

Box::Prepared::Prepared(const BoxQuestion& question_) : question(question_) {
    const Corners& corners = question.corners;
    if (corners.count != 3 && corners.count != 4) exact();
    constexpr double beyond = DBL_MAX;
    bounds = {-beyond, -beyond, -beyond, beyond, beyond, beyond};

    // 1. Corners relative to the origin, which is that of ExactBox, and a normal.
    const Point& near = corners.points[0].nearest();
    if (std::isfinite(near.x) && std::isfinite(near.y) && std::isfinite(near.z)) origin = near;
    std::array<Vector3<double>, 4> c;
    double extent = 0;
    for (int i = 0; i < corners.count; ++i) {
        c[i] = relative_to(corners.points[i], origin);
        extent = std::max(extent, largest_component(c[i]));
    }
    if (!(extent > 0x1p-150 && extent < 0x1p150)) {  // scale to about 1
        int exponent;
        std::frexp(extent, &exponent);
        scale = std::ldexp(1.0, std::clamp(-exponent, -1000, 1000));
        for (Vector3<double>& corner : c) corner = scale * corner;
    }
    const Vector3<double> across =
        corners.count == 3 ? cross(c[1] - c[0], c[2] - c[0]) : cross(c[2] - c[0], c[3] - c[1]);
    if (!proven_valid(question, across)) exact();  // throws where SPEC 4 refuses the box
    aligned = AlignedBox::of(question);
    // Truncated, not rounded: the bounds below leave room for it.
    const double margin = mpq_get_d(question.margin.backend().data());
    const double height = mpq_get_d(question.height.backend().data());
    if (!(extent > 1e-280 && extent < 1e280 && margin < 1e20 && height < 1e20 && height > 1e-20)) return;

    // 2. Unit directions; E: the error of a coordinate relative to the largest one.
    double coordinate_error;
    Vector3<double> u, n;
    if (aligned) {
        u[aligned->axis[0]] = aligned->negative[0] ? -1 : 1;
        n[aligned->axis[2]] = aligned->negative[2] ? -1 : 1;
        base_exact = aligned->base.rest == 0 && scale >= 1;  // scaling down could underflow
        coordinate_error = 4 * unit_roundoff;
    } else {
        // A fraction this small is near no binary64 number, one too large has none.
        const double longest = largest_component(question.u.nearest());
        if (!(longest > 0x1p-900 && std::isfinite(longest))) return;
        const Vector3<double> u_exponent = normalised_exponent(question.u.nearest());
        u = (1 / norm(u_exponent)) * u_exponent;
        const double across_norm = norm(across);
        // Edges of length up to 2 sqrt(3) e, each wrong by 6 u of itself: the cross product by less than 16 u 12 e^2.
        const double edge = extent * scale;
        const double direction_error = 200 * unit_roundoff * edge * edge / across_norm + 8 * unit_roundoff;
        if (!(direction_error < 1e-6)) return;
        n = (1 / across_norm) * across;
        // p - o, the products and their sums: 6 u |p - o|; |p - o| is at most sqrt(3) M (1 + small).
        coordinate_error = 1.8 * (6 * unit_roundoff + 2 * direction_error);
    }
    const Vector3<double> w = cross(n, u);
    directions = {scale * u, scale * w, scale * n};

    // 3. The box in the frame, with its own errors.
    const auto in_frame = [&](const Vector3<double>& v) { return Vector3<double>{dot(u, v), dot(w, v), dot(n, v)}; };
    frame.low = frame.high = in_frame(c[0]);
    double corner_size = 0;
    for (int i = 0; i < corners.count; ++i) {
        const Vector3<double> q = in_frame(c[i]);
        corner_size = std::max(corner_size, largest_component(c[i]));
        for (int axis = 0; axis < 2; ++axis) {
            frame.low[axis] = std::min(frame.low[axis], q[axis]);
            frame.high[axis] = std::max(frame.high[axis], q[axis]);
        }
    }
    const double corner_error = coordinate_error * corner_size;
    double shortest = beyond, box_error = corner_error;
    for (int axis = 0; axis < 2; ++axis) {
        const double length = frame.high[axis] - frame.low[axis];
        frame.low[axis] -= margin * length;
        frame.high[axis] += margin * length;
        shortest = std::min(shortest, frame.high[axis] - frame.low[axis]);
    }
    frame.high.z = frame.low.z + height * shortest;
    put_on_grid();
    size = std::max(largest_component(frame.low), largest_component(frame.high));
    box_error += (2 * margin * corner_error + 8 * unit_roundoff * size);
    box_error += height * (2 * box_error + 8 * unit_roundoff * shortest);
    error = std::max(coordinate_error, box_error / size) * 1.01;
    if (!(error < 1e-6)) return;
    usable = true;

    // 4. Bounds in space, padded by what the coordinates may be wrong.
    const double pad = 8 * error * size / scale;
    for (int axis = 0; axis < 3; ++axis) {
        double least = beyond, greatest = -beyond;
        for (int corner = 0; corner < 8; ++corner) {
            const double offset = (corner & 1 ? frame.high.x : frame.low.x) * u[axis] +
                                  (corner & 2 ? frame.high.y : frame.low.y) * w[axis] +
                                  (corner & 4 ? frame.high.z : frame.low.z) * n[axis];
            least = std::min(least, offset / scale);
            greatest = std::max(greatest, offset / scale);
        }
        bounds[axis] = std::nextafter(origin[axis] + (least - pad), -beyond);
        bounds[axis + 3] = std::nextafter(origin[axis] + (greatest + pad), beyond);
    }
}

/// Where the box is made of short binary64 numbers: the frame as their differences from the origin, exact for a
/// query that finds itself on one of the steps.
void Box::Prepared::put_on_grid() {
    if (!aligned || !aligned->sides || scale != 1) return;
    Vector3<double> start;
    BitSpan bits;
    for (int k = 0; k < 3; ++k) {
        start[k] = aligned->coordinate(origin, k);
        bits.add(start[k]);
        for (const AlignedBox::Pair& side : (*aligned->sides)[static_cast<std::size_t>(k)]) {
            if (side.rest != 0) return;
            bits.add(side.nearest);
        }
    }
    for (int k = 0; k < 3; ++k) {
        const auto& [low, high] = (*aligned->sides)[static_cast<std::size_t>(k)];
        frame.low[k] = low.nearest - start[k];
        frame.high[k] = high.nearest - start[k];
    }
    grid = {std::ldexp(1.0, bits.high - 50), std::ldexp(1.0, bits.low)};
}

const ExactBox& Box::Prepared::exact() const {
    std::call_once(exact_once_, [&] { exact_ = std::make_unique<const ExactBox>(question); });
    return *exact_;
}

const IntegerBox& Box::Prepared::integers() const {
    std::call_once(integers_once_, [&] { integers_ = std::make_unique<const IntegerBox>(exact()); });
    return *integers_;
}

const IntervalBox& Box::Prepared::intervals() const {
    std::call_once(intervals_once_, [&] { intervals_ = std::make_unique<const IntervalBox>(exact()); });
    return *intervals_;
}

Box::Prepared::~Prepared() = default;

Box::Box(const BoxQuestion& question) : prepared_(std::make_unique<Prepared>(question)) {}
Box::~Box() = default;
Box::Box(Box&&) noexcept = default;
Box& Box::operator=(Box&&) noexcept = default;

PolygonId Box::polygon() const {
    return prepared_->question.polygon;
}

const std::array<double, 6>& Box::bounds() const {
    return prepared_->bounds;
}

}  // namespace cob
