/// \file
/// A sign that may not be known: what a filter returns. Undecided is a value of its own, never a bool.
#pragma once

#include "cob/arithmetic.hpp"

namespace cob {

enum class UncertainSign : std::int8_t { negative = -1, zero = 0, positive = 1, undecided = 2 };

constexpr UncertainSign uncertain(Sign sign) {
    return static_cast<UncertainSign>(sign);
}

/// Sign of a value that is wrong by at most bound, which is not negative; undecided for NaN.
constexpr UncertainSign filtered_sign(double value, double bound) {
    return value > bound              ? UncertainSign::positive
           : value < -bound           ? UncertainSign::negative
           : bound == 0 && value == 0 ? UncertainSign::zero
                                      : UncertainSign::undecided;
}

/// A truth that may not be known.
enum class UncertainBool : std::int8_t { no = 0, yes = 1, undecided = 2 };

}  // namespace cob
