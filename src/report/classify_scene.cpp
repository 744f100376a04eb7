#include "report/classify_scene.hpp"

#include "arithmetic/shared_progress.hpp"
#include "buffer/ordered_pipeline.hpp"
#include "buffer/shared_cache.hpp"
#include "cob/files.hpp"
#include "cob/tables.hpp"
#include "report/ply.hpp"

#include <algorithm>
#include <optional>

namespace cob {
namespace {

constexpr std::uint64_t block_size = 1024;  // a power of 4: with a tree of buffers, a block is a whole subtree

/// Consecutive elements and what is to be written of them.
struct Block {
    std::uint64_t first = 0, last = 0;
    std::string boxes, states, relations, inherited, corners;
    std::vector<CloseObjectBuffer> buffers;
    ClassifyStatistics statistics;
};

/// The files, as many as are wanted.
struct Files {
    TableWriter<StateRow> states;
    std::optional<TableWriter<BoxRow>> boxes;
    std::optional<TableWriter<RelationRow>> relations;
    std::optional<OutputFile> inherited;
    std::optional<PlyWriter> ply;

    Files(const std::string& folder, const ElementList& elements, const ClassifySceneOptions& options)
        : states(folder + "/" + table_name<StateRow>()) {
        if (options.boxes) boxes.emplace(folder + "/" + table_name<BoxRow>());
        if (options.relations) relations.emplace(folder + "/" + table_name<RelationRow>());
        if (options.classify.buffer.mode == BufferMode::inherit) {
            inherited.emplace(folder + "/inherited.csv");
            inherited->write("box,state,inherited\n");
        }
        if (!options.ply) return;
        std::uint64_t corners = 0;
        for (const Element& patch : elements.patches())
            corners += static_cast<std::uint64_t>(elements.root_of(patch).corner_count());
        ply.emplace(folder + "/elements.ply", corners << (2 * elements.meshing().level), elements.size());
    }

    void write(const Block& block) {
        states.write_lines(block.states);
        if (boxes) boxes->write_lines(block.boxes);
        if (relations) relations->write_lines(block.relations);
        if (inherited) inherited->write(block.inherited);
        if (ply) ply->write_corners(block.corners);
    }

    void commit() {
        states.commit();
        if (boxes) boxes->commit();
        if (relations) relations->commit();
        if (inherited) inherited->commit();
        if (ply) ply->commit();
    }
};

/// Classifies the elements of a block and makes their lines.
class BlockWork {
public:
    BlockWork(const ElementList& elements, const CandidateSource& source, BufferBuilder& buffers,
              const ClassifySceneOptions& options, SharedProgress& progress)
        : elements_(elements), source_(source), buffers_(buffers), options_(options), progress_(progress) {}

    void operator()(Block& block) const {
        ElementClassifier classifier(elements_, source_, options_.classify);
        SharedCache shared(elements_.scene());
        ClassifiedElement element;
        for (std::uint64_t number = block.first; number < block.last; ++number) {
            if (number % 16 == 0) progress_.pulse();
            classifier(number, element);
            append(static_cast<RowId>(number), element, shared, block);
        }
        block.statistics = classifier.statistics();
    }

private:
    void append(RowId id, const ClassifiedElement& element, SharedCache& shared, Block& block) const {
        const Classification& found = element.found;
        append_row(block.states, StateRow{id, found.state,
                                          found.state == BufferState::occluded ? std::vector<PolygonId>() : found.close,
                                          found.cover, found.light, true});
        if (options_.boxes) append_row(block.boxes, BoxRow{id, element.question, 0});
        if (options_.relations)
            for (const Neighbour& neighbour : found.neighbours)
                append_row(block.relations,
                           RelationRow{id, neighbour.polygon, neighbour.answer.relation, neighbour.answer.covers,
                                       shared(element.question.polygon, neighbour.polygon), true});
        if (element.inherited && *element.inherited != found.state)
            block.inherited +=
                std::to_string(id) + "," + to_text(found.state) + "," + to_text(*element.inherited) + "\n";
        if (options_.ply) PlyWriter::append_corners(block.corners, element.question.corners);
        block.buffers.push_back(buffers_.keep(found));
    }

    const ElementList& elements_;
    const CandidateSource& source_;
    BufferBuilder& buffers_;
    const ClassifySceneOptions& options_;
    SharedProgress& progress_;
};

}  // namespace

ClassifySceneResult classify_scene(const ElementList& elements, const CandidateSource& source,
                                   const std::string& folder, const ClassifySceneOptions& options) {
    ClassifySceneOptions plan = options;
    plan.classify.relations = options.relations;
    plan.classify.questions = options.boxes || options.relations || options.ply;
    BufferBuilder builder(elements.scene(), elements.roots(), source, plan.classify.buffer);
    std::vector<CloseObjectBuffer> buffers;
    buffers.reserve(elements.size());
    Files files(folder, elements, plan);
    ClassifySceneResult result;

    // Elements, block by block.
    SharedProgress progress(plan.progress, elements.size());
    std::uint64_t next = 0;
    ordered_pipeline<Block>(
        thread_count(plan.threads),
        [&](Block& block) {
            block.first = next;
            block.last = next = std::min(next + block_size, elements.size());
            return block.first < block.last;
        },
        BlockWork(elements, source, builder, plan, progress),
        [&](const Block& block) {
            files.write(block);
            buffers.insert(buffers.end(), block.buffers.begin(), block.buffers.end());
            result.statistics += block.statistics;
            progress.step(block.last - block.first);
        });

    // Faces of the picture: PLY wants them after all corners.
    if (files.ply)
        for (std::uint64_t number = 0; number < elements.size(); ++number) {
            const Element& patch = elements.patches()[number >> (2 * elements.meshing().level)];
            files.ply->write_face(elements.root_of(patch).corner_count(), buffers[number].state());
        }
    files.commit();
    result.relations = files.relations ? files.relations->rows() : 0;
    result.buffer_bytes = buffers.size() * sizeof(CloseObjectBuffer);
    result.list_bytes = builder.list_bytes();
    return result;
}

}  // namespace cob
