// SHA-256 by the instructions that x86 processors have for it (SHA extensions: sha256rnds2, sha256msg1, sha256msg2).
#include "golden/sha256.hpp"

#if defined(__x86_64__)

#include "golden/sha256_constants.hpp"

#include <cpuid.h>
#include <immintrin.h>

namespace cob {
namespace {

[[gnu::target("sha,sse4.1")]] __m128i load(const void* bytes) {
    return _mm_loadu_si128(static_cast<const __m128i*>(bytes));
}

/// The instructions keep the eight words a to h as {a, b, e, f} and {c, d, g, h}, the first named highest.
[[gnu::target("sha,sse4.1")]] void compress_by_processor(Sha256State& state, const unsigned char* blocks,
                                                         std::size_t count) {
    const __m128i big_endian = _mm_set_epi64x(0x0c0d0e0f08090a0b, 0x0405060700010203);

    const __m128i cdab = _mm_shuffle_epi32(load(state.data()), 0xb1), efgh = _mm_shuffle_epi32(load(&state[4]), 0x1b);
    __m128i abef = _mm_alignr_epi8(cdab, efgh, 8), cdgh = _mm_blend_epi16(efgh, cdab, 0xf0);

    for (; count > 0; --count, blocks += 64) {
        const __m128i abef_before = abef, cdgh_before = cdgh;
        __m128i w[4];  // words t - 16 to t - 1 of the message schedule, four to a register
        for (std::size_t t = 0; t < 64; t += 4) {
            __m128i& next = w[t / 4 % 4];
            if (t < 16) {
                next = _mm_shuffle_epi8(load(blocks + 4 * t), big_endian);
            } else {
                const __m128i &last = w[(t / 4 + 3) % 4], &before = w[(t / 4 + 2) % 4], &second = w[(t / 4 + 1) % 4];
                next = _mm_sha256msg2_epu32(
                    _mm_add_epi32(_mm_sha256msg1_epu32(next, second), _mm_alignr_epi8(last, before, 4)), last);
            }
            const __m128i terms = _mm_add_epi32(next, load(&sha256_constants[t]));
            cdgh = _mm_sha256rnds2_epu32(cdgh, abef, terms);
            abef = _mm_sha256rnds2_epu32(abef, cdgh, _mm_shuffle_epi32(terms, 0x0e));
        }
        abef = _mm_add_epi32(abef, abef_before);
        cdgh = _mm_add_epi32(cdgh, cdgh_before);
    }

    const __m128i feba = _mm_shuffle_epi32(abef, 0x1b), dchg = _mm_shuffle_epi32(cdgh, 0xb1);
    const __m128i dcba = _mm_blend_epi16(feba, dchg, 0xf0), hgfe = _mm_alignr_epi8(dchg, feba, 8);
    _mm_storeu_si128(static_cast<__m128i*>(static_cast<void*>(state.data())), dcba);
    _mm_storeu_si128(static_cast<__m128i*>(static_cast<void*>(&state[4])), hgfe);
}

}  // namespace

Sha256Compress sha256_compress_of_processor() {
    constexpr unsigned ssse3 = 1U << 9, sse41 = 1U << 19, sha = 1U << 29;
    unsigned a = 0, b = 0, c = 0, d = 0;
    if (__get_cpuid(1, &a, &b, &c, &d) == 0 || (c & ssse3) == 0 || (c & sse41) == 0) return nullptr;
    if (__get_cpuid_count(7, 0, &a, &b, &c, &d) == 0 || (b & sha) == 0) return nullptr;
    return compress_by_processor;
}

}  // namespace cob

#else

namespace cob {

Sha256Compress sha256_compress_of_processor() {
    return nullptr;
}

}  // namespace cob

#endif
