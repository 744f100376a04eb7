/// \file
/// Pieces as triangles in binary32, four side by side, to say of most that a segment misses them for certain.
///
/// Everything is in the coordinates of a normalised scene (normalisation.hpp). o, d: origin and direction of the
/// segment in binary32.
#pragma once

#include "cob/candidates.hpp"
#include "geometry/lanes.hpp"
#include "geometry/normalisation.hpp"

#include <array>
#include <cmath>
#include <vector>

namespace cob {

/// Up to four triangles. A piece of up to six corners is the fan of its triangles, all in one packet, one after the
/// other; one of more has no triangle but NaN, of which nothing is certain.
struct alignas(32) PiecePacket {
    std::array<std::array<Lanes, 3>, 3> corners;  ///< By corner and axis.
    std::array<PieceId, 4> pieces;                ///< Lanes that are left over repeat the last triangle.

    /// Lanes that a piece takes.
    static int lanes_of(const Piece& piece) {
        return piece.corner_count <= 6 ? static_cast<int>(piece.corner_count) - 2 : 1;
    }
    /// Of pieces that take four lanes at most.
    PiecePacket(const Scene& scene, const std::vector<PieceId>& ids, const Normalisation& normalise);
};

/// A segment, prepared for packets.
///
/// The line is seen along k, the axis of its greatest direction: a point v is seen, relative to the line, at
///     p = (v_i - o_i) - s_i (v_k - o_k),  s_i = d_i / d_k,  and so for j,
/// wrong by at most `off` in each coordinate. With e = the ends' error and everything within [-4, 4]:
///   v: 2^-25 + e, o: 2^-23 + e, both in i and, times |s_i| <= 1, in k:        10 2^-25 + 4 e
///   two differences (< 8), a product (< 8) and their difference (< 16):       40 2^-25
///   s_i: its own rounding, 2^-25 of 8, and where d is wrong by g = 2 e + 2^-50 < |d_k| / 8, 2.3 g / |d_k| of 5:
///                                                                              8 2^-25 + 12 g / |d_k|
/// together less than 2^-19 + 4 e + 32 g / |d_k|. For greater g this is beyond all that can be seen.
struct PacketSegment {
    std::array<std::size_t, 3> axes;  ///< i, j, k.
    Lanes origin_i, origin_j, origin_k, slope_i, slope_j;
    Lanes off;          ///< Very great where nothing is certain.
    Lanes least, most;  ///< v_k - o_k of all points of the segment, widened by `off`.

    explicit PacketSegment(const NormalSegment& segment) {
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

/// What is certain about a segment and the triangles of a packet. Bit k: triangle k.
struct PacketAnswer {
    unsigned possible = 0;  ///< May be met; all others are missed for certain.
    unsigned crossed = 0;   ///< Of those: the segment crosses the interior from one side to the other for certain.
};

/// See PacketSegment for what is seen of the corners, and for `off`.
///
/// The line misses the closed triangle where of the three 2 x 2 determinants of its corners, as seen, one is positive
/// and one negative, and passes through its interior where all are positive or all negative. With r <= 10 the greatest
/// coordinate of the corners as seen, a determinant is wrong by at most 4 off r + 2 off^2 for its entries, and by
/// 2^-22 r^2 for its roundings, which is less than 1.3 off r: by less than bound = off (6 r + 4 off).
///
/// Where the line passes, the depths of the corners bound the depth, that is v_k - o_k. Large triangles want more: the
/// line meets the plane at depth n / s, with s the sum of the determinants, and n that of their products with the
/// depths of the opposite corners. With m the greatest determinant and depths of less than 6 (8 at the segment's end),
///     n:              3 bound (6 + off) + 3 m off, and 2^-18 m for roundings;
///     depth of s's:   3 bound (8 + off) for s, and 3 2^-19 m for roundings;
/// together less than 48 bound + 12 m off, for off < 1.25; where that is greater, nothing is certain.
inline PacketAnswer certain(const PiecePacket& packet, const PacketSegment& segment) {
    const auto [i, j, k] = segment.axes;
    std::array<Lanes, 3> a, b, depth;
    for (std::size_t c = 0; c < 3; ++c) {
        const auto& corner = packet.corners[c];
        depth[c] = corner[k] - segment.origin_k;
        a[c] = (corner[i] - segment.origin_i) - segment.slope_i * depth[c];
        b[c] = (corner[j] - segment.origin_j) - segment.slope_j * depth[c];
    }
    // 1. The line, and the corners' depths. Comparisons with NaN are false, so that nothing is missed.
    const Lanes u = a[1] * b[2] - b[1] * a[2], v = a[2] * b[0] - b[2] * a[0], w = a[0] * b[1] - b[0] * a[1];
    const Lanes r = greater(greater(greater(absolute(a[0]), absolute(b[0])), greater(absolute(a[1]), absolute(b[1]))),
                            greater(absolute(a[2]), absolute(b[2])));
    const Lanes bound = segment.off * (6 * r + 4 * segment.off);
    const Lanes least = lesser(lesser(u, v), w), most = greater(greater(u, v), w);
    const Lanes nearest = lesser(lesser(depth[0], depth[1]), depth[2]);
    const Lanes farthest = greater(greater(depth[0], depth[1]), depth[2]);
    const LaneMask passed = (least < -bound) & (most > bound);
    const unsigned possible = ~bits_of(passed | (nearest > segment.most) | (farthest < segment.least)) & 15u;
    if (possible == 0) return {};

    // 2. The depth at which the line meets the plane.
    const Lanes sum = u + v + w, turned = u * depth[0] + v * depth[1] + w * depth[2];
    const Lanes s = absolute(sum), n = sum < 0 ? -turned : turned;
    const Lanes wrong = 48 * bound + 12 * segment.off * greater(most, -least);
    const LaneMask facing = s > 4 * bound;
    const LaneMask beside = (n > segment.most * s + wrong) | (n < segment.least * s - wrong);
    const Lanes last = segment.most - 2 * segment.off, first = segment.least + 2 * segment.off;
    const LaneMask between =
        ((nearest > first) & (farthest < last)) | ((n < last * s - wrong) & (n > first * s + wrong));
    const LaneMask through = (least > bound) | (most < -bound);
    const unsigned left = possible & ~bits_of(facing & beside);
    return {left, left & bits_of(through & facing & between)};
}

/// Hands the pieces that the segment may meet to the callback, each once. False: stop.
inline bool hand_over(const PiecePacket& packet, const PacketSegment& segment,
                      CandidateSource::PieceCallback callback) {
    const PacketAnswer answer = certain(packet, segment);
    for (unsigned lanes = answer.possible; lanes != 0;) {
        const PieceId piece = packet.pieces[static_cast<std::size_t>(__builtin_ctz(lanes))];
        unsigned fan = 0;  // all triangles of the piece
        for (std::size_t lane = 0; lane < 4; ++lane) fan |= static_cast<unsigned>(packet.pieces[lane] == piece) << lane;
        if (!callback.call(callback.context, piece, (answer.crossed & fan) != 0)) return false;
        lanes &= ~fan;
    }
    return true;
}

}  // namespace cob
