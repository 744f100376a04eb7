/// \file
/// Signs of short coordinates, in binary64 alone: no bound, nothing undecided.
///
/// Let every coordinate of a query be a multiple of one step s, a power of two, and at most 2^24 s. Then
///   differences are at most 2^25 s, products of two of them 2^50 s^2, and their sums 2^51 s^2: gaps along e x k and
///       the components of N of a triangle or quadrilateral are integers of less than 53 bits, times s^2, and exact;
///   the products of N with differences are at most 2^76 s^3, a gap along N, the sum of three, is wrong by less than
///       2^27 s^3, whichever corner is first (rounding keeps order); where that leaves its sign open, N is split at
///       2^26 s^2 into parts of which the sums of products, at most 3 * 2^50 times 2^26 s^3 and s^3, are exact. The
///       sum of the two sums has the right sign, as has every sum of two numbers.
/// Ties are the ordinary case of scenes that are drawn on a grid, and this costs no more than a filter.
#pragma once

#include "arithmetic/uncertain_sign.hpp"
#include "cob/scene.hpp"
#include "geometry/frame.hpp"

#include <cmath>
#include <cstdint>
#include <cstring>

namespace cob {

/// The steps, powers of two, of which everything of a box is a multiple.
struct GridSteps {
    double least = 1, greatest = 0;  ///< None where least > greatest.

    bool contain(double step) const { return least <= step && step <= greatest; }
};

/// The step of which M is less than 2^24, the finest that GridKernel admits; M > 0 and not subnormal.
inline double grid_step(double largest) {
    std::uint64_t bits;
    std::memcpy(&bits, &largest, sizeof bits);
    bits &= std::uint64_t{0x7ff} << 52;  // 2^e <= M < 2^(e + 1)
    double power;
    std::memcpy(&power, &bits, sizeof power);
    return power * 0x1p-23;
}

/// Whether all coordinates are multiples of the step; for absolute values below 2^51 steps.
inline bool on_grid(const Point& p, double step) {
    // One unit in the last place of a number of this size is a step.
    const double large = 0x1.8p52 * step;
    return (p.x + large) - large == p.x && (p.y + large) - large == p.y && (p.z + large) - large == p.z;
}

class GridKernel {
public:
    using Number = double;
    static constexpr int most_corners = 4;  ///< Of the piece.

    explicit GridKernel(double step) : splitter_(0x1.8p78 * step * step), plane_bound_(0x1p27 * step * step * step) {}

    UncertainSign face(double gap, int) const { return uncertain(sign_of(gap)); }
    UncertainSign base(double gap) const { return uncertain(sign_of(gap)); }
    UncertainSign top(double gap) const { return uncertain(sign_of(gap)); }
    UncertainSign edge(double gap, const Vector3<double>&, bool) const { return uncertain(sign_of(gap)); }
    UncertainSign turn(double value, int) const { return uncertain(sign_of(value)); }

    template <class Offset>
    UncertainSign plane(double gap, const Vector3<double>& d, const Offset& offset, bool) const {
        if (std::abs(gap) > plane_bound_) return uncertain(sign_of(gap));
        const Vector3<double> c = offset();
        const Vector3<double> high = {upper(d.x), upper(d.y), upper(d.z)};
        return uncertain(sign_of(dot(high, c) + dot(d - high, c)));
    }

private:
    /// The nearest multiple of 2^26 s^2.
    double upper(double value) const { return (value + splitter_) - splitter_; }

    double splitter_, plane_bound_;
};

}  // namespace cob
