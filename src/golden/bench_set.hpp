/// \file
/// A golden set, read for measuring: questions by kind, with everything but the decision prepared.
#pragma once

#include "cob/bench.hpp"
#include "cob/candidates.hpp"
#include "cob/geometry.hpp"
#include "cob/scene.hpp"
#include "cob/visibility.hpp"

#include <functional>
#include <map>
#include <memory>
#include <vector>

namespace cob {

struct BenchPair {
    PolygonId polygon = no_polygon;
    Relation relation = Relation::disjoint;  ///< The exact one.
    bool covers = false;
};

struct BenchBox {
    BoxQuestion question;
    std::vector<BenchPair> pairs;  ///< Candidates, and whatever the set lists.
};

struct BenchSegment {
    Segment segment;
    Visibility visibility = Visibility::clear;  ///< The exact one.
};

struct BenchSet {
    Scene scene;
    std::unique_ptr<CandidateSource> candidates;
    std::map<std::string, std::vector<BenchBox>> boxes;  ///< By kind.
    std::map<std::string, std::vector<BenchSegment>> segments;
};

BenchSet read_bench_set(const std::string& folder, const BenchOptions& options);

/// What one question came out as.
enum class Outcome : std::uint8_t { right, undecided, wrong };

/// Asks `count` questions several times over. Before each time, and before the clock starts, prepare() makes anew what
/// the questions may keep; ask(k) decides question k and keeps the answer; judge(k) tells what it was worth, after the
/// clock has stopped. Tells the progress that it begins.
BenchRow measure(
    std::size_t count, const BenchOptions& options, const std::function<void(std::size_t)>& ask,
    const std::function<Outcome(std::size_t)>& judge, const std::function<void()>& prepare = [] {});

/// Rows of the variants in our own arithmetics, and of other people's code; each with the kinds and their sum.
void bench_boxes(const BenchSet& set, const BenchOptions& options, std::vector<BenchRow>& rows);
void bench_segments(const BenchSet& set, const BenchOptions& options, std::vector<BenchRow>& rows);
void bench_cgal(const BenchSet& set, const BenchOptions& options, std::vector<BenchRow>& rows);
/// Nothing where the program was built without Embree.
void bench_embree(const BenchSet& set, const BenchOptions& options, std::vector<BenchRow>& rows);

/// Adds one row's questions to those of a sum.
void add_row(BenchRow& sum, const BenchRow& row);
/// Adds the rows of one variant and their sum as kind "all".
void add_rows(std::vector<BenchRow>& rows, std::vector<BenchRow> kinds);

}  // namespace cob
