/// \file
/// Progress of loops on several threads.
#pragma once

#include "cob/progress.hpp"

#include <mutex>

namespace cob {

/// Tells progress from many threads, one at a time.
class SharedProgress {
public:
    /// Refers to `progress`, which may be empty.
    SharedProgress(const Progress& progress, std::uint64_t total) : progress_(progress), total_(total) {}
    void step(std::uint64_t more = 1) {
        if (!progress_) return;
        const std::lock_guard<std::mutex> lock(mutex_);
        progress_(done_ += more, total_);
    }
    /// Nothing done, but a chance to be interrupted.
    void pulse() { step(0); }

private:
    const Progress& progress_;
    std::uint64_t total_, done_ = 0;
    std::mutex mutex_;
};

}  // namespace cob
