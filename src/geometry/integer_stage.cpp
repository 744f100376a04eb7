#include "geometry/integer_stage.hpp"

#include "arithmetic/wide_integer.hpp"

#include <boost/container/small_vector.hpp>

#include <cmath>
#include <type_traits>

namespace cob {
namespace {

/// Signs of integers; an irrational height is between two of them.
template <int Limbs>
class IntegerKernel {
public:
    using Number = WideInteger<Limbs>;

    IntegerKernel() = default;
    /// The top is at high.z + h with rise < h < rise + step.
    IntegerKernel(const Number& rise, const Number& step) : rise_(rise), step_(step), irrational_(true) {}

    UncertainSign face(const Number& gap, int) const { return uncertain(gap.sign()); }
    UncertainSign base(const Number& gap) const { return uncertain(gap.sign()); }
    UncertainSign top(const Number& gap) const {
        return irrational_ ? between(gap - rise_ - step_, gap - rise_) : uncertain(gap.sign());
    }
    UncertainSign edge(const Number& gap, const Vector3<Number>& d, bool at_top) const {
        if (!irrational_ || !at_top) return uncertain(gap.sign());
        const Number least_height = gap + d.z * rise_;  // d.z < 0
        return between(least_height + d.z * step_, least_height);
    }
    template <class Offset>
    UncertainSign plane(const Number& gap, const Vector3<Number>& d, const Offset&, bool at_top) const {
        return edge(gap, d, at_top);
    }
    UncertainSign turn(const Number& value, int) const { return uncertain(value.sign()); }

private:
    /// Sign of a number strictly between two others.
    static UncertainSign between(const Number& low, const Number& high) {
        if (!less_than_zero(low)) return UncertainSign::positive;
        return greater_than_zero(high) ? UncertainSign::undecided : UncertainSign::negative;
    }

    Number rise_, step_;
    bool irrational_ = false;
};

/// Everything of a query in units of 2^unit.
template <int Limbs>
struct Integers {
    using Number = WideInteger<Limbs>;
    FrameBox<Number> box;
    IntegerKernel<Limbs> kernel;
    boost::container::small_vector<Vector3<Number>, 8> corners;

    Integers() = default;

    FramePiece<Number> piece() const { return {corners.data(), static_cast<int>(corners.size())}; }

    Integers(const AlignedBox& aligned, const View<Point>& points, int unit) {
        const auto convert = [](const AlignedBox::Pair& pair, int unit_) {
            return Number(pair.nearest, unit_) + Number(pair.rest, unit_);
        };
        for (int k = 0; k < 3; ++k) {
            const auto& side = (*aligned.sides)[static_cast<std::size_t>(k)];
            box.low[k] = convert(side[0], unit);
            box.high[k] = convert(side[1], unit);
        }
        for (const Point& p : points) {
            corners.emplace_back();
            for (int k = 0; k < 3; ++k) corners.back()[k] = Number(aligned.coordinate(p, k), unit);
        }
    }

    Integers(const IntegerBox& integer, const Point& origin, const View<Point>& points, int unit) {
        std::array<Vector3<Number>, 3> directions;
        for (int k = 0; k < 3; ++k) {
            const auto i = static_cast<std::size_t>(k);
            for (int axis = 0; axis < 3; ++axis) directions[i][axis] = Number(integer.directions[i][axis], 0);
            box.low[k] = Number(integer.low[k], integer.exponent[k] - unit);
            box.high[k] = Number(integer.high[k], integer.exponent[k] - unit);
        }
        if (integer.rise != 0)
            kernel = IntegerKernel<Limbs>(Number(integer.rise, integer.rise_exponent - unit),
                                          Number(Integer(1), integer.rise_exponent - unit));
        // Both are multiples of 2^unit, so a difference of less than 53 bits is exact in binary64.
        const double steps = std::abs(unit) < 900 ? std::ldexp(1.0, -unit) : 0;
        const auto difference = [&](double a, double b) {
            const double value = (a - b) * steps;
            return steps != 0 && std::abs(value) < 0x1p52 ? Number(static_cast<std::int64_t>(value))
                                                          : Number(a, unit) - Number(b, unit);
        };
        for (const Point& p : points) {
            Vector3<Number> relative;
            for (int axis = 0; axis < 3; ++axis) relative[axis] = difference(p[axis], origin[axis]);
            corners.push_back(
                {dot(directions[0], relative), dot(directions[1], relative), dot(directions[2], relative)});
        }
    }
};

/// |value| < 2^result; value >= 0 and finite.
int exponent_above(double value) {
    int exponent;
    std::frexp(value, &exponent);
    return exponent;
}

bool has_sides(const Box::Prepared& box) {
    return box.aligned && box.aligned->sides;
}

/// Units of a query, and the bits of each frame coordinate in them.
struct Size {
    int unit = 0;
    std::array<int, 3> bits{};  ///< Absolute frame coordinates are less than 2^bits.
};

Size size_of(const IntegerQuery& query) {
    const Box::Prepared& box = query.box;
    BitSpan span;
    for (const Point& p : query.corners)
        for (int axis = 0; axis < 3; ++axis) span.add(p[axis]);
    std::array<double, 3> reach{};
    double largest = box.size;
    for (int k = 0; k < 3; ++k) {
        reach[static_cast<std::size_t>(k)] =
            std::max({-query.rounded.low[k], query.rounded.high[k], -box.frame.low[k], box.frame.high[k]});
        largest = std::max(largest, reach[static_cast<std::size_t>(k)]);
    }
    const int scale_exponent = exponent_above(box.scale) - 1;

    Size size;
    if (has_sides(box)) {
        size.unit = std::min(box.aligned->unit, span.low);
        for (std::size_t k = 0; k < 3; ++k)
            size.bits[k] = std::max(1, exponent_above(reach[k] + box.error * largest) - scale_exponent - size.unit);
        return size;
    }
    const IntegerBox& integer = box.integers();
    size.unit = std::min(integer.unit, span.low);
    for (int axis = 0; axis < 3; ++axis) {
        const BinaryParts origin(box.origin[axis]);
        if (origin.magnitude != 0) size.unit = std::min(size.unit, origin.exponent);
    }
    // |p - o| <= sqrt(3) largest; three products.
    const int relative = exponent_above(1.8 * largest) - scale_exponent;
    for (std::size_t k = 0; k < 3; ++k)
        size.bits[k] =
            std::max(1, std::max(integer.direction_bits[k] + relative + 2, integer.limit_exponent[k]) - size.unit);
    return size;
}

/// Short coordinates, the ordinary case of scenes drawn on a grid: all corners and sides on a lattice of 2^38 steps
/// each way (and the piece of four corners at most) fit two limbs and need no counting of bits. False where not. The
/// box must have sides.
bool on_lattice(const IntegerQuery& query, Integers<2>& integers) {
    constexpr int lattice_bits = 38;
    const Box::Prepared& box = query.box;
    if (query.corners.size() > 4) return false;
    double largest = box.size;
    for (int k = 0; k < 3; ++k) largest = std::max({largest, -query.rounded.low[k], query.rounded.high[k]});
    const int exponent = exponent_above(largest * 1.001 / box.scale) - lattice_bits;
    if (exponent < -900 || exponent > 900) return false;
    const double steps = std::ldexp(1.0, -exponent);

    // Multiples of the step whose distance from the origin is less than 2^38 of it: differences are exact.
    bool exact = true;
    const auto in_steps = [&](double coordinate) {
        const double value = coordinate * steps;
        const bool is_integer =
            std::abs(value) < 0x1p62 && static_cast<double>(static_cast<std::int64_t>(value)) == value;
        const bool underflown = value == 0 && coordinate != 0;  // beside coordinates above 2^38
        exact = exact && is_integer && !underflown;
        return value;
    };
    Vector3<double> origin;
    const auto convert = [&](double coordinate, int k) {
        const double value = in_steps(coordinate);
        return WideInteger<2>(exact ? static_cast<std::int64_t>(value - origin[k]) : 0);
    };
    for (int k = 0; k < 3; ++k) {
        origin[k] = in_steps(box.aligned->coordinate(box.origin, k));
        const auto& side = (*box.aligned->sides)[static_cast<std::size_t>(k)];
        exact = exact && side[0].rest == 0 && side[1].rest == 0;
        if (!exact) return false;
        integers.box.low[k] = convert(side[0].nearest, k);
        integers.box.high[k] = convert(side[1].nearest, k);
    }
    for (const Point& p : query.corners) {
        integers.corners.emplace_back();
        for (int k = 0; k < 3; ++k) integers.corners.back()[k] = convert(box.aligned->coordinate(p, k), k);
    }
    return exact;
}

enum class Degree { faces, sides, plane };

/// Bits, with the sign, of the largest result: differences have one more than coordinates; a side's gap is the sum
/// of two products of differences and perhaps the height's; N, a fan of sums of two products, times a difference.
int bits_needed(const Size& size, Degree degree, int corner_count) {
    const auto [a, b, z] = size.bits;
    if (degree == Degree::faces) return std::max({a, b, z}) + 4;
    const int fan = exponent_above(static_cast<double>(corner_count));
    if (degree == Degree::plane) return a + b + z + 9 + fan;
    return std::max({a + b, a + z, b + z}) + 6 + fan;
}

/// Calls evaluate(Integers<Limbs>) with as few limbs as the bits need; false: too many.
template <class Evaluate>
bool in_integers(const IntegerQuery& query, Degree degree, const Evaluate& evaluate) {
    if (has_sides(query.box)) {
        if (Integers<2> integers; on_lattice(query, integers)) {
            evaluate(integers);
            return true;
        }
    }
    const Size size = size_of(query);
    const int bits = bits_needed(size, degree, static_cast<int>(query.corners.size()));
    const auto with = [&](auto limbs) {
        if (has_sides(query.box))
            evaluate(Integers<limbs>(*query.box.aligned, query.corners, size.unit));
        else
            evaluate(Integers<limbs>(query.box.integers(), query.box.origin, query.corners, size.unit));
        return true;
    };
    if (bits <= 128) return with(std::integral_constant<int, 2>());
    if (bits <= 256) return with(std::integral_constant<int, 4>());
    if (bits <= 512) return with(std::integral_constant<int, 8>());
    if (bits <= 1024) return with(std::integral_constant<int, 16>());
    return false;
}

}  // namespace

bool separate_in_integers(const IntegerQuery& query, AxisSet open, Findings& findings) {
    const Degree degree = open.only_faces() ? Degree::faces : open.normals == 0 ? Degree::sides : Degree::plane;
    return in_integers(query, degree, [&](const auto& integers) {
        findings.undecided = {};
        separate(integers.kernel, integers.box, integers.piece(), open, findings);
    });
}

UncertainBool covers_in_integers(const IntegerQuery& query) {
    UncertainBool answer = UncertainBool::undecided;
    in_integers(query, Degree::plane, [&](const auto& integers) {
        answer = meets_all_box_edges(integers.kernel, integers.box, integers.piece());
    });
    return answer;
}

}  // namespace cob
