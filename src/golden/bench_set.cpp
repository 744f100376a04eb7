#include "golden/bench_set.hpp"

#include "cob/error.hpp"
#include "cob/files.hpp"
#include "cob/manifest.hpp"
#include "cob/tables.hpp"
#include "cob/verify/recorder.hpp"
#include "geometry/candidate_list.hpp"

#include <algorithm>
#include <chrono>

namespace cob {

namespace {

std::vector<PolygonId> candidates_of(const BenchSet& set, const Box& box) {
    std::vector<PolygonId> found = polygons_in(*set.candidates, box.bounds());
    found.erase(std::remove(found.begin(), found.end(), box.polygon()), found.end());
    return found;
}

void read_boxes(const std::string& folder, const BenchOptions& options, BenchSet& set) {
    verify::detail::Tags tags(folder, "box");
    TableReader<BoxRow> boxes(folder + "/boxes.csv");
    TableReader<RelationRow> relations(folder + "/relations.csv");
    BoxRow row;
    RelationRow relation;
    bool more = relations.next(relation);
    while (boxes.next(row)) {
        auto& of_kind = set.boxes[tags.of(row.box).kind];
        const bool wanted = of_kind.size() < options.most_of_kind;
        std::map<PolygonId, BenchPair> pairs;
        for (; more && relation.box == row.box; more = relations.next(relation))
            pairs[relation.polygon] = {relation.polygon, relation.relation, relation.covers};
        if (!wanted) continue;
        BenchBox entry{row.question, {}};
        for (const PolygonId id : candidates_of(set, Box(row.question))) pairs.try_emplace(id, BenchPair{id});
        for (const auto& [id, pair] : pairs) entry.pairs.push_back(pair);
        of_kind.push_back(std::move(entry));
    }
}

void read_segments(const std::string& folder, const BenchOptions& options, BenchSet& set) {
    verify::detail::Tags tags(folder, "segment");
    TableReader<SegmentRow> segments(folder + "/segments.csv");
    TableReader<VisibilityRow> answers(folder + "/visibility.csv");
    SegmentRow row;
    VisibilityRow answer;
    while (segments.next(row) && answers.next(answer)) {
        auto& of_kind = set.segments[tags.of(row.segment).kind];
        if (of_kind.size() < options.most_of_kind) of_kind.push_back({{row.from, row.to}, answer.visibility});
    }
}

}  // namespace

BenchSet read_bench_set(const std::string& folder, const BenchOptions& options) {
    check_files(folder, read_set_manifest(folder));
    BenchSet set{read_obj(folder + "/scene.obj", {true, false}), {}, {}, {}};
    set.candidates = make_candidates(set.scene, Source::tree);
    try {
        if (exists(folder + "/boxes.csv")) read_boxes(folder, options, set);
        if (exists(folder + "/segments.csv")) read_segments(folder, options, set);
    } catch (const verify::Error& error) {
        throw InputError(error.what());
    }
    return set;
}

BenchRow measure(std::size_t count, const BenchOptions& options, const std::function<void(std::size_t)>& ask,
                 const std::function<Outcome(std::size_t)>& judge, const std::function<void()>& prepare) {
    if (options.progress) options.progress(0, 0);
    BenchRow row;
    row.questions = count;
    if (count == 0) return row;
    std::vector<double> times;
    for (int repetition = 0; repetition < std::max(1, options.repetitions); ++repetition) {
        prepare();
        const auto begin = std::chrono::steady_clock::now();
        for (std::size_t k = 0; k < count; ++k) ask(k);
        const std::chrono::duration<double, std::nano> elapsed = std::chrono::steady_clock::now() - begin;
        times.push_back(elapsed.count() / static_cast<double>(count));
    }
    std::sort(times.begin(), times.end());
    row.nanoseconds_min = times.front();
    row.nanoseconds_median = times[times.size() / 2];
    for (std::size_t k = 0; k < count; ++k) {
        const Outcome outcome = judge(k);
        row.wrong += outcome == Outcome::wrong;
        row.undecided += outcome == Outcome::undecided;
    }
    return row;
}

void add_row(BenchRow& sum, const BenchRow& row) {
    const auto before = static_cast<double>(sum.questions), added = static_cast<double>(row.questions);
    const auto mean = [&](double a, double b) { return added == 0 ? a : (a * before + b * added) / (before + added); };
    sum.nanoseconds_min = mean(sum.nanoseconds_min, row.nanoseconds_min);
    sum.nanoseconds_median = mean(sum.nanoseconds_median, row.nanoseconds_median);
    sum.questions += row.questions, sum.wrong += row.wrong, sum.undecided += row.undecided;
    sum.bytes = std::max(sum.bytes, row.bytes);
}

void add_rows(std::vector<BenchRow>& rows, std::vector<BenchRow> kinds) {
    if (kinds.empty()) return;
    BenchRow all;
    all.question = kinds.front().question, all.variant = kinds.front().variant, all.kind = "all";
    for (const BenchRow& row : kinds) add_row(all, row);
    rows.push_back(all);
    rows.insert(rows.end(), kinds.begin(), kinds.end());
}

}  // namespace cob
