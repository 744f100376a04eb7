/// \file
/// Exact comparisons of squared lengths of binary64 points: filter first, then fixed-width
/// integers, then fractions.
#pragma once

#include "cob/arithmetic.hpp"

namespace cob {

/// Sign of |b - a|^2 - |d - c|^2.
Sign compare_lengths(const Point& a, const Point& b, const Point& c, const Point& d);

/// Sign of |b - a|^2 - (length 2^exponent)^2; length > 0 and finite.
Sign compare_length(const Point& a, const Point& b, double length, int exponent);

}  // namespace cob
