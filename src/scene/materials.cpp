#include "scene/materials.hpp"

#include "cob/error.hpp"
#include "cob/files.hpp"
#include "scene/statements.hpp"

#include <cmath>
#include <filesystem>
#include <optional>
#include <system_error>

namespace cob {
namespace {

namespace fs = std::filesystem;

constexpr double pi = 3.14159265358979323846;

/// Statements of MTL that describe what is not simulated here: they mean something, so they are not counted.
bool is_known(std::string_view keyword) {
    static const std::set<std::string_view> known{"Ka",    "Ks",   "Ns",   "Ni",   "d",     "Tr",       "Tf",
                                                  "illum", "bump", "refl", "disp", "decal", "sharpness"};
    return known.count(keyword) > 0 || keyword.substr(0, 4) == "map_";
}

/// Red, green and blue; one value stands for all three.
std::array<double, 3> read_colour(const std::string& file, const Statement& statement) {
    std::array<double, 3> colour{};
    std::string_view rest = statement.rest;
    std::size_t count = 0;
    for (std::string_view token; !(token = take_token(rest)).empty(); ++count) {
        const auto value = parse_binary64(token);
        if (!value || count == 3)
            throw InputError("bad colour", {file, statement.line, std::string(statement.rest),
                                            "give one finite number, or three: red, green, blue"});
        colour[count] = *value;
    }
    if (count == 1) return {colour[0], colour[0], colour[0]};
    if (count != 3)
        throw InputError("bad colour", {file, statement.line, std::string(statement.rest),
                                        "give one finite number, or three: red, green, blue"});
    return colour;
}

std::array<double, 3> read_reflectance(const std::string& file, const Statement& statement) {
    const auto colour = read_colour(file, statement);
    for (const double value : colour)
        if (!(value >= 0 && value <= 1))
            throw InputError("reflectance outside [0, 1]", {file, statement.line, std::string(statement.rest),
                                                            "a diffuse surface reflects a share of 0 to 1"});
    return colour;
}

std::array<double, 3> read_exitance(const std::string& file, const Statement& statement, bool is_radiance) {
    auto colour = read_colour(file, statement);
    for (double& value : colour) {
        if (is_radiance) value *= pi;
        if (!(value >= 0 && std::isfinite(value)))
            throw InputError("emission is negative or not finite",
                             {file, statement.line, std::string(statement.rest), "give finite numbers of at least 0"});
    }
    return colour;
}

}  // namespace

void count_skipped(ReadReport& report, std::string_view keyword) {
    constexpr std::size_t longest = 24, most = 64;
    std::string name;
    for (const char c : keyword.substr(0, longest)) name += c > ' ' && c < '\x7f' ? c : '?';
    if (report.skipped.size() >= most && report.skipped.count(name) == 0) name = "(others)";
    ++report.skipped[name];
}

MaterialLibrary::MaterialLibrary(std::string scene_file, const ReadOptions& options, ReadReport& report)
    : scene_file_(std::move(scene_file)), options_(options), report_(report) {}

std::string MaterialLibrary::existing_file(std::string_view name) const {
    std::error_code error;
    const auto is_file = [&](const fs::path& path) { return fs::is_regular_file(path, error); };
    const fs::path folder = fs::path(scene_file_).parent_path();
    const fs::path as_written = folder / fs::path(name);
    if (is_file(as_written)) return as_written.string();
    const std::size_t last = name.find_last_of("/\\");
    if (last == std::string_view::npos || last + 1 == name.size()) return {};
    const fs::path beside = folder / fs::path(name.substr(last + 1));
    return is_file(beside) ? beside.string() : std::string();
}

void MaterialLibrary::read_libraries(std::string_view names) {
    // Blanks separate names and may be part of one: from each place take the longest that is a file.
    constexpr std::size_t longest = 4096;  // of a path on the systems there are
    names = without_comment(names).substr(0, longest);
    while (!names.empty()) {
        std::string file;
        std::size_t length = names.size();
        while (length > 0 && (file = existing_file(trimmed(names.substr(0, length)))).empty()) {
            const std::size_t blank = names.substr(0, length).find_last_of(" \t");
            length = blank == std::string_view::npos ? 0 : blank;
        }
        if (file.empty()) {
            length = std::min(names.find_first_of(" \t"), names.size());
            report_.warnings.push_back("material library '" + std::string(names.substr(0, length)) +
                                       "' not found: its materials are grey and do not emit");
        } else if (files_.insert(file).second) {
            read_text(read_file(file), file);
        }
        names = trimmed(names.substr(length));
    }
}

void MaterialLibrary::read_text(std::string_view text, const std::string& path) {
    StatementReader reader(text);
    Material* material = nullptr;
    for (Statement statement; reader.next(statement);) {
        if (statement.keyword == "newmtl") {
            const std::string name(statement.rest);
            const auto index = static_cast<std::int32_t>(materials_.size());
            if (!by_name_.emplace(name, index).second)
                report_.warnings.push_back("material '" + name + "' is defined twice: the first is used");
            by_name_without_comment_.emplace(without_comment(name), index);
            material = &materials_.emplace_back();
            material->name = without_comment(name);
        } else if (statement.keyword == "Kd" || statement.keyword == "Ke") {
            if (!material)
                throw InputError("no material to belong to", {path, statement.line, std::string(statement.keyword),
                                                              "begin the material with newmtl NAME"});
            if (statement.keyword == "Kd")
                material->reflectance = read_reflectance(path, statement);
            else
                material->emitted_exitance = read_exitance(path, statement, options_.emission_is_radiance);
        } else if (!is_known(statement.keyword)) {
            count_skipped(report_, statement.keyword);
        }
    }
}

std::int32_t MaterialLibrary::find(std::string_view name) {
    for (const std::string_view key : {name, without_comment(name)})
        for (const auto* map : {&by_name_, &by_name_without_comment_})
            if (const auto found = map->find(key); found != map->end()) return found->second;
    if (unknown_.emplace(name).second)
        report_.warnings.push_back("material '" + std::string(name) + "' is not defined: grey, not emitting");
    return 0;
}

}  // namespace cob
