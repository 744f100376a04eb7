/// \file
/// Signed integers of a fixed number of 64-bit limbs, for exact determinants without allocation.
#pragma once

#include "cob/arithmetic.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

namespace cob {

/// Two's complement, least limb first. Sums keep the width and products add the widths; the caller chooses the width
/// so that nothing overflows.
template <int limbs>
struct FixedInteger {
    std::array<std::uint64_t, static_cast<std::size_t>(limbs)> limb{};

    bool negative() const { return (limb[limbs - 1] >> 63) != 0; }
    Sign sign() const {
        if (negative()) return Sign::negative;
        for (const std::uint64_t word : limb)
            if (word != 0) return Sign::positive;
        return Sign::zero;
    }

    FixedInteger& operator+=(const FixedInteger& other) {
        std::uint64_t carry = 0;
        for (int k = 0; k < limbs; ++k) {
            const std::uint64_t sum = limb[k] + other.limb[k];
            const std::uint64_t total = sum + carry;
            carry = static_cast<std::uint64_t>(sum < limb[k]) + static_cast<std::uint64_t>(total < sum);
            limb[k] = total;
        }
        return *this;
    }
    FixedInteger& operator-=(const FixedInteger& other) {
        std::uint64_t borrow = 0;
        for (int k = 0; k < limbs; ++k) {
            const std::uint64_t difference = limb[k] - other.limb[k];
            const std::uint64_t total = difference - borrow;
            borrow =
                static_cast<std::uint64_t>(limb[k] < other.limb[k]) + static_cast<std::uint64_t>(difference < borrow);
            limb[k] = total;
        }
        return *this;
    }
    friend FixedInteger operator+(FixedInteger a, const FixedInteger& b) { return a += b; }
    friend FixedInteger operator-(FixedInteger a, const FixedInteger& b) { return a -= b; }
};

template <int n, int m>
FixedInteger<n + m> operator*(const FixedInteger<n>& a, const FixedInteger<m>& b) {
    __extension__ using Wide = unsigned __int128;
    FixedInteger<n + m> product;
    for (int i = 0; i < n; ++i) {
        std::uint64_t carry = 0;
        for (int j = 0; j < m; ++j) {
            const Wide sum = static_cast<Wide>(a.limb[i]) * b.limb[j] + product.limb[i + j] + carry;
            product.limb[i + j] = static_cast<std::uint64_t>(sum);
            carry = static_cast<std::uint64_t>(sum >> 64);
        }
        product.limb[i + m] = carry;
    }
    // Read as unsigned, a negative factor is too great by 2^(its width): take the other factor off, that far up.
    const auto take_off = [&product](const auto& factor, int from, int count) {
        std::uint64_t borrow = 0;
        for (int k = 0; k < count; ++k) {
            std::uint64_t& word = product.limb[from + k];
            const std::uint64_t difference = word - factor.limb[k];
            const std::uint64_t total = difference - borrow;
            borrow =
                static_cast<std::uint64_t>(word < factor.limb[k]) + static_cast<std::uint64_t>(difference < borrow);
            word = total;
        }
    };
    if (a.negative()) take_off(b, n, m);
    if (b.negative()) take_off(a, m, n);
    return product;
}

/// The binary places that a set of numbers occupies: from 2^low up to below 2^(high + 1).
struct BinaryRange {
    int low = std::numeric_limits<int>::max(), high = std::numeric_limits<int>::min();

    /// A finite number; zero occupies nothing.
    void add(double value) {
        if (value == 0) return;
        const Parts parts = parts_of(value);
        const int last = parts.exponent + __builtin_ctzll(parts.mantissa);
        const int first = parts.exponent + 63 - __builtin_clzll(parts.mantissa);
        low = last < low ? last : low;
        high = first > high ? first : high;
    }
    int places() const { return low > high ? 0 : high - low + 1; }

    /// |value| = mantissa 2^exponent, for finite values.
    struct Parts {
        std::uint64_t mantissa;
        int exponent;
    };
    static Parts parts_of(double value) {
        std::uint64_t bits;
        std::memcpy(&bits, &value, sizeof bits);
        const std::uint64_t fraction = bits & ((std::uint64_t{1} << 52) - 1);
        const int biased = static_cast<int>((bits >> 52) & 0x7ff);
        if (biased == 0) return {fraction, -1074};
        return {fraction | (std::uint64_t{1} << 52), biased - 1075};
    }
};

/// value / 2^low; value is a multiple of 2^low and fits.
template <int limbs>
FixedInteger<limbs> to_fixed(double value, int low) {
    FixedInteger<limbs> result;
    if (value == 0) return result;
    auto [mantissa, exponent] = BinaryRange::parts_of(value);
    int shift = exponent - low;
    if (shift < 0) {
        mantissa >>= -shift;  // only zeros leave: value is a multiple of 2^low
        shift = 0;
    }
    const int word = shift / 64, bit = shift % 64;
    result.limb[word] = mantissa << bit;
    if (bit > 0 && word + 1 < limbs) result.limb[word + 1] = mantissa >> (64 - bit);
    return value < 0 ? FixedInteger<limbs>{} - result : result;
}

}  // namespace cob
