#include "geometry/difference_signs.hpp"

#include "arithmetic/wide_integer.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <optional>
#include <type_traits>

namespace cob {
namespace {

constexpr int next(int axis) {
    return axis == 2 ? 0 : axis + 1;
}

// ------------------------------------------------------------------------------------------------------ filter

/// A coordinate of a difference in binary64. The true one is off by at most `rest`, and by one rounding.
struct Approximate {
    double value, rest;
};

Approximate approximate(const Difference& difference, int axis) {
    Approximate result{difference.to.nearest()[axis] - difference.from.nearest()[axis], 0};
    for (const PointReference* end : {&difference.from, &difference.to})
        if (const ExactPoint* exact = end->inexact()) {
            // A fraction's rest is rounded itself; twice its size contains it and its own rounding, and where it
            // underflowed it is below the least positive number.
            result.rest += 2 * std::abs(exact->rest()[axis]);
            if (exact->has_fraction()) result.rest += std::numeric_limits<double>::denorm_min();
        }
    return result;
}

/// Bounds within which neither overflow nor underflow spoils products of three: with every column's greatest entry
/// above 1e-97, what underflows is below the error bound by far.
constexpr double least_entry = 1e-97, greatest_entry = 1e102;

struct Column {
    Approximate p, q, r;
    double greatest, rest;  ///< Of the three.
};

Column column(const Triple& triple, int axis) {
    Column c{approximate(triple.p, axis), approximate(triple.q, axis), approximate(triple.r, axis), 0, 0};
    c.greatest = std::max({std::abs(c.p.value), std::abs(c.q.value), std::abs(c.r.value)});
    c.rest = std::max({c.p.rest, c.q.rest, c.r.rest});
    return c;
}

std::optional<Sign> filtered(const Triple& triple) {
    const Column x = column(triple, 0), y = column(triple, 1), z = column(triple, 2);
    for (const Column* c : {&x, &y, &z}) {
        if (c->greatest == 0 && c->rest == 0) return Sign::zero;
        if (!(c->greatest > least_entry && c->greatest < greatest_entry)) return std::nullopt;
    }
    const double determinant = x.p.value * (y.q.value * z.r.value - z.q.value * y.r.value) +
                               y.p.value * (z.q.value * x.r.value - x.q.value * z.r.value) +
                               z.p.value * (x.q.value * y.r.value - y.q.value * x.r.value);
    // Six products of one entry a column, each with 3 roundings of its entries and at most 5 more: 6 * 8 * 2^-53
    // = 5.33e-15 times the greatest entries, and a little for second order and for the bound's own roundings.
    double bound = 5.5e-15 * x.greatest * y.greatest * z.greatest;
    if (x.rest > 0 || y.rest > 0 || z.rest > 0) {
        const double gx = x.greatest + x.rest, gy = y.greatest + y.rest, gz = z.greatest + z.rest;
        bound += 6.1 * (x.rest * gy * gz + gx * y.rest * gz + gx * gy * z.rest);
    }
    if (determinant > bound) return Sign::positive;
    if (determinant < -bound) return Sign::negative;
    return std::nullopt;
}

std::optional<Sign> filtered(const Difference& p, const Difference& q, int axis) {
    const int a = next(axis), b = next(a);
    const Approximate pa = approximate(p, a), pb = approximate(p, b), qa = approximate(q, a), qb = approximate(q, b);
    const double ga = std::max(std::abs(pa.value), std::abs(qa.value)), ra = std::max(pa.rest, qa.rest);
    const double gb = std::max(std::abs(pb.value), std::abs(qb.value)), rb = std::max(pb.rest, qb.rest);
    if ((ga == 0 && ra == 0) || (gb == 0 && rb == 0)) return Sign::zero;
    if (!(ga > least_entry && ga < greatest_entry && gb > least_entry && gb < greatest_entry)) return std::nullopt;
    const double minor = pa.value * qb.value - pb.value * qa.value;
    // Two products, each with 4 roundings: 2 * 4 * 2^-53 = 8.9e-16.
    const double bound = 9.5e-16 * ga * gb + 2.1 * (ra * (gb + rb) + (ga + ra) * rb);
    if (minor > bound) return Sign::positive;
    if (minor < -bound) return Sign::negative;
    return std::nullopt;
}

// ---------------------------------------------------------------------------------------------------- integers

void occupy(BitSpan& span, const PointReference& point, int axis) {
    span.add(point.nearest()[axis]);
    if (point.inexact()) span.add(point.inexact()->rest()[axis]);
}

void occupy(BitSpan& span, const Difference& difference) {
    for (int axis = 0; axis < 3; ++axis) {
        occupy(span, difference.from, axis);
        occupy(span, difference.to, axis);
    }
}

void occupy(BitSpan& span, const Triple& triple) {
    for (const Difference* difference : {&triple.p, &triple.q, &triple.r}) occupy(span, *difference);
}

bool has_fraction(const Difference& difference) {
    return difference.from.has_fraction() || difference.to.has_fraction();
}

bool has_fraction(const Triple& triple) {
    return has_fraction(triple.p) || has_fraction(triple.q) || has_fraction(triple.r);
}

/// Numbers of so many bits have differences (of sums of two) that fit `limbs` limbs, with 4 bits to spare
/// for the sums of products of them.
constexpr int bits_in(int limbs) {
    return 64 * limbs - 6;
}

template <int limbs>
WideInteger<limbs> on_grid(const Difference& difference, int axis, int low) {
    using Number = WideInteger<limbs>;
    Number value = Number(difference.to.nearest()[axis], low) - Number(difference.from.nearest()[axis], low);
    if (const ExactPoint* exact = difference.to.inexact()) value = value + Number(exact->rest()[axis], low);
    if (const ExactPoint* exact = difference.from.inexact()) value = value - Number(exact->rest()[axis], low);
    return value;
}

/// a d - b c.
template <int n, int m>
WideInteger<n + m> determinant_2d(const WideInteger<n>& a, const WideInteger<n>& b, const WideInteger<m>& c,
                                  const WideInteger<m>& d) {
    return widening_product(a, d) - widening_product(b, c);
}

template <int limbs>
WideInteger<3 * limbs> on_grid(const Triple& triple, int low) {
    WideInteger<limbs> p[3], q[3], r[3];
    for (int axis = 0; axis < 3; ++axis) {
        p[axis] = on_grid<limbs>(triple.p, axis, low);
        q[axis] = on_grid<limbs>(triple.q, axis, low);
        r[axis] = on_grid<limbs>(triple.r, axis, low);
    }
    WideInteger<3 * limbs> sum;
    for (int axis = 0; axis < 3; ++axis) {
        const int a = next(axis), b = next(a);
        sum = sum + widening_product(p[axis], determinant_2d(q[a], q[b], r[a], r[b]));
    }
    return sum;
}

/// Calls `evaluate` with the number of limbs that so many bits need, as a type; nothing beyond four limbs.
template <class Evaluate>
std::optional<Sign> in_fixed_width(const BitSpan& span, Evaluate evaluate) {
    if (span.only_zeros()) return Sign::zero;
    if (span.bits() <= bits_in(1)) return evaluate(std::integral_constant<int, 1>{});
    if (span.bits() <= bits_in(2)) return evaluate(std::integral_constant<int, 2>{});
    if (span.bits() <= bits_in(4)) return evaluate(std::integral_constant<int, 4>{});
    return std::nullopt;
}

// --------------------------------------------------------------------------------------------------- fractions

RationalPoint rational(const Difference& difference) {
    return difference.to.rational() - difference.from.rational();
}

Rational rational(const Triple& triple) {
    return dot(rational(triple.p), cross(rational(triple.q), rational(triple.r)));
}

}  // namespace

bool operator==(const PointReference& a, const PointReference& b) {
    if (!a.exact_ && !b.exact_) return *a.nearest_ == *b.nearest_;
    if (a.exact_ && b.exact_) return *a.exact_ == *b.exact_;
    return false;  // one is binary64 and the other is not
}

Sign exact_sign_of(const Triple& triple, const SignContext& context) {
    if (context.fallback == Fallback::integers && !has_fraction(triple)) {
        BitSpan span;
        occupy(span, triple);
        const auto sign =
            in_fixed_width(span, [&](auto limbs) { return on_grid<decltype(limbs)::value>(triple, span.low).sign(); });
        if (sign) {
            ++context.counters->integer;
            return *sign;
        }
    }
    ++context.counters->rational;
    return sign_of(rational(triple));
}

Sign sign_of(const Triple& triple, const SignContext& context) {
    if (const auto sign = filtered(triple)) {
        ++context.counters->filtered;
        return *sign;
    }
    return exact_sign_of(triple, context);
}

Sign cross_component(const Difference& p, const Difference& q, int axis, const SignContext& context) {
    if (const auto sign = filtered(p, q, axis)) {
        ++context.counters->filtered;
        return *sign;
    }
    const int a = next(axis), b = next(a);
    if (context.fallback == Fallback::integers && !has_fraction(p) && !has_fraction(q)) {
        BitSpan span;
        for (const Difference* difference : {&p, &q})
            for (const PointReference* end : {&difference->from, &difference->to}) {
                occupy(span, *end, a);
                occupy(span, *end, b);
            }
        const auto sign = in_fixed_width(span, [&](auto limbs) {
            constexpr int n = decltype(limbs)::value;
            return determinant_2d(on_grid<n>(p, a, span.low), on_grid<n>(p, b, span.low), on_grid<n>(q, a, span.low),
                                  on_grid<n>(q, b, span.low))
                .sign();
        });
        if (sign) {
            ++context.counters->integer;
            return *sign;
        }
    }
    ++context.counters->rational;
    return sign_of(cross(rational(p), rational(q))[axis]);
}

Sign sign_of_determinant(const Triple& a, const Triple& b, const Triple& c, const Triple& d,
                         const SignContext& context) {
    if (context.fallback == Fallback::integers && !has_fraction(a) && !has_fraction(b) && !has_fraction(c) &&
        !has_fraction(d)) {
        BitSpan span;
        for (const Triple* triple : {&a, &b, &c, &d}) occupy(span, *triple);
        const auto sign = in_fixed_width(span, [&](auto limbs) {
            constexpr int n = decltype(limbs)::value;
            return determinant_2d(on_grid<n>(a, span.low), on_grid<n>(b, span.low), on_grid<n>(c, span.low),
                                  on_grid<n>(d, span.low))
                .sign();
        });
        if (sign) {
            ++context.counters->integer;
            return *sign;
        }
    }
    ++context.counters->rational;
    return sign_of(Rational(rational(a) * rational(d) - rational(b) * rational(c)));
}

bool same_direction(const Difference& p, const Difference& q, const SignContext& context) {
    for (int axis = 0; axis < 3; ++axis)
        if (cross_component(p, q, axis, context) != Sign::zero) return false;
    // Parallel: they point the same way where any coordinate that is not zero has one sign. Ends are compared
    // rather than subtracted, so that nothing underflows.
    for (int axis = 0; axis < 3; ++axis) {
        const auto ascends = [axis](const Difference& difference) {
            if (!difference.from.inexact() && !difference.to.inexact()) {
                const double a = difference.from.nearest()[axis], b = difference.to.nearest()[axis];
                return a < b ? Sign::positive : a > b ? Sign::negative : Sign::zero;
            }
            return sign_of(rational(difference)[axis]);
        };
        const Sign sp = ascends(p);
        if (sp != Sign::zero) return sp == ascends(q);
    }
    return false;
}

}  // namespace cob
