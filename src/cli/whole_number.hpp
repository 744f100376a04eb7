/// \file
/// A check of options that count.
#pragma once

#include <CLI/CLI.hpp>

#include <string>

namespace cob::cli {

/// Digits alone: CLI11 takes -1 for the largest number of an unsigned type.
inline CLI::Validator whole_number() {
    const auto check = [](const std::string& text) -> std::string {
        const bool digits = !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
        return digits ? "" : "'" + text + "' is no whole number: write 0 or more";
    };
    return {check, ""};
}

}  // namespace cob::cli
