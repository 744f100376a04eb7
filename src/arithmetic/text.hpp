/// \file
/// Numbers in text beyond what cob/arithmetic.hpp offers.
#pragma once

#include "cob/arithmetic.hpp"

#include <string_view>

namespace cob {

/// Of decimal digits behind an optional sign, leading zeros included, which Boost would take for another base.
Integer decimal_integer(std::string_view text);

}  // namespace cob
