#include "geometry/exact_box.hpp"

#include "cob/error.hpp"

#include <algorithm>
#include <climits>
#include <cmath>

namespace cob {
namespace {

/// The point times the denominator, a multiple of those of its parts.
Vector3<Integer> times(const Integer& denominator_, const RationalPoint& v) {
    Vector3<Integer> result;
    for (int axis = 0; axis < 3; ++axis) {
        const Integer factor = denominator_ / denominator(v[axis]);
        result[axis] = numerator(v[axis]) * factor;
    }
    return result;
}

Integer common_denominator(const RationalPoint& v) {
    return lcm(lcm(denominator(v.x), denominator(v.y)), denominator(v.z));
}

Vector3<Integer> primitive(Vector3<Integer> v) {
    const Integer common = gcd(gcd(v.x, v.y), v.z);
    if (common > 1)
        for (int axis = 0; axis < 3; ++axis) v[axis] /= common;
    return v;
}

Rational dot(const Vector3<Integer>& a, const RationalPoint& b) {
    return Rational(a.x) * b.x + Rational(a.y) * b.y + Rational(a.z) * b.z;
}

std::optional<Rational> exact_root(const Rational& square) {
    Integer rest;
    const Integer p = sqrt(numerator(square), rest);
    if (rest != 0) return std::nullopt;
    const Integer q = sqrt(denominator(square), rest);
    if (rest != 0) return std::nullopt;
    return Rational(p, q);
}

InputError refused(const std::string& problem, const std::string& remedy) {
    InputError::Where where;
    where.remedy = remedy;
    return InputError(problem, where);
}

/// Along the element's area vector; checks that the corners are coplanar and convex.
Vector3<Integer> checked_normal(const std::array<Vector3<Integer>, 4>& c, int count) {
    if (count == 3) return cross(c[1] - c[0], c[2] - c[0]);
    const Vector3<Integer> normal = cross(c[2] - c[0], c[3] - c[1]);
    if (cob::dot(normal, c[1] - c[0]) != 0)
        throw refused("the corners of a box's element are not in one plane", "give coplanar corners or a triangle");
    for (int i = 0; i < count; ++i) {
        const Vector3<Integer> here = c[(i + 1) % count] - c[i], next = c[(i + 2) % count] - c[(i + 1) % count];
        const Integer turn = cob::dot(normal, cross(here, next));
        if (turn < 0 || (turn == 0 && cob::dot(here, next) < 0))
            throw refused("the corners of a box's element are not convex", "give convex corners in order");
    }
    return normal;
}

}  // namespace

ExactBox::ExactBox(const BoxQuestion& question) {
    const int count = question.corners.count;
    if (count != 3 && count != 4)
        throw refused("a box's element has " + std::to_string(count) + " corners", "give three or four");
    if (question.margin < 0)
        throw refused("the margin " + to_text(question.margin) + " is negative", "give a margin of at least 0");
    if (question.height <= 0)
        throw refused("the height " + to_text(question.height) + " is not positive", "give a height above 0");

    // The corners relative to the origin, over one denominator: what follows is done in integers, as fractions
    // would spend their time on common divisors.
    const Point& near = question.corners.points[0].nearest();
    if (std::isfinite(near.x) && std::isfinite(near.y) && std::isfinite(near.z)) origin = near;
    std::array<RationalPoint, 4> relative;
    Integer unit = 1;  // parts of 1
    for (int i = 0; i < count; ++i) {
        relative[i] = question.corners.points[i].rational() - to_rational(origin);
        unit = lcm(unit, common_denominator(relative[i]));
    }
    std::array<Vector3<Integer>, 4> corners;
    for (int i = 0; i < count; ++i) corners[i] = times(unit, relative[i]);

    // The directions.
    const Vector3<Integer> normal = checked_normal(corners, count), zero{};
    const RationalPoint u = question.u.rational();
    if (normal == zero) throw refused("a box's element has no area", "leave it out");
    if (u == RationalPoint{}) throw refused("the base-edge direction u of a box is zero", "give a side's direction");
    directions[0] = primitive(times(common_denominator(u), u));
    directions[2] = primitive(normal);
    if (cob::dot(directions[2], directions[0]) != 0)
        throw refused("the base-edge direction u of a box is not exactly perpendicular to its element's normal",
                      "give the exact difference of two of the corners");
    directions[1] = primitive(cross(directions[2], directions[0]));

    // Extents, each widened on both sides by the margin.
    FrameBox<Rational> element;
    for (int axis = 0; axis < 3; ++axis) {
        Integer low = cob::dot(directions[axis], corners[0]), high = low;
        for (int i = 1; i < count && axis < 2; ++i) {
            const Integer at = cob::dot(directions[axis], corners[i]);
            low = std::min(low, at);
            high = std::max(high, at);
        }
        element.low[axis] = Rational(low, unit);
        element.high[axis] = Rational(high, unit);
    }
    frame = element;
    for (int axis = 0; axis < 2; ++axis) {
        const Rational widening = question.margin * (element.high[axis] - element.low[axis]);
        frame.low[axis] -= widening;
        frame.high[axis] += widening;
    }

    // The height: a length along u is (extent of a) / |u|, one along n is (extent of z) / |n|.
    const auto squared = [](const Vector3<Integer>& v) { return Rational(cob::dot(v, v)); };
    const auto squared_length = [&](int axis) {
        const Rational extent = frame.high[axis] - frame.low[axis];
        return Rational(extent * extent / squared(directions[axis]));
    };
    height_squared =
        question.height * question.height * std::min(squared_length(0), squared_length(1)) * squared(directions[2]);
    height = exact_root(height_squared);
    frame.high.z = height ? Rational(frame.low.z + *height) : frame.low.z;
}

Vector3<Rational> ExactBox::to_frame(const RationalPoint& p) const {
    const RationalPoint relative = p - to_rational(origin);
    return {dot(directions[0], relative), dot(directions[1], relative), dot(directions[2], relative)};
}

namespace {

int bit_length(const Integer& value) {
    return value == 0 ? 0 : static_cast<int>(msb(Integer(abs(value)))) + 1;
}

/// value = mantissa / odd * 2^exponent.
struct Dyadic {
    Integer mantissa, odd;
    int exponent = 0;

    explicit Dyadic(const Rational& value) : mantissa(numerator(value)), odd(denominator(value)) {
        const auto twos = static_cast<int>(lsb(odd));
        odd >>= static_cast<unsigned>(twos);
        exponent = -twos;
        if (mantissa == 0) return;
        const auto zeros = static_cast<int>(lsb(Integer(abs(mantissa))));
        mantissa >>= static_cast<unsigned>(zeros);
        exponent += zeros;
    }
    bool is_zero() const { return mantissa == 0; }
};

}  // namespace

IntegerBox::IntegerBox(const ExactBox& box) {
    constexpr int root_bits = 160;  // enough to tell the top from what lies an ulp beside it
    unit = INT_MAX / 4;
    for (int axis = 0; axis < 3; ++axis) {
        const Dyadic a(box.frame.low[axis]), b(box.frame.high[axis]);
        const Integer denominator_ = lcm(a.odd, b.odd);
        exponent[axis] = a.is_zero() && b.is_zero() ? 0
                         : a.is_zero()              ? b.exponent
                         : b.is_zero()              ? a.exponent
                                                    : std::min(a.exponent, b.exponent);
        const auto scaled = [&](const Dyadic& d) {
            return d.is_zero() ? Integer(0)
                               : Integer((d.mantissa * (denominator_ / d.odd))
                                         << static_cast<unsigned>(d.exponent - exponent[axis]));
        };
        low[axis] = scaled(a);
        high[axis] = scaled(b);
        limit_exponent[axis] = exponent[axis] + std::max(bit_length(low[axis]), bit_length(high[axis]));
        if (!a.is_zero() || !b.is_zero()) unit = std::min(unit, exponent[axis]);

        for (int component = 0; component < 3; ++component) {
            directions[axis][component] = box.directions[axis][component] * denominator_;
            direction_bits[axis] = std::max(direction_bits[axis], bit_length(directions[axis][component]));
        }
        if (axis == 2 && !box.height) {
            // floor(sqrt(square 4^f)) with f such that the root has root_bits bits.
            const Rational square = box.height_squared * Rational(denominator_) * Rational(denominator_);
            const int size = bit_length(numerator(square)) - bit_length(denominator(square));
            const int f = root_bits - size / 2;
            Integer p = numerator(square), q = denominator(square);
            if (f >= 0)
                p <<= static_cast<unsigned>(2 * f);
            else
                q <<= static_cast<unsigned>(-2 * f);
            rise = sqrt(Integer(p / q));
            rise_exponent = -f;
            unit = std::min(unit, rise_exponent);
            limit_exponent[2] = std::max(limit_exponent[2], rise_exponent + bit_length(rise) + 1) + 1;
        }
    }
}

}  // namespace cob
