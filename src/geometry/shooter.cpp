#include "cob/shooter.hpp"

#include "cob/error.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <cmath>
#include <string>

namespace cob {
namespace {

/// Sample points are combinations of corners with weights on this grid: with corners of 53 bits they are sums of two
/// binary64 numbers.
constexpr double grid = 0x1p15;

double on_grid(double weight) {
    return std::floor(weight * grid + 0.5) / grid;
}

/// Calls work(k) for every k below count, on as many threads as wanted; every k writes only what is its own.
template <class Work>
void for_each_index(std::size_t count, Threads threads, Work work) {
    constexpr std::size_t block = 64;  // segments cost around a microsecond
    const auto run = [&] {
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, block),
                          [&](const tbb::blocked_range<std::size_t>& range) {
                              for (std::size_t k = range.begin(); k != range.end(); ++k) work(k);
                          });
    };
    if (threads.count == 1) {
        for (std::size_t k = 0; k < count; ++k) work(k);
    } else if (threads.count > 1) {
        tbb::task_arena(threads.count).execute(run);
    } else {
        run();
    }
}

}  // namespace

std::vector<SamplePoint> sample_points(const Scene& scene, const Root& root, const Element& element, int per_side) {
    if (per_side < 1 || per_side > 64)
        throw InputError("sample points per side", {"", 0, std::to_string(per_side), "choose 1 to 64"});
    std::vector<SamplePoint> samples;
    samples.reserve(static_cast<std::size_t>(per_side) * static_cast<std::size_t>(per_side));
    const auto add = [&](double s, double t) {
        samples.push_back({point_in(scene, root, element, on_grid(s / per_side), on_grid(t / per_side)), root.piece});
    };
    const bool triangle = root.corner_count() == 3;
    for (int j = 0; j < per_side; ++j)
        for (int i = 0; i < (triangle ? per_side - j : per_side); ++i) {
            if (!triangle) {
                add(i + 0.5, j + 0.5);
                continue;
            }
            add(i + 1.0 / 3, j + 1.0 / 3);
            if (i + j + 1 < per_side) add(i + 2.0 / 3, j + 2.0 / 3);
        }
    return samples;
}

double visible_fraction(const VisibilityOracle& oracle, const SamplePoint& receiver,
                        const std::vector<SamplePoint>& samples, PredicateCounters* counters) {
    std::size_t seen = 0, counted = 0;
    for (const SamplePoint& sample : samples) {
        if (sample.point == receiver.point) continue;
        ++counted;
        const Segment segment{receiver.point, sample.point, receiver.piece, sample.piece};
        if (oracle(segment, counters) != Visibility::blocked) ++seen;
    }
    return counted == 0 ? 0 : static_cast<double>(seen) / static_cast<double>(counted);
}

std::vector<double> visible_fractions(const VisibilityOracle& oracle, const std::vector<SamplePoint>& receivers,
                                      const std::vector<SamplePoint>& samples, Threads threads) {
    std::vector<double> fractions(receivers.size());
    for_each_index(receivers.size(), threads,
                   [&](std::size_t k) { fractions[k] = visible_fraction(oracle, receivers[k], samples); });
    return fractions;
}

std::vector<Visibility> visibilities(const VisibilityOracle& oracle, const std::vector<Segment>& segments,
                                     Threads threads) {
    std::vector<Visibility> answers(segments.size());
    for_each_index(segments.size(), threads, [&](std::size_t k) { answers[k] = oracle(segments[k]); });
    return answers;
}

}  // namespace cob
