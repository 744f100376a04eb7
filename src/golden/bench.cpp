#include "cob/bench.hpp"

#include "golden/bench_set.hpp"

#include <algorithm>
#include <array>
#include <fstream>

namespace cob {

namespace {

struct Variant {
    const char* name;
    Arithmetic arithmetic;
};
constexpr std::array<Variant, 6> variants{{{"float", Arithmetic::binary32},
                                           {"double", Arithmetic::binary64},
                                           {"epsilon", Arithmetic::epsilon},
                                           {"interval", Arithmetic::interval},
                                           {"exact", Arithmetic::exact},
                                           {"rational", Arithmetic::rational}}};

/// The worst of a question's pairs.
Outcome judge(const BenchBox& box, const std::vector<BoxAnswer>& answers) {
    Outcome worst = Outcome::right;
    for (std::size_t k = 0; k < box.pairs.size(); ++k) {
        const BenchPair& pair = box.pairs[k];
        const BoxAnswer& answer = answers[k];
        const bool same = answer.relation == pair.relation && answer.covers == pair.covers;
        worst = std::max(worst, !answer.decided ? Outcome::undecided : same ? Outcome::right : Outcome::wrong);
    }
    return worst;
}

}  // namespace

void bench_boxes(const BenchSet& set, const BenchOptions& options, std::vector<BenchRow>& rows) {
    for (const Variant& variant : variants) {
        std::vector<BenchRow> kinds;
        for (const auto& [kind, boxes] : set.boxes) {
            std::vector<std::vector<BoxAnswer>> answers(boxes.size());
            for (std::size_t k = 0; k < boxes.size(); ++k) answers[k].resize(boxes[k].pairs.size());
            // A box has its binary64 frame from the beginning. What a variant needs beyond that (integers, intervals,
            // fractions) a box makes once, when first asked, and keeps: each repetition gets boxes of its own.
            std::vector<Box> prepared;
            const auto prepare = [&, &questions = boxes] {
                prepared.clear();
                for (const BenchBox& box : questions) prepared.emplace_back(box.question);
            };
            const auto ask = [&, &questions = boxes](std::size_t k) {
                const std::vector<BenchPair>& pairs = questions[k].pairs;
                for (std::size_t p = 0; p < pairs.size(); ++p)
                    answers[k][p] = relate(set.scene, pairs[p].polygon, prepared[k], variant.arithmetic);
            };
            const auto judge_one = [&, &questions = boxes](std::size_t k) { return judge(questions[k], answers[k]); };
            BenchRow row = measure(boxes.size(), options, ask, judge_one, prepare);
            row.question = "box", row.variant = variant.name, row.kind = kind;
            row.bytes = set.candidates->memory();
            kinds.push_back(std::move(row));
        }
        add_rows(rows, std::move(kinds));
    }
}

void bench_segments(const BenchSet& set, const BenchOptions& options, std::vector<BenchRow>& rows) {
    const VisibilityOracle oracle(set.scene, *set.candidates);
    for (const Variant& variant : variants) {
        std::vector<BenchRow> kinds;
        for (const auto& [kind, segments] : set.segments) {
            std::vector<VisibilityAnswer> answers(segments.size());
            const auto ask = [&, &questions = segments](std::size_t k) {
                answers[k] = oracle(questions[k].segment, variant.arithmetic);
            };
            BenchRow row = measure(segments.size(), options, ask, [&, &questions = segments](std::size_t k) {
                const Visibility exact = questions[k].visibility;
                if (!answers[k].decided) return Outcome::undecided;
                return exact == Visibility::grazing || answers[k].visibility == exact ? Outcome::right : Outcome::wrong;
            });
            row.question = "segment", row.variant = variant.name, row.kind = kind;
            row.bytes = set.candidates->memory() + oracle.memory();
            kinds.push_back(std::move(row));
        }
        add_rows(rows, std::move(kinds));
    }
}

std::vector<BenchRow> bench_set(const std::string& folder, const BenchOptions& options) {
    const BenchSet set = read_bench_set(folder, options);
    BenchOptions counted = options;
    if (options.progress)
        counted.progress = [&options, kinds = std::uint64_t{0}](std::uint64_t, std::uint64_t) mutable {
            options.progress(kinds++, 0);
        };
    std::vector<BenchRow> rows;
    bench_boxes(set, counted, rows);
    bench_cgal(set, counted, rows);
    bench_segments(set, counted, rows);
    bench_embree(set, counted, rows);
    return rows;
}

std::vector<BenchRow> bench_sets(const std::vector<std::string>& sets, const BenchOptions& options) {
    std::vector<BenchRow> sums;
    for (const std::string& set : sets)
        for (const BenchRow& row : bench_set(set, options)) {
            const auto same = std::find_if(sums.begin(), sums.end(), [&](const BenchRow& sum) {
                return sum.question == row.question && sum.variant == row.variant && sum.kind == row.kind;
            });
            if (same == sums.end())
                sums.push_back(row);
            else
                add_row(*same, row);
        }
    return sums;
}

BenchMachine bench_machine() {
    BenchMachine machine{"unknown processor", "unknown compiler", COB_COMMIT};
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);)
        if (line.rfind("model name", 0) == 0) {
            machine.processor = line.substr(line.find(':') + 2);
            break;
        }
#if defined(__clang__)
    machine.compiler = "clang " __clang_version__;
#elif defined(__GNUC__)
    machine.compiler = "gcc " __VERSION__;
#endif
    return machine;
}

}  // namespace cob
