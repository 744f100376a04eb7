#include "golden/sha256.hpp"

#include "golden/sha256_constants.hpp"

#include <algorithm>
#include <cstring>

namespace cob {
namespace {

constexpr std::uint32_t rotate(std::uint32_t x, int n) {
    return (x >> n) | (x << (32 - n));
}

std::uint32_t big_endian(const unsigned char* bytes) {
    return std::uint32_t{bytes[0]} << 24 | std::uint32_t{bytes[1]} << 16 | std::uint32_t{bytes[2]} << 8 | bytes[3];
}

void compress_block(Sha256State& state, const unsigned char* block) {
    std::array<std::uint32_t, 64> w;
    for (std::size_t t = 0; t < 16; ++t) w[t] = big_endian(block + 4 * t);
    for (std::size_t t = 16; t < 64; ++t) {
        const std::uint32_t s0 = rotate(w[t - 15], 7) ^ rotate(w[t - 15], 18) ^ (w[t - 15] >> 3);
        const std::uint32_t s1 = rotate(w[t - 2], 17) ^ rotate(w[t - 2], 19) ^ (w[t - 2] >> 10);
        w[t] = w[t - 16] + s0 + w[t - 7] + s1;
    }
    auto [a, b, c, d, e, f, g, h] = state;
    for (std::size_t t = 0; t < 64; ++t) {
        const std::uint32_t sum1 = rotate(e, 6) ^ rotate(e, 11) ^ rotate(e, 25);
        const std::uint32_t t1 = h + sum1 + ((e & f) ^ (~e & g)) + sha256_constants[t] + w[t];
        const std::uint32_t sum0 = rotate(a, 2) ^ rotate(a, 13) ^ rotate(a, 22);
        const std::uint32_t t2 = sum0 + ((a & b) ^ (a & c) ^ (b & c));
        h = g;
        g = f;
        f = e;
        e = d + t1;
        d = c;
        c = b;
        b = a;
        a = t1 + t2;
    }
    const Sha256State sum = {a, b, c, d, e, f, g, h};
    for (std::size_t k = 0; k < 8; ++k) state[k] += sum[k];
}

}  // namespace

void sha256_compress(Sha256State& state, const unsigned char* blocks, std::size_t count) {
    for (; count > 0; --count, blocks += 64) compress_block(state, blocks);
}

Sha256::Sha256() {
    static const Sha256Compress of_processor = sha256_compress_of_processor();
    compress_ = of_processor != nullptr ? of_processor : sha256_compress;
}

void Sha256::update(std::string_view bytes) {
    const auto* at = reinterpret_cast<const unsigned char*>(bytes.data());
    std::size_t left = bytes.size(), filled = length_ % 64;
    length_ += bytes.size();
    if (filled > 0) {
        const std::size_t count = std::min(left, 64 - filled);
        std::memcpy(pending_.data() + filled, at, count);
        at += count;
        left -= count;
        if (filled + count < 64) return;
        compress_(state_, pending_.data(), 1);
    }
    if (left >= 64) compress_(state_, at, left / 64);
    if (left % 64 > 0) std::memcpy(pending_.data(), at + left / 64 * 64, left % 64);
}

std::string Sha256::finish() {
    const std::uint64_t bits = 8 * length_;
    update(std::string_view("\x80", 1));
    static constexpr std::array<char, 64> zeros{};
    update(std::string_view(zeros.data(), (120 - length_ % 64) % 64));
    std::array<char, 8> size;
    for (std::size_t k = 0; k < 8; ++k) size[k] = static_cast<char>(bits >> (56 - 8 * k));
    update(std::string_view(size.data(), size.size()));

    std::string digits;
    for (const std::uint32_t word : state_)
        for (int shift = 28; shift >= 0; shift -= 4) digits += "0123456789abcdef"[word >> shift & 15];
    return digits;
}

}  // namespace cob
