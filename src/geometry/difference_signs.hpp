/// \file
/// Exact signs of products of differences of points: every decision about segments and pieces is one of these.
///
/// Three stages, each right where it decides: binary64 with an error bound, integers of fixed width on a binary grid
/// that holds the operands, and fractions.
#pragma once

#include "cob/arithmetic.hpp"
#include "cob/geometry.hpp"

namespace cob {

/// An exact point that is owned by somebody else.
class PointReference {
public:
    PointReference(const Point& point) : nearest_(&point) {}  // NOLINT: a binary64 point is an exact point
    PointReference(const ExactPoint& point)                   // NOLINT
        : nearest_(&point.nearest()), exact_(point.is_binary64() ? nullptr : &point) {}

    const Point& nearest() const { return *nearest_; }
    /// Null where nearest() is the point itself.
    const ExactPoint* inexact() const { return exact_; }
    bool has_fraction() const { return exact_ && exact_->has_fraction(); }
    RationalPoint rational() const { return exact_ ? exact_->rational() : to_rational(*nearest_); }
    friend bool operator==(const PointReference& a, const PointReference& b);

private:
    const Point* nearest_;
    const ExactPoint* exact_ = nullptr;
};

/// to - from, not computed.
struct Difference {
    PointReference from, to;
};

/// The parallelepiped p . (q x r), not computed.
struct Triple {
    Difference p, q, r;
};

/// What decides where the filter does not. `fractions` alone is the textbook's way, kept for measurements.
enum class Fallback : std::uint8_t { integers, fractions };

/// How signs are computed, and the count of how they were.
struct SignContext {
    PredicateCounters* counters;  ///< Never null.
    Fallback fallback = Fallback::integers;
    /// Ends that carry a piece, or are a corner of one, cost no arithmetic. Off only for measurements.
    bool known_ends = true;
};

/// Sign of p . (q x r).
Sign sign_of(const Triple& triple, const SignContext& context);
/// The same without the filter, for callers that have filtered already.
Sign exact_sign_of(const Triple& triple, const SignContext& context);
/// Sign of the component of p x q along a coordinate axis.
Sign cross_component(const Difference& p, const Difference& q, int axis, const SignContext& context);
/// Sign of a d - b c, of four values of Triple.
Sign sign_of_determinant(const Triple& a, const Triple& b, const Triple& c, const Triple& d,
                         const SignContext& context);
/// p and q, both not zero, point exactly the same way.
bool same_direction(const Difference& p, const Difference& q, const SignContext& context);

}  // namespace cob
