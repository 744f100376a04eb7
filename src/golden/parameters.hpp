/// \file
/// Parameters of a set as the manifest tells them.
#pragma once

#include "cob/golden.hpp"

#include <map>
#include <string>

namespace cob {

/// The inverse of parameters_of().
std::map<std::string, std::string> to_text(const GoldenParameters& parameters);

}  // namespace cob
