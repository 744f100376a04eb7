/// \file
/// What --threads means, and loops on several threads.
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cstddef>
#include <thread>

namespace cob {

/// The number of threads that the user's option means: 0 is one for each processor, and more than these bring nothing.
inline int thread_count(int option) {
    const int processors = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    return option > 0 ? std::min(option, processors) : processors;
}

/// f(0) to f(count - 1), each once, about `grain` in a row, on so many threads; 0: as many as the caller has, at first
/// all.
template <class F>
void in_parallel(int threads, std::size_t count, const F& f, std::size_t grain = 1) {
    const auto run = [&] {
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, grain), [&](const auto& range) {
            for (std::size_t k = range.begin(); k != range.end(); ++k) f(k);
        });
    };
    if (threads > 0)
        tbb::task_arena(thread_count(threads)).execute(run);
    else
        run();
}

}  // namespace cob
