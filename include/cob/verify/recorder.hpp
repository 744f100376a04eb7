// Distributed under the Boost Software License, Version 1.0 (https://www.boost.org/LICENSE_1_0.txt).
/// \file
/// The questions of a golden set (SPEC 7) with their tags, and the counting of answers to them. Needs the standard
/// library alone.
#pragma once

#include "cob/verify/table.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace cob::verify {

namespace detail {

inline const char* const boxes_header = "box,polygon,x0,y0,z0,x1,y1,z1,x2,y2,z2,x3,y3,z3,ux,uy,uz,margin,height";
inline const char* const relations_header = "box,polygon,relation,covers,shared";
inline const char* const close_header = "box,polygon,close";
inline const char* const states_header = "box,state,close,cover,light";
inline const char* const visibility_header = "segment,visibility";
inline const char* const hidden_header = "segment,hidden";
inline const std::vector<std::string> segments_headers{"segment,x0,y0,z0,x1,y1,z1,from,to",
                                                       "segment,x0,y0,z0,x1,y1,z1"};

/// Kind and band of the questions of one sort, in step with their table.
class Tags {
public:
    Tags(const std::string& set, const char* question) : question_(question) {
        if (!Table::exists(set + "/tags.csv")) return;
        table_ = std::make_unique<Table>(set + "/tags.csv", std::vector<std::string>{"question,id,kind,band"});
        step();
    }
    struct Tag {
        std::string kind = "untagged";
        std::optional<int> band;
    };
    Tag of(std::int64_t id) {
        while (at_row_ && id_ < id) step();
        if (!at_row_ || id_ != id) return {};
        return {std::string(table_->field(2)), static_cast<int>(table_->integer(3))};
    }

private:
    void step() {
        while ((at_row_ = table_->next()))
            if (table_->field(0) == question_) break;
        if (at_row_) id_ = table_->integer(1);
    }
    std::string question_;
    std::unique_ptr<Table> table_;
    bool at_row_ = false;
    std::int64_t id_ = 0;
};

/// A point of three columns as hex-floats; what is no binary64 number stands as the fraction, too.
inline std::string point_text(const Table& row, std::size_t column) {
    std::string text = "(";
    for (std::size_t k = column; k < column + 3; ++k) {
        const std::string_view field = row.field(k);
        text += (k > column ? ", " : "") + hex(row.number(k));
        if (field.find('/') != std::string_view::npos) text += " ~ " + std::string(field);
    }
    return text + ")";
}

/// Size of a question (diagonal of the bounds of its points) and largest coordinate.
inline std::array<double, 2> size_of(const Table& row, const std::vector<std::size_t>& points) {
    double largest = 0;
    std::array<double, 3> half{};  // extents and their squares may leave binary64
    for (std::size_t axis = 0; axis < 3; ++axis) {
        double low = HUGE_VAL, high = -HUGE_VAL;
        for (const std::size_t column : points) {
            const double value = row.number(column + axis);
            low = std::min(low, value), high = std::max(high, value);
            largest = std::max(largest, std::abs(value));
        }
        half[axis] = high / 2 - low / 2;
    }
    return {std::min(2 * std::hypot(half[0], half[1], half[2]), std::numeric_limits<double>::max()), largest};
}

inline std::vector<std::size_t> corner_columns(const Table& box) {
    return box.field(11).empty() ? std::vector<std::size_t>{2, 5, 8} : std::vector<std::size_t>{2, 5, 8, 11};
}

inline std::string box_text(const Table& row) {
    std::string text = "own polygon " + std::string(row.field(1)) + " corners";
    for (const std::size_t column : corner_columns(row)) text += " " + point_text(row, column);
    return text + " u " + point_text(row, 14) + " margin " + std::string(row.field(17)) + " height " +
           std::string(row.field(18));
}

inline std::string segment_text(const Table& row) {
    return "from " + point_text(row, 1) + " to " + point_text(row, 4);
}

/// The question that answers are compared for.
struct Question {
    std::int64_t id = 0;
    Tags::Tag tag;
    const Table* row = nullptr;  ///< Of boxes.csv or segments.csv; null: an id that was not asked.
};

/// Counts what comes in into one table's report.
class Recorder {
public:
    Recorder(TableReport& table, std::vector<Disagreement>& first, const Options& options,
             std::vector<std::string> rows, std::vector<std::string> columns)
        : table_(table), first_(first), options_(options), empty_{{}, {std::move(rows), std::move(columns)}} {
        table_.total = empty_;
        table_.answered = true;
    }

    /// One answer: row and column of the confusion matrix, and the name of the first column of the table in which
    /// it differs ("": agrees).
    void compared(const Question& question, std::int64_t polygon, std::size_t row, std::size_t column,
                  const char* differs, std::string_view exact, std::string_view given) {
        KindReport& kind = of(question.tag.kind);
        const bool near = options_.near_band && question.tag.band && *question.tag.band >= *options_.near_band;
        const bool undecided = empty_.confusion.columns[column] == "undecided";
        for (KindReport* part : {&table_.total, &kind}) {
            ++part->counts.compared;
            ++part->confusion.at(row, column);
            if (undecided)
                ++part->counts.undecided;
            else if (*differs)
                ++(near ? part->counts.near : part->counts.wrong);
        }
        if (!*differs && !undecided) return;
        ++table_.columns[undecided ? "undecided" : differs];
        list(question, polygon, undecided ? "answer" : differs, exact, given);
    }
    void missing(const Question& question, std::string_view exact) {
        add(question, &Counts::missing);
        list(question, -1, "answer", exact, "nothing");
    }
    void doubled(const Question& question, std::int64_t polygon, std::string_view given) {
        add(question, &Counts::doubled);
        list(question, polygon, "id", "answered before", "again: " + std::string(given));
    }
    void unknown(const Question& question, std::int64_t polygon, std::string_view given) {
        add(question, &Counts::unknown);
        list(question, polygon, "id", "not asked", given);
    }

private:
    KindReport& of(const std::string& kind) { return table_.kinds.try_emplace(kind, empty_).first->second; }
    void add(const Question& question, std::uint64_t Counts::*count) {
        ++(table_.total.counts.*count);
        ++(of(question.tag.kind).counts.*count);
    }
    void list(const Question& question, std::int64_t polygon, const char* column, std::string_view exact,
              std::string_view given) {
        if (listed_ == options_.listed) return;
        ++listed_;
        Disagreement d{
            table_.table,       question.id, polygon, question.tag.kind, question.tag.band, column, std::string(exact),
            std::string(given), {},          0};
        if (question.row) {
            const bool box = table_.table != "visibility";
            const auto [size, largest] =
                size_of(*question.row, box ? corner_columns(*question.row) : std::vector<std::size_t>{1, 4});
            d.question = box ? box_text(*question.row) : segment_text(*question.row);
            if (d.band) d.switch_ulps = switch_ulps(*d.band, size, largest);
        }
        first_.push_back(std::move(d));
    }

    TableReport& table_;
    std::vector<Disagreement>& first_;
    const Options& options_;
    KindReport empty_;
    std::size_t listed_ = 0;
};

inline bool is_hit(const Options& options, std::size_t relation) {
    return std::find(options.hit.begin(), options.hit.end(), static_cast<Relation>(relation)) != options.hit.end();
}

}  // namespace detail

}  // namespace cob::verify
