/// \file
/// Every sign that the visibility of one segment rests on, in any arithmetic, and the fast ones of the exact product.
///
/// x, y are the ends of the segment, d = y - x.
#pragma once

#include "cob/visibility.hpp"
#include "geometry/certain.hpp"
#include "geometry/difference_signs.hpp"
#include "geometry/visibility_pieces.hpp"

#include <algorithm>
#include <cmath>

namespace cob {

enum class End : std::uint8_t { from, to };

/// A ray from a point of contact: only its direction matters, from one vertex towards another.
struct Ray {
    VertexId from, to;
    friend Ray operator-(const Ray& ray) { return {ray.to, ray.from}; }
};

/// Exact arithmetic: filter, integers, fractions.
struct ExactArithmetic {
    SignContext context;

    Sign sign(const Triple& triple) const { return sign_of(triple, context); }
    Sign component(const Difference& p, const Difference& q, int axis) const {
        return cross_component(p, q, axis, context);
    }
    Sign determinant(const Triple& a, const Triple& b, const Triple& c, const Triple& d) const {
        return sign_of_determinant(a, b, c, d, context);
    }
    bool same_direction(const Difference& p, const Difference& q) const { return cob::same_direction(p, q, context); }
};

/// The signs by their formulas, in whatever arithmetic.
template <class Arithmetic>
class SegmentSigns {
public:
    /// What is certain in exact arithmetic is so here.
    static constexpr bool exact = false;

    SegmentSigns(const PieceTable& pieces, const Segment& segment, Arithmetic arithmetic)
        : pieces_(&pieces), from_(segment.from), to_(segment.to), arithmetic_(arithmetic) {}

    const PieceTable& pieces() const { return *pieces_; }
    const Scene& scene() const { return pieces_->scene(); }

    /// Whatever can be said at once; there is always `unknown`.
    Certain at_once(PieceId) const { return Certain::unknown; }
    /// On which side of the piece's plane an end lies; positive: the visible one.
    Sign end_side(PieceId piece, End end) const { return arithmetic_.sign(to_plane(piece, end)); }
    /// det(d, a - x, b - x): how the line of the segment passes the line from a to b.
    Sign line_side(VertexId a, VertexId b) const {
        return arithmetic_.sign({direction(), {from_, position(a)}, {from_, position(b)}});
    }
    /// det(d, s, t): seen along d, t lies to the left (+), right (-) or along the line (0) of s.
    Sign turn(const Ray& s, const Ray& t) const {
        return arithmetic_.sign({direction(), difference(s), difference(t)});
    }
    /// Seen along d, the two rays, from one point, are one; neither is parallel to d.
    bool same_sight(const Ray& s, const Ray& t) const {
        if (s.from == t.from && s.to == t.to) return true;
        if (turn(s, t) != Sign::zero) return false;
        // d x s and d x t are parallel: the rays are one or opposite.
        for (int axis = 0; axis < 3; ++axis) {
            const Sign sign = arithmetic_.component(direction(), difference(s), axis);
            if (sign != Sign::zero) return sign == arithmetic_.component(direction(), difference(t), axis);
        }
        return false;
    }
    /// The two rays, from one point, are one ray in space.
    bool same_ray(const Ray& s, const Ray& t) const {
        return (position(s.from) == position(t.from) && position(s.to) == position(t.to)) ||
               arithmetic_.same_direction(difference(s), difference(t));
    }
    /// Sides of a piece, seen along an axis along which its normal is not zero, have one direction or the opposite.
    bool parallel(const Ray& s, const Ray& t, int axis) const {
        return arithmetic_.component(difference(s), difference(t), axis) == Sign::zero;
    }
    /// In the plane of a piece, seen along that axis: on which side of the line from a to b an end lies.
    Sign flat_side(VertexId a, VertexId b, End end, int axis) const {
        return arithmetic_.component({position(a), position(b)}, {position(a), point(end)}, axis);
    }
    /// The same of a vertex and the line of the segment.
    Sign flat_side(VertexId a, int axis) const {
        return arithmetic_.component(direction(), {from_, position(a)}, axis);
    }
    /// Sign of t_a - t_b, the parameters at which the segment crosses the planes of two pieces; both are crossed.
    Sign compare_parameters(PieceId a, PieceId b) const {
        // With s the triple of an end, t = s(x) / (s(x) - s(y)), and the sign of the denominator is that of s(x).
        const Sign numerator = arithmetic_.determinant(to_plane(b, End::from), to_plane(a, End::from),
                                                       to_plane(b, End::to), to_plane(a, End::to));
        return numerator * end_side(a, End::from) * end_side(b, End::from);
    }
    /// Vertices at one position.
    bool same_position(VertexId a, VertexId b) const { return a == b || position(a) == position(b); }

protected:
    const Point& position(VertexId vertex) const { return scene().position(vertex); }
    const PointReference& point(End end) const { return end == End::from ? from_ : to_; }
    Difference direction() const { return {from_, to_}; }
    Difference difference(const Ray& ray) const { return {position(ray.from), position(ray.to)}; }
    Triple to_plane(PieceId piece, End end) const {
        const PiecePlane plane = pieces_->plane(piece);
        const Point& origin = position(plane.origin);
        return {{origin, point(end)}, {origin, position(plane.first)}, {origin, position(plane.last)}};
    }

    const PieceTable* pieces_;
    PointReference from_, to_;
    Arithmetic arithmetic_;
};

/// The exact signs, fast: filters on prepared planes and differences; ends that are known to lie on a piece, or are
/// a corner of it, cost no arithmetic.
class ExactSigns : public SegmentSigns<ExactArithmetic> {
    using Base = SegmentSigns<ExactArithmetic>;

public:
    static constexpr bool exact = true;

    ExactSigns(const PieceTable& pieces, const Segment& segment, const SignContext& context)
        : Base(pieces, segment, ExactArithmetic{context}),
          from_piece_(context.known_ends ? segment.from_piece : -1),
          to_piece_(context.known_ends ? segment.to_piece : -1),
          d_(to_.nearest() - from_.nearest()),
          from_rest_(rest(from_)),
          to_rest_(rest(to_)) {
        d_size_ = greatest(d_);
        // Where d is out of the filters' range no product with it is trusted.
        const bool in_range = d_size_ > 1e-97 && d_size_ < 1e102;
        if (!in_range) d_size_ = std::numeric_limits<double>::quiet_NaN();
    }

    /// The filters alone, for the bulk of the pieces that a segment passes.
    Certain at_once(PieceId piece) const {
        const ApproximatePlane& plane = pieces_->approximate(piece);
        // 1. The sides that the ends lie on.
        const bool from_known = is_carried(piece, from_piece_), to_known = is_carried(piece, to_piece_);
        const Sign begins = from_known ? Sign::zero : filtered_end_side(plane, End::from);
        const Sign ends = to_known ? Sign::zero : filtered_end_side(plane, End::to);
        if (begins == Sign::zero && ends == Sign::zero) return Certain::unknown;
        // 2. An end known to lie in the plane: missed as the other does not. Both ends on one side.
        if (begins == Sign::zero)
            return from_known || is_triangle_corner(piece, End::from) ? count(1, Certain::missed) : Certain::unknown;
        if (ends == Sign::zero)
            return to_known || is_triangle_corner(piece, End::to) ? count(1, Certain::missed) : Certain::unknown;
        if (begins == ends) return count(2, Certain::missed);
        // 3. The line of the segment passes every side on the inner hand, or some side on the outer.
        if (plane.corner_count == 3) return triangle_crossed(plane, begins);
        return Certain::unknown;
    }

    Sign end_side(PieceId piece, End end) const {
        const ApproximatePlane& plane = pieces_->approximate(piece);
        if (is_carried(piece, end == End::from ? from_piece_ : to_piece_)) return Sign::zero;
        const Sign sign = filtered_end_side(plane, end);
        if (sign != Sign::zero) {
            ++arithmetic_.context.counters->filtered;
            return sign;
        }
        if (arithmetic_.context.known_ends && is_corner(piece, end)) return Sign::zero;
        return exact_sign_of(to_plane(piece, end), arithmetic_.context);
    }

    Sign line_side(VertexId a, VertexId b) const {
        const Point r = position(a) - from_.nearest(), s = position(b) - from_.nearest();
        const double value = dot(cross(d_, r), s), bound = line_bound(std::max(greatest(r), greatest(s)));
        if (std::abs(value) > bound) {
            ++arithmetic_.context.counters->filtered;
            return value > 0 ? Sign::positive : Sign::negative;
        }
        return exact_sign_of({direction(), {from_, position(a)}, {from_, position(b)}}, arithmetic_.context);
    }

private:
    static double greatest(const Point& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }
    /// How far nearest() is off in each coordinate, at most.
    static double rest(const PointReference& point) {
        if (!point.inexact()) return 0;
        return 2 * greatest(point.inexact()->rest()) + std::numeric_limits<double>::denorm_min();
    }
    Certain count(unsigned signs, Certain certain) const {
        arithmetic_.context.counters->filtered += signs;
        return certain;
    }

    /// Zero: not certain.
    Sign filtered_end_side(const ApproximatePlane& plane, End end) const {
        const Point r = point(end).nearest() - plane.origin;
        const double off = end == End::from ? from_rest_ : to_rest_;
        double bound = plane.error * (greatest(r) + off) + 1e-300;
        if (off > 0) bound += plane.size() * off;
        const double value = dot(plane.normal, r);
        if (!std::isfinite(value)) return Sign::zero;  // one product may overflow that two others outweigh
        return value > bound ? Sign::positive : value < -bound ? Sign::negative : Sign::zero;
    }

    /// The bound of a determinant of d and two differences from x, each at most `size` in every coordinate: as the
    /// general filter's, with the greatest entries of rows instead of columns. NaN where nothing is certain.
    double line_bound(double size) const {
        const bool in_range = size > 1e-97 && size < 1e102;  // below, something may have underflowed unseen
        if (!in_range) return std::numeric_limits<double>::quiet_NaN();
        double bound = 5.5e-15 * d_size_ * size * size + 1e-300;
        if (from_rest_ > 0 || to_rest_ > 0) {
            const double off = from_rest_ + to_rest_, longest = size + off;
            bound += 6.1 * off * longest * (longest + 2 * (d_size_ + off));
        }
        return bound;
    }

    Certain triangle_crossed(const ApproximatePlane& plane, Sign begins) const {
        const Point &x = from_.nearest(), a = plane.origin - x, b = plane.others[0] - x, c = plane.others[1] - x;
        const double bound = line_bound(std::max({greatest(a), greatest(b), greatest(c)}));
        const Point da = cross(d_, a), db = cross(d_, b);
        // Inside where all have the sign of the far end.
        const double inward = begins == Sign::negative ? 1 : -1;
        const double ab = inward * dot(da, b), bc = inward * dot(db, c), ca = -inward * dot(da, c);
        const double least = std::min({ab, bc, ca});
        if (least < -bound) return count(3, Certain::missed);
        if (least > bound) return count(5, Certain::crossed_inside);
        return Certain::unknown;
    }

    /// The same as is_corner() of a triangle, from what is at hand.
    bool is_triangle_corner(PieceId piece, End end) const {
        const ApproximatePlane& plane = pieces_->approximate(piece);
        if (plane.corner_count != 3 || !arithmetic_.context.known_ends || point(end).inexact()) return false;
        const Point& p = point(end).nearest();
        return p == plane.origin || p == plane.others[0] || p == plane.others[1];
    }
    /// The plane of a piece is known to be that of the one that an end carries.
    bool is_carried(PieceId piece, PieceId carried) const {
        if (carried < 0) return false;
        const std::int32_t group = pieces_->approximate(piece).group;
        return piece == carried || (group >= 0 && group == pieces_->approximate(carried).group);
    }
    bool is_corner(PieceId piece, End end) const {
        if (point(end).inexact()) return false;
        for (const VertexId corner : scene().corners(scene().piece(piece)))
            if (position(corner) == point(end).nearest()) return true;
        return false;
    }

    PieceId from_piece_, to_piece_;
    Point d_;
    double d_size_;
    double from_rest_, to_rest_;
};

}  // namespace cob
