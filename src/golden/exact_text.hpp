/// \file
/// Exact coordinates as text and back, fast where they are binary64 numbers or sums of two (SPEC 7).
#pragma once

#include "cob/arithmetic.hpp"

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace cob {

/// One exact coordinate as an ExactPoint holds it: nearest + rest, or a fraction where no such pair exists.
struct ExactNumber {
    double nearest = 0, rest = 0;
    std::optional<Rational> fraction;
};

/// As parse_binary64(), several times as fast on ordinary decimals.
std::optional<double> parse_number(std::string_view text);
/// As parse_exact().
std::optional<ExactNumber> parse_exact_number(std::string_view text);
/// The point of three coordinates.
ExactPoint to_point(const std::array<ExactNumber, 3>& coordinates);

/// Appends what to_text(double) returns.
void append_number(std::string& text, double value);
/// Appends the three coordinates of a point, separated by commas, each as to_text(Rational) writes it.
void append_point(std::string& text, const ExactPoint& point);
void append_point(std::string& text, const Point& point);

}  // namespace cob
