/// \file
/// What is left out of a scene, and why, for `cob info` and the summaries.
#pragma once

#include "cob/omissions.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace cob {

/// One row for each omission that is made, and for each that is turned off although it were possible; titles in a
/// column of that width. Empty where there are none.
std::string left_out_rows(const Omissions& omissions, std::size_t column);
/// The same of all omissions, and of those that the scene does not allow the reason against them.
std::string omission_rows(const Omissions& omissions);
/// An object by name: left_out, possible, kept, reason.
nlohmann::ordered_json omissions_json(const Omissions& omissions);

}  // namespace cob
