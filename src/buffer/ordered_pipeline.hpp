/// \file
/// Blocks of work on several threads, taken up and put down in one order: same bytes for any number of threads, and
/// memory bounded by the blocks under way.
#pragma once

#include "arithmetic/threads.hpp"

#include <tbb/parallel_pipeline.h>

#include <cstddef>
#include <exception>
#include <vector>

namespace cob {

/// produce(block) fills the next block, false at the end, in order; work(block) runs on any thread; consume(block)
/// again in order. Of several exceptions the one of the earliest block leaves.
template <class Block, class Produce, class Work, class Consume>
void ordered_pipeline(int threads, const Produce& produce, const Work& work, const Consume& consume) {
    if (threads == 1) {
        for (Block block; produce(block); block = Block()) {
            work(block);
            consume(block);
        }
        return;
    }
    struct Slot {
        Block block;
        std::exception_ptr failure;
    };
    // Blocks are put down in order, so of those under way no two are `slots.size()` apart.
    std::vector<Slot> slots(static_cast<std::size_t>(4 * threads));
    std::size_t taken = 0;
    bool ended = false;
    const auto take = [&](tbb::flow_control& control) -> Slot* {
        Slot& slot = slots[taken++ % slots.size()];
        slot = Slot();
        try {
            ended = ended || !produce(slot.block);
        } catch (...) {
            // Blocks before it may still fail: the failure waits for its turn.
            slot.failure = std::current_exception();
        }
        if (ended) {
            control.stop();
            return nullptr;
        }
        ended = static_cast<bool>(slot.failure);
        return &slot;
    };
    const auto run = [&](Slot* slot) {
        try {
            if (!slot->failure) work(slot->block);
        } catch (...) {
            slot->failure = std::current_exception();
        }
        return slot;
    };
    const auto put = [&](Slot* slot) {
        if (slot->failure) std::rethrow_exception(slot->failure);
        consume(slot->block);
    };
    tbb::task_arena arena(threads);
    arena.execute([&] {
        tbb::parallel_pipeline(slots.size(), tbb::make_filter<void, Slot*>(tbb::filter_mode::serial_in_order, take) &
                                                 tbb::make_filter<Slot*, Slot*>(tbb::filter_mode::parallel, run) &
                                                 tbb::make_filter<Slot*, void>(tbb::filter_mode::serial_in_order, put));
    });
}

}  // namespace cob
