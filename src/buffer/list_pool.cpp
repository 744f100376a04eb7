#include "buffer/list_pool.hpp"

#include "cob/error.hpp"

#include <algorithm>

namespace cob {

std::uint32_t BufferBuilder::Pool::allocate(std::uint64_t words) {
    const std::lock_guard<std::mutex> lock(mutex_);
    const std::uint64_t left = chunk_words - next_ % chunk_words;
    if (words > left && next_ % chunk_words != 0) next_ += left;
    const std::uint64_t first = next_ / chunk_words, last = (next_ + words - 1) / chunk_words;
    if (last >= chunk_count)
        throw InputError("lists of close polygons exceed 4 GiB", {"", 0, "", "use fewer elements or smaller boxes"});
    // The rest of a long list's last chunk stays unused: the next list begins a chunk of its own.
    if (chunks_[first].load() == nullptr) {
        memory_.push_back(std::make_unique<std::uint32_t[]>(std::max<std::uint64_t>(words, chunk_words)));
        chunks_[first].store(memory_.back().get());
    }
    const auto place = static_cast<std::uint32_t>(next_);
    next_ = first == last ? next_ + words : (last + 1) * chunk_words;
    words_ += words;
    return place;
}

std::uint32_t BufferBuilder::Pool::store(View<PolygonId> list) {
    if (list.empty()) return 0;
    const std::uint32_t place = allocate(list.size() + 1);
    std::uint32_t* words = chunks_[place / chunk_words].load() + place % chunk_words;
    *words = static_cast<std::uint32_t>(list.size());
    std::transform(list.begin(), list.end(), words + 1, [](PolygonId id) { return static_cast<std::uint32_t>(id); });
    return place;
}

View<PolygonId> BufferBuilder::Pool::list(std::uint32_t place) const {
    if (place == 0) return {};
    const std::uint32_t* words = chunks_[place / chunk_words].load() + place % chunk_words;
    // Signed and unsigned words of one width may alias.
    const auto* first = reinterpret_cast<const PolygonId*>(words + 1);
    return {first, first + *words};
}

}  // namespace cob
