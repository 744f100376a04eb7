/// \file
/// Enclosures of functions that no standard bounds: by series whose remainders are known, in interval arithmetic.
#pragma once

#include "arithmetic/interval.hpp"

namespace cob {

inline constexpr double pi_low = 0x1.921fb54442d18p+1;  ///< The binary64 number below pi.
inline Interval pi_interval() {
    return {pi_low, std::nextafter(pi_low, 4.0)};
}

/// Natural logarithm; its low end is -infinity where the argument may be zero.
Interval log(const Interval& x);
/// Angle of the points (x, y) of a box, in [-pi, pi]; everything where the box meets the cut x <= 0, y = 0.
Interval atan2(const Interval& y, const Interval& x);

}  // namespace cob
