/// \file
/// Text for reports.
#pragma once

#include <cstddef>
#include <string>

namespace cob {

/// printf into a string.
[[gnu::format(printf, 1, 2)]] std::string printed(const char* format, ...);

/// A line of a list: a title in a column of that width, then a value.
std::string titled_line(const std::string& title, std::size_t column, const std::string& value);

/// A cell of a comma-separated table, quoted where it must be (RFC 4180).
std::string csv_cell(const std::string& text);

}  // namespace cob
