/// \file
/// Pieces by their corners in binary32, to say of most that a segment misses them for certain.
///
/// Everything is in the coordinates of a normalised scene (normalisation.hpp). o, d: origin and direction of the
/// segment in binary32.
#pragma once

#include "cob/candidates.hpp"
#include "geometry/certain.hpp"
#include "geometry/lanes.hpp"
#include "geometry/normalisation.hpp"

#include <array>
#include <cmath>

namespace cob {

/// The corners of a piece of three or four, side by side, in one cache line. A triangle has the middle of its last side
/// as its fourth, so that it is a convex quadrangle, too. A piece of more corners has none but NaN, of which nothing is
/// certain.
struct alignas(64) PieceOutline {
    std::array<Lanes, 3> corners;  ///< By axis.
    PieceId piece;

    PieceOutline(const Scene& scene, PieceId id, const Normalisation& normalise);
};

/// A segment, prepared for outlines.
///
/// The line is seen along k, the axis of its greatest direction: a point v is seen, relative to the line, at
///     p = (v_i - o_i) - s_i (v_k - o_k),  s_i = d_i / d_k,  and so for j,
/// wrong by at most `off` in each coordinate. With e = the ends' error and everything within [-4, 4]:
///   v: 2^-25 + e, o: 2^-23 + e, both in i and, times |s_i| <= 1, in k:        10 2^-25 + 4 e
///   two differences (< 8), a product (< 8) and their difference (< 16):       40 2^-25
///   s_i: its own rounding, 2^-25 of 8, and where d is wrong by g = 2 e + 2^-50 < |d_k| / 8, 2.3 g / |d_k| of 5:
///                                                                              8 2^-25 + 12 g / |d_k|
/// together less than 2^-19 + 4 e + 32 g / |d_k|. For greater g this is beyond all that can be seen.
struct OutlineSegment {
    std::array<std::size_t, 3> axes;  ///< i, j, k.
    Lanes origin_i, origin_j, origin_k, slope_i, slope_j;
    Lanes off;          ///< Very great where nothing is certain.
    Lanes least, most;  ///< v_k - o_k of all points of the segment, widened by `off`.

    explicit OutlineSegment(const NormalSegment& segment) {
        const Point d = segment.to - segment.from;
        const double x = std::abs(d.x), y = std::abs(d.y), z = std::abs(d.z);
        const int k = x >= y && x >= z ? 0 : y >= z ? 1 : 2, i = k == 2 ? 0 : k + 1, j = i == 2 ? 0 : i + 1;
        axes = {static_cast<std::size_t>(i), static_cast<std::size_t>(j), static_cast<std::size_t>(k)};
        const auto lanes = [](double value) { return all_lanes(static_cast<float>(value)); };
        origin_i = lanes(segment.from[i]);
        origin_j = lanes(segment.from[j]);
        origin_k = lanes(segment.from[k]);
        const double inverse = 1 / d[k];
        slope_i = lanes(d[i] * inverse);
        slope_j = lanes(d[j] * inverse);
        const double wrong = 0x1p-19 + 4 * segment.error + (64 * segment.error + 0x1p-45) * std::abs(inverse);
        off = lanes(std::min(wrong, 1e30));
        const Lanes last = lanes(d[k]);
        least = lesser(last, all_lanes(0)) - off;
        most = greater(last, all_lanes(0)) + off;
    }
};

/// What binary32 can say of the exact segment and the exact piece. See OutlineSegment for what is seen of the corners,
/// and for `off`.
///
/// The line misses the closed piece where of the 2 x 2 determinants of its sides, as seen, one is positive and one
/// negative, and passes through its interior where all are positive or all negative. With r <= 10 the greatest
/// coordinate of two corners as seen, their determinant is wrong by at most 4 off r + 2 off^2 for its entries, and by
/// 2^-22 r^2 for its roundings, which is less than 1.3 off r: by less than bound = off (6 r + 4 off).
///
/// Where the line passes, the depths of the corners bound the depth, that is v_k - o_k. Large pieces want more: the
/// line meets the plane, that of the first three corners, at depth n / s, with s the sum of this triangle's
/// determinants, and n that of their products with the depths of the opposite corners. With m the greatest determinant,
/// bound the greatest of theirs, and depths of less than 6 (8 at the segment's end),
///     n:              3 bound (6 + off) + 3 m off, and 2^-18 m for roundings;
///     depth of s's:   3 bound (8 + off) for s, and 3 2^-19 m for roundings;
/// together less than 48 bound + 12 m off, for off < 1.25; where that is greater, nothing is certain.
inline Certain certain(const PieceOutline& outline, const OutlineSegment& segment) {
    const auto [i, j, k] = segment.axes;
    const Lanes depth = outline.corners[k] - segment.origin_k;
    const Lanes a = (outline.corners[i] - segment.origin_i) - segment.slope_i * depth;
    const Lanes b = (outline.corners[j] - segment.origin_j) - segment.slope_j * depth;
    // 1. The line, and the corners' depths. Comparisons with NaN are false, so that nothing is missed.
    const Lanes next_a = rotated(a), next_b = rotated(b), sides = a * next_b - b * next_a;
    const Lanes r = greater(greater(absolute(a), absolute(b)), greater(absolute(next_a), absolute(next_b)));
    const Lanes bounds = segment.off * (6 * r + 4 * segment.off);
    const unsigned left = bits_of(sides > bounds), right = bits_of(sides < -bounds);
    if (left != 0 && right != 0) return Certain::missed;
    if (all_of(depth > segment.most) || all_of(depth < segment.least)) return Certain::missed;
    const Lanes last = segment.most - 2 * segment.off, first = segment.least + 2 * segment.off;
    const bool through = left == 15 || right == 15;
    if (through && all_of((depth > first) & (depth < last))) return Certain::crossed_inside;

    // 2. The depth at which the line meets the plane.
    const float u = sides[1], v = a[2] * b[0] - b[2] * a[0], w = sides[0];
    const float sum = u + v + w, turned = u * depth[0] + v * depth[1] + w * depth[2];
    const float s = std::abs(sum), n = sum < 0 ? -turned : turned;
    const float bound = greatest(segment.off * (6 * greatest(r) + 4 * segment.off));
    const float wrong = 48 * bound + 12 * segment.off[0] * std::max({std::abs(u), std::abs(v), std::abs(w)});
    if (!(s > 4 * bound)) return Certain::unknown;
    if (n > segment.most[0] * s + wrong || n < segment.least[0] * s - wrong) return Certain::missed;
    if (through && n < last[0] * s - wrong && n > first[0] * s + wrong) return Certain::crossed_inside;
    return Certain::unknown;
}

/// False: stop, says the callback, which is not asked of a piece that is missed.
inline bool hand_over(const PieceOutline& outline, const OutlineSegment& segment,
                      CandidateSource::PieceCallback callback) {
    const Certain known = certain(outline, segment);
    return known == Certain::missed || callback.call(callback.context, outline.piece, known == Certain::crossed_inside);
}

}  // namespace cob
