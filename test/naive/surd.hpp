/// \file
/// Numbers of the form a + b sqrt(c): all that a box's irrational height (SPEC 4) can lead to.
#pragma once

#include "cob/arithmetic.hpp"

namespace cob::naive {

/// a + b sqrt(c), exactly; numbers that meet in an operation have one c >= 0 in common, or no root.
class Surd {
public:
    Surd() = default;
    Surd(const Rational& rational) : a_(rational) {}  // NOLINT: implicit, every fraction is one
    static Surd root(const Rational& c) {
        Surd result;
        result.b_ = 1;
        result.c_ = c;
        return result;
    }

    friend Surd operator+(const Surd& x, const Surd& y) { return {x.a_ + y.a_, x.b_ + y.b_, common(x, y)}; }
    friend Surd operator-(const Surd& x, const Surd& y) { return {x.a_ - y.a_, x.b_ - y.b_, common(x, y)}; }
    friend Surd operator*(const Surd& x, const Rational& factor) { return {x.a_ * factor, x.b_ * factor, x.c_}; }
    friend Surd operator/(const Surd& x, const Rational& divisor) { return {x.a_ / divisor, x.b_ / divisor, x.c_}; }

    /// -1, 0 or 1. Where a and b sqrt(c) differ in sign the larger square wins.
    int sign() const {
        const int a = a_.sign(), b = c_ == 0 ? 0 : b_.sign();
        if (a == b || b == 0) return a;
        if (a == 0) return b;
        const Rational difference = a_ * a_ - b_ * b_ * c_;
        return difference > 0 ? a : difference < 0 ? b : 0;
    }
    friend bool operator<(const Surd& x, const Surd& y) { return (x - y).sign() < 0; }

private:
    Surd(Rational a, Rational b, Rational c) : a_(std::move(a)), b_(std::move(b)), c_(std::move(c)) {}
    static const Rational& common(const Surd& x, const Surd& y) { return x.b_ == 0 ? y.c_ : x.c_; }

    Rational a_, b_, c_;
};

}  // namespace cob::naive
