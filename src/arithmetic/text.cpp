#include "arithmetic/text.hpp"

#include <locale.h>
#include <algorithm>
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

std::string printed_with(int digits, double value) {
    char text[64];
    std::snprintf(text, sizeof text, "%.*g", digits, value);
    return text;
}

/// Binary64 holds it with all its digits, or it is zero.
bool is_normal(double nearest, const Rational& value) {
    return std::isnormal(nearest) || value == 0;
}

}  // namespace

std::string one_line(std::string text) {
    std::replace_if(
        text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }, '?');
    return text;
}

Integer decimal_integer(std::string_view text) {
    const bool negative = text.front() == '-';
    const std::size_t first = text.find_first_of("123456789");
    if (first == std::string_view::npos) return 0;
    const Integer value{std::string(text.substr(first))};
    return negative ? Integer(-value) : value;
}

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
    if (error == std::errc::invalid_argument || stop != end) return std::nullopt;
    if (error == std::errc::result_out_of_range) {
        // from_chars does not say which way; strtod rounds correctly and does. The C locale has no other point.
        static const locale_t c_locale = ::newlocale(LC_ALL_MASK, "C", locale_t{});
        const std::string copy((hex ? "0x" : "") + std::string(digits));
        value = ::strtod_l(copy.c_str(), nullptr, c_locale);
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
    const Integer q = decimal_integer(denominator);
    if (q <= 0) return std::nullopt;
    return Rational(decimal_integer(numerator), q);
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

std::string rounded_text(const Rational& value, int digits) {
    const double nearest = to_nearest(value);
    if (is_normal(nearest, value)) return printed_with(digits, nearest);
    return boost::multiprecision::mpf_float_50(value).str(digits);
}

std::string rounded_root_text(const Rational& squared, int digits) {
    const double nearest = to_nearest(squared);
    if (is_normal(nearest, squared)) return printed_with(digits, std::sqrt(nearest));
    return boost::multiprecision::mpf_float_50(sqrt(boost::multiprecision::mpf_float_50(squared))).str(digits);
}

std::string scaled_text(double value, int exponent) {
    const double scaled = std::scalbn(value, exponent);
    if (std::isnormal(scaled) || value == 0) return to_text(scaled);
    return boost::multiprecision::mpf_float_50(ldexp(boost::multiprecision::mpf_float_50(value), exponent)).str(17);
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
    Integer p = abs(numerator(value)), q = denominator(value);
    long exponent = static_cast<long>(msb(p)) - static_cast<long>(msb(q));  // 2^(e-1) < |value| < 2^(e+1)
    if (exponent > 1025) return sign * std::numeric_limits<double>::infinity();
    if (exponent < -1080) return sign * 0.0;
    const auto shifted = [](const Integer& n, long bits) { return bits > 0 ? Integer(n << bits) : n; };
    if (shifted(q, exponent) > shifted(p, -exponent)) --exponent;  // 2^e <= |value|
    const long shift = std::min(52 - exponent, 1074L);
    p = shifted(p, shift);
    q = shifted(q, -shift);
    Integer quotient, remainder;
    divide_qr(p, q, quotient, remainder);
    const Integer twice = 2 * remainder;
    if (twice > q || (twice == q && bit_test(quotient, 0))) quotient += 1;
    return sign * std::ldexp(quotient.convert_to<double>(), static_cast<int>(-shift));
}

std::optional<double> to_binary64(const Rational& value) {
    // Nearly always up to 53 bits over a power of two, each a word long: margins, heights, parameters of points.
    const auto& p = *mpq_numref(value.backend().data());
    const auto& q = *mpq_denref(value.backend().data());
    if (mpz_size(&p) <= 1 && mpz_size(&q) == 1) {
        const mp_limb_t over = mpz_getlimbn(&p, 0), under = mpz_getlimbn(&q, 0);
        if (over >> 53 == 0 && (under & (under - 1)) == 0) {
            const double magnitude = static_cast<double>(over) / static_cast<double>(under);
            return mpz_sgn(&p) < 0 ? -magnitude : magnitude;
        }
    }
    // GMP truncates, which changes nothing where the value is a binary64 number: the usual case, and a cheap one.
    const double truncated = value.convert_to<double>();
    if (std::isfinite(truncated) && Rational(truncated) == value) return truncated;
    const double number = to_nearest(value);
    if (std::isfinite(number) && Rational(number) == value) return number;
    return std::nullopt;
}

}  // namespace cob
