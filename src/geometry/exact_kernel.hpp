/// \file
/// Signs in fractions, with the box's irrational height compared by squares.
#pragma once

#include "arithmetic/uncertain_sign.hpp"
#include "geometry/frame.hpp"

namespace cob {

/// Sign of a + b sqrt(square), square >= 0.
inline Sign sign_with_root(const Rational& a, const Rational& b, const Rational& square) {
    const Sign sa = sign_of(a), sb = square == 0 ? Sign::zero : sign_of(b);
    if (sa == Sign::zero || sa == sb) return sb == Sign::zero ? sa : sb;
    if (sb == Sign::zero) return sa;
    return sa * sign_of(Rational(a * a - b * b * square));
}

/// The kernel of separate() over fractions: never undecided.
class RationalKernel {
public:
    using Number = Rational;

    /// rise_squared: the square of what high.z of the FrameBox lacks to the top; 0 where it lacks nothing.
    explicit RationalKernel(const Rational& rise_squared) : rise_squared_(rise_squared) {}

    UncertainSign face(const Number& gap, int) const { return uncertain(sign_of(gap)); }
    UncertainSign base(const Number& gap) const { return uncertain(sign_of(gap)); }
    UncertainSign top(const Number& gap) const { return uncertain(sign_with_root(gap, -1, rise_squared_)); }
    UncertainSign edge(const Number& gap, const Vector3<Number>& d, bool at_top) const {
        return uncertain(at_top ? sign_with_root(gap, d.z, rise_squared_) : sign_of(gap));
    }
    template <class Offset>
    UncertainSign plane(const Number& gap, const Vector3<Number>& d, const Offset&, bool at_top) const {
        return edge(gap, d, at_top);
    }
    UncertainSign turn(const Number& value, int) const { return uncertain(sign_of(value)); }

private:
    const Rational& rise_squared_;
};

}  // namespace cob
