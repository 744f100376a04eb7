#include "scene/seen.hpp"

#include "arithmetic/wide_integer.hpp"

#include <cmath>
#include <limits>

namespace cob {
namespace {

/// One component of Newell's normal in binary64 with a bound of its error. Both are 0 where it is exactly so.
struct Approximation {
    double value = 0, error = 0;
    double low() const { return std::abs(value) - error; }
    double high() const { return std::abs(value) + error; }
};

/// Component along the axis that the plane (first, second) leaves out; nothing where a product leaves the range in
/// which its error is relative.
std::optional<Approximation> newell_component(const std::vector<Point>& loop, int first, int second) {
    constexpr double least = 0x1p-900, greatest = 0x1p900;
    const Point& origin = loop.front();
    double sum = 0, magnitude = 0;
    for (std::size_t k = 1; k + 1 < loop.size(); ++k) {
        const Point a = loop[k] - origin, b = loop[k + 1] - origin;
        const double p = a[first] * b[second], q = a[second] * b[first];
        const auto safe = [&](double product, double f, double g) {
            const double size = std::abs(product);
            return (size > least && size < greatest) || f == 0 || g == 0;
        };
        if (!safe(p, a[first], b[second]) || !safe(q, a[second], b[first])) return std::nullopt;
        sum += p - q;
        magnitude += std::abs(p) + std::abs(q);
    }
    // Each product carries 3 roundings (two differences, one product), each term one, the sum fewer than n: the
    // error is below (n + 4) u sum |products|, twice that with room for the rounding of the bound itself.
    const double n = static_cast<double>(loop.size());
    return Approximation{sum, 2 * (n + 4) * 0x1p-53 * magnitude};
}

/// Newell's normal over any exact number type; convert makes a point's difference from the first corner.
template <class T, class Convert>
Vector3<T> newell_normal(const std::vector<Point>& loop, Convert&& convert) {
    Vector3<T> normal, before = convert(loop[1]);
    for (std::size_t k = 2; k < loop.size(); ++k) {
        const Vector3<T> at = convert(loop[k]);
        normal = normal + cross(before, at);
        before = at;
    }
    return normal;
}

View2 view_along(int axis, bool up) {
    const auto first = static_cast<std::uint8_t>((axis + 1) % 3), second = static_cast<std::uint8_t>((axis + 2) % 3);
    const auto along = static_cast<std::uint8_t>(axis);
    return up ? View2{along, first, second} : View2{along, second, first};
}

std::optional<View2> filtered_view(const std::vector<Point>& loop) {
    std::array<Approximation, 3> normal;
    for (int axis = 0; axis < 3; ++axis) {
        const auto component = newell_component(loop, (axis + 1) % 3, (axis + 2) % 3);
        if (!component) return std::nullopt;
        normal[static_cast<std::size_t>(axis)] = *component;
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
        bool largest = normal[axis].low() > 0;
        for (std::size_t other = 0; other < 3; ++other)
            largest = largest && (other == axis || normal[axis].low() > normal[other].high());
        if (largest) return view_along(static_cast<int>(axis), normal[axis].value > 0);
    }
    return std::nullopt;
}

/// The view along the largest component of an exact normal.
template <class T>
std::optional<View2> view_of_normal(const Vector3<T>& normal) {
    const auto magnitude = [&](int axis) {
        return sign_of(normal[axis]) == Sign::negative ? -normal[axis] : normal[axis];
    };
    int largest = 0;
    for (int axis = 1; axis < 3; ++axis)
        if (magnitude(axis) > magnitude(largest)) largest = axis;
    if (sign_of(normal[largest]) == Sign::zero) return std::nullopt;
    return view_along(largest, sign_of(normal[largest]) == Sign::positive);
}

template <int Limbs>
std::optional<View2> integer_view(const std::vector<Point>& loop, int unit) {
    using Number = WideInteger<Limbs>;
    const auto number = [&](double value) { return Number(value, unit); };
    return view_of_normal(newell_normal<Number>(loop, [&](const Point& point) {
        Vector3<Number> difference;
        for (int axis = 0; axis < 3; ++axis) difference[axis] = number(point[axis]) - number(loop[0][axis]);
        return difference;
    }));
}

}  // namespace

std::optional<View2> view_of(const std::vector<Point>& loop) {
    if (loop.size() < 3) return std::nullopt;
    if (const auto view = filtered_view(loop)) return view;

    // Two components are equal (planes at 45 degrees), or all are zero or nearly so.
    BitSpan span;
    for (const Point& point : loop)
        for (int axis = 0; axis < 3; ++axis) span.add(point[axis]);
    const int bits_of_count = std::numeric_limits<std::size_t>::digits;  // of the sum's terms, more than enough
    if (span.only_zeros()) return std::nullopt;
    if (2 * (span.bits() + 1) + bits_of_count + 2 <= 256) return integer_view<4>(loop, span.low);
    return view_of_normal(
        newell_normal<Rational>(loop, [&](const Point& point) { return to_rational(point) - to_rational(loop[0]); }));
}

SeenLoop see(std::vector<Point> loop, View2 view) {
    SeenLoop result{view, std::move(loop), {}};
    result.seen.reserve(result.space.size());
    for (const Point& point : result.space) result.seen.push_back({point[view.first], point[view.second]});
    return result;
}

bool is_planar(const SeenLoop& loop) {
    if (loop.size() == 3) return true;
    // In a plane that is not seen edge-on, corners that are apart in space are apart as seen.
    if (loop.seen[0] == loop.seen[1]) return false;
    std::size_t third = 2;
    while (third < loop.size() && orientation(loop.seen[0], loop.seen[1], loop.seen[third]) == Sign::zero) ++third;
    if (third == loop.size()) return false;
    for (std::size_t k = 2; k < loop.size(); ++k)
        if (k != third && orientation(loop.space[0], loop.space[1], loop.space[third], loop.space[k]) != Sign::zero)
            return false;
    return true;
}

bool is_convex(const SeenLoop& loop) {
    // Steps up (in x, then in y) and steps down alternate once each in a loop that goes around once.
    int reversals = 0;
    const auto up = [&](std::size_t k) {
        const Point2 &from = loop.seen[k], &to = loop.seen[loop.next(k)];
        return from.x != to.x ? from.x < to.x : from.y < to.y;
    };
    for (std::size_t before = 0; before < loop.size(); ++before) {
        const std::size_t at = loop.next(before), after = loop.next(at);
        const Sign turn = orientation(loop.seen[before], loop.seen[at], loop.seen[after]);
        if (turn == Sign::negative) return false;
        if (turn == Sign::zero && turns_back(loop.seen[before], loop.seen[at], loop.seen[after])) return false;
        reversals += up(before) != up(at) ? 1 : 0;
    }
    return reversals == 2;
}

}  // namespace cob
