#include "golden/band.hpp"
#include "golden/number_format.hpp"

#include <array>
#include <cmath>

namespace cob {

namespace {

/// A move of an end, exactly: a - b times a power of two.
struct Move {
    Point a, b;
    int power = 0;
};

/// The power of two that brings a length to at most 2^-k of the segment's, and more than half of that.
int power_for(double length, double segment, int k) {
    int exponent_length = 0, exponent_segment = 0;
    const double mantissa_length = std::frexp(length, &exponent_length);
    const double mantissa_segment = std::frexp(segment, &exponent_segment);
    return exponent_segment - exponent_length - k - (mantissa_length > mantissa_segment ? 1 : 0);
}

double length(const Point& v) {
    return std::hypot(v.x, v.y, v.z);
}

/// The two directions an end moves in.
std::array<Move, 2> moves(const Scene& scene, PieceId piece, const Point& along, int k) {
    std::array<Move, 2> result;
    const double segment = length(along);
    if (piece >= 0) {
        const auto corners = scene.corners(scene.piece(piece));
        for (std::size_t side = 0; side < 2; ++side)
            result[side] = {scene.position(corners[side + 1]), scene.position(corners[side])};
    } else {
        int longest = 0;
        for (int axis = 1; axis < 3; ++axis)
            if (std::abs(along[axis]) > std::abs(along[longest])) longest = axis;
        for (int side = 0; side < 2; ++side) result[static_cast<std::size_t>(side)].a[(longest + 1 + side) % 3] = 1;
    }
    for (Move& move : result) move.power = power_for(length(move.a - move.b), segment, k);
    return result;
}

/// Sum of up to four numbers as two, without rounding; false where two are not enough.
bool add_exactly(std::array<double, 4> terms, double& nearest, double& rest) {
    // Distil (Shewchuk 1997, grow-expansion): after each pass the sums stand at the end, what they left out before.
    for (std::size_t pass = 0; pass < 4; ++pass)
        for (std::size_t k = 1; k < terms.size(); ++k) {
            const double sum = terms[k] + terms[k - 1], part = sum - terms[k];
            terms[k - 1] = (terms[k] - (sum - part)) + (terms[k - 1] - part);
            terms[k] = sum;
        }
    nearest = terms[3], rest = terms[2];
    return terms[0] == 0 && terms[1] == 0 && std::isfinite(nearest) && nearest + rest == nearest;
}

/// point + sign * move, exactly.
ExactPoint moved(const ExactPoint& point, const Move& move, double sign) {
    if (!point.has_fraction() && std::abs(move.power) < 200) {
        const double factor = std::ldexp(sign, move.power);
        Point nearest, rest;
        bool exact = true;
        for (int axis = 0; axis < 3 && exact; ++axis) {
            const double a = factor * move.a[axis], b = factor * move.b[axis];
            exact = a / factor == move.a[axis] && b / factor == move.b[axis] &&  // no underflow
                    add_exactly({point.nearest()[axis], point.rest()[axis], a, -b}, nearest[axis], rest[axis]);
        }
        if (exact) return ExactPoint::from_pair(nearest, rest);
    }
    return ExactPoint(point.rational() +
                      Rational(sign * power_of_two(move.power)) * (to_rational(move.a) - to_rational(move.b)));
}

/// blocker: see VisibilityOracle.
bool stays(const Scene& scene, const VisibilityOracle& oracle, const Segment& segment, Visibility visibility, int k,
           PieceId& blocker) {
    const Point along = segment.to.nearest() - segment.from.nearest();
    const std::array<Move, 2> from = moves(scene, segment.from_piece, along, k);
    const std::array<Move, 2> to = moves(scene, segment.to_piece, along, k);
    for (const std::size_t way : {0, 1})
        for (const double sign : {1.0, -1.0}) {
            Segment other = segment;
            other.from = moved(segment.from, from[way], sign);
            other.to = moved(segment.to, to[way], way == 0 ? sign : -sign);
            if (oracle(other, blocker) != visibility) return false;
        }
    return true;
}

}  // namespace

int segment_band(const Scene& scene, const VisibilityOracle& oracle, const Segment& segment, Visibility& visibility) {
    PieceId blocker = -1;
    visibility = oracle(segment, blocker);
    if (visibility == Visibility::grazing) return highest_band;
    const auto holds = [&](int k) { return stays(scene, oracle, segment, visibility, k, blocker); };
    if (holds(lowest_band)) return lowest_band;
    if (!holds(highest_band - 1)) return highest_band;
    int low = lowest_band + 1, high = highest_band - 1;
    while (low < high) {
        const int middle = (low + high) / 2;
        if (holds(middle))
            high = middle;
        else
            low = middle + 1;
    }
    return low;
}

}  // namespace cob
