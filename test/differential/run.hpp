/// \file
/// Runs many cases on all cores and counts what they met: a test whose cases never gave some answer has not tested
/// it, and fails.
#pragma once

#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

#include <cstdint>
#include <cstdio>
#include <map>
#include <string>
#include <vector>

namespace cob::test {

/// How many times the ordinary length the tests have (COB_LONG_TESTS: 100).
inline constexpr std::uint64_t length = COB_LENGTH;

/// What happened in some cases.
struct Tally {
    std::map<std::string, std::uint64_t> counts;  ///< How often each answer occurred.
    std::uint64_t differences = 0;
    std::vector<std::string> first_differences;  ///< At most ten.

    void count(const std::string& answer) { ++counts[answer]; }
    /// Counts as an answer that agrees, or as a difference, to be shown with its case's number.
    void compare(const std::string& library, const std::string& naive, const std::string& what) {
        count(naive);
        if (library == naive) return;
        ++differences;
        if (first_differences.size() < 10)
            first_differences.push_back(what + ": library " + library + ", naive " + naive);
    }
    Tally& operator+=(const Tally& other) {
        for (const auto& [answer, times] : other.counts) counts[answer] += times;
        differences += other.differences;
        for (const std::string& difference : other.first_differences)
            if (first_differences.size() < 10) first_differences.push_back(difference);
        return *this;
    }
};

/// Cases first to first + count - 1, in parallel; the sum is formed in their order.
template <class Case>
Tally run_cases(std::uint64_t first, std::uint64_t count, Case one_case) {
    constexpr std::uint64_t block = 64;
    std::vector<Tally> blocks((count + block - 1) / block);
    tbb::parallel_for(std::size_t{0}, blocks.size(), [&](std::size_t b) {
        const std::uint64_t begin = first + b * block, end = std::min(first + count, begin + block);
        for (std::uint64_t seed = begin; seed < end; ++seed) one_case(seed, blocks[b]);
    });
    Tally sum;
    for (const Tally& one : blocks) sum += one;
    return sum;
}

/// Correctness first, then the counts.
inline void expect_no_difference(const Tally& tally) {
    std::printf("%llu differences;", static_cast<unsigned long long>(tally.differences));
    for (const auto& [answer, times] : tally.counts)
        std::printf(" %s %llu", answer.c_str(), static_cast<unsigned long long>(times));
    std::printf("\n");
    EXPECT_EQ(tally.differences, 0u);
    for (const std::string& difference : tally.first_differences) ADD_FAILURE() << difference;
}

/// Each of these answers made up at least this share of all of them.
inline void expect_shares(const Tally& tally, const std::vector<std::pair<std::string, double>>& least) {
    double sum = 0;
    const auto times = [&](const std::string& answer) {
        const auto found = tally.counts.find(answer);
        return found == tally.counts.end() ? 0.0 : static_cast<double>(found->second);
    };
    for (const auto& [answer, share] : least) sum += times(answer);
    for (const auto& [answer, share] : least) EXPECT_GE(times(answer), share * sum) << answer;
}

}  // namespace cob::test
