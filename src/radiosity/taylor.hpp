/// \file
/// Truncated Taylor polynomials in one or two variables with interval coefficients, and functions of them.
///
/// A polynomial is kept by its homogeneous parts. Degree k of a function then follows from lower degrees by the same
/// recurrences for one variable and for two: Euler's operator, which multiplies the part of degree k by k, is a
/// derivation (Griewank and Walther 2008, section 13.2). With coefficients that hold for every point of a region, the
/// parts of the highest degree are Lagrange's remainder for any base point in it (Moore 1966).
#pragma once

#include "arithmetic/interval_functions.hpp"

#include <array>

namespace cob::radiosity {

template <int variables, int order>
class Taylor {
    static_assert(variables == 1 || variables == 2);

public:
    static constexpr int size_of(int k) { return variables == 1 ? 1 : k + 1; }
    static constexpr int start_of(int k) { return variables == 1 ? k : k * (k + 1) / 2; }
    static constexpr int size = start_of(order + 1);

    Taylor() = default;
    Taylor(const Interval& constant) : degree_(0) { coefficients_[0] = constant; }  // NOLINT: implicit, a number
    Taylor(double constant) : Taylor(Interval(constant)) {}                         // NOLINT

    /// Coefficient of u^(k - j) v^j.
    const Interval& at(int k, int j = 0) const { return coefficients_[static_cast<std::size_t>(start_of(k) + j)]; }
    void set(int k, int j, const Interval& value) {
        coefficients_[static_cast<std::size_t>(start_of(k) + j)] = value;
        degree_ = std::max(degree_, k);
    }

    friend Taylor operator+(const Taylor& a, const Taylor& b) {
        Taylor result = a;
        result.degree_ = std::max(a.degree_, b.degree_);
        for (std::size_t i = 0; i < end(b.degree_); ++i) result.coefficients_[i] += b.coefficients_[i];
        return result;
    }
    friend Taylor operator-(const Taylor& a) {
        Taylor result = a;
        for (std::size_t i = 0; i < end(a.degree_); ++i) result.coefficients_[i] = -a.coefficients_[i];
        return result;
    }
    friend Taylor operator-(const Taylor& a, const Taylor& b) { return a + -b; }
    friend Taylor operator*(const Taylor& a, const Taylor& b) {
        Taylor result;
        result.degree_ = std::min(order, a.degree_ + b.degree_);
        for (int i = 0; i <= a.degree_; ++i)
            for (int k = i; k <= std::min(order, i + b.degree_); ++k) result.add_product(a, i, b, k);
        return result;
    }
    friend Taylor operator/(const Taylor& a, const Taylor& b) {
        const Interval inverse = Interval(1) / b.at(0);
        Taylor result = a;
        result.degree_ = order;
        for (int k = 0; k <= order; ++k) {
            for (int i = std::max(0, k - b.degree_); i < k; ++i) result.subtract_product(result, i, b, k);
            result.scale(k, inverse);
        }
        return result;
    }
    friend Taylor sqrt(const Taylor& a) {
        Taylor result = a;
        result.degree_ = order;
        result.set(0, 0, sqrt(a.at(0)));
        const Interval inverse = Interval(1) / (Interval(2) * result.at(0));
        for (int k = 1; k <= order; ++k) {
            for (int i = 1; i < k; ++i) result.subtract_product(result, i, result, k);
            result.scale(k, inverse);
        }
        return result;
    }
    /// E log a = E a / a, with E Euler's operator.
    friend Taylor log(const Taylor& a) { return integrated(log(a.at(0)), euler(a) / a); }
    /// E atan2(y, x) = (x E y - y E x) / (x^2 + y^2).
    friend Taylor atan2(const Taylor& y, const Taylor& x) {
        return integrated(atan2(y.at(0), x.at(0)), (x * euler(y) - y * euler(x)) / (x * x + y * y));
    }

private:
    static constexpr std::size_t end(int degree) { return static_cast<std::size_t>(start_of(degree + 1)); }

    /// Adds part i of a times part k - i of b to part k.
    void add_product(const Taylor& a, int i, const Taylor& b, int k) {
        for (int p = 0; p < size_of(i); ++p)
            for (int q = 0; q < size_of(k - i); ++q)
                coefficients_[static_cast<std::size_t>(start_of(k) + p + q)] += a.at(i, p) * b.at(k - i, q);
    }
    void subtract_product(const Taylor& a, int i, const Taylor& b, int k) {
        for (int p = 0; p < size_of(i); ++p)
            for (int q = 0; q < size_of(k - i); ++q)
                coefficients_[static_cast<std::size_t>(start_of(k) + p + q)] -= a.at(i, p) * b.at(k - i, q);
    }
    void scale(int k, const Interval& factor) {
        for (int j = 0; j < size_of(k); ++j) {
            Interval& c = coefficients_[static_cast<std::size_t>(start_of(k) + j)];
            c = c * factor;
        }
    }
    static Taylor euler(Taylor a) {
        for (int k = 0; k <= a.degree_; ++k) a.scale(k, Interval(k));
        return a;
    }
    static Taylor integrated(const Interval& constant, Taylor derivative) {
        derivative.degree_ = order;
        derivative.set(0, 0, constant);
        for (int k = 1; k <= order; ++k) derivative.scale(k, Interval(1) / Interval(k));
        return derivative;
    }

    std::array<Interval, static_cast<std::size_t>(size)> coefficients_{};
    int degree_ = 0;  ///< All parts above are zero.
};

}  // namespace cob::radiosity
