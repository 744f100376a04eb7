/// \file
/// One self-contained HTML page: headings, text, tables and pictures, with nothing loaded from elsewhere.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace cob::report {

/// A table: one row of heads, then rows of as many cells.
struct Table {
    std::vector<std::string> heads;
    std::vector<std::vector<std::string>> rows;

    /// Comma-separated with LF; cells with commas, quotes or line ends are quoted (RFC 4180).
    std::string csv() const;
    /// In columns, for a terminal.
    std::string text() const;
};

class Page {
public:
    explicit Page(std::string title);

    void heading(const std::string& text);
    void paragraph(const std::string& text);
    void table(const Table& table);
    /// Embeds a PNG or SVG file; a line of text where it is not there.
    void picture(const std::string& path, const std::string& caption);

    std::string html() const;

private:
    std::string title_, body_;
};

std::string html_escaped(std::string_view text);
std::string base64(std::string_view bytes);

}  // namespace cob::report
