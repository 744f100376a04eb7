#include "arithmetic/process.hpp"

#include <malloc.h>
#include <sys/resource.h>
#include <fstream>
#include <string>

namespace cob {

std::uint64_t peak_memory() {
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;  // Linux counts in KiB
}

namespace {

/// A line of /proc/self/status, "VmHWM" or "VmRSS", in bytes; 0 where there is none.
std::uint64_t status_bytes(const std::string& name) {
    std::ifstream file("/proc/self/status");
    for (std::string line; std::getline(file, line);)
        if (line.rfind(name + ":", 0) == 0) return std::stoull(line.substr(name.size() + 1)) * 1024;
    return 0;
}

std::uint64_t heap_in_use() {
    const struct mallinfo2 info = ::mallinfo2();
    return info.uordblks + info.hblkhd;
}

}  // namespace

MemoryWatch::MemoryWatch() {
    ::malloc_trim(0);  // else what the run before has freed would be taken again unseen
    std::ofstream reset("/proc/self/clear_refs");
    reset << "5" << std::flush;  // proc(5): the peak becomes the present resident set
    resident_ = reset.good() && status_bytes("VmHWM") > 0;
    before_ = resident_ ? status_bytes("VmRSS") : heap_in_use();
}

std::uint64_t MemoryWatch::peak() const {
    const std::uint64_t now = resident_ ? status_bytes("VmHWM") : heap_in_use();
    return now > before_ ? now - before_ : 0;
}

double processor_seconds() {
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_utime.tv_sec) + 1e-6 * static_cast<double>(usage.ru_utime.tv_usec);
}

}  // namespace cob
