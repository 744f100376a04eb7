// How fast segments are answered, beside CGAL's tree over EPICK that counts intersected triangles, and beside the same
// code with fractions as its only fallback. What is wrong is printed before anything is timed.
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

#include <cstdio>
#include <map>
#include <memory>

namespace cob::test {
namespace {

constexpr int segment_count = 20000;
constexpr int small = 741, large = 70000;

const char* to_text(Ends ends) {
    return ends == Ends::free_space ? "free space" : ends == Ends::surface ? "surface points" : "vertices";
}

/// A scene with its segments and oracles, made once.
struct Subject {
    explicit Subject(int triangles) : scene(benchmark_scene(triangles)) {
        for (const Ends ends : {Ends::free_space, Ends::surface, Ends::vertices})
            segments[ends] = benchmark_segments(scene, ends, segment_count);
        candidates = make_candidates(scene, Source::cgal);
        pieces = std::make_unique<PieceTable>(scene);
        oracle = std::make_unique<VisibilityOracle>(scene, *candidates);
    }
    Scene scene;
    std::map<Ends, std::vector<Segment>> segments;
    std::unique_ptr<CandidateSource> candidates;
    std::unique_ptr<PieceTable> pieces;
    std::unique_ptr<VisibilityOracle> oracle;
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

void oracle_benchmark(benchmark::State& state, int triangles, Ends ends) {
    Subject& s = subject(triangles);
    PredicateCounters counters;
    run(state, s.segments[ends], [&](const Segment& segment) { return (*s.oracle)(segment, &counters); });
    report(state, counters);
    state.counters["bytes/polygon"] =
        static_cast<double>(s.oracle->memory() + s.candidates->memory()) / static_cast<double>(s.scene.polygon_count());
}

/// `hints`: with the pieces that the ends lie on, else without, as textbook code has it.
void fractions_benchmark(benchmark::State& state, int triangles, Ends ends, bool hints) {
    Subject& s = subject(triangles);
    PredicateCounters counters;
    run(state, s.segments[ends], [&](Segment segment) {
        if (!hints) segment.from_piece = segment.to_piece = -1;
        const ExactSigns signs(*s.pieces, segment, {&counters, Fallback::fractions});
        return visibility_along(signs, *s.candidates, segment);
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

/// Every tenth segment against fractions alone; prints and returns how many answers are wrong.
int wrong_answers(int triangles, Ends ends) {
    Subject& s = subject(triangles);
    int wrong = 0, asked = 0;
    std::map<Visibility, int> answers;
    for (std::size_t k = 0; k < s.segments[ends].size(); k += 20) {
        const Visibility answer = (*s.oracle)(s.segments[ends][k]);
        wrong += answer != (*s.oracle)(s.segments[ends][k], Arithmetic::rational).visibility;
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
    using namespace cob::test;
    benchmark::Initialize(&argc, argv);
    int wrong = 0;
    for (const int triangles : {small, large})
        for (const Ends ends : {Ends::free_space, Ends::surface, Ends::vertices}) {
            wrong += wrong_answers(triangles, ends);
            const std::string name = std::string("/") + to_text(ends) + "/" + std::to_string(triangles);
            const auto add = [&name](const char* subject, auto function) {
                benchmark::RegisterBenchmark((subject + name).c_str(), function);
            };
            add("cob", [=](benchmark::State& state) { oracle_benchmark(state, triangles, ends); });
            add("fractions only, no hints",
                [=](benchmark::State& state) { fractions_benchmark(state, triangles, ends, false); });
            add("fractions only", [=](benchmark::State& state) { fractions_benchmark(state, triangles, ends, true); });
            add("CGAL EPICK count", [=](benchmark::State& state) { cgal_benchmark(state, triangles, ends); });
        }
    benchmark::RunSpecifiedBenchmarks();
    return wrong == 0 ? 0 : 1;
}
