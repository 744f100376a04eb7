// How fast segments are answered, beside CGAL's tree over EPICK that counts intersected triangles, and beside
// fractions. What is wrong is printed before anything is timed.
//
// "fractions only, nothing known" is what the exact answers are measured against: the same code over the same
// candidates, where what the filters leave undecided goes to GMP's fractions at once: no integers of fixed width, and
// ends carry no pieces. "fractions only" is the same with ends that do.
//
// Where Embree is installed, the same with Embree as the tree, and Embree's own triangles in robust mode.
//
// Names: subject / ends of the segments / triangles. Counters: segments per second, share of the signs that each
// stage decided, bytes per polygon beside the scene.
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include "geometry/visibility_oracle.hpp"
#include "visibility/benchmark_scenes.hpp"

#include <benchmark/benchmark.h>

#ifdef COB_HAS_EMBREE
#include "geometry/embree_triangles.hpp"
#endif

#include <array>
#include <cstdio>
#include <map>
#include <memory>

namespace cob::test {
namespace {

constexpr int segment_count = 20000;
/// Triangles, about: against CGAL and fractions, and against Embree.
constexpr std::array<int, 2> sizes{741, 70000};
constexpr std::array<int, 3> embree_sizes{1000, 30000, 100000};

const char* to_text(Ends ends) {
    return ends == Ends::free_space ? "free space" : ends == Ends::surface ? "surface points" : "vertices";
}

/// A scene with its segments and oracles, made once.
struct Subject {
    explicit Subject(int triangles) : scene(benchmark_scene(triangles)) {
        for (const Ends ends : {Ends::free_space, Ends::surface, Ends::vertices})
            segments[ends] = benchmark_segments(scene, ends, segment_count);
        pieces = std::make_unique<PieceTable>(scene);
        for (const Source source : {Source::tree, Source::embree}) {
            if (!is_available(source)) continue;
            candidates[source] = make_candidates(scene, source);
            oracle[source] = std::make_unique<VisibilityOracle>(scene, *candidates[source]);
        }
    }
    Scene scene;
    std::map<Ends, std::vector<Segment>> segments;
    std::unique_ptr<PieceTable> pieces;
    std::map<Source, std::unique_ptr<CandidateSource>> candidates;
    std::map<Source, std::unique_ptr<VisibilityOracle>> oracle;
};

Subject& subject(int triangles) {
    static std::map<int, std::unique_ptr<Subject>> subjects;
    auto& entry = subjects[triangles];
    if (!entry) entry = std::make_unique<Subject>(triangles);
    return *entry;
}

void report(benchmark::State& state, const PredicateCounters& counters) {
    state.SetItemsProcessed(state.iterations());
    const double signs = static_cast<double>(counters.filtered + counters.integer + counters.rational);
    if (signs == 0) return;
    state.counters["filter%"] = 100 * static_cast<double>(counters.filtered) / signs;
    state.counters["integer%"] = 100 * static_cast<double>(counters.integer) / signs;
    state.counters["fraction%"] = 100 * static_cast<double>(counters.rational) / signs;
}

/// Calls ask(segment) for one segment after the other, round and round.
template <class Ask>
void run(benchmark::State& state, const std::vector<Segment>& segments, Ask ask) {
    std::size_t k = 0;
    for (auto _ : state) {
        benchmark::DoNotOptimize(ask(segments[k]));
        k = k + 1 == segments.size() ? 0 : k + 1;
    }
}

void oracle_benchmark(benchmark::State& state, int triangles, Ends ends, Source source) {
    Subject& s = subject(triangles);
    const VisibilityOracle& oracle = *s.oracle[source];
    PredicateCounters counters;
    run(state, s.segments[ends], [&](const Segment& segment) { return oracle(segment, &counters); });
    report(state, counters);
    state.counters["bytes/polygon"] = static_cast<double>(oracle.memory() + s.candidates[source]->memory()) /
                                      static_cast<double>(s.scene.polygon_count());
}

/// The same code with fractions behind the filter and nothing else; `known_ends`: what the ends are known to lie on
/// still spares arithmetic.
void fractions_benchmark(benchmark::State& state, int triangles, Ends ends, Source source, bool known_ends) {
    Subject& s = subject(triangles);
    PredicateCounters counters;
    run(state, s.segments[ends], [&](const Segment& segment) {
        const ExactSigns signs(*s.pieces, segment, {&counters, Fallback::fractions, known_ends});
        return visibility_along(signs, *s.candidates[source], segment);
    });
    report(state, counters);
}

void cgal_benchmark(benchmark::State& state, int triangles, Ends ends) {
    using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
    using Iterator = std::vector<Kernel::Triangle_3>::const_iterator;
    using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, CGAL::AABB_triangle_primitive<Kernel, Iterator>>>;
    Subject& s = subject(triangles);
    const auto point = [](const Point& p) { return Kernel::Point_3(p.x, p.y, p.z); };
    std::vector<Kernel::Triangle_3> soup;
    for (const Piece& piece : s.scene.pieces()) {
        const View<VertexId> c = s.scene.corners(piece);
        soup.emplace_back(point(s.scene.position(c[0])), point(s.scene.position(c[1])), point(s.scene.position(c[2])));
    }
    Tree tree(soup.begin(), soup.end());
    tree.build();
    run(state, s.segments[ends], [&](const Segment& segment) {
        return tree.number_of_intersected_primitives(
            Kernel::Segment_3(point(segment.from.nearest()), point(segment.to.nearest())));
    });
    state.SetItemsProcessed(state.iterations());
}

#ifdef COB_HAS_EMBREE
void embree_benchmark(benchmark::State& state, int triangles, Ends ends) {
    Subject& s = subject(triangles);
    const EmbreeTriangles embree(s.scene);
    run(state, s.segments[ends], [&](const Segment& segment) { return embree.hidden(segment); });
    state.SetItemsProcessed(state.iterations());
    int missed = 0, invented = 0;
    for (const Segment& segment : s.segments[ends]) {
        const Visibility answer = (*s.oracle[Source::tree])(segment);
        const bool hidden = embree.hidden(segment);
        missed += answer == Visibility::blocked && !hidden;
        invented += answer == Visibility::clear && hidden;
    }
    state.counters["blocked missed"] = missed;
    state.counters["clear hidden"] = invented;
}
#endif

/// Every twentieth segment against fractions alone; prints and returns how many answers are wrong.
int wrong_answers(int triangles, Ends ends) {
    Subject& s = subject(triangles);
    int wrong = 0, asked = 0;
    std::map<Visibility, int> answers;
    for (std::size_t k = 0; k < s.segments[ends].size(); k += 20) {
        const Segment& segment = s.segments[ends][k];
        const Visibility answer = (*s.oracle[Source::tree])(segment, Arithmetic::rational).visibility;
        for (const auto& [source, oracle] : s.oracle) wrong += (*oracle)(segment) != answer;
        ++answers[answer];
        ++asked;
    }
    std::printf("%-14s %6d triangles: %d wrong of %d (clear %d, grazing %d, blocked %d)\n", to_text(ends),
                s.scene.polygon_count(), wrong, asked, answers[Visibility::clear], answers[Visibility::grazing],
                answers[Visibility::blocked]);
    return wrong;
}

}  // namespace
}  // namespace cob::test

int main(int argc, char** argv) {
    using namespace cob;
    using namespace cob::test;
    benchmark::Initialize(&argc, argv);
    int wrong = 0;
    const auto add = [](const std::string& subject, int triangles, Ends ends, auto function) {
        const std::string name = subject + "/" + to_text(ends) + "/" + std::to_string(triangles);
        benchmark::RegisterBenchmark(name.c_str(), function);
    };
    const std::array<Ends, 3> all_ends{Ends::free_space, Ends::surface, Ends::vertices};
    for (const int triangles : sizes)
        for (const Ends ends : all_ends) {
            wrong += wrong_answers(triangles, ends);
            for (const Source source : {Source::tree, Source::embree}) {
                if (!is_available(source)) continue;
                const std::string tree = std::string(" over ") + cob::to_text(source);
                add("cob" + tree, triangles, ends,
                    [=](auto& state) { oracle_benchmark(state, triangles, ends, source); });
                add("fractions only" + tree, triangles, ends,
                    [=](auto& state) { fractions_benchmark(state, triangles, ends, source, true); });
                add("fractions only, nothing known" + tree, triangles, ends,
                    [=](auto& state) { fractions_benchmark(state, triangles, ends, source, false); });
            }
            add("CGAL EPICK count", triangles, ends, [=](auto& state) { cgal_benchmark(state, triangles, ends); });
        }
#ifdef COB_HAS_EMBREE
    for (const int triangles : embree_sizes)
        for (const Ends ends : all_ends) {
            wrong += wrong_answers(triangles, ends);
            add("beside Embree: cob over embree", triangles, ends,
                [=](auto& state) { oracle_benchmark(state, triangles, ends, Source::embree); });
            add("beside Embree: its triangles", triangles, ends,
                [=](auto& state) { embree_benchmark(state, triangles, ends); });
        }
#endif
    benchmark::RunSpecifiedBenchmarks();
    return wrong == 0 ? 0 : 1;
}
