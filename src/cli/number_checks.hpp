/// \file
/// Checks of numbers that let nothing through that CLI11's own do.
#pragma once

#include <CLI/CLI.hpp>

#include <cmath>
#include <cstdlib>
#include <string>

namespace cob::cli {

inline bool is_whole_number(const std::string& text) {
    return !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
}

/// Digits alone: CLI11 takes -1 for the largest number of an unsigned type.
inline CLI::Validator whole_number() {
    const auto check = [](const std::string& text) -> std::string {
        return is_whole_number(text) ? "" : "'" + text + "' is no whole number: write 0 or more";
    };
    return {check, ""};
}

/// The same, and above 0.
inline CLI::Validator positive_whole_number() {
    const auto check = [](const std::string& text) -> std::string {
        const bool positive = is_whole_number(text) && text.find_first_not_of('0') != std::string::npos;
        return positive ? "" : "'" + text + "' is no whole number above 0";
    };
    return {check, ""};
}

/// No NaN, which is in every range of CLI11, and no infinity.
inline CLI::Validator finite() {
    const auto check = [](const std::string& text) -> std::string {
        return std::isfinite(std::strtod(text.c_str(), nullptr)) ? "" : "'" + text + "' is no finite number";
    };
    return {check, ""};
}

/// Finite and at least 0.
inline CLI::Validator not_negative() {
    const auto check = [](const std::string& text) -> std::string {
        const double value = std::strtod(text.c_str(), nullptr);
        return std::isfinite(value) && value >= 0 ? "" : "'" + text + "' is no finite number from 0 up";
    };
    return {check, ""};
}

}  // namespace cob::cli
