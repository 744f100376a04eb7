// Distributed under the Boost Software License, Version 1.0 (https://www.boost.org/LICENSE_1_0.txt).
/// \file
/// A comma-separated table read row by row in bounded memory, strictly. Needs the standard library alone.
#pragma once

#include "cob/verify/report.hpp"

#include <charconv>
#include <cstring>
#include <fstream>
#include <memory>

namespace cob::verify {

/// A coordinate in plain binary64: a decimal is rounded correctly; a fraction p/q within two units in the last place
/// (make the set with --grid where that matters); nothing for anything else.
inline std::optional<double> parse_number(std::string_view text) {
    const auto decimal = [](std::string_view part) -> std::optional<double> {
        double value = 0;
        const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), value);
        if (end != part.data() + part.size() || part.empty()) return {};
        if (error == std::errc::result_out_of_range) return 0.0;  // Only underflow stands in a table.
        if (error != std::errc{}) return {};
        return value;
    };
    const std::size_t slash = text.find('/');
    if (slash == std::string_view::npos) return decimal(text);
    // p and q may leave the range of binary64 where p/q does not: cut both to their leading digits.
    const auto leading = [&](std::string_view part, int& dropped) -> std::optional<double> {
        constexpr std::size_t kept = 40;
        for (std::size_t k = !part.empty() && part[0] == '-'; k < part.size(); ++k)
            if (part[k] < '0' || part[k] > '9') return {};
        dropped = part.size() > kept ? static_cast<int>(part.size() - kept) : 0;
        return decimal(part.substr(0, kept));
    };
    int dropped_p = 0, dropped_q = 0;
    const auto p = leading(text.substr(0, slash), dropped_p), q = leading(text.substr(slash + 1), dropped_q);
    if (!p || !q || *q <= 0) return {};
    const double ratio = *p / *q;
    const int power = dropped_p - dropped_q;
    return power == 0 ? ratio : ratio * std::pow(10.0, power);
}

/// One open table. Lines end in LF or CRLF, the last one, too.
class Table {
public:
    /// Opens it and checks that its header is one of those given. Throws Error.
    Table(std::string path, std::vector<std::string> headers)
        : path_(std::move(path)), file_(path_, std::ios::binary), buffer_(std::size_t{1} << 18) {
        if (!file_) throw Error(path_ + ": cannot open file: check the path");
        if (!read_line()) throw Error(path_ + ": empty table: the first line is " + headers.front());
        for (header_ = 0; header_ < headers.size(); ++header_)
            if (line_ == headers[header_]) break;
        if (header_ == headers.size()) {
            std::string expected;
            for (const std::string& header : headers) expected += (expected.empty() ? "" : " or ") + header;
            fail("wrong header", std::string(line_), "expected " + expected);
        }
        split();
        columns_ = fields_.size();
    }

    static bool exists(const std::string& path) { return std::ifstream(path).good(); }

    /// Which of the headers it has.
    std::size_t header() const { return header_; }

    /// Moves to the next row; false at the end.
    bool next() {
        if (!read_line()) return false;
        split();
        if (fields_.size() != columns_)
            fail("row of " + std::to_string(fields_.size()) + " fields", std::string(line_),
                 "the header has " + std::to_string(columns_) + "; is the table truncated?");
        return true;
    }
    const std::string& path() const { return path_; }
    std::string_view line() const { return line_; }
    std::string_view field(std::size_t column) const { return fields_[column]; }

    std::int64_t integer(std::size_t column) const {
        std::int64_t value = 0;
        const std::string_view text = fields_[column];
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        if (error != std::errc{} || end != text.data() + text.size())
            fail("not an integer", std::string(text), "write an id");
        return value;
    }
    double number(std::size_t column) const {
        const auto value = parse_number(fields_[column]);
        if (!value) fail("not a number", std::string(fields_[column]), "write a decimal or a fraction p/q");
        return *value;
    }
    /// Index of the field among the words.
    std::size_t word(std::size_t column, const std::vector<std::string>& words) const {
        for (std::size_t k = 0; k < words.size(); ++k)
            if (fields_[column] == words[k]) return k;
        std::string expected;
        for (const std::string& name : words) expected += (expected.empty() ? "" : ", ") + name;
        fail("unknown word", std::string(fields_[column]), "expected " + expected);
    }

    [[noreturn]] void fail(const std::string& problem, const std::string& value, const std::string& remedy) const {
        std::string shown = value.substr(0, 60);
        for (char& c : shown)
            if (static_cast<unsigned char>(c) < 0x20) c = '?';
        throw Error(path_ + ":" + std::to_string(number_) + ": " + problem + (value.empty() ? "" : " '" + shown + "'") +
                    ": " + remedy);
    }

private:
    /// Sets line_ to the next line, without its end.
    bool read_line() {
        for (;;) {
            const char* start = buffer_.data() + begin_;
            if (const void* found = std::memchr(start, '\n', end_ - begin_)) {
                const auto length = static_cast<std::size_t>(static_cast<const char*>(found) - start);
                line_ = std::string_view(start, length);
                if (!line_.empty() && line_.back() == '\r') line_.remove_suffix(1);
                begin_ += length + 1;
                ++number_;
                if (number_ == 1 && line_.substr(0, 3) == "\xef\xbb\xbf") line_.remove_prefix(3);  // spreadsheets' mark
                return true;
            }
            if (!fill()) {
                if (begin_ == end_) return false;
                ++number_;
                fail("line without its end", std::string(start, end_ - begin_), "the table is truncated: make it anew");
            }
        }
    }
    /// Reads on behind the unread rest; false at the end of the file.
    bool fill() {
        std::memmove(buffer_.data(), buffer_.data() + begin_, end_ - begin_);
        end_ -= begin_;
        begin_ = 0;
        if (end_ == buffer_.size()) buffer_.resize(2 * buffer_.size());
        file_.read(buffer_.data() + end_, static_cast<std::streamsize>(buffer_.size() - end_));
        end_ += static_cast<std::size_t>(file_.gcount());
        return file_.gcount() > 0;
    }
    void split() {
        fields_.clear();
        std::string_view rest = line_;
        for (std::size_t comma; (comma = rest.find(',')) != std::string_view::npos; rest.remove_prefix(comma + 1))
            fields_.push_back(rest.substr(0, comma));
        fields_.push_back(rest);
    }

    std::string path_;
    std::ifstream file_;
    std::vector<char> buffer_;
    std::size_t begin_ = 0, end_ = 0;  ///< Unread part of the buffer.
    std::size_t number_ = 0;           ///< Of the line, from 1.
    std::size_t header_ = 0, columns_ = 0;
    std::string_view line_;
    std::vector<std::string_view> fields_;
};

/// A table read question by question: rows ascend by their first column.
class Cursor {
public:
    Cursor() = default;
    Cursor(const std::string& path, std::vector<std::string> headers)
        : table_(std::make_unique<Table>(path, std::move(headers))) {
        step();
    }
    bool exists() const { return table_ != nullptr; }
    bool at_row() const { return at_row_; }
    /// Whether the row at hand answers this question.
    bool at(std::int64_t id) const { return at_row_ && id_ == id; }
    std::int64_t id() const { return id_; }
    const Table& row() const { return *table_; }
    void step() {
        const bool first = !at_row_;
        at_row_ = table_->next();
        if (!at_row_) return;
        const std::int64_t id = table_->integer(0);
        if (!first && id < id_) table_->fail("ids do not ascend", std::to_string(id), "sort the rows by their ids");
        id_ = id;
    }

private:
    std::unique_ptr<Table> table_;
    bool at_row_ = false;
    std::int64_t id_ = 0;
};

}  // namespace cob::verify
