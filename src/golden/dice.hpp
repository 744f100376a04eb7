/// \file
/// Random numbers that are a pure function of (seed, stream, index): each question draws its own, so that shards can
/// be made in any order. SplitMix64 (Steele, Lea, Flood 2014); raw bits only, so the same on every platform.
#pragma once

#include <cstdint>

namespace cob {

class Dice {
public:
    Dice(std::uint64_t seed, std::uint64_t stream, std::uint64_t index)
        : state_(mix(mix(seed + golden_gamma) + stream * golden_gamma) ^ mix(index + 1)) {}

    std::uint64_t operator()() { return mix(state_ += golden_gamma); }
    /// 0 to n - 1, from 32 bits while n is below 2^32. No value is likelier than another by 2^-32, above by 2^-64.
    std::uint64_t below(std::uint64_t n) {
        const int bits = n >> 32 == 0 ? 32 : 64;
        return static_cast<std::uint64_t>(uint128{(*this)() >> (64 - bits)} * n >> bits);
    }
    /// One of the values.
    template <class Range>
    const auto& of(const Range& range) {
        return range[below(range.size())];
    }
    bool coin() { return ((*this)() >> 63) != 0; }

private:
    __extension__ using uint128 = unsigned __int128;
    static constexpr std::uint64_t golden_gamma = 0x9e3779b97f4a7c15;
    static std::uint64_t mix(std::uint64_t z) {
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
        z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
        return z ^ (z >> 31);
    }
    std::uint64_t state_;
};

}  // namespace cob
