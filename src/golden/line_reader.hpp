/// \file
/// Lines and fields of a table, with what an error message needs. Throws InputError.
#pragma once

#include "cob/arithmetic.hpp"
#include "cob/scene.hpp"
#include "golden/exact_text.hpp"

#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace cob {

/// Reads a text file line by line through one block.
class LineReader {
public:
    explicit LineReader(std::string path);

    /// The next line without its LF or CRLF, valid until the next call; false at the end of the file. A last line
    /// that does not end is refused: the table was cut off.
    bool next(std::string_view& line);
    std::size_t line_number() const { return line_number_; }

    [[noreturn]] void refuse(const std::string& problem, std::string_view value, const std::string& remedy) const;

private:
    struct Close {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };

    bool fill();

    std::string path_;
    std::unique_ptr<std::FILE, Close> file_;
    std::vector<char> block_;
    std::size_t begin_ = 0, end_ = 0;  ///< Unread part of the block.
    std::size_t line_number_ = 0;
    bool finished_ = false;
};

/// Takes a line apart, field by field, strictly.
class Fields {
public:
    /// header: the column names, for messages and for their number.
    /// undecided: the word is accepted where a row has a place for it.
    Fields(const LineReader& reader, std::string_view header, std::string_view line, bool undecided = false)
        : reader_(reader), header_(header), line_(line), rest_(line), undecided_(undecided) {}

    std::string_view text();
    std::int64_t id();
    std::int64_t integer(std::int64_t least, std::int64_t most);
    PolygonId polygon();                          ///< 0 or more.
    PolygonId polygon_or_none();                  ///< -1: none.
    void polygons(std::vector<PolygonId>& list);  ///< Ascending, separated by single spaces; may be empty.
    bool flag();                                  ///< 0 or 1.
    double number();
    ExactNumber exact();
    Rational exact_rational();
    Point point();
    ExactPoint exact_point();
    /// Takes the word `undecided` where it stands next and is accepted.
    bool take_undecided();
    bool next_is_empty() const { return rest_.empty() || rest_.front() == ','; }
    /// What is left of the line, not taken.
    std::string_view rest() const { return rest_; }
    bool ended() const { return ended_; }  ///< All fields are taken.
    /// Throws unless all fields are taken.
    void expect_end() const;

    /// Refuses the field that was taken last.
    [[noreturn]] void refuse(const std::string& problem, std::string_view value, const std::string& remedy) const;

private:
    std::string column_name() const;
    [[noreturn]] void refuse_count() const;

    const LineReader& reader_;
    std::string_view header_, line_, rest_;
    int taken_ = 0;
    bool ended_ = false;
    bool undecided_;
};

}  // namespace cob
