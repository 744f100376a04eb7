#include "golden/answer_shard.hpp"

#include "buffer/shared_cache.hpp"
#include "golden/band.hpp"

#include <tbb/parallel_for.h>

namespace cob {

namespace {

constexpr std::uint64_t block_size = 256;  ///< Questions that one task answers.

}  // namespace

ShardMaker::ShardMaker(const Scene& scene, const CandidateSource& candidates, const Questions& questions)
    : scene_(scene), candidates_(candidates), questions_(questions), oracle_(scene, candidates) {
    bounds_.reserve(scene.polygons().size());
    for (PolygonId id = 0; id < scene.polygon_count(); ++id) bounds_.push_back(bounds_of(scene, scene.loop(id)));
}

ShardMaker::Shard ShardMaker::make(const ShardRange& range) const {
    const std::uint64_t blocks = (range.last - range.first + block_size - 1) / block_size;
    std::vector<Shard> parts(blocks);
    tbb::parallel_for(std::uint64_t{0}, blocks, [&](std::uint64_t block) {
        const std::uint64_t first = range.first + block * block_size, last = std::min(first + block_size, range.last);
        parts[block] = range.question == TagRow::Question::box ? box_block(first, last) : segment_block(first, last);
    });

    Shard whole = std::move(parts.front());
    for (std::uint64_t block = 1; block < blocks; ++block) {
        for (auto& [name, text] : parts[block].tables) whole.tables[name] += text;
        for (const auto& [name, count] : parts[block].counts) whole.counts[name] += count;
        parts[block] = {};
    }
    return whole;
}

ShardMaker::Shard ShardMaker::box_block(std::uint64_t first, std::uint64_t last) const {
    std::string boxes, states, relations, tags;
    Shard shard;
    BoxBands bands(scene_, candidates_, bounds_);
    SharedCache shared_with(scene_);
    Classification found;
    for (std::uint64_t number = first; number < last; ++number) {
        const BoxTask task = questions_.box(number);
        const auto id = static_cast<RowId>(number);
        const int band = bands(task.question, found);

        append_row(boxes, BoxRow{id, task.question});
        append_row(tags, TagRow{TagRow::Question::box, id, task.kind, band});
        const bool closed = found.state == BufferState::occluded;
        append_row(states, StateRow{id, found.state, closed ? std::vector<PolygonId>{} : found.close, found.cover,
                                    found.light});
        ++shard.counts[std::string("state ") + to_text(found.state)];
        for (const Neighbour& neighbour : found.neighbours) {
            append_row(relations, RelationRow{id, neighbour.polygon, neighbour.answer.relation, neighbour.answer.covers,
                                              shared_with(task.question.polygon, neighbour.polygon)});
            ++shard.counts[std::string("relation ") + to_text(neighbour.answer.relation)];
        }
    }
    shard.counts["boxes"] = static_cast<std::int64_t>(last - first);
    shard.tables = {{table_name<BoxRow>(), std::move(boxes)},
                    {table_name<StateRow>(), std::move(states)},
                    {table_name<RelationRow>(), std::move(relations)},
                    {table_name<TagRow>(), std::move(tags)}};
    return shard;
}

ShardMaker::Shard ShardMaker::segment_block(std::uint64_t first, std::uint64_t last) const {
    std::string segments, visibility, tags;
    Shard shard;
    for (std::uint64_t number = first; number < last; ++number) {
        const SegmentTask task = questions_.segment(number);
        const auto id = static_cast<RowId>(number);
        Visibility answer = Visibility::clear;
        const int band = segment_band(scene_, oracle_, task.segment, answer);

        append_row(segments, SegmentRow{id, task.segment.from, task.segment.to, task.from, task.to});
        append_row(visibility, VisibilityRow{id, answer});
        append_row(tags, TagRow{TagRow::Question::segment, id, task.kind, band});
        ++shard.counts[std::string("visibility ") + to_text(answer)];
    }
    shard.counts["segments"] = static_cast<std::int64_t>(last - first);
    shard.tables = {{table_name<SegmentRow>(), std::move(segments)},
                    {table_name<VisibilityRow>(), std::move(visibility)},
                    {table_name<TagRow>(), std::move(tags)}};
    return shard;
}

}  // namespace cob
