#include "cob/error.hpp"

namespace cob {
namespace {

std::string shortened(const std::string& value) {
    constexpr std::size_t longest = 60;
    std::string text;
    for (const char c : value.substr(0, longest)) text += static_cast<unsigned char>(c) < 0x20 ? '?' : c;
    return value.size() > longest ? text + "..." : text;
}

std::string message(const std::string& problem, const InputError::Where& where) {
    std::string text;
    if (!where.file.empty()) text += where.file + ":";
    if (where.line > 0) text += std::to_string(where.line) + ":";
    if (!text.empty()) text += " ";
    text += problem;
    if (!where.value.empty()) text += " '" + shortened(where.value) + "'";
    if (!where.remedy.empty()) text += ": " + where.remedy;
    return text;
}

}  // namespace

InputError::InputError(const std::string& problem, Where where)
    : std::runtime_error(message(problem, where)), where_(std::move(where)) {}

InputError::InputError(const std::string& problem) : InputError(problem, Where{}) {}

}  // namespace cob
