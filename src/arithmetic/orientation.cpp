#include "arithmetic/orientation.hpp"

#include "arithmetic/wide_integer.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>

// Every stage evaluates the same determinants:
//   in space:   |  b-a, c-a, d-a |,   in a plane: | b-a, c-a | in two coordinates.
// The determinant is linear in each coordinate by itself, so the integers are scaled one coordinate at a time.

namespace cob {
namespace {

template <class T>
T determinant(const T& a, const T& b, const T& c, const T& d) {
    return a * d - b * c;
}

/// Columns x, y, z of the rows r0, r1, r2.
template <class T>
T determinant(const Vector3<T>& r0, const Vector3<T>& r1, const Vector3<T>& r2) {
    return determinant(r0.x, r0.y, r1.x, r1.y) * r2.z - determinant(r0.x, r0.y, r2.x, r2.y) * r1.z +
           determinant(r1.x, r1.y, r2.x, r2.y) * r0.z;
}

constexpr double unit_roundoff = 0x1p-53;
// Below and above, products of three differences could under- or overflow.
constexpr double smallest_safe = 1e-97, largest_safe = 1e102;

double nearest_difference(const Point& p, const Point& origin, int axis) {
    return p[axis] - origin[axis];
}
double nearest_difference(const ExactPoint& p, const ExactPoint& origin, int axis) {
    return (p.nearest()[axis] - origin.nearest()[axis]) + (p.rest()[axis] - origin.rest()[axis]);
}
/// Bounds the terms that nearest_difference() sums, whose roundings are relative to them; a fraction's rest is rounded
/// relative to itself, however near another's is.
double magnitude(const Point& p, const Point& origin, int axis) {
    return std::abs(p[axis] - origin[axis]);
}
double magnitude(const ExactPoint& p, const ExactPoint& origin, int axis) {
    const double rest = p.rest()[axis], origin_rest = origin.rest()[axis];
    return std::abs(p.nearest()[axis] - origin.nearest()[axis]) + (p.has_fraction() || origin.has_fraction()
                                                                       ? std::abs(rest) + std::abs(origin_rest)
                                                                       : std::abs(rest - origin_rest));
}
// A difference is wrong by at most this many unit roundoffs of magnitude(): one rounding; or two for the parts,
// one for their sum, and one in rest() itself where a fraction stands behind it, with a fifth for slack.
template <class P>
constexpr double roundings = 5;
template <>
constexpr double roundings<Point> = 1;

void add_bits(BitSpan& span, const Point& p, int axis) {
    span.add(p[axis]);
}
void add_bits(BitSpan& span, const ExactPoint& p, int axis) {
    span.add(p.nearest()[axis]);
    span.add(p.rest()[axis]);
}
template <int Limbs>
WideInteger<Limbs> integer_difference(const Point& p, const Point& origin, int axis, int unit) {
    return WideInteger<Limbs>(p[axis], unit) - WideInteger<Limbs>(origin[axis], unit);
}
template <int Limbs>
WideInteger<Limbs> integer_difference(const ExactPoint& p, const ExactPoint& origin, int axis, int unit) {
    return integer_difference<Limbs>(p.nearest(), origin.nearest(), axis, unit) +
           integer_difference<Limbs>(p.rest(), origin.rest(), axis, unit);
}
RationalPoint rational(const Point& p) {
    return to_rational(p);
}
RationalPoint rational(const ExactPoint& p) {
    return p.rational();
}
/// The points with each coordinate in a unit of its own in which it is an integer of all of them: a determinant of
/// fractions takes a greatest common divisor at each step, and these take nearly all of its time.
template <std::size_t N>
std::array<Vector3<Integer>, N> in_integers(const std::array<RationalPoint, N>& points) {
    std::array<Vector3<Integer>, N> result;
    for (int axis = 0; axis < 3; ++axis) {
        Integer common = 1;
        for (const RationalPoint& p : points) common = lcm(common, denominator(p[axis]));
        for (std::size_t k = 0; k < N; ++k)
            result[k][axis] = numerator(points[k][axis]) * Integer(common / denominator(points[k][axis]));
    }
    return result;
}
bool fits_integers(const Point&) {
    return true;
}
bool fits_integers(const ExactPoint& p) {
    return !p.has_fraction();
}

/// Sign of a filtered value; false: undecided (also for NaN).
bool decided(double value, double bound, Sign& sign) {
    if (value > bound) return sign = Sign::positive, true;
    if (value < -bound) return sign = Sign::negative, true;
    return false;
}

void report(Stage* stage, Stage value) {
    if (stage != nullptr) *stage = value;
}

// ---------------------------------------------------------------------------------------------- in space

template <class P>
bool filtered_3d(const P& a, const P& b, const P& c, const P& d, Sign& sign) {
    Point r0, r1, r2;
    double product = 1, smallest = largest_safe, largest = 0;
    for (int axis = 0; axis < 3; ++axis) {
        r0[axis] = nearest_difference(b, a, axis);
        r1[axis] = nearest_difference(c, a, axis);
        r2[axis] = nearest_difference(d, a, axis);
        const double size = std::max({magnitude(b, a, axis), magnitude(c, a, axis), magnitude(d, a, axis)});
        product *= size;
        smallest = std::min(smallest, size);
        largest = std::max(largest, size);
    }
    if (smallest == 0) {  // a difference of binary64 numbers is zero only where they are equal
        sign = Sign::zero;
        return fits_integers(a) && fits_integers(b) && fits_integers(c) && fits_integers(d);
    }
    if (!(smallest > smallest_safe && largest < largest_safe)) return false;
    // With X, Y, Z the sizes and k roundings in each difference, a minor is wrong by at most (4k + 4) u XY, its
    // product with a third difference by (6k + 6) u XYZ, and the sum of three by (18k + 18 + 10) u XYZ.
    const double bound = (20 * roundings<P> + 32) * unit_roundoff * product;
    return decided(determinant(r0, r1, r2), bound, sign);
}

template <int Limbs, class P>
Sign integer_3d(const P& a, const P& b, const P& c, const P& d, const std::array<BitSpan, 3>& spans) {
    Vector3<WideInteger<Limbs>> rows[3];
    const P* const ends[3] = {&b, &c, &d};
    for (int row = 0; row < 3; ++row)
        for (int axis = 0; axis < 3; ++axis)
            rows[row][axis] = integer_difference<Limbs>(*ends[row], a, axis, spans[axis].low);
    return sign_of(determinant(rows[0], rows[1], rows[2]));
}

template <class P>
Sign orientation_3d(const P& a, const P& b, const P& c, const P& d, Stage* stage) {
    Sign sign;
    report(stage, Stage::filter);
    if (filtered_3d(a, b, c, d, sign)) return sign;

    if (fits_integers(a) && fits_integers(b) && fits_integers(c) && fits_integers(d)) {
        report(stage, Stage::integer);
        std::array<BitSpan, 3> spans;
        int bits = 3 + 1;  // six terms, and the sign
        for (int axis = 0; axis < 3; ++axis) {
            for (const P* p : {&a, &b, &c, &d}) add_bits(spans[axis], *p, axis);
            if (spans[axis].only_zeros()) return Sign::zero;
            bits += spans[axis].bits() + 2;  // difference of two, each of two parts
        }
        if (bits <= 128) return integer_3d<2>(a, b, c, d, spans);
        if (bits <= 256) return integer_3d<4>(a, b, c, d, spans);
        if (bits <= 512) return integer_3d<8>(a, b, c, d, spans);
        if (bits <= 1024) return integer_3d<16>(a, b, c, d, spans);
    }
    report(stage, Stage::rational);
    return orientation(rational(a), rational(b), rational(c), rational(d));
}

template <int Limbs>
Sign integer_direction(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c, const ExactPoint& direction,
                       int point_unit, int direction_unit) {
    const ExactPoint zero;
    Vector3<WideInteger<Limbs>> rows[3];
    for (int axis = 0; axis < 3; ++axis) {
        rows[0][axis] = integer_difference<Limbs>(b, a, axis, point_unit);
        rows[1][axis] = integer_difference<Limbs>(c, a, axis, point_unit);
        rows[2][axis] = integer_difference<Limbs>(direction, zero, axis, direction_unit);
    }
    return sign_of(determinant(rows[0], rows[1], rows[2]));
}

// --------------------------------------------------------------------------------------------- in a plane

template <class P>
bool filtered_2d(const P& a, const P& b, const P& c, int first, int second, Sign& sign) {
    const double size_x = std::max(magnitude(b, a, first), magnitude(c, a, first));
    const double size_y = std::max(magnitude(b, a, second), magnitude(c, a, second));
    if (size_x == 0 || size_y == 0) {
        sign = Sign::zero;
        return fits_integers(a) && fits_integers(b) && fits_integers(c);
    }
    if (!(std::min(size_x, size_y) > smallest_safe && std::max(size_x, size_y) < largest_safe)) return false;
    const double value = determinant(nearest_difference(b, a, first), nearest_difference(b, a, second),
                                     nearest_difference(c, a, first), nearest_difference(c, a, second));
    // (4k + 4) u XY, see above.
    return decided(value, (5 * roundings<P> + 5) * unit_roundoff * size_x * size_y, sign);
}

template <int Limbs, class P>
Sign integer_2d(const P& a, const P& b, const P& c, int first, int second, const BitSpan& x, const BitSpan& y) {
    return sign_of(
        determinant(integer_difference<Limbs>(b, a, first, x.low), integer_difference<Limbs>(b, a, second, y.low),
                    integer_difference<Limbs>(c, a, first, x.low), integer_difference<Limbs>(c, a, second, y.low)));
}

template <class P>
Sign orientation_2d(const P& a, const P& b, const P& c, int first, int second, Stage* stage) {
    Sign sign;
    report(stage, Stage::filter);
    if (filtered_2d(a, b, c, first, second, sign)) return sign;

    if (fits_integers(a) && fits_integers(b) && fits_integers(c)) {
        report(stage, Stage::integer);
        BitSpan x, y;
        for (const P* p : {&a, &b, &c}) add_bits(x, *p, first), add_bits(y, *p, second);
        if (x.only_zeros() || y.only_zeros()) return Sign::zero;
        const int bits = x.bits() + y.bits() + 2 * 2 + 1 + 1;
        if (bits <= 128) return integer_2d<2>(a, b, c, first, second, x, y);
        if (bits <= 256) return integer_2d<4>(a, b, c, first, second, x, y);
        if (bits <= 1024) return integer_2d<16>(a, b, c, first, second, x, y);
    }
    report(stage, Stage::rational);
    const auto [pa, pb, pc] = in_integers<3>({rational(a), rational(b), rational(c)});
    return sign_of(determinant<Integer>(pb[first] - pa[first], pb[second] - pa[second], pc[first] - pa[first],
                                        pc[second] - pa[second]));
}

}  // namespace

Sign orientation(const Point& a, const Point& b, const Point& c, const Point& d, Stage* stage) {
    return orientation_3d(a, b, c, d, stage);
}

Sign orientation(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c, const ExactPoint& d, Stage* stage) {
    return orientation_3d(a, b, c, d, stage);
}

Sign orientation(const RationalPoint& a, const RationalPoint& b, const RationalPoint& c, const RationalPoint& d) {
    const auto [pa, pb, pc, pd] = in_integers<4>({a, b, c, d});
    return sign_of(determinant(pb - pa, pc - pa, pd - pa));
}

Sign orientation_of_direction(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c,
                              const ExactPoint& direction) {
    // Mostly all lies across one axis, and so does the direction.
    const bool pairs = !a.has_fraction() && !b.has_fraction() && !c.has_fraction() && !direction.has_fraction();
    for (int axis = 0; axis < 3 && pairs; ++axis) {
        const auto level = [&](const ExactPoint& p) {
            return p.nearest()[axis] == a.nearest()[axis] && p.rest()[axis] == a.rest()[axis];
        };
        if (direction.nearest()[axis] == 0 && level(b) && level(c)) return Sign::zero;
    }
    if (fits_integers(a) && fits_integers(b) && fits_integers(c) && fits_integers(direction)) {
        BitSpan points, directions;  // each with one unit for all its coordinates
        for (int axis = 0; axis < 3; ++axis) {
            for (const ExactPoint* p : {&a, &b, &c}) add_bits(points, *p, axis);
            add_bits(directions, direction, axis);
        }
        if (points.only_zeros() || directions.only_zeros()) return Sign::zero;
        const int bits = 2 * (points.bits() + 2) + directions.bits() + 1 + 3 + 1;
        const auto in = [&](auto limbs) {
            return integer_direction<limbs>(a, b, c, direction, points.low, directions.low);
        };
        if (bits <= 256) return in(std::integral_constant<int, 4>());
        if (bits <= 512) return in(std::integral_constant<int, 8>());
        if (bits <= 1024) return in(std::integral_constant<int, 16>());
    }
    const auto [pa, pb, pc, pd] = in_integers<4>({rational(a), rational(b), rational(c), rational(direction)});
    return sign_of(determinant(pb - pa, pc - pa, pd));
}

Sign orientation(const Point2& a, const Point2& b, const Point2& c, Stage* stage) {
    return orientation_2d(Point{a.x, a.y, 0}, Point{b.x, b.y, 0}, Point{c.x, c.y, 0}, 0, 1, stage);
}

Sign orientation_seen(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c, int first, int second,
                      Stage* stage) {
    return orientation_2d(a, b, c, first, second, stage);
}

bool collinear(const Point& a, const Point& b, const Point& c) {
    const auto straight = [&](int first, int second) {
        return orientation_2d(a, b, c, first, second, nullptr) == Sign::zero;
    };
    return straight(0, 1) && straight(1, 2) && straight(2, 0);
}

}  // namespace cob
