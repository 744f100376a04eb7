// Distributed under the Boost Software License, Version 1.0 (https://www.boost.org/LICENSE_1_0.txt).
/// \file
/// What a comparison with a golden set found: confusion matrices, counts by kind, the first disagreements.
/// Needs the standard library alone.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace cob::verify {

/// Bad input: "file:line: problem 'value': remedy".
class Error : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// Relation of a polygon to a box (SPEC 5), visibility along a segment (SPEC 6).
enum class Relation : std::uint8_t { disjoint, base, coplanar, boundary, crossing, undecided };
enum class Visibility : std::uint8_t { clear, grazing, blocked, undecided };

inline const std::vector<std::string>& relation_names() {
    static const std::vector<std::string> names{"disjoint", "base", "coplanar", "boundary", "crossing", "undecided"};
    return names;
}
inline const std::vector<std::string>& visibility_names() {
    static const std::vector<std::string> names{"clear", "grazing", "blocked", "undecided"};
    return names;
}
inline const std::vector<std::string>& state_names() {
    static const std::vector<std::string> names{"empty", "close", "occluded", "undecided"};
    return names;
}
/// Columns of a variant that says only yes or no.
inline const std::vector<std::string>& yes_no_names() {
    static const std::vector<std::string> names{"no", "yes", "undecided"};
    return names;
}

struct Options {
    /// Grazing segments must be answered `grazing` (of `hidden`: 0); else any answer to them is accepted.
    bool strict = false;
    /// Disagreements on questions of this band or more (2^-band of the question's size from the next switch) are
    /// counted apart, as near ones; nothing: none are.
    std::optional<int> near_band;
    /// Relations that a yes of a yes-or-no variant stands for.
    std::vector<Relation> hit{Relation::crossing, Relation::boundary};
    std::size_t listed = 10;  ///< Disagreements described one by one.
};

/// How often each exact answer (row) was answered how (column).
struct Confusion {
    std::vector<std::string> rows, columns;
    std::vector<std::uint64_t> counts;  ///< Row by row.

    Confusion() = default;
    Confusion(std::vector<std::string> row_names, std::vector<std::string> column_names)
        : rows(std::move(row_names)), columns(std::move(column_names)), counts(rows.size() * columns.size(), 0) {}
    std::uint64_t& at(std::size_t row, std::size_t column) { return counts[row * columns.size() + column]; }
    std::uint64_t at(std::size_t row, std::size_t column) const { return counts[row * columns.size() + column]; }
};

/// Answers of one table, or of one kind of question in it.
struct Counts {
    std::uint64_t compared = 0;   ///< Answers set beside an exact one.
    std::uint64_t wrong = 0;      ///< Differ, and are not near.
    std::uint64_t near = 0;       ///< Differ on a question of at least Options::near_band.
    std::uint64_t undecided = 0;  ///< The variant says that it cannot tell.
    std::uint64_t missing = 0;    ///< Questions without an answer.
    std::uint64_t doubled = 0;    ///< Answers to what was answered before; the first one counts.
    std::uint64_t unknown = 0;    ///< Answers to what was not asked.

    bool agree() const;
};

/// All counts by name, in the order in which reports give them.
struct NamedCount {
    const char* name;
    std::uint64_t Counts::*count;
};
inline constexpr NamedCount named_counts[] = {{"compared", &Counts::compared}, {"wrong", &Counts::wrong},
                                              {"near", &Counts::near},         {"undecided", &Counts::undecided},
                                              {"missing", &Counts::missing},   {"doubled", &Counts::doubled},
                                              {"unknown", &Counts::unknown}};

inline bool Counts::agree() const {
    for (const NamedCount& named : named_counts)
        if (named.count != &Counts::compared && this->*named.count != 0) return false;
    return true;
}

struct KindReport {
    Counts counts;
    Confusion confusion;
};

/// One table of answers: relations, states or visibility.
struct TableReport {
    std::string table;      ///< "relations", "states", "visibility".
    bool answered = false;  ///< False: the variant has no such table, and nothing was compared.
    KindReport total;
    std::map<std::string, KindReport> kinds;       ///< By kind of question; "untagged" where the set has no tags.
    std::map<std::string, std::uint64_t> columns;  ///< Disagreements by column of the table.
};

/// One answer that differs, with what an engineer needs to repeat it.
struct Disagreement {
    std::string table;
    std::int64_t id = 0;        ///< Box or segment.
    std::int64_t polygon = -1;  ///< Of relations; else -1.
    std::string kind;
    std::optional<int> band;  ///< From tags.csv.
    std::string column;       ///< Which column differs: "relation", "covers", ...
    std::string exact, given;
    std::string question;    ///< Coordinates as hex-floats (and fractions where they are none).
    double switch_ulps = 0;  ///< Upper bound for the distance to the next switch in ulps of the largest coordinate.
};

struct Report {
    std::vector<TableReport> tables;
    std::vector<Disagreement> first;  ///< The first Options::listed of each table.

    /// Something was answered, and every answer agrees.
    bool agree() const {
        bool answered = false;
        for (const TableReport& table : tables) {
            if (!table.total.counts.agree()) return false;
            answered = answered || table.answered;
        }
        return answered;
    }
};

/// C hex-float.
inline std::string hex(double value) {
    char text[40];
    std::snprintf(text, sizeof text, "%a", value);
    return text;
}

/// Upper bound for the distance to the next switch: a band k says that a move by 2^-k of the size changes nothing
/// while one by 2^-(k-1) does; in units in the last place of the largest coordinate.
inline double switch_ulps(int band, double size, double largest_coordinate) {
    const double ulp = std::nextafter(largest_coordinate, HUGE_VAL) - largest_coordinate;
    return std::ldexp(size, 1 - band) / ulp;
}

inline std::string to_text(const Disagreement& d) {
    std::string text = d.table + ": " + (d.table == "visibility" ? "segment " : "box ") + std::to_string(d.id);
    if (d.polygon >= 0) text += " polygon " + std::to_string(d.polygon);
    text += " (" + d.kind;
    if (d.band) {
        char ulps[32];
        std::snprintf(ulps, sizeof ulps, "%.3g", d.switch_ulps);
        text += ", band " + std::to_string(*d.band) + ": a switch within " + ulps + " ulps";
    }
    return text + "): " + d.column + " is " + d.exact + ", answered " + d.given +
           (d.question.empty() ? "" : "\n    " + d.question);
}

namespace detail {

inline std::string padded(const std::string& text, std::size_t width) {
    return text.size() < width ? std::string(width - text.size(), ' ') + text : text;
}

inline std::string to_text(const Confusion& confusion) {
    std::string text = "  " + padded("exact \\ given", 14);
    for (const std::string& column : confusion.columns) text += padded(column, 12);
    for (std::size_t row = 0; row < confusion.rows.size(); ++row) {
        std::uint64_t sum = 0;
        for (std::size_t column = 0; column < confusion.columns.size(); ++column) sum += confusion.at(row, column);
        if (sum == 0) continue;
        text += "\n  " + padded(confusion.rows[row], 14);
        for (std::size_t column = 0; column < confusion.columns.size(); ++column)
            text += padded(std::to_string(confusion.at(row, column)), 12);
    }
    return text + "\n";
}

inline std::string to_text(const std::string& name, const Counts& counts) {
    std::string text = "  " + padded(name, 14);
    for (const NamedCount& named : named_counts) text += padded(std::to_string(counts.*named.count), 11);
    return text + "\n";
}

}  // namespace detail

/// The whole report, for people.
inline std::string to_text(const Report& report) {
    std::string text;
    for (const TableReport& table : report.tables) {
        text += table.table + (table.answered ? "\n" : ": not answered\n");
        if (!table.answered) continue;
        text += detail::to_text(table.total.confusion) + "  " + detail::padded("kind", 14);
        for (const NamedCount& named : named_counts) text += detail::padded(named.name, 11);
        text += "\n";
        for (const auto& [kind, part] : table.kinds) text += detail::to_text(kind, part.counts);
        text += detail::to_text("all", table.total.counts);
    }
    if (!report.first.empty()) text += "first disagreements\n";
    for (const Disagreement& disagreement : report.first) text += "  " + to_text(disagreement) + "\n";
    return text + (report.agree() ? "all answers agree\n" : "DISAGREE\n");
}

}  // namespace cob::verify
