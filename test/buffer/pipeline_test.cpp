// Blocks of work in order on any number of threads.
#include "buffer/ordered_pipeline.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

namespace cob {
namespace {

struct Block {
    int number = -1, result = -1;
};

TEST(OrderedPipeline, PutsDownInTheOrderOfTakingUp) {
    for (const int threads : {1, 2, 5}) {
        int next = 0;
        std::vector<int> results;
        ordered_pipeline<Block>(
            threads, [&](Block& block) { return (block.number = next++) < 1000; },
            [](Block& block) { block.result = block.number * block.number; },
            [&](const Block& block) { results.push_back(block.result); });
        ASSERT_EQ(results.size(), 1000u);
        for (int k = 0; k < 1000; ++k) ASSERT_EQ(results[static_cast<std::size_t>(k)], k * k);
    }
}

// Of several failures the first in order is the one that is told, whichever thread is faster; what comes before it
// has been put down.
TEST(OrderedPipeline, TheEarliestFailureLeaves) {
    for (const int threads : {1, 2, 5})
        for (const int unreadable : {100, 41}) {  // where taking up fails, too
            int next = 0, put = 0;
            std::string told;
            try {
                ordered_pipeline<Block>(
                    threads,
                    [&](Block& block) {
                        block.number = next++;
                        if (block.number == unreadable) throw std::runtime_error("taking up");
                        return true;
                    },
                    [](const Block& block) {
                        if (block.number >= 40) throw std::runtime_error("work " + std::to_string(block.number));
                    },
                    [&](const Block&) { ++put; });
            } catch (const std::runtime_error& error) {
                told = error.what();
            }
            EXPECT_EQ(told, "work 40");
            EXPECT_EQ(put, 40);
        }
}

}  // namespace
}  // namespace cob
