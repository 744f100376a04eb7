/// \file
/// What --threads means.
#pragma once

#include <tbb/task_arena.h>

#include <algorithm>
#include <thread>

namespace cob {

/// The number of threads that the user's option means: 0 is one for each processor, and more than these bring nothing.
inline int thread_count(int option) {
    const int processors = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    return option > 0 ? std::min(option, processors) : processors;
}

/// Runs work, whose parallel loops take so many threads; 0: as many as the caller has, at first all.
template <class Work>
void on_threads(int option, const Work& work) {
    if (option > 0)
        tbb::task_arena(thread_count(option)).execute(work);
    else
        work();
}

}  // namespace cob
