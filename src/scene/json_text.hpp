/// \file
/// JSON as it is written to files.
#pragma once

#include <nlohmann/json.hpp>

#include <string>

namespace cob {

/// Indented, with a line end. JSON is UTF-8; paths and names in files may be in any encoding: what is no UTF-8 becomes
/// U+FFFD.
inline std::string json_text(const nlohmann::ordered_json& json) {
    return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace cob
