/// \file
/// One shard of a golden set: its questions with answers, kinds and bands, as rows without headers.
#pragma once

#include "cob/tables.hpp"
#include "cob/visibility.hpp"
#include "geometry/bounds.hpp"
#include "golden/questions.hpp"
#include "golden/shards.hpp"

namespace cob {

/// Questions first to last - 1 of one sort.
struct ShardRange {
    TagRow::Question question = TagRow::Question::box;
    std::uint64_t first = 0, last = 0;
};

class ShardMaker {
public:
    /// All must outlive it.
    ShardMaker(const Scene& scene, const CandidateSource& candidates, const Questions& questions);

    struct Shard {
        ShardTables tables;
        std::map<std::string, std::int64_t> counts;  ///< Rows of each table, and answers by name.
    };
    /// In parallel; the same bytes for any number of threads.
    Shard make(const ShardRange& range) const;

private:
    Shard box_block(std::uint64_t first, std::uint64_t last) const;
    Shard segment_block(std::uint64_t first, std::uint64_t last) const;

    const Scene& scene_;
    const CandidateSource& candidates_;
    const Questions& questions_;
    VisibilityOracle oracle_;
    std::vector<Bounds> bounds_;
};

}  // namespace cob
