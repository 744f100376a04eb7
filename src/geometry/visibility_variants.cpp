// The same formulas in other arithmetic, as subjects for the study of error against time.
#include <CGAL/FPU.h>
#include <CGAL/Interval_nt.h>

#include "cob/candidates.hpp"
#include "geometry/bounds.hpp"
#include "geometry/visibility_oracle.hpp"

namespace cob {
namespace {

using Interval = CGAL::Interval_nt<false>;  // wants rounding upward, see Protect_FPU_rounding below

template <class Number>
Number coordinate(const PointReference& point, int axis) {
    return static_cast<Number>(point.nearest()[axis]);
}

template <>
Rational coordinate<Rational>(const PointReference& point, int axis) {
    if (point.has_fraction()) return point.rational()[axis];
    const Rational nearest(point.nearest()[axis]);
    return point.inexact() ? Rational(nearest + Rational(point.inexact()->rest()[axis])) : nearest;
}

template <>
Interval coordinate<Interval>(const PointReference& point, int axis) {
    const double nearest = point.nearest()[axis];
    if (!std::isfinite(nearest)) return Interval(-Bounds::infinity, Bounds::infinity);
    if (!point.inexact()) return Interval(nearest);
    const double rest = point.inexact()->rest()[axis];
    if (!point.has_fraction()) return Interval(nearest) + Interval(rest);
    const double off = 2 * std::abs(rest) + std::numeric_limits<double>::denorm_min();
    return Interval(nearest) + Interval(-off, off);
}

template <class Number>
Vector3<Number> vector(const Difference& difference) {
    Vector3<Number> v;
    for (int axis = 0; axis < 3; ++axis)
        v[axis] = coordinate<Number>(difference.to, axis) - coordinate<Number>(difference.from, axis);
    return v;
}

template <class Number>
Number value(const Triple& triple) {
    return dot(vector<Number>(triple.p), cross(vector<Number>(triple.q), vector<Number>(triple.r)));
}

/// A number's sign as it comes: right in Rational, anything near zero in floating point.
template <class Number>
struct PlainSign {
    Sign operator()(const Number& number) const { return sign_of(number); }
};

/// An interval's sign, where it has one; else `undecided` is set.
struct IntervalSign {
    bool* undecided;
    Sign operator()(const Interval& interval) const {
        if (interval.inf() > 0) return Sign::positive;
        if (interval.sup() < 0) return Sign::negative;
        if (!(interval.inf() == 0 && interval.sup() == 0)) *undecided = true;
        return Sign::zero;
    }
};

/// The formulas of ExactArithmetic in one number type.
template <class Number, class SignOf>
struct NumberArithmetic {
    SignOf sign_of_number;

    Sign sign(const Triple& triple) const { return sign_of_number(value<Number>(triple)); }
    Sign component(const Difference& p, const Difference& q, int axis) const {
        return sign_of_number(cross(vector<Number>(p), vector<Number>(q))[axis]);
    }
    Sign determinant(const Triple& a, const Triple& b, const Triple& c, const Triple& d) const {
        return sign_of_number(value<Number>(a) * value<Number>(d) - value<Number>(b) * value<Number>(c));
    }
    bool same_direction(const Difference& p, const Difference& q) const {
        const Vector3<Number> vp = vector<Number>(p), vq = vector<Number>(q), product = cross(vp, vq);
        for (int axis = 0; axis < 3; ++axis)
            if (sign_of_number(product[axis]) != Sign::zero) return false;
        return sign_of_number(dot(vp, vq)) == Sign::positive;
    }
};

double length(const Point& v) {
    return std::sqrt(dot(v, v));
}

/// binary64 with the usual tolerance: what is nearer than `tolerance` touches.
struct EpsilonArithmetic {
    static constexpr double relative = 1e-6;
    double tolerance;  ///< relative * the scene's longest extent.

    Sign beyond(double number, double limit) const {
        return std::abs(number) <= limit ? Sign::zero : number > 0 ? Sign::positive : Sign::negative;
    }
    /// The volume over its greatest face is the least of the three distances.
    Sign sign(const Triple& triple) const {
        const Point p = vector<double>(triple.p), q = vector<double>(triple.q), r = vector<double>(triple.r);
        const double face = std::max({length(cross(q, r)), length(cross(p, q)), length(cross(p, r))});
        return beyond(dot(p, cross(q, r)), tolerance * face);
    }
    Sign component(const Difference& p, const Difference& q, int axis) const {
        const Point vp = vector<double>(p), vq = vector<double>(q);
        return beyond(cross(vp, vq)[axis], tolerance * std::max(length(vp), length(vq)));
    }
    /// Of parameters along a segment (see SegmentSigns::compare_parameters): relative to its length.
    Sign determinant(const Triple& a, const Triple& b, const Triple& c, const Triple& d) const {
        const double va = value<double>(a), vb = value<double>(b), vc = value<double>(c), vd = value<double>(d);
        return beyond(va * vd - vb * vc, relative * std::abs((va - vc) * (vb - vd)));
    }
    bool same_direction(const Difference& p, const Difference& q) const {
        const Point vp = vector<double>(p), vq = vector<double>(q);
        return length(cross(vp, vq)) <= tolerance * std::max(length(vp), length(vq)) && dot(vp, vq) > 0;
    }
};

}  // namespace

/// Only what is certain counts: a piece crossed inside for certain blocks whatever the others do.
VisibilityAnswer VisibilityOracle::Implementation::in_intervals(const Segment& segment) const {
    const std::vector<PieceId> ids = candidates_along(candidates, segment);  // trees want the usual rounding
    const CGAL::Protect_FPU_rounding<true> upward;
    using Signs = SegmentSigns<NumberArithmetic<Interval, IntervalSign>>;
    bool undecided = false, any_undecided = false;
    const Signs signs(pieces, segment, {{&undecided}});
    Gathering<Signs> gathering(signs);
    for (const PieceId id : ids) {
        undecided = false;
        const bool blocked = !gathering.add(id);
        if (blocked && !undecided) return {Visibility::blocked, true};
        any_undecided = any_undecided || undecided;
    }
    undecided = any_undecided;
    const Visibility visibility = any_undecided ? Visibility::grazing : gathering.answer();
    return {visibility, !undecided};
}

VisibilityAnswer VisibilityOracle::operator()(const Segment& segment, Arithmetic arithmetic,
                                              PredicateCounters* counters) const {
    refuse_a_point(segment);
    const auto with = [&](auto numbers) {
        const SegmentSigns<decltype(numbers)> signs(implementation_->pieces, segment, numbers);
        return VisibilityAnswer{visibility_along(signs, implementation_->candidates, segment), true};
    };
    switch (arithmetic) {
        case Arithmetic::exact:
            break;
        case Arithmetic::binary32:
            return with(NumberArithmetic<float, PlainSign<float>>{});
        case Arithmetic::binary64:
            return with(NumberArithmetic<double, PlainSign<double>>{});
        case Arithmetic::epsilon: {
            std::call_once(implementation_->extent_known,
                           [&] { implementation_->extent = longest_extent(bounds_of(implementation_->pieces.scene())); });
            return with(EpsilonArithmetic{EpsilonArithmetic::relative * implementation_->extent});
        }
        case Arithmetic::interval: {
            const VisibilityAnswer answer = implementation_->in_intervals(segment);
            if (!answer.decided && counters) ++counters->undecided;
            return answer;
        }
        case Arithmetic::rational:
            return with(NumberArithmetic<Rational, PlainSign<Rational>>{});
    }
    return {(*this)(segment, counters), true};
}

}  // namespace cob
