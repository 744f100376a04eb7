/// \file
/// Exact points on the dyadic lattices that refinement makes on roots (SPEC 3).
#pragma once

#include "cob/geometry.hpp"

#include <cstdint>
#include <optional>

namespace cob {

/// The number numerator / 2^bits.
struct Dyadic {
    std::int64_t numerator = 0;
    int bits = 0;
};

/// base + step / 2^base_bits * fraction, a binary64 number taken exactly; nothing where it does not fit.
std::optional<Dyadic> dyadic_sum(std::uint32_t base, int base_bits, int step, double fraction);

/// The point of a root at lattice coordinates (u, v). Quadrilateral: bilinear, u along corner 0 to 1, v along
/// corner 0 to 3; triangle: corner0 + u (corner1 - corner0) + v (corner2 - corner0).
ExactPoint lattice_point(const Scene& scene, const Root& root, Dyadic u, Dyadic v);

/// The same with fractions for u and v, of any size.
ExactPoint lattice_point(const Scene& scene, const Root& root, const Rational& u, const Rational& v);

}  // namespace cob
