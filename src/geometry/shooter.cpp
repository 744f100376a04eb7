#include "cob/shooter.hpp"

#include "arithmetic/threads.hpp"
#include "cob/error.hpp"

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

constexpr std::size_t block = 64;  ///< Of one thread in a row: segments cost around a microsecond.

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
    in_parallel(
        threads.count, receivers.size(),
        [&](std::size_t k) { fractions[k] = visible_fraction(oracle, receivers[k], samples); }, block);
    return fractions;
}

std::vector<Visibility> visibilities(const VisibilityOracle& oracle, const std::vector<Segment>& segments,
                                     Threads threads) {
    std::vector<Visibility> answers(segments.size());
    in_parallel(
        threads.count, segments.size(), [&](std::size_t k) { answers[k] = oracle(segments[k]); }, block);
    return answers;
}

}  // namespace cob
