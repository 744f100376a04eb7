/// \file
/// Four binary32 numbers side by side, by the vector extensions that gcc and clang share.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>

namespace cob {

using Lanes = float __attribute__((vector_size(16)));
using LaneMask = std::int32_t __attribute__((vector_size(16)));  ///< All bits of a lane set: true.

inline Lanes all_lanes(float value) {
    return Lanes{value, value, value, value};
}
/// The second where either is NaN.
inline Lanes lesser(Lanes a, Lanes b) {
    return a < b ? a : b;
}
inline Lanes greater(Lanes a, Lanes b) {
    return a > b ? a : b;
}
inline Lanes absolute(Lanes a) {
    return greater(a, -a);
}
/// Lane k takes what lane k + 1 had, the last what the first had.
inline Lanes rotated(Lanes a) {
    return __builtin_shufflevector(a, a, 1, 2, 3, 0);
}
inline float greatest(Lanes a) {
    return std::max(std::max(a[0], a[1]), std::max(a[2], a[3]));
}
/// Bit k: lane k is true.
inline unsigned bits_of(LaneMask mask) {
    const LaneMask weighted = mask & LaneMask{1, 2, 1, 2};
    std::array<std::uint64_t, 2> halves;
    std::memcpy(halves.data(), &weighted, sizeof weighted);
    const std::uint64_t both = halves[0] | halves[1] << 2;
    return static_cast<unsigned>(both | both >> 32) & 15u;
}
inline bool all_of(LaneMask mask) {
    return bits_of(mask) == 15;
}

}  // namespace cob
