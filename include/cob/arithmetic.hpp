/// \file
/// Number types, vectors and exact points (SPEC section 1). No geometry here.
#pragma once

#include <boost/multiprecision/gmp.hpp>
#include <boost/range/iterator_range.hpp>

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace cob {

/// Exact fraction and integer, of any size.
using Rational = boost::multiprecision::number<boost::multiprecision::gmp_rational, boost::multiprecision::et_off>;
using Integer = boost::multiprecision::number<boost::multiprecision::gmp_int, boost::multiprecision::et_off>;

/// A view of consecutive values owned by somebody else; valid as long as the owner is unchanged.
template <class T>
using View = boost::iterator_range<const T*>;

enum class Sign : std::int8_t { negative = -1, zero = 0, positive = 1 };

constexpr Sign operator-(Sign s) {
    return static_cast<Sign>(-static_cast<int>(s));
}
constexpr Sign operator*(Sign a, Sign b) {
    return static_cast<Sign>(static_cast<int>(a) * static_cast<int>(b));
}

template <class T>
Sign sign_of(const T& value) {
    return value < 0 ? Sign::negative : value > 0 ? Sign::positive : Sign::zero;
}

/// A point or direction in space over any number type.
template <class T>
struct Vector3 {
    T x{}, y{}, z{};

    const T& operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
    T& operator[](int axis) { return axis == 0 ? x : axis == 1 ? y : z; }
    friend bool operator==(const Vector3& a, const Vector3& b) { return a.x == b.x && a.y == b.y && a.z == b.z; }
    friend bool operator!=(const Vector3& a, const Vector3& b) { return !(a == b); }
    /// Lexicographic: x, then y, then z.
    friend bool operator<(const Vector3& a, const Vector3& b) {
        return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z;
    }
    friend Vector3 operator+(const Vector3& a, const Vector3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
    friend Vector3 operator-(const Vector3& a, const Vector3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
    friend Vector3 operator-(const Vector3& a) { return {-a.x, -a.y, -a.z}; }
    friend Vector3 operator*(const T& s, const Vector3& a) { return {s * a.x, s * a.y, s * a.z}; }
};

template <class T>
T dot(const Vector3<T>& a, const Vector3<T>& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class T>
Vector3<T> cross(const Vector3<T>& a, const Vector3<T>& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

using Point = Vector3<double>;            ///< Exactly these binary64 coordinates.
using RationalPoint = Vector3<Rational>;  ///< Exactly these fractions.

RationalPoint to_rational(const Point& point);

/// An exact point of any provenance that is cheap where it can be: its value is nearest() + rest(), both
/// binary64 and summed without rounding, or, only where no such pair exists, a fraction beside them.
/// Scene vertices have rest() = 0; so have all points of an exactly consumable set (SPEC 7). Corners and sample
/// points inside elements of ordinary scenes fit the pair.
class ExactPoint {
public:
    ExactPoint() = default;
    ExactPoint(const Point& point) : nearest_(point) {}  // NOLINT: implicit, every binary64 point is exact
    explicit ExactPoint(const RationalPoint& point);
    /// The sum of two points that are such a pair already: nearest must be the binary64 point nearest to the sum.
    static ExactPoint from_pair(const Point& nearest, const Point& rest) {
        ExactPoint point(nearest);
        point.rest_ = rest;
        return point;
    }

    /// The binary64 point nearest to it, coordinate by coordinate.
    const Point& nearest() const { return nearest_; }
    /// What nearest() leaves out, rounded to nearest where has_fraction().
    const Point& rest() const { return rest_; }
    bool is_binary64() const { return !fraction_ && rest_ == Point{}; }
    bool has_fraction() const { return static_cast<bool>(fraction_); }
    RationalPoint rational() const;

    friend bool operator==(const ExactPoint& a, const ExactPoint& b);
    friend bool operator!=(const ExactPoint& a, const ExactPoint& b) { return !(a == b); }

private:
    Point nearest_;
    Point rest_;
    std::shared_ptr<const RationalPoint> fraction_;
};

/// The binary64 number nearest to a decimal or C hex-float text, ties to even (SPEC 1), the whole text being the
/// number; nothing for anything else, for infinities, for NaN and for values that round to infinity. Underflow
/// rounds, too. Independent of the locale.
std::optional<double> parse_binary64(std::string_view text);

/// A coordinate of a table (SPEC 7): as parse_binary64(), or a fraction p/q of two decimal integers, q > 0.
std::optional<Rational> parse_exact(std::string_view text);

/// Shortest decimal that reads back to the same binary64 number.
std::string to_text(double value);
/// As to_text(double) where the value is a binary64 number, else p/q in lowest terms (also where q is 1: without it
/// the text would be read as the nearest binary64 number).
std::string to_text(const Rational& value);
/// C hex-float, as printf %a.
std::string to_hex_text(double value);

/// The binary64 number nearest to an exact value, ties to even; infinite beyond the range. Deterministic.
double to_nearest(const Rational& value);
/// The same number, exactly: nothing where value is no binary64 number.
std::optional<double> to_binary64(const Rational& value);

}  // namespace cob
