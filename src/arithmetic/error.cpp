#include "cob/error.hpp"

#include "arithmetic/text.hpp"

namespace cob {
namespace {

std::string shortened(const std::string& value) {
    constexpr std::size_t longest = 60;
    return value.size() > longest ? value.substr(0, longest) + "..." : value;
}

std::string message(const std::string& problem, const InputError::Where& where) {
    std::string text;
    if (!where.file.empty()) text += where.file + ":";
    if (where.line > 0) text += std::to_string(where.line) + ":";
    if (!text.empty()) text += " ";
    text += problem;
    if (!where.value.empty()) text += " '" + shortened(where.value) + "'";
    if (!where.remedy.empty()) text += ": " + where.remedy;
    return one_line(std::move(text));
}

}  // namespace

InputError::InputError(const std::string& problem, Where where)
    : std::runtime_error(message(problem, where)), where_(std::move(where)) {}

InputError::InputError(const std::string& problem) : InputError(problem, Where{}) {}

}  // namespace cob
