/// \file
/// Lists of polygons behind 30-bit places: what a CloseObjectBuffer of 4 bytes points to.
#pragma once

#include "cob/buffer.hpp"

#include <array>
#include <atomic>
#include <memory>
#include <mutex>
#include <vector>

namespace cob {

/// Append-only and thread-safe. A place counts words of 4 bytes: a list is its length, then its polygons. Places are
/// cut into chunks that are allocated when they are first needed; a list longer than a chunk takes several places'
/// worth of chunks at once, so that every list is contiguous and never moves.
class BufferBuilder::Pool {
public:
    /// The place of the list; 0 for the empty one. Throws InputError when 4 GiB are full.
    std::uint32_t store(View<PolygonId> list);
    View<PolygonId> list(std::uint32_t place) const;
    std::size_t bytes() const { return words_.load() * sizeof(std::uint32_t); }

private:
    static constexpr std::uint32_t chunk_bits = 16;
    static constexpr std::uint32_t chunk_words = 1u << chunk_bits;
    static constexpr std::uint32_t chunk_count = 1u << (30 - chunk_bits);

    std::uint32_t allocate(std::uint64_t words);

    std::array<std::atomic<std::uint32_t*>, chunk_count> chunks_{};  ///< Read without the mutex.
    std::mutex mutex_;
    std::vector<std::unique_ptr<std::uint32_t[]>> memory_;  ///< Of the chunks.
    std::uint64_t next_ = 1;                                ///< First free place; 0 is the empty list.
    std::atomic<std::uint64_t> words_{0};
};

}  // namespace cob
