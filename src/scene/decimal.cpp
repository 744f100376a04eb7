// Which polygons are planar in the decimal text of their file, although not with the binary64 numbers nearest to it.
#include "arithmetic/text.hpp"
#include "cob/census.hpp"
#include "cob/files.hpp"
#include "scene/statements.hpp"

#include <charconv>
#include <optional>

namespace cob {
namespace {

/// A decimal number as an exact fraction. Hex-floats count as the binary64 number they denote, and so do decimals with
/// an exponent that no coordinate needs.
Rational exact_decimal(std::string_view text) {
    const auto as_binary64 = [&] { return Rational(parse_binary64(text).value_or(0)); };
    if (text.find_first_of("xX") != std::string_view::npos) return as_binary64();
    long exponent = 0;
    std::string_view digits = text;
    if (const std::size_t e = text.find_first_of("eE"); e != std::string_view::npos) {
        digits = text.substr(0, e);
        std::string_view power = text.substr(e + 1);
        if (!power.empty() && power.front() == '+') power.remove_prefix(1);
        constexpr long largest = 400;
        const auto [stop, error] = std::from_chars(power.data(), power.data() + power.size(), exponent);
        if (error != std::errc() || stop != power.data() + power.size() || std::abs(exponent) > largest)
            return as_binary64();
    }
    std::string integer;
    for (const char c : digits)
        if (c != '.') integer += c;
    if (const std::size_t point = digits.find('.'); point != std::string_view::npos)
        exponent -= static_cast<long>(digits.size() - point - 1);
    const Integer power = boost::multiprecision::pow(Integer(10), static_cast<unsigned>(std::abs(exponent)));
    const Integer value = decimal_integer(integer);
    return exponent < 0 ? Rational(value, power) : Rational(value * power);
}

/// The texts of the coordinates of all vertices of an OBJ file.
std::vector<std::array<std::string, 3>> coordinate_texts(const std::string& path) {
    const std::string content = read_file(path);
    std::vector<std::array<std::string, 3>> texts;
    StatementReader reader(content);
    for (Statement statement; reader.next(statement);)
        if (statement.keyword == "v") {
            std::string_view rest = statement.rest;
            texts.emplace_back();
            for (std::string& text : texts.back()) text = take_token(rest);
        }
    return texts;
}

bool is_planar(const std::vector<RationalPoint>& corners) {
    const RationalPoint zero;
    RationalPoint step, normal;
    for (const RationalPoint& corner : corners) {
        const RationalPoint along = corner - corners.front();
        if (step == zero)
            step = along;
        else if (normal == zero)
            normal = cross(step, along);
        else if (dot(normal, along) != 0)
            return false;
    }
    return true;
}

}  // namespace

std::vector<PolygonId> planar_as_decimal(const Scene& scene, const std::string& path) {
    std::vector<PolygonId> planar;
    const auto texts = coordinate_texts(path);
    for (PolygonId id = 0; id < scene.polygon_count(); ++id) {
        if (!scene.polygon(id).valid || scene.polygon(id).planar) continue;
        std::vector<RationalPoint> corners;
        for (const VertexId corner : scene.loop(id)) {
            const auto& text = texts.at(static_cast<std::size_t>(corner));
            corners.push_back({exact_decimal(text[0]), exact_decimal(text[1]), exact_decimal(text[2])});
        }
        if (is_planar(corners)) planar.push_back(id);
    }
    return planar;
}

}  // namespace cob
