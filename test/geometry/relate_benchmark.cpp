// Triangle against box by class of input: wrong answers first, then which stage decided, then times as ratios.
//   ratio to binary64: the product against the same formula in plain double;
//   ratio of Gmpq:     the same formula in CGAL::Gmpq against the product;
//   ratio of EPICK:    CGAL's do_intersect(Triangle_3, Bbox_3) against the product, boxes parallel to the axes.
// Run: relate_benchmark [Google Benchmark options]; times are of single queries, one thread.
#include "classes.hpp"
#include "geometry/prepared_box.hpp"
#include "geometry/study.hpp"
#include "geometry/study_kernels.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Intersections_3/Bbox_3_Triangle_3.h>
#include <benchmark/benchmark.h>

#include <cstdio>
#include <map>
#include <memory>

namespace cob::test {
namespace {

constexpr int triangle_count = 20000, box_count = 64;

using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;

/// The product's queries, and what the peers need to answer them.
struct Workload {
    InputClass input_class;
    Queries queries;
    std::vector<Epick::Triangle_3> triangles;
    std::vector<CGAL::Bbox_3> boxes;
    std::vector<FrameBox<CGAL::Gmpq>> gmpq_boxes;

    explicit Workload(const InputClass& input)
        : input_class(input), queries(QueryMaker(input, 2).make(box_count, triangle_count)) {
        for (PolygonId i = 0; i < queries.size(); ++i) {
            const View<VertexId> loop = queries.scene.loop(i);
            const auto corner = [&](int k) {
                const Point& p = queries.scene.position(loop[k]);
                return Epick::Point_3(p.x, p.y, p.z);
            };
            triangles.emplace_back(corner(0), corner(1), corner(2));
        }
        for (const auto& [low, high] : queries.extents) boxes.emplace_back(low.x, low.y, low.z, high.x, high.y, high.z);
        for (const Box& box : queries.boxes) {
            const ExactBox& exact = box.prepared().exact();
            const auto convert = [](const RationalPoint& p) {
                return Vector3<CGAL::Gmpq>{gmpq(p.x), gmpq(p.y), gmpq(p.z)};
            };
            gmpq_boxes.push_back({convert(exact.frame.low), convert(exact.frame.high)});
        }
    }

    static CGAL::Gmpq gmpq(const Rational& value) {
        CGAL::Gmpq result;
        mpq_set(result.mpq(), value.backend().data());
        return result;
    }
};

const Workload& workload(std::size_t i) {
    static std::map<std::size_t, std::unique_ptr<Workload>> all;
    std::unique_ptr<Workload>& one = all[i];
    if (!one) one = std::make_unique<Workload>(input_classes()[i]);
    return *one;
}

BoxAnswer relate_in_gmpq(const Workload& work, PolygonId i) {
    const ExactBox& exact = work.queries.box(i).prepared().exact();
    const auto to_frame = [&](const Point& p) {
        const auto along = [&](int k) {
            const Vector3<Integer>& d = exact.directions[static_cast<std::size_t>(k)];
            CGAL::Gmpq sum = 0;
            for (int axis = 0; axis < 3; ++axis)
                if (d[axis] != 0)
                    sum += Workload::gmpq(Rational(d[axis])) * (CGAL::Gmpq(p[axis]) - CGAL::Gmpq(exact.origin[axis]));
            return sum;
        };
        return Vector3<CGAL::Gmpq>{along(0), along(1), along(2)};
    };
    return relate_with(PlainKernel<CGAL::Gmpq>{}, work.gmpq_boxes[static_cast<std::size_t>(i) % work.gmpq_boxes.size()],
                       work.queries.scene, i, to_frame);
}

void print_correctness() {
    std::printf("%-18s %9s %9s %9s %9s | %8s %8s %9s | %s\n", "class", "binary32", "binary64", "epsilon", "interval",
                "filter", "integer", "rational", "crossing boundary coplanar base disjoint");
    std::printf("%-18s %9s %9s %9s %9s | %8s %8s %9s |\n", "", "wrong", "wrong", "wrong", "undecided", "%", "%", "%");
    for (std::size_t c = 0; c < input_classes().size(); ++c) {
        const Queries& queries = workload(c).queries;
        std::map<Arithmetic, int> wrong;
        std::map<Relation, int> relations;
        PredicateCounters stages;
        for (PolygonId i = 0; i < queries.size(); ++i) {
            const BoxAnswer exact = relate(queries.scene, i, queries.box(i), &stages);
            ++relations[exact.relation];
            for (const Arithmetic arithmetic : {Arithmetic::binary32, Arithmetic::binary64, Arithmetic::epsilon}) {
                const BoxAnswer answer = relate(queries.scene, i, queries.box(i), arithmetic);
                wrong[arithmetic] += answer.relation != exact.relation || answer.covers != exact.covers;
            }
            if (i % 10 == 0)
                wrong[Arithmetic::interval] +=
                    !relate(queries.scene, i, queries.box(i), Arithmetic::interval).decided * 10;
        }
        const double all = static_cast<double>(stages.filtered + stages.integer + stages.rational) / 100;
        std::printf("%-18s %9d %9d %9d %9d | %8.2f %8.2f %9.2f | %d %d %d %d %d\n", input_classes()[c].name,
                    wrong[Arithmetic::binary32], wrong[Arithmetic::binary64], wrong[Arithmetic::epsilon],
                    wrong[Arithmetic::interval], static_cast<double>(stages.filtered) / all,
                    static_cast<double>(stages.integer) / all, static_cast<double>(stages.rational) / all,
                    relations[Relation::crossing], relations[Relation::boundary], relations[Relation::coplanar],
                    relations[Relation::base], relations[Relation::disjoint]);
    }
    std::printf("of %d queries a class; interval: a tenth of them, times ten\n\n", triangle_count);
}

/// Runs through the first `queries` queries again and again; one iteration is one query.
template <class Query>
void run(benchmark::State& state, PolygonId queries, const Query& query) {
    PolygonId i = 0;
    for (auto _ : state) {
        benchmark::DoNotOptimize(query(i));
        if (++i == queries) i = 0;
    }
}

void register_benchmarks() {
    for (std::size_t c = 0; c < input_classes().size(); ++c) {
        const std::string name = input_classes()[c].name;
        const auto add = [&](const std::string& peer, auto query, PolygonId queries) {
            benchmark::RegisterBenchmark((name + "/" + peer).c_str(), [c, query, queries](benchmark::State& state) {
                const Workload& work = workload(c);
                run(state, queries, [&](PolygonId i) { return query(work, i); });
            });
        };
        const auto relate_in = [](Arithmetic arithmetic) {
            return [arithmetic](const Workload& work, PolygonId i) {
                return relate(work.queries.scene, i, work.queries.box(i), arithmetic);
            };
        };
        add("exact", relate_in(Arithmetic::exact), triangle_count);
        add("binary32", relate_in(Arithmetic::binary32), triangle_count);
        add("binary64", relate_in(Arithmetic::binary64), triangle_count);
        add("rational", relate_in(Arithmetic::rational), 1000);
        if (input_classes()[c].oblique) continue;  // Gmpq: a rational height; EPICK: boxes parallel to the axes
        add("gmpq", relate_in_gmpq, 1000);
        add(
            "epick",
            [](const Workload& work, PolygonId i) {
                return CGAL::do_intersect(work.triangles[static_cast<std::size_t>(i)],
                                          work.boxes[static_cast<std::size_t>(i) % work.boxes.size()]);
            },
            triangle_count);
    }
}

/// Prints as usual and remembers the least time of each benchmark.
class RatioReporter : public benchmark::ConsoleReporter {
public:
    void ReportRuns(const std::vector<Run>& runs) override {
        ConsoleReporter::ReportRuns(runs);
        for (const Run& run : runs) {
            if (run.run_type != Run::RT_Iteration || run.iterations == 0) continue;
            const std::string name = run.benchmark_name().substr(0, run.benchmark_name().find("/repeats"));
            const double nanoseconds = run.cpu_accumulated_time / static_cast<double>(run.iterations) * 1e9;
            const auto [found, added] = least_.try_emplace(name, nanoseconds);
            if (!added) found->second = std::min(found->second, nanoseconds);
        }
    }

    void print_ratios() const {
        std::printf("\n%-18s %10s %14s %12s %12s %14s\n", "class", "exact ns", "exact/binary64", "gmpq/exact",
                    "epick/exact", "rational/exact");
        for (const InputClass& input : input_classes()) {
            const std::string name = input.name;
            const auto time = [&](const char* peer) {
                const auto found = least_.find(name + "/" + peer);
                return found == least_.end() ? 0 : found->second;
            };
            const double exact = time("exact");
            if (exact == 0) continue;
            std::printf("%-18s %10.1f %14.2f %12.1f %12.2f %14.1f\n", input.name, exact,
                        time("binary64") > 0 ? exact / time("binary64") : 0, time("gmpq") / exact,
                        time("epick") / exact, time("rational") / exact);
        }
    }

private:
    std::map<std::string, double> least_;
};

}  // namespace
}  // namespace cob::test

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
    cob::test::print_correctness();
    cob::test::register_benchmarks();
    cob::test::RatioReporter reporter;
    benchmark::RunSpecifiedBenchmarks(&reporter);
    reporter.print_ratios();
    return 0;
}
