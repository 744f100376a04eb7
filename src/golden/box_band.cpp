#include "geometry/candidate_list.hpp"
#include "geometry/convex_polygon.hpp"
#include "golden/band.hpp"
#include "golden/box_clearance.hpp"
#include "golden/number_format.hpp"

#include <algorithm>
#include <cmath>

namespace cob {

namespace {

/// Twice the largest |factor - 1| tried, so that no polygon that matters is left out by rounding.
constexpr double reach = 2.0 / (1 << lowest_band);

/// Bounds of the box scaled by 1 + reach, generously.
std::array<double, 6> grown(const std::array<double, 6>& bounds) {
    std::array<double, 6> result = bounds;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double more = reach * (bounds[axis + 3] - bounds[axis]);
        result[axis] = bounds[axis] - more, result[axis + 3] = bounds[axis + 3] + more;
    }
    return result;
}

/// The square root of a positive fraction to 53 bits, also where binary64 has no number as large or small.
Rational rounded_root(const Rational& square) {
    const int half = (static_cast<int>(msb(numerator(square))) - static_cast<int>(msb(denominator(square)))) / 2;
    const Rational unit = power_of_two(half);
    return unit * Rational(std::sqrt(to_nearest(square / (unit * unit))));
}

/// The question scaled about the centre of its box: everything is similar but for the height, whose half is rounded
/// to a binary64 multiple of the normal.
class ScaledQuestion {
public:
    explicit ScaledQuestion(const BoxQuestion& question) : question_(question), corners_(polygon_of(question.corners)) {
        const RationalPoint u = question.u.rational(), n = area_vector(corners_), w = cross(n, u);
        const Rational uu = dot(u, u), ww = dot(w, w), nn = dot(n, n);

        // Extents of the corners from the first, in units of u and w.
        std::array<Rational, 2> low, high;
        for (const RationalPoint& corner : corners_) {
            const RationalPoint d = corner - corners_[0];
            const std::array<Rational, 2> at{dot(d, u) / uu, dot(d, w) / ww};
            for (std::size_t axis = 0; axis < 2; ++axis)
                low[axis] = std::min(low[axis], at[axis]), high[axis] = std::max(high[axis], at[axis]);
        }
        const Rational along_u = high[0] - low[0], along_w = high[1] - low[1];
        const Rational shorter = std::min(Rational(along_u * along_u * uu), Rational(along_w * along_w * ww));
        const Rational height = question.height * (1 + 2 * question.margin);
        const Rational half = rounded_root(height * height * shorter / nn) / 2;
        centre_ = corners_[0] + (low[0] + high[0]) / 2 * u + (low[1] + high[1]) / 2 * w + half * n;
    }

    Box box(const Rational& factor) const {
        BoxQuestion scaled = question_;
        for (std::size_t k = 0; k < corners_.size(); ++k)
            scaled.corners.points[k] = ExactPoint(centre_ + factor * (corners_[k] - centre_));
        return Box(scaled);
    }

private:
    const BoxQuestion& question_;
    ConvexPolygon corners_;
    RationalPoint centre_;
};

bool same_answers(const Classification& a, const Classification& b) {
    return a.light == b.light && std::equal(a.neighbours.begin(), a.neighbours.end(), b.neighbours.begin(),
                                            b.neighbours.end(), [](const Neighbour& x, const Neighbour& y) {
                                                return x.polygon == y.polygon &&
                                                       x.answer.relation == y.answer.relation &&
                                                       x.answer.covers == y.answer.covers;
                                            });
}

/// The smallest k whose 2^-k is below a clearance.
int band_of(double clearance) {
    int k = lowest_band;
    while (k < highest_band && !(std::ldexp(1.0, -k) < clearance)) ++k;
    return k;
}

}  // namespace

int BoxBands::operator()(const BoxQuestion& question, Classification& result) {
    // Everything near, and of it what may meet the box itself.
    const Box box(question);
    const auto& b = box.bounds();
    const Bounds own{{b[0], b[1], b[2]}, {b[3], b[4], b[5]}};
    near_ = polygons_in(source_, grown(b));
    candidates_.clear();
    for (const PolygonId id : near_)
        if (bounds_[static_cast<std::size_t>(id)].meets(own)) candidates_.push_back(id);
    classifier_.among(box, {candidates_.data(), candidates_.data() + candidates_.size()}, result);

    // On a switch already.
    for (const Neighbour& neighbour : result.neighbours)
        if (neighbour.answer.relation != Relation::crossing) return highest_band;

    // The nearest switch, as far as binary64 tells.
    const BoxFrame frame(question);
    Clearance nearest = frame.usable() ? Clearance{HUGE_VAL, HUGE_VAL} : Clearance{0, HUGE_VAL};
    const auto take = [&](const Clearance& clearance) {
        nearest.low = std::min(nearest.low, clearance.low), nearest.high = std::min(nearest.high, clearance.high);
    };
    auto neighbour = result.neighbours.begin();
    for (const PolygonId id : near_) {
        if (id == question.polygon) continue;
        const bool crosses = neighbour != result.neighbours.end() && neighbour->polygon == id;
        take(meeting_clearance(scene_, id, frame, crosses ? Relation::crossing : Relation::disjoint));
        if (!crosses) continue;
        take(covering_clearance(scene_, id, frame, neighbour->answer.covers));
        if (scene_.is_light(id))
            take(facing_clearance(scene_, id, frame, std::binary_search(result.light.begin(), result.light.end(), id)));
        ++neighbour;
    }

    // Exact arithmetic decides between the bands that are left.
    int low = band_of(nearest.high), high = band_of(nearest.low);
    if (low >= high) return low;
    const ScaledQuestion scaled(question);
    const auto stays = [&](int k) {
        for (const double sign : {-1.0, 1.0}) {
            moved_.among(scaled.box(1 + Rational(std::ldexp(sign, -k))), {near_.data(), near_.data() + near_.size()},
                         scratch_);
            if (!same_answers(scratch_, result)) return false;
        }
        return true;
    };
    // What binary64 cannot tell from a switch mostly is one.
    if (high == highest_band && !stays(--high)) return highest_band;
    while (low < high) {
        const int middle = (low + high) / 2;
        if (stays(middle))
            high = middle;
        else
            low = middle + 1;
    }
    return low;
}

}  // namespace cob
