/// \file
/// The lines of OBJ and MTL files as statements: a keyword and what follows it.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace cob {

struct Statement {
    std::string_view keyword;
    std::string_view rest;  ///< Trimmed; a trailing comment is still there.
    std::size_t line = 0;   ///< Where it begins, from 1.
};

/// Goes through a text statement by statement. Lines end in LF, CRLF or CR; a backslash before the end continues a
/// line; empty lines and comment lines are left out. The views hold until the next call and as long as the text.
class StatementReader {
public:
    explicit StatementReader(std::string_view text);

    /// False at the end.
    bool next(Statement& statement);

private:
    std::string_view logical_line();
    std::string_view physical_line();

    std::string_view text_;
    std::size_t at_ = 0, lines_ = 0;
    std::string joined_;  ///< A continued line.
};

/// Takes the next token, which ends at a blank or where a comment begins, off the front; empty at the end.
std::string_view take_token(std::string_view& rest);

std::string_view trimmed(std::string_view text);

/// A name with the comment cut off that may follow it.
std::string_view without_comment(std::string_view name);

}  // namespace cob
