/// \file
/// Numbers in text beyond what cob/arithmetic.hpp offers.
#pragma once

#include "cob/arithmetic.hpp"

#include <string>
#include <string_view>

namespace cob {

/// Of decimal digits behind an optional sign, leading zeros included, which Boost would take for another base.
Integer decimal_integer(std::string_view text);

/// With question marks for line breaks and other control characters: file names may hold any.
std::string one_line(std::string text);

/// With so many digits, also where binary64 holds no such number: "1.5625e+600".
std::string rounded_text(const Rational& value, int digits);
/// The same of the square root of a value that is not negative.
std::string rounded_root_text(const Rational& squared, int digits);
/// value x 2^exponent: to_text() where binary64 holds it, else with 17 digits.
std::string scaled_text(double value, int exponent);

}  // namespace cob
