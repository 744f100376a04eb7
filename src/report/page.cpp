#include "report/page.hpp"

#include "cob/error.hpp"
#include "cob/files.hpp"
#include "report/text.hpp"

#include <algorithm>

namespace cob::report {
namespace {

constexpr const char* style =
    "body{font:16px/1.5 system-ui,sans-serif;max-width:72rem;margin:2rem auto;padding:0 1rem;color:#222}"
    "table{display:block;overflow-x:auto;border-collapse:collapse;margin:1rem "
    "0;font-size:14px;font-variant-numeric:tabular-nums}"
    "th,td{border:1px solid #ccc;padding:.2rem .6rem;text-align:left}th{background:#f3f3f3}"
    "figure{margin:1rem 0}img{max-width:100%;height:auto}figcaption{color:#555;font-size:14px}";

bool ends_with(const std::string& text, std::string_view end) {
    return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

std::string csv_row(const std::vector<std::string>& cells) {
    std::string row;
    for (std::size_t k = 0; k < cells.size(); ++k) row += (k ? "," : "") + csv_cell(cells[k]);
    return row + "\n";
}

}  // namespace

std::string html_escaped(std::string_view text) {
    std::string result;
    for (const char c : text) {
        switch (c) {
            case '&':
                result += "&amp;";
                break;
            case '<':
                result += "&lt;";
                break;
            case '>':
                result += "&gt;";
                break;
            case '"':
                result += "&quot;";
                break;
            default:
                result += c;
        }
    }
    return result;
}

std::string base64(std::string_view bytes) {
    constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t k = 0; k < bytes.size(); k += 3) {
        const std::size_t count = std::min<std::size_t>(3, bytes.size() - k);
        unsigned group = 0;
        for (std::size_t i = 0; i < 3; ++i)
            group = group << 8 | (i < count ? static_cast<unsigned char>(bytes[k + i]) : 0u);
        for (std::size_t i = 0; i < 4; ++i) text += i <= count ? digits[group >> (18 - 6 * i) & 63] : '=';
    }
    return text;
}

std::string Table::csv() const {
    std::string text = csv_row(heads);
    for (const auto& row : rows) text += csv_row(row);
    return text;
}

std::string Table::text() const {
    std::vector<std::size_t> widths(heads.size());
    const auto widen = [&](const std::vector<std::string>& cells) {
        for (std::size_t k = 0; k < cells.size() && k < widths.size(); ++k)
            widths[k] = std::max(widths[k], cells[k].size());
    };
    widen(heads);
    for (const auto& row : rows) widen(row);
    std::string result;
    const auto add = [&](const std::vector<std::string>& cells) {
        for (std::size_t k = 0; k < cells.size() && k < widths.size(); ++k) {
            result += cells[k];
            if (k + 1 < cells.size()) result.append(widths[k] - cells[k].size() + 2, ' ');
        }
        result += '\n';
    };
    add(heads);
    for (const auto& row : rows) add(row);
    return result;
}

Page::Page(std::string title) : title_(std::move(title)) {}

void Page::heading(const std::string& text) {
    body_ += "<h2>" + html_escaped(text) + "</h2>\n";
}

void Page::paragraph(const std::string& text) {
    body_ += "<p>" + html_escaped(text) + "</p>\n";
}

void Page::table(const Table& table) {
    body_ += "<table>\n<tr>";
    for (const auto& head : table.heads) body_ += "<th>" + html_escaped(head) + "</th>";
    body_ += "</tr>\n";
    for (const auto& row : table.rows) {
        body_ += "<tr>";
        for (const auto& cell : row) body_ += "<td>" + html_escaped(cell) + "</td>";
        body_ += "</tr>\n";
    }
    body_ += "</table>\n";
}

void Page::picture(const std::string& path, const std::string& caption) {
    std::string bytes;
    try {
        bytes = read_file(path);
    } catch (const InputError&) {
        paragraph(caption + ": no picture (gnuplot is not installed; the numbers are in the tables)");
        return;
    }
    const char* type = ends_with(path, ".svg") ? "image/svg+xml" : "image/png";
    body_ += "<figure><img alt=\"" + html_escaped(caption) + "\" src=\"data:" + type + ";base64," + base64(bytes) +
             "\"><figcaption>" + html_escaped(caption) + "</figcaption></figure>\n";
}

std::string Page::html() const {
    return "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>" + html_escaped(title_) +
           "</title><style>" + style + "</style></head>\n<body>\n<h1>" + html_escaped(title_) + "</h1>\n" + body_ +
           "</body></html>\n";
}

}  // namespace cob::report
