/// \file
/// The parts of answer_set(): one function for each table of questions.
#pragma once

#include "cob/answer.hpp"
#include "cob/error.hpp"
#include "cob/files.hpp"
#include "cob/scene.hpp"
#include "cob/tables.hpp"

#include <optional>
#include <string>
#include <vector>

namespace cob {

/// A set under way: where it is read from, where the answers go, and how.
struct AnswerJob {
    const Scene& scene;
    const CandidateSource& source;
    const std::string& set;
    const std::string& folder;
    const AnswerOptions& options;

    template <class Row>
    std::string question_path() const {
        return set + "/" + table_name<Row>();
    }
    template <class Row>
    std::string answer_path() const {
        return folder + "/" + table_name<Row>();
    }
};

/// The answers under way: all files appear together, when all questions are answered.
struct AnswerFiles {
    std::optional<TableWriter<StateRow>> states;
    std::optional<TableWriter<RelationRow>> relations;
    std::optional<TableWriter<VisibilityRow>> visibility;
    std::optional<OutputFile> yes_or_no;  ///< A peer's answers, instead of all others.

    void commit() {
        if (states) states->commit();
        if (relations) relations->commit();
        if (visibility) visibility->commit();
        if (yes_or_no) yes_or_no->commit();
    }
};

/// Runs the work on one question; what it refuses gets the line that the question stands in.
template <class Work>
void at_line(const std::string& path, std::size_t line, const Work& work) {
    try {
        work();
    } catch (const InputError& error) {
        throw InputError(error.what(), {path, line, "", ""});
    }
}

/// Up to `count` rows; none at the end of the table.
template <class Row>
std::vector<Row> read_rows(TableReader<Row>& reader, std::size_t count) {
    std::vector<Row> rows;
    rows.reserve(count);
    for (Row row; rows.size() < count && reader.next(row);) rows.push_back(row);
    return rows;
}

/// -1 or a valid polygon of the scene; throws InputError.
void refuse_unknown_polygon(const Scene& scene, PolygonId polygon);
/// The two ends alone; throws InputError where SPEC 6 refuses them, or the scene does not have from and to.
Segment checked_segment(const Scene& scene, const SegmentRow& row);

/// Each opens its files, fills them and leaves them to be committed.
void answer_boxes(const AnswerJob& job, AnswerFiles& files, AnswerSummary& summary);
void answer_segments(const AnswerJob& job, AnswerFiles& files, AnswerSummary& summary);
/// The segments by Embree or the boxes by CGAL, as options.peer says.
void answer_by_peer(const AnswerJob& job, AnswerFiles& files, AnswerSummary& summary);

}  // namespace cob
