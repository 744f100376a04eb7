// Distributed under the Boost Software License, Version 1.0 (https://www.boost.org/LICENSE_1_0.txt).
/// \file
/// A folder of answer tables against a golden set (SPEC 7), in one pass and bounded memory. Needs the standard
/// library alone.
#pragma once

#include "cob/verify/recorder.hpp"

namespace cob::verify {

namespace detail {

/// A yes-or-no variant's answers; their indices are those of yes_no_names().
inline const std::vector<std::string>& yes_no_digits() {
    static const std::vector<std::string> digits{"0", "1", "undecided"};
    return digits;
}

/// Answers before the question, or all that are left, were not asked for.
inline void skip_unknown(Cursor& given, Recorder& recorder, const Question* question = nullptr) {
    for (; given.at_row() && !(question && given.id() >= question->id); given.step())
        recorder.unknown({given.id(), {}, nullptr}, -1, given.row().line());
}

/// relations.csv of both sides, box by box: what is not listed is disjoint (of `close`: 0).
class RelationComparison {
public:
    RelationComparison(const std::string& set, const std::string& answers, std::int64_t polygons,
                       const Options& options, Recorder& recorder)
        : exact_(set + "/relations.csv", {relations_header}),
          given_(answers + "/relations.csv", {relations_header, close_header}),
          polygons_(polygons),
          options_(options),
          recorder_(recorder) {}

    static bool reduced(const std::string& answers) {
        return Table(answers + "/relations.csv", {relations_header, close_header}).header() == 1;
    }

    void at(const Question& question) {
        skip_unknown(given_, recorder_, &question);
        std::int64_t previous = -1;
        for (; given_.at(question.id); given_.step()) {
            const Table& row = given_.row();
            const std::int64_t polygon = row.integer(1);
            if (polygon < previous) row.fail("polygons do not ascend", std::string(row.field(1)), "sort the rows");
            if (polygon < 0 || polygon >= polygons_) {
                recorder_.unknown(question, polygon, row.line());
                continue;
            }
            if (polygon == previous) {
                recorder_.doubled(question, polygon, row.line());
                continue;
            }
            previous = polygon;
            pass_exact(question, polygon);
            const bool listed = exact_.at(question.id) && exact_.row().integer(1) == polygon;
            compare(question, polygon, listed ? &exact_.row() : nullptr, &row);
            if (listed) exact_.step();
        }
        pass_exact(question, polygons_);
    }
    void finish() { skip_unknown(given_, recorder_); }

private:
    /// Rows of the set before this polygon: the variant left them out.
    void pass_exact(const Question& question, std::int64_t polygon) {
        for (; exact_.at(question.id) && exact_.row().integer(1) < polygon; exact_.step())
            compare(question, exact_.row().integer(1), &exact_.row(), nullptr);
    }
    void compare(const Question& question, std::int64_t polygon, const Table* exact, const Table* given) {
        const std::size_t truth = exact ? exact->word(2, relation_names()) : 0;
        const std::string_view exact_text = exact ? exact->line() : "disjoint";
        const std::string_view given_text = given ? given->line() : "no row";
        if (given_.row().header() == 1) {
            const std::size_t answer = given ? given->word(2, yes_no_digits()) : 0;
            const bool wrong = answer != static_cast<std::size_t>(is_hit(options_, truth));
            recorder_.compared(question, polygon, truth, answer, wrong ? "close" : "", exact_text, given_text);
            return;
        }
        const std::size_t answer = given ? given->word(2, relation_names()) : 0;
        const char* differs = answer != truth                      ? "relation"
                              : !exact || !given                   ? ""
                              : exact->field(3) != given->field(3) ? "covers"
                              : exact->field(4) != given->field(4) ? "shared"
                                                                   : "";
        recorder_.compared(question, polygon, truth, answer, differs, exact_text, given_text);
    }

    Cursor exact_, given_;
    std::int64_t polygons_;
    const Options& options_;
    Recorder& recorder_;
};

/// A table with one row for each question.
template <class Compare>
class RowComparison {
public:
    /// compare(question, row of the set, row of the answers) counts one pair of rows.
    RowComparison(const std::string& set, const std::string& answers, const char* table,
                  std::vector<std::string> headers, Recorder& recorder, Compare compare)
        : exact_(set + table, {headers.front()}),
          given_(answers + table, headers),
          recorder_(recorder),
          compare_(compare) {}

    void at(const Question& question) {
        skip_unknown(given_, recorder_, &question);
        if (!exact_.at(question.id))
            throw Error(exact_.row().path() + ": no answer to question " + std::to_string(question.id) +
                        ": the set is not whole, make it anew");
        if (!given_.at(question.id)) recorder_.missing(question, exact_.row().line());
        for (bool first = true; given_.at(question.id); given_.step(), first = false) {
            if (first)
                compare_(question, exact_.row(), given_.row());
            else
                recorder_.doubled(question, -1, given_.row().line());
        }
        exact_.step();
    }
    void finish() { skip_unknown(given_, recorder_); }

private:
    Cursor exact_, given_;
    Recorder& recorder_;
    Compare compare_;
};

inline void compare_state(Recorder& recorder, const Question& question, const Table& exact, const Table& given) {
    static const char* const columns[] = {"", "state", "close", "cover", "light"};
    const char* differs = "";
    for (std::size_t k = 4; k > 0; --k)
        if (exact.field(k) != given.field(k)) differs = columns[k];
    recorder.compared(question, -1, exact.word(1, state_names()), given.word(1, state_names()), differs, exact.line(),
                      given.line());
}

inline void compare_visibility(Recorder& recorder, const Options& options, const Question& question, const Table& exact,
                               const Table& given) {
    const std::size_t truth = exact.word(1, visibility_names());
    const bool hidden = given.header() == 1;
    const std::size_t answer = given.word(1, hidden ? yes_no_digits() : visibility_names());
    const bool free = truth == static_cast<std::size_t>(Visibility::grazing) && !options.strict;
    const std::size_t wanted = hidden ? truth == static_cast<std::size_t>(Visibility::blocked) : truth;
    recorder.compared(question, -1, truth, answer,
                      answer == wanted || free ? ""
                      : hidden                 ? "hidden"
                                               : "visibility",
                      exact.field(1), given.field(1));
}

/// Face lines of the set's scene.
inline std::int64_t count_polygons(const std::string& set) {
    std::ifstream file(set + "/scene.obj");
    if (!file) throw Error(set + "/scene.obj: cannot open file: is this a golden set?");
    std::int64_t count = 0;
    for (std::string line; std::getline(file, line);)
        count += line.size() > 1 && line[0] == 'f' && std::isspace(line[1]);
    return count;
}

}  // namespace detail

/// Box tables of the answers against those of the set. Throws Error on bad input.
inline Report compare_boxes(const std::string& set, const std::string& answers, const Options& options) {
    using namespace detail;
    Report report;
    if (!Table::exists(set + "/boxes.csv")) return report;
    report.tables.resize(2);
    report.tables[0].table = "relations";
    report.tables[1].table = "states";

    std::optional<Recorder> relation_recorder, state_recorder;
    std::optional<RelationComparison> relations;
    if (Table::exists(answers + "/relations.csv")) {
        relation_recorder.emplace(report.tables[0], report.first, options, relation_names(),
                                  RelationComparison::reduced(answers) ? yes_no_names() : relation_names());
        relations.emplace(set, answers, count_polygons(set), options, *relation_recorder);
    }
    const auto by_state = [&](const Question& question, const Table& exact, const Table& given) {
        compare_state(*state_recorder, question, exact, given);
    };
    std::optional<RowComparison<decltype(by_state)>> states;
    if (Table::exists(answers + "/states.csv")) {
        state_recorder.emplace(report.tables[1], report.first, options, state_names(), state_names());
        states.emplace(set, answers, "/states.csv", std::vector<std::string>{states_header}, *state_recorder, by_state);
    }
    if (!relations && !states) return report;

    Tags tags(set, "box");
    for (Cursor box(set + "/boxes.csv", {boxes_header}); box.at_row(); box.step()) {
        const Question question{box.id(), tags.of(box.id()), &box.row()};
        if (relations) relations->at(question);
        if (states) states->at(question);
    }
    if (relations) relations->finish();
    if (states) states->finish();
    return report;
}

/// Visibility of the answers against that of the set. Throws Error on bad input.
inline Report compare_segments(const std::string& set, const std::string& answers, const Options& options) {
    using namespace detail;
    Report report;
    if (!Table::exists(set + "/segments.csv")) return report;
    report.tables.resize(1);
    report.tables[0].table = "visibility";
    const std::string given = answers + "/visibility.csv";
    if (!Table::exists(given)) return report;

    const std::vector<std::string> headers{visibility_header, hidden_header};
    Recorder recorder(report.tables[0], report.first, options, visibility_names(),
                      Table(given, headers).header() == 1 ? yes_no_names() : visibility_names());
    const auto by_row = [&](const Question& question, const Table& exact, const Table& answer) {
        compare_visibility(recorder, options, question, exact, answer);
    };
    RowComparison<decltype(by_row)> rows(set, answers, "/visibility.csv", headers, recorder, by_row);
    Tags tags(set, "segment");
    for (Cursor segment(set + "/segments.csv", segments_headers); segment.at_row(); segment.step())
        rows.at({segment.id(), tags.of(segment.id()), &segment.row()});
    rows.finish();
    return report;
}

/// Adds the tables of one more report.
inline void append(Report& report, Report more) {
    report.tables.insert(report.tables.end(), more.tables.begin(), more.tables.end());
    report.first.insert(report.first.end(), more.first.begin(), more.first.end());
}

/// Throws Error where nothing was answered.
inline void require_answers(const Report& report, const std::string& answers) {
    for (const TableReport& table : report.tables)
        if (table.answered) return;
    throw Error(answers + ": no table that answers the set: write relations.csv, states.csv or visibility.csv");
}

/// All tables of the answers against the set, without its checksums. Throws Error on bad input.
inline Report compare(const std::string& set, const std::string& answers, const Options& options = {}) {
    Report report = compare_boxes(set, answers, options);
    append(report, compare_segments(set, answers, options));
    require_answers(report, answers);
    return report;
}

}  // namespace cob::verify
