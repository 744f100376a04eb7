/// \file
/// The one exception that input causes: what is wrong, where, and what to do about it.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>

namespace cob {

/// Bad input: a file, a table or an option whose value cannot be used. The message is one line,
/// "file:line: problem 'value': remedy", without the parts that are not known. Exit code 2 of every command.
class InputError : public std::runtime_error {
public:
    /// Where the trouble is and how to end it.
    struct Where {
        std::string file;      ///< Path as the user gave it; empty: not in a file.
        std::size_t line = 0;  ///< Line, from 1; 0: the file as a whole.
        std::string value;     ///< The offending text as it stands there; shortened to 60 characters.
        std::string remedy;    ///< What to do, as an imperative.
    };

    InputError(const std::string& problem, Where where);
    explicit InputError(const std::string& problem);

    const Where& where() const noexcept { return where_; }

private:
    Where where_;
};

}  // namespace cob
