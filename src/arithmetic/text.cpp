#include "cob/arithmetic.hpp"

#include <locale.h>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>

namespace cob {
namespace {

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

/// Whole decimal integers only: what GMP would accept beyond that (blanks, other bases) is not a number here.
bool is_integer(std::string_view text) {
    if (!text.empty() && (text.front() == '-' || text.front() == '+')) text.remove_prefix(1);
    if (text.empty()) return false;
    for (const char c : text)
        if (!is_digit(c)) return false;
    return true;
}

Integer to_integer(std::string_view text) {
    if (text.front() == '+') text.remove_prefix(1);
    return Integer(std::string(text));
}

}  // namespace

std::optional<double> parse_binary64(std::string_view text) {
    const bool negative = !text.empty() && text.front() == '-';
    std::string_view digits = text;
    if (!digits.empty() && (digits.front() == '-' || digits.front() == '+')) digits.remove_prefix(1);
    const bool hex = digits.size() > 2 && digits[0] == '0' && (digits[1] == 'x' || digits[1] == 'X');
    if (hex) digits.remove_prefix(2);
    if (digits.empty() || digits.front() == '-' || digits.front() == '+') return std::nullopt;
    if (digits.front() == 'i' || digits.front() == 'I' || digits.front() == 'n' || digits.front() == 'N')
        return std::nullopt;  // infinity and NaN are words, not numbers

    double value = 0;
    const char* end = digits.data() + digits.size();
    const auto [stop, error] =
        std::from_chars(digits.data(), end, value, hex ? std::chars_format::hex : std::chars_format::general);
    if (error == std::errc::invalid_argument || stop != end) {
        // C writes a hex exponent alone ("0x1p3") as well as a decimal one; everything else is not a number.
        return std::nullopt;
    }
    if (error == std::errc::result_out_of_range) {
        // from_chars does not say which way; strtod rounds correctly and does. The C locale has no other point.
        static const locale_t c_locale = ::newlocale(LC_ALL_MASK, "C", locale_t{});
        const std::string copy((hex ? "0x" : "") + std::string(digits));
        value = ::strtod_l(copy.c_str(), nullptr, c_locale);
        if (!std::isfinite(value)) return std::nullopt;
    }
    if (!std::isfinite(value)) return std::nullopt;
    return negative ? -value : value;
}

std::optional<Rational> parse_exact(std::string_view text) {
    const std::size_t slash = text.find('/');
    if (slash == std::string_view::npos) {
        const auto value = parse_binary64(text);
        return value ? std::optional<Rational>(Rational(*value)) : std::nullopt;
    }
    const std::string_view numerator = text.substr(0, slash), denominator = text.substr(slash + 1);
    if (!is_integer(numerator) || !is_integer(denominator)) return std::nullopt;
    const Integer q = to_integer(denominator);
    if (q <= 0) return std::nullopt;
    return Rational(to_integer(numerator), q);
}

std::string to_text(double value) {
    if (value == 0) return "0";  // -0 and 0 are one number
    char text[32];
    const auto result = std::to_chars(text, text + sizeof text, value);
    return std::string(text, result.ptr);
}

std::string to_text(const Rational& value) {
    const auto number = to_binary64(value);
    if (number) return to_text(*number);
    return denominator(value) == 1 ? value.str() + "/1" : value.str();
}

std::string to_hex_text(double value) {
    char text[40];
    std::snprintf(text, sizeof text, "%a", value);
    return text;
}

double to_nearest(const Rational& value) {
    // mpq_get_d truncates, so round here: to 53 bits or to the subnormal grid, half to even.
    const int sign = value.sign();
    if (sign == 0) return 0;
    Integer p = abs(numerator(value));
    const Integer q = denominator(value);
    long exponent = static_cast<long>(msb(p)) - static_cast<long>(msb(q));  // 2^(e-1) < |value| < 2^(e+1)
    if (exponent > 1025) return sign * std::numeric_limits<double>::infinity();
    if (exponent < -1080) return sign * 0.0;
    long shift = 54 - exponent;      // at least 54 significant bits before rounding
    if (shift > 1074) shift = 1074;  // never below the subnormal grid
    Integer scaled_p = p, scaled_q = q;
    if (shift >= 0)
        scaled_p <<= static_cast<unsigned long>(shift);
    else
        scaled_q <<= static_cast<unsigned long>(-shift);
    Integer quotient, remainder;
    divide_qr(scaled_p, scaled_q, quotient, remainder);
    // Drop all but 53 bits, with everything below as a sticky remainder.
    if (quotient != 0) {
        const long excess = static_cast<long>(msb(quotient)) + 1 - 53;
        if (excess > 0) {
            const unsigned long bits = static_cast<unsigned long>(excess);
            const Integer kept = quotient >> bits;
            const Integer dropped = quotient - (kept << bits);
            const Integer half = Integer(1) << (bits - 1);
            const bool up = dropped > half || (dropped == half && (remainder != 0 || bit_test(kept, 0)));
            quotient = up ? Integer(kept + 1) : kept;
            shift -= excess;
            return sign * std::ldexp(quotient.convert_to<double>(), static_cast<int>(-shift));
        }
    }
    const Integer twice = 2 * remainder;
    if (twice > scaled_q || (twice == scaled_q && bit_test(quotient, 0))) quotient += 1;
    return sign * std::ldexp(quotient.convert_to<double>(), static_cast<int>(-shift));
}

std::optional<double> to_binary64(const Rational& value) {
    // GMP truncates, which changes nothing where the value is a binary64 number: the usual case, and a cheap one.
    const double truncated = value.convert_to<double>();
    if (std::isfinite(truncated) && Rational(truncated) == value) return truncated;
    const double number = to_nearest(value);
    if (std::isfinite(number) && Rational(number) == value) return number;
    return std::nullopt;
}

}  // namespace cob
