// boxes.csv -> states.csv and relations.csv.
#include "buffer/ordered_pipeline.hpp"
#include "buffer/shared_cache.hpp"
#include "cob/classification.hpp"
#include "golden/answer.hpp"

namespace cob {
namespace {

constexpr std::size_t block_size = 1024;

struct Block {
    std::vector<BoxRow> rows;
    std::string states, relations;
    std::uint64_t undecided = 0;
    PredicateCounters predicates;
};

/// Classifies the boxes of one block.
class BlockWork {
public:
    explicit BlockWork(const AnswerJob& job) : job_(job), path_(job.question_path<BoxRow>()) {}

    void operator()(Block& block) const {
        BoxClassifier classifier(job_.scene, job_.options.arithmetic);
        SharedCache shared(job_.scene);
        Classification found;
        for (const BoxRow& row : block.rows) {
            at_line(path_, row.line, [&] {
                refuse_unknown_polygon(job_.scene, row.question.polygon);
                classifier.from_scene(Box(row.question), job_.source, found);
            });
            append(row, found, shared, block);
        }
        block.predicates = classifier.counters();
        block.rows = {};
    }

private:
    static void append(const BoxRow& row, Classification& found, SharedCache& shared, Block& block) {
        for (const Neighbour& neighbour : found.neighbours) {
            const BoxAnswer& answer = neighbour.answer;
            append_row(block.relations, RelationRow{row.box, neighbour.polygon, answer.relation, answer.covers,
                                                    shared(row.question.polygon, neighbour.polygon), answer.decided});
            block.undecided += !answer.decided;
        }
        block.undecided += !found.decided;
        if (found.state == BufferState::occluded) found.close.clear();
        append_row(block.states, StateRow{row.box, found.state, found.close, found.cover, found.light, found.decided});
    }

    const AnswerJob& job_;
    std::string path_;
};

}  // namespace

void answer_boxes(const AnswerJob& job, AnswerFiles& files, AnswerSummary& summary) {
    TableReader<BoxRow> questions(job.question_path<BoxRow>());
    auto& states = files.states.emplace(job.answer_path<StateRow>());
    auto& relations = files.relations.emplace(job.answer_path<RelationRow>());
    ordered_pipeline<Block>(
        thread_count(job.options.threads),
        [&](Block& block) {
            block.rows = read_rows(questions, block_size);
            return !block.rows.empty();
        },
        BlockWork(job),
        [&](const Block& block) {
            states.write_lines(block.states);
            relations.write_lines(block.relations);
            summary.undecided += block.undecided;
            summary.predicates += block.predicates;
            if (job.options.progress) job.options.progress(states.rows(), 0);
        });
    summary.boxes = states.rows();
    summary.relations = relations.rows();
}

}  // namespace cob
