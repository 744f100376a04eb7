/// \file
/// Integers of a fixed number of 64-bit limbs, on the stack: the exact stage behind the filters.
#pragma once

#include "cob/arithmetic.hpp"

#include <algorithm>
#include <array>
#include <climits>
#include <cstdint>
#include <cstring>

namespace cob {

__extension__ typedef unsigned __int128 DoubleLimb;

/// a + b + carry; carry becomes what leaves the limb.
inline std::uint64_t add_with_carry(std::uint64_t a, std::uint64_t b, std::uint64_t& carry) {
    const std::uint64_t sum = a + b, total = sum + carry;
    carry = static_cast<std::uint64_t>(sum < a) + static_cast<std::uint64_t>(total < sum);
    return total;
}

/// a - b - borrow; borrow becomes what is missing.
inline std::uint64_t subtract_with_borrow(std::uint64_t a, std::uint64_t b, std::uint64_t& borrow) {
    const std::uint64_t difference = a - b, total = difference - borrow;
    borrow = static_cast<std::uint64_t>(a < b) + static_cast<std::uint64_t>(difference < borrow);
    return total;
}

/// A finite binary64 number as it is stored.
struct StoredParts {
    std::uint64_t mantissa;  ///< Less than 2^53; 0 for zero.
    int exponent;            ///< |value| = mantissa * 2^exponent.
    bool negative;

    explicit StoredParts(double value) {
        std::uint64_t bits;
        std::memcpy(&bits, &value, sizeof bits);
        negative = (bits >> 63) != 0;
        const int biased = static_cast<int>((bits >> 52) & 0x7ff);
        mantissa = bits & ((std::uint64_t{1} << 52) - 1);
        if (biased != 0) mantissa |= std::uint64_t{1} << 52;
        exponent = (biased == 0 ? 1 : biased) - 1075;
    }
};

/// A finite binary64 number as an odd integer times a power of two.
struct BinaryParts {
    std::uint64_t magnitude = 0;  ///< Odd, or 0 for zero.
    int exponent = 0;             ///< |value| = magnitude * 2^exponent.
    bool negative = false;

    explicit BinaryParts(double value) {
        const StoredParts stored(value);
        negative = stored.negative;
        if (stored.mantissa == 0) return;
        const int zeros = __builtin_ctzll(stored.mantissa);
        magnitude = stored.mantissa >> zeros;
        exponent = stored.exponent + zeros;
    }
};

/// Which bits a set of numbers uses: every one is a multiple of 2^low and less than 2^high in absolute value.
struct BitSpan {
    int low = INT_MAX / 4, high = INT_MIN / 4;

    void add(double value) {
        if (value == 0) return;
        const StoredParts parts(value);
        low = std::min(low, parts.exponent + __builtin_ctzll(parts.mantissa));
        high = std::max(high, parts.exponent + 64 - __builtin_clzll(parts.mantissa));
    }
    bool only_zeros() const { return high < low; }
    /// Bits of the largest magnitude when counted in units of 2^low.
    int bits() const { return only_zeros() ? 0 : high - low; }
};

/// Two's complement integer of Limbs x 64 bits. Operations wrap silently: the caller proves, by counting bits,
/// that every result whose sign is asked fits; all else, conversions too, is modulo 2^bits and may wrap.
template <int Limbs>
class WideInteger {
public:
    static constexpr int bits = 64 * Limbs;  ///< Holds |value| < 2^(bits - 1).

    WideInteger() : limbs_{} {}
    WideInteger(std::int64_t value) {  // NOLINT: implicit, as for every number type
        limbs_.fill(value < 0 ? ~std::uint64_t{0} : 0);
        limbs_[0] = static_cast<std::uint64_t>(value);
    }
    /// value / 2^unit, which must be an integer.
    WideInteger(double value, int unit) : limbs_{} {
        const BinaryParts parts(value);
        if (parts.magnitude == 0) return;
        place(parts.magnitude, parts.exponent - unit);
        if (parts.negative) negate();
    }
    /// value * 2^shift, shift >= 0.
    WideInteger(const Integer& value, int shift) : limbs_{} {
        const mpz_srcptr z = value.backend().data();
        const std::size_t size = mpz_size(z);
        const mp_limb_t* source = mpz_limbs_read(z);
        const int whole = shift / 64, part = shift % 64;
        for (int i = 0; i < static_cast<int>(size); ++i) {
            if (i + whole < Limbs) limbs_[i + whole] |= source[i] << part;
            if (part != 0 && i + whole + 1 < Limbs) limbs_[i + whole + 1] |= source[i] >> (64 - part);
        }
        if (mpz_sgn(z) < 0) negate();
    }

    /// Of a value that is not negative: its bits [from, from + count), count <= 64; bits beyond the top are 0.
    std::uint64_t bits_from(int from, int count) const {
        if (count == 0) return 0;
        const int whole = from / 64, part = from % 64;
        std::uint64_t found = whole < Limbs ? limbs_[whole] >> part : 0;
        if (part != 0 && whole + 1 < Limbs) found |= limbs_[whole + 1] << (64 - part);
        return count == 64 ? found : found & ((std::uint64_t{1} << count) - 1);
    }
    /// Of a value that is not negative: it is less than 2^result.
    int bit_length() const {
        for (int i = Limbs - 1; i >= 0; --i)
            if (limbs_[i] != 0) return 64 * (i + 1) - __builtin_clzll(limbs_[i]);
        return 0;
    }

    Sign sign() const {
        if (limbs_[Limbs - 1] >> 63) return Sign::negative;
        std::uint64_t any = 0;
        for (const std::uint64_t limb : limbs_) any |= limb;
        return any != 0 ? Sign::positive : Sign::zero;
    }

    friend WideInteger operator+(const WideInteger& a, const WideInteger& b) {
        WideInteger sum;
        if constexpr (Limbs == 2) return sum.from(a.both() + b.both());
        std::uint64_t carry = 0;
        for (int i = 0; i < Limbs; ++i) sum.limbs_[i] = add_with_carry(a.limbs_[i], b.limbs_[i], carry);
        return sum;
    }
    friend WideInteger operator-(const WideInteger& a, const WideInteger& b) {
        WideInteger difference;
        if constexpr (Limbs == 2) return difference.from(a.both() - b.both());
        std::uint64_t borrow = 0;
        for (int i = 0; i < Limbs; ++i) difference.limbs_[i] = subtract_with_borrow(a.limbs_[i], b.limbs_[i], borrow);
        return difference;
    }
    friend WideInteger operator*(const WideInteger& a, const WideInteger& b) {
        // Modulo 2^bits the product of two's complement numbers is that of the unsigned ones.
        WideInteger product;
        if constexpr (Limbs == 2) return product.from(a.both() * b.both());
        for (int i = 0; i < Limbs; ++i) {
            std::uint64_t carry = 0;
            for (int j = 0; i + j < Limbs; ++j) {
                const DoubleLimb t = DoubleLimb{a.limbs_[i]} * b.limbs_[j] + product.limbs_[i + j] + carry;
                product.limbs_[i + j] = static_cast<std::uint64_t>(t);
                carry = static_cast<std::uint64_t>(t >> 64);
            }
        }
        return product;
    }
    /// The product in the width that always holds it: never wraps.
    template <int n, int m>
    friend WideInteger<n + m> widening_product(const WideInteger<n>& a, const WideInteger<m>& b);
    friend WideInteger operator-(WideInteger a) {
        a.negate();
        return a;
    }

    friend bool operator==(const WideInteger& a, const WideInteger& b) { return a.limbs_ == b.limbs_; }
    friend bool operator!=(const WideInteger& a, const WideInteger& b) { return !(a == b); }
    friend bool operator<(const WideInteger& a, const WideInteger& b) {
        const auto top_a = static_cast<std::int64_t>(a.limbs_[Limbs - 1]);
        const auto top_b = static_cast<std::int64_t>(b.limbs_[Limbs - 1]);
        if (top_a != top_b) return top_a < top_b;
        for (int i = Limbs - 2; i >= 0; --i)
            if (a.limbs_[i] != b.limbs_[i]) return a.limbs_[i] < b.limbs_[i];
        return false;
    }
    friend bool operator>(const WideInteger& a, const WideInteger& b) { return b < a; }

    // What the templates over number types ask. Of two numbers, only the difference need fit.
    friend bool less_than_zero(const WideInteger& a) { return a.limbs_[Limbs - 1] >> 63 != 0; }
    friend bool greater_than_zero(const WideInteger& a) { return a.sign() == Sign::positive; }
    friend WideInteger lesser(const WideInteger& a, const WideInteger& b) { return less_than_zero(b - a) ? b : a; }
    friend WideInteger greater(const WideInteger& a, const WideInteger& b) { return less_than_zero(a - b) ? b : a; }

    void negate() {
        unsigned char carry = 1;
        for (std::uint64_t& limb : limbs_) {
            limb = ~limb + carry;
            carry = carry && limb == 0;
        }
    }

private:
    /// Takes the number off this one's limbs [first, first + Other); what it borrows beyond them is lost.
    template <int Other>
    void take_off(const WideInteger<Other>& number, int first) {
        std::uint64_t borrow = 0;
        for (int i = 0; i < Other; ++i)
            limbs_[first + i] = subtract_with_borrow(limbs_[first + i], number.limbs_[i], borrow);
    }

    // Two limbs are a number that compilers know.
    DoubleLimb both() const { return DoubleLimb{limbs_[1]} << 64 | limbs_[0]; }
    const WideInteger& from(DoubleLimb value) {
        limbs_[0] = static_cast<std::uint64_t>(value);
        limbs_[1] = static_cast<std::uint64_t>(value >> 64);
        return *this;
    }

    void place(std::uint64_t magnitude, int shift) {
        const int whole = shift / 64, part = shift % 64;
        if (whole >= Limbs) return;  // zero modulo 2^bits
        limbs_[whole] = magnitude << part;
        if (part != 0 && whole + 1 < Limbs) limbs_[whole + 1] = magnitude >> (64 - part);
    }

    std::array<std::uint64_t, Limbs> limbs_;  // least significant first

    template <int>
    friend class WideInteger;  // other widths
};

template <int n, int m>
WideInteger<n + m> widening_product(const WideInteger<n>& a, const WideInteger<m>& b) {
    WideInteger<n + m> product;
    if constexpr (n == 1 && m == 1) {
        const auto signed_limb = [](std::uint64_t limb) {
            return static_cast<DoubleLimb>(static_cast<std::int64_t>(limb));
        };
        return product.from(signed_limb(a.limbs_[0]) * signed_limb(b.limbs_[0]));
    }
    for (int i = 0; i < n; ++i) {
        std::uint64_t carry = 0;
        for (int j = 0; j < m; ++j) {
            const DoubleLimb t = DoubleLimb{a.limbs_[i]} * b.limbs_[j] + product.limbs_[i + j] + carry;
            product.limbs_[i + j] = static_cast<std::uint64_t>(t);
            carry = static_cast<std::uint64_t>(t >> 64);
        }
        product.limbs_[i + m] = carry;
    }
    // Read as unsigned, a negative factor is too great by 2^(its width): take the other factor off, that far up.
    if (less_than_zero(a)) product.take_off(b, n);
    if (less_than_zero(b)) product.take_off(a, m);
    return product;
}

template <int Limbs>
Sign sign_of(const WideInteger<Limbs>& value) {
    return value.sign();
}

}  // namespace cob
