/// \file
/// Random choices that are the same on every platform: raw engine bits only, the case's number is the seed.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <iterator>
#include <random>

namespace cob::naive {

class Dice {
public:
    explicit Dice(std::uint64_t seed) : engine_(seed) {}

    /// One of 0 to count - 1.
    int below(int count) { return static_cast<int>((engine_() >> 11) % static_cast<std::uint64_t>(count)); }
    /// One of first to last.
    int between(int first, int last) { return first + below(last - first + 1); }
    bool one_in(int count) { return below(count) == 0; }
    template <class T>
    T pick(std::initializer_list<T> choices) {
        return choices.begin()[below(static_cast<int>(std::size(choices)))];
    }
    template <class Container>
    const auto& any(const Container& choices) {
        return choices[static_cast<std::size_t>(below(static_cast<int>(std::size(choices))))];
    }

private:
    std::mt19937_64 engine_;
};

}  // namespace cob::naive
