/// \file
/// What this process has used: for summaries, never for answers.
#pragma once

#include <chrono>
#include <cstdint>

namespace cob {

/// Most bytes of memory that the process has held at any time so far.
std::uint64_t peak_memory();

/// Most memory that the process held since this was made, beyond what it held then.
class MemoryWatch {
public:
    MemoryWatch();
    /// Of the resident set, whose high-water mark Linux lets a process reset; where it does not: what the heap holds
    /// now beyond what it held then.
    std::uint64_t peak() const;

private:
    bool resident_ = false;
    std::uint64_t before_ = 0;
};

/// Seconds of processor time that all threads of the process have used so far, by the program itself.
double processor_seconds();

/// Seconds since it was made or since the last lap().
class Stopwatch {
public:
    double lap() {
        const auto now = std::chrono::steady_clock::now();
        const double seconds = std::chrono::duration<double>(now - begin_).count();
        begin_ = now;
        return seconds;
    }

private:
    std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

}  // namespace cob
