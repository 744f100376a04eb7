/// \file
/// Memory that is read here and there by every segment, on large pages where the system has them: with small ones the
/// processor spends more time on finding the pages than on reading them.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <new>
#include <vector>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace cob {

/// An allocator for std::vector. Alike for all types, so that all are equal.
template <class T>
class LargePages {
public:
    using value_type = T;

    LargePages() = default;
    template <class Other>
    LargePages(const LargePages<Other>&) {}  // NOLINT: implicit, as the standard asks

    T* allocate(std::size_t count) {
        const std::size_t bytes = count * sizeof(T);
        if (bytes < page) return static_cast<T*>(::operator new(bytes, alignment()));
        const std::size_t whole = (bytes + page - 1) / page * page;
        void* memory = std::aligned_alloc(page, whole);
        if (memory == nullptr) throw std::bad_alloc();
#ifdef MADV_HUGEPAGE
        madvise(memory, whole, MADV_HUGEPAGE);  // a hint: refused, nothing changes
#endif
        return static_cast<T*>(memory);
    }
    void deallocate(T* memory, std::size_t count) {
        if (count * sizeof(T) < page)
            ::operator delete(memory, alignment());
        else
            std::free(memory);
    }
    friend bool operator==(const LargePages&, const LargePages&) {
        return true;
    }
    friend bool operator!=(const LargePages&, const LargePages&) {
        return false;
    }

private:
    static constexpr std::size_t page = std::size_t{1} << 21;
    static constexpr std::align_val_t alignment() {
        return std::align_val_t{alignof(T)};
    }
};

template <class T>
using LargeVector = std::vector<T, LargePages<T>>;

}  // namespace cob
