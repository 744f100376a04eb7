/// \file
/// The kernels that are studied beside the product: the same formula of separate() without certainty (binary32,
/// binary64, with a tolerance) or without decisions (intervals).
#pragma once

#include "arithmetic/interval.hpp"
#include "geometry/frame.hpp"

#include <cmath>

namespace cob {

/// Believes every sign.
template <class T>
class PlainKernel {
public:
    using Number = T;
    UncertainSign face(const T& gap, int) const { return uncertain(sign_of(gap)); }
    UncertainSign base(const T& gap) const { return uncertain(sign_of(gap)); }
    UncertainSign top(const T& gap) const { return uncertain(sign_of(gap)); }
    UncertainSign edge(const T& gap, const Vector3<T>&, bool) const { return uncertain(sign_of(gap)); }
    template <class Offset>
    UncertainSign plane(const T& gap, const Vector3<T>&, const Offset&, bool) const {
        return uncertain(sign_of(gap));
    }
    UncertainSign turn(const T& value, int) const { return uncertain(sign_of(value)); }
};

/// Takes every distance up to a tolerance for zero. Distances along d are gaps divided by |d|.
class EpsilonKernel {
public:
    using Number = double;
    explicit EpsilonKernel(double tolerance) : tolerance_(tolerance) {}

    UncertainSign face(double gap, int) const { return sign(gap, 1); }
    UncertainSign base(double gap) const { return sign(gap, 1); }
    UncertainSign top(double gap) const { return sign(gap, 1); }
    UncertainSign edge(double gap, const Vector3<double>& d, bool) const { return sign(gap, std::sqrt(dot(d, d))); }
    template <class Offset>
    UncertainSign plane(double gap, const Vector3<double>& d, const Offset&, bool) const {
        return sign(gap, std::sqrt(dot(d, d)));
    }
    UncertainSign turn(double value, int) const { return sign(value, tolerance_); }

private:
    UncertainSign sign(double gap, double length) const {
        return std::abs(gap) <= tolerance_ * length ? UncertainSign::zero : uncertain(sign_of(gap));
    }
    double tolerance_;
};

/// Knows what it does not know.
class IntervalKernel {
public:
    using Number = Interval;
    UncertainSign face(const Interval& gap, int) const { return gap.sign(); }
    UncertainSign base(const Interval& gap) const { return gap.sign(); }
    UncertainSign top(const Interval& gap) const { return gap.sign(); }
    UncertainSign edge(const Interval& gap, const Vector3<Interval>& d, bool) const {
        // Whether a zero gap is one at the base depends on the sign of d.z.
        const bool unclear = gap.sign() == UncertainSign::zero && d.z.straddles_zero();
        return unclear ? UncertainSign::undecided : gap.sign();
    }
    template <class Offset>
    UncertainSign plane(const Interval& gap, const Vector3<Interval>& d, const Offset&, bool top) const {
        return edge(gap, d, top);
    }
    UncertainSign turn(const Interval& value, int) const { return value.sign(); }
};

}  // namespace cob
