/// \file
/// SHA-256, FIPS 180-4, incremental.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace cob {

using Sha256State = std::array<std::uint32_t, 8>;

/// The compression function over `count` blocks of 64 bytes.
using Sha256Compress = void (*)(Sha256State& state, const unsigned char* blocks, std::size_t count);

/// In plain C++.
void sha256_compress(Sha256State& state, const unsigned char* blocks, std::size_t count);
/// By the processor's own instructions, five times as fast; null where it has none.
Sha256Compress sha256_compress_of_processor();

class Sha256 {
public:
    /// With the fastest there is.
    Sha256();
    explicit Sha256(Sha256Compress compress) : compress_(compress) {}

    void update(std::string_view bytes);
    /// The digest of all bytes so far, as 64 lower-case hexadecimal digits; nothing may follow.
    std::string finish();

private:
    Sha256Compress compress_;
    Sha256State state_{0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a, 0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
    std::array<unsigned char, 64> pending_{};
    std::uint64_t length_ = 0;  ///< Bytes so far.
};

}  // namespace cob
