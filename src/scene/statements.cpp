#include "scene/statements.hpp"

namespace cob {
namespace {

constexpr bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

}  // namespace

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
    while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
    return text;
}

std::string_view take_token(std::string_view& rest) {
    rest = trimmed(rest);
    if (!rest.empty() && rest.front() == '#') rest = {};
    std::size_t length = 0;
    while (length < rest.size() && !is_blank(rest[length]) && rest[length] != '#') ++length;
    const std::string_view token = rest.substr(0, length);
    rest.remove_prefix(length);
    return token;
}

std::string_view without_comment(std::string_view name) {
    for (std::size_t k = 0; k < name.size(); ++k)
        if (name[k] == '#' && (k == 0 || is_blank(name[k - 1]))) return trimmed(name.substr(0, k));
    return name;
}

StatementReader::StatementReader(std::string_view text) : text_(text) {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    if (text_.substr(0, byte_order_mark.size()) == byte_order_mark) at_ = byte_order_mark.size();
}

bool StatementReader::next(Statement& statement) {
    while (at_ < text_.size()) {
        const std::size_t line = lines_ + 1;
        const std::string_view content = trimmed(logical_line());
        if (content.empty() || content.front() == '#') continue;
        std::size_t length = 0;
        while (length < content.size() && !is_blank(content[length])) ++length;
        statement = {content.substr(0, length), trimmed(content.substr(length)), line};
        return true;
    }
    return false;
}

std::string_view StatementReader::logical_line() {
    std::string_view line = physical_line();
    // A comment ends with its line, be it a path of Windows'.
    if (line.empty() || line.back() != '\\' || trimmed(line).substr(0, 1) == "#") return line;
    joined_.clear();
    while (!line.empty() && line.back() == '\\') {
        joined_.append(line.substr(0, line.size() - 1));
        joined_ += ' ';
        if (at_ >= text_.size()) return joined_;
        line = physical_line();
    }
    joined_.append(line);
    return joined_;
}

std::string_view StatementReader::physical_line() {
    ++lines_;
    const std::size_t begin = at_;
    std::size_t end = begin;
    while (end < text_.size() && text_[end] != '\n' && text_[end] != '\r') ++end;
    at_ = end;
    if (at_ < text_.size()) at_ += text_.substr(at_, 2) == "\r\n" ? 2 : 1;
    return text_.substr(begin, end - begin);
}

}  // namespace cob
