/// \file
/// Parameters of a set: what follows from them, and as the manifest tells them.
#pragma once

#include "cob/golden.hpp"
#include "golden/number_format.hpp"

#include <map>
#include <string>

namespace cob {

/// The numbers that the questions may consist of.
NumberFormat format_of(const GoldenParameters& parameters);
/// The inverse of parameters_of().
std::map<std::string, std::string> to_text(const GoldenParameters& parameters);

}  // namespace cob
