/// \file
/// A fuzz target: whatever the bytes are, reading them ends as the reader says or with InputError.
///
/// Each target is a program: with COB_FUZZ and clang one for libFuzzer, else one that changes the seeds at random,
/// which ctest runs and which fails unless every outcome occurs often.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace cob::fuzz {

struct Target {
    std::vector<std::string> seeds;     ///< Texts to begin with.
    std::vector<std::string> words;     ///< That mean something to the reader.
    std::vector<std::string> outcomes;  ///< What read() returns; each at least every 20th time. "refused": InputError.
    long rounds;                        ///< Texts that the test reads.
    std::function<std::string(std::string_view)> read;  ///< Ends the process (require()) where a promise is broken.
};

/// The program's target.
Target target();

inline void require(bool condition, const char* what) {
    if (condition) return;
    std::fprintf(stderr, "broken: %s\n", what);
    std::abort();
}

/// For readers that take a path: a new file each time, as cutting off an old one waits for the disk.
inline void write_anew(const std::string& path, std::string_view text) {
    std::remove(path.c_str());
    std::ofstream(path, std::ios::binary) << text;
}

}  // namespace cob::fuzz
