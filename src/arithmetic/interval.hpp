/// \file
/// Intervals of binary64 numbers, rounded outward from the nearest result: no change of rounding mode, a little
/// wider than need be.
#pragma once

#include "arithmetic/uncertain_sign.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cob {

class Interval {
public:
    Interval() = default;
    Interval(double value) : low_(value), high_(value) {}  // NOLINT: implicit, as for every number type
    Interval(double low, double high) : low_(low), high_(high) {}

    double low() const { return low_; }
    double high() const { return high_; }
    /// Undecided also where an end is NaN.
    UncertainSign sign() const {
        return !(low_ <= high_)          ? UncertainSign::undecided
               : low_ > 0                ? UncertainSign::positive
               : high_ < 0               ? UncertainSign::negative
               : low_ == 0 && high_ == 0 ? UncertainSign::zero
                                         : UncertainSign::undecided;
    }

    friend Interval operator+(const Interval& a, const Interval& b) {
        return {down_sum(a.low_ + b.low_), up_sum(a.high_ + b.high_)};
    }
    friend Interval operator-(const Interval& a, const Interval& b) {
        return {down_sum(a.low_ - b.high_), up_sum(a.high_ - b.low_)};
    }
    friend Interval operator-(const Interval& a) { return {-a.high_, -a.low_}; }
    friend Interval operator*(const Interval& a, const Interval& b) {
        if ((a.low_ == 0 && a.high_ == 0) || (b.low_ == 0 && b.high_ == 0)) return {};
        const double p = a.low_ * b.low_, q = a.low_ * b.high_, r = a.high_ * b.low_, s = a.high_ * b.high_;
        if (std::isnan(p + q + r + s)) return unknown();
        return {down(std::min({p, q, r, s})), up(std::max({p, q, r, s}))};
    }

    /// Unknown where the divisor may be zero.
    friend Interval operator/(const Interval& a, const Interval& b) {
        if (!(b.low_ > 0 || b.high_ < 0)) return unknown();
        const double p = a.low_ / b.low_, q = a.low_ / b.high_, r = a.high_ / b.low_, s = a.high_ / b.high_;
        if (std::isnan(p + q + r + s)) return unknown();
        return {down(std::min({p, q, r, s})), up(std::max({p, q, r, s}))};
    }
    Interval& operator+=(const Interval& other) { return *this = *this + other; }
    Interval& operator-=(const Interval& other) { return *this = *this - other; }

    /// Of what is not below zero; what of the interval is, is rounding.
    friend Interval sqrt(const Interval& a) {
        if (!(a.high_ >= 0)) return unknown();
        return {std::max(0.0, down(std::sqrt(std::max(0.0, a.low_)))), up(std::sqrt(a.high_))};
    }
    /// Tighter than a * a.
    friend Interval square(const Interval& a) {
        const double p = a.low_ * a.low_, q = a.high_ * a.high_;
        if (std::isnan(p + q)) return unknown();
        const bool zero = a.low_ <= 0 && a.high_ >= 0;
        return {zero ? 0 : std::max(0.0, down(std::min(p, q))), up(std::max(p, q))};
    }
    /// At least the distance of any of its numbers from zero.
    double magnitude() const { return std::max(std::abs(low_), std::abs(high_)); }
    double middle() const { return low_ + (high_ - low_) / 2; }
    double width() const { return up_sum(high_ - low_); }
    bool is_bounded() const { return std::isfinite(low_) && std::isfinite(high_); }
    static Interval unknown() {
        return {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    }

    /// Neither surely above nor surely below zero, nor zero itself.
    bool straddles_zero() const { return sign() == UncertainSign::undecided; }

    friend Interval lesser(const Interval& a, const Interval& b) {
        return {std::min(a.low_, b.low_), std::min(a.high_, b.high_)};
    }
    friend Interval greater(const Interval& a, const Interval& b) {
        return {std::max(a.low_, b.low_), std::max(a.high_, b.high_)};
    }
    friend bool greater_than_zero(const Interval& a) { return a.low_ > 0; }
    friend bool less_than_zero(const Interval& a) { return a.high_ < 0; }
    /// See frame.hpp: where it is not known which end comes first along d, whatever lies between them.
    friend Interval first_along(const Interval& d, const Interval& low, const Interval& high) {
        return d.low_ > 0 ? low : d.high_ < 0 ? high : Interval(low.low_, high.high_);
    }

private:
    // The nearest result is wrong by at most half an ulp, that is by less than 2^-52 of itself or, where a product
    // underflows, by the least subnormal. A sum that rounds to zero is zero.
    static double down(double r) { return r - (std::abs(r) * 0x1p-52 + 0x1p-1074); }
    static double up(double r) { return r + (std::abs(r) * 0x1p-52 + 0x1p-1074); }
    static double down_sum(double r) { return r == 0 ? 0 : down(r); }
    static double up_sum(double r) { return r == 0 ? 0 : up(r); }

    double low_ = 0, high_ = 0;
};

}  // namespace cob
