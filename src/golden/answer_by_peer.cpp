// Other people's code answers, in short forms of the tables: segments.csv -> `segment,hidden`, boxes.csv ->
// `box,polygon,close`.
#include "cob/verify/recorder.hpp"
#include "golden/answer.hpp"
#include "golden/cgal_variant.hpp"

#ifdef COB_HAS_EMBREE
#include "geometry/candidate_list.hpp"
#include "geometry/embree_triangles.hpp"
#endif

#include <algorithm>

namespace cob {
namespace {

/// As long as rows come and are answered.
template <class Row, class AnswerRow>
std::uint64_t answer_rows(const AnswerJob& job, OutputFile& file, const AnswerRow& answer_row) {
    const std::string path = job.question_path<Row>();
    TableReader<Row> questions(path);
    std::uint64_t count = 0;
    std::string lines;
    for (Row row; questions.next(row); ++count) {
        lines.clear();
        at_line(path, row.line, [&] { answer_row(row, lines); });
        file.write(lines);
        if (job.options.progress) job.options.progress(count, 0);
    }
    return count;
}

OutputFile& begin(AnswerFiles& files, const std::string& path, const char* header) {
    OutputFile& file = files.yes_or_no.emplace(path);
    file.write(std::string(header) + "\n");
    return file;
}

void answer_by_embree(const AnswerJob& job, AnswerFiles& files, AnswerSummary& summary) {
#ifdef COB_HAS_EMBREE
    if (!summary.has_segments)
        throw InputError("set without segments", {job.set, 0, "", "Embree answers segments.csv only"});
    const EmbreeTriangles embree(job.scene);
    OutputFile& file = begin(files, job.answer_path<VisibilityRow>(), verify::detail::hidden_header);
    summary.segments = answer_rows<SegmentRow>(job, file, [&](const SegmentRow& row, std::string& lines) {
        const bool hidden = embree.hidden(checked_segment(job.scene, row));
        lines = std::to_string(row.segment) + (hidden ? ",1\n" : ",0\n");
    });
#else
    (void)files, (void)summary;
    throw InputError("built without Embree", {job.set, 0, "", "install it and build again"});
#endif
}

void answer_by_cgal(const AnswerJob& job, AnswerFiles& files, AnswerSummary& summary) {
    if (!summary.has_boxes) throw InputError("set without boxes", {job.set, 0, "", "CGAL answers boxes.csv only"});
    const auto cgal = make_cgal_variant(job.scene, job.options.peer);
    OutputFile& file = begin(files, job.answer_path<RelationRow>(), verify::detail::close_header);
    summary.boxes = answer_rows<BoxRow>(job, file, [&](const BoxRow& row, std::string& lines) {
        refuse_unknown_polygon(job.scene, row.question.polygon);
        const Box box(row.question);
        const auto cuboid = cuboid_of(row.question);
        if (!cuboid)
            throw InputError("box is not axis-aligned or has a corner that is no binary64 number",
                             {"", 0, "", "ask CGAL about other boxes, or another variant"});
        for (const PolygonId id : polygons_in(job.source, box.bounds())) {
            if (id == row.question.polygon || !cgal->meets(id, *cuboid)) continue;
            lines += std::to_string(row.box) + "," + std::to_string(id) + ",1\n";
            ++summary.relations;
        }
    });
}

}  // namespace

void answer_by_peer(const AnswerJob& job, AnswerFiles& files, AnswerSummary& summary) {
    const bool embree = job.options.peer == Peer::embree;
    embree ? answer_by_embree(job, files, summary) : answer_by_cgal(job, files, summary);
    // Nothing else is answered.
    summary.has_boxes = summary.has_boxes && !embree;
    summary.has_segments = summary.has_segments && embree;
    summary.has_points = false;
}

}  // namespace cob
