// segments.csv -> visibility.csv.
#include "buffer/ordered_pipeline.hpp"
#include "geometry/visibility_oracle.hpp"
#include "golden/answer.hpp"

namespace cob {
namespace {

constexpr std::size_t block_size = 4096;

struct Block {
    std::vector<SegmentRow> rows;
    std::string visibility;
    std::uint64_t undecided = 0;
    PredicateCounters predicates;
};

}  // namespace

Segment checked_segment(const Scene& scene, const SegmentRow& row) {
    refuse_unknown_polygon(scene, row.from_polygon);
    refuse_unknown_polygon(scene, row.to_polygon);
    const Segment segment{row.from, row.to, -1, -1};
    refuse_a_point(segment);
    return segment;
}

void answer_segments(const AnswerJob& job, AnswerFiles& files, AnswerSummary& summary) {
    const std::string path = job.question_path<SegmentRow>();
    TableReader<SegmentRow> questions(path);
    auto& visibility = files.visibility.emplace(job.answer_path<VisibilityRow>());
    const VisibilityOracle oracle(job.scene, job.source);
    ordered_pipeline<Block>(
        thread_count(job.options.threads),
        [&](Block& block) {
            block.rows = read_rows(questions, block_size);
            return !block.rows.empty();
        },
        [&](Block& block) {
            for (const SegmentRow& row : block.rows)
                at_line(path, row.line, [&] {
                    const Segment segment = checked_segment(job.scene, row);
                    const VisibilityAnswer answer = oracle(segment, job.options.arithmetic, &block.predicates);
                    append_row(block.visibility, VisibilityRow{row.segment, answer.visibility, answer.decided});
                    block.undecided += !answer.decided;
                });
            block.rows = {};
        },
        [&](const Block& block) {
            visibility.write_lines(block.visibility);
            summary.undecided += block.undecided;
            summary.predicates += block.predicates;
            if (job.options.progress) job.options.progress(visibility.rows(), 0);
        });
    summary.segments = visibility.rows();
}

}  // namespace cob
