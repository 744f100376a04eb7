// What binary32 says of the outlines of pieces is certain: "missed" and "crossed" hold exactly, at every scale, an ulp
// beside every contact, and where binary32 and binary64 themselves end (SPEC 1, SPEC 6).
#include "geometry/piece_tree.hpp"
#include "geometry/visibility_oracle.hpp"
#include "visibility/random.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace cob::test {
namespace {

#ifdef COB_LONG_TESTS
constexpr int scene_count = 20000;
#else
constexpr int scene_count = 400;
#endif

struct Counts {
    int missed = 0, crossed = 0, left = 0, touched = 0;
};

/// Every outline of the scene against the segment.
void check(const Scene& scene, const Segment& segment, Counts& counts, const std::string& name) {
    const PieceTree tree(scene);
    ASSERT_EQ(tree.outlines().size(), scene.pieces().size());
    const NormalSegment normal = normalised(tree.normalisation(), segment.from.nearest(), segment.to.nearest());
    if (normal.kind != NormalSegment::Kind::within) return;
    const OutlineSegment prepared(normal);
    const PieceTable pieces(scene);
    PredicateCounters counters;
    const ExactSigns signs(pieces, segment, {&counters});
    for (const PieceOutline& outline : tree.outlines()) {
        const Touch::Kind kind = touch(signs, outline.piece).kind;
        const std::string what = name + ", piece " + std::to_string(outline.piece);
        switch (certain(outline, prepared)) {
            case Certain::missed:
                ++counts.missed;
                ASSERT_EQ(static_cast<int>(kind), static_cast<int>(Touch::Kind::none)) << what;
                break;
            case Certain::crossed_inside:
                ++counts.crossed;
                ASSERT_EQ(static_cast<int>(kind), static_cast<int>(Touch::Kind::inside)) << what;
                break;
            case Certain::unknown:
                ++counts.left;
                counts.touched += kind != Touch::Kind::none;
                break;
        }
    }
}

/// Lattice scenes so scaled and moved, and segments that touch them in every way, or miss that by an ulp.
void check_at(int exponent, double offset, int seed_base, Counts& counts) {
    for (int seed = seed_base; seed < seed_base + scene_count / 10; ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        const auto placed = [&](Point p) {
            for (int axis = 0; axis < 3; ++axis) p[axis] = std::ldexp(p[axis] + offset, exponent);
            return p;
        };
        std::vector<Loop> loops =
            random.integer(0, 1) == 0 ? lattice_terrain(random, 3, 2) : lattice_soup(random, 8, 5, 8);
        for (Loop& loop : loops)
            for (Point& p : loop) p = placed(p);
        const Scene scene = scene_of(loops, Vertices::shared, true);
        if (scene.pieces().empty()) continue;
        for (int k = 0; k < 12; ++k) {
            Point ends[2];
            for (Point& end : ends) {
                end = placed(random.lattice_point(-1, 6));
                if (random.integer(0, 1) == 0) continue;
                for (int axis = 0; axis < 3; ++axis)
                    end[axis] = std::nextafter(end[axis], random.integer(0, 1) == 0 ? -1e308 : 1e308);
            }
            Segment segment{ends[0], ends[1]};
            if (random.integer(0, 3) == 0) {
                const RationalPoint a = to_rational(ends[0]), b = to_rational(ends[1]);
                segment.from = ExactPoint(a + (Rational(1, 3) * (b - a)));
            }
            if (segment.from == segment.to) continue;
            check(scene, segment, counts, "2^" + std::to_string(exponent) + ", seed " + std::to_string(seed));
            if (testing::Test::HasFatalFailure()) return;
        }
    }
}

TEST(Outlines, WhatIsCertainIsSo) {
    Counts counts;
    check_at(0, 0, 0, counts);
    check_at(-500, 0, 1000000, counts);
    check_at(1000, 0, 2000000, counts);
    // Most must be decided, and enough be touched that is not.
    EXPECT_GT(counts.missed, counts.left);
    EXPECT_GT(counts.crossed, 200);
    EXPECT_GT(counts.touched, 100);
}

TEST(Outlines, NothingIsCertainWhereBinary32SeesNothing) {
    Counts subnormal;
    check_at(-1070, 0, 3000000, subnormal);
    EXPECT_EQ(subnormal.crossed, 0);
    Counts far_away;  // an extent of 5 at 2^50: an ulp is a quarter
    check_at(0, 0x1p50, 4000000, far_away);
    EXPECT_EQ(far_away.crossed, 0);
    EXPECT_GT(subnormal.left + far_away.left, 1000);
}

TEST(Outlines, WhatIsCertainIsSoFarFromTheOrigin) {
    Counts counts;
    check_at(0, 0x1p20, 5000000, counts);
    check_at(-30, 0x1p31, 6000000, counts);
    EXPECT_GT(counts.missed, 1000);
    EXPECT_GT(counts.crossed, 100);
}

// Short segments beside large triangles: the line's direction is known badly.
TEST(Outlines, ShortSegments) {
    Counts counts;
    const Scene scene =
        scene_of({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}}, Vertices::shared);
    for (int exponent = 0; exponent >= -1074; exponent -= exponent > -60 ? 1 : 13) {
        Random random(static_cast<std::uint64_t>(-exponent));
        for (int k = 0; k < 20; ++k) {
            const Point at{random.integer(0, 4) / 4.0, random.integer(0, 4) / 4.0, random.integer(0, 2) / 2.0};
            const double step = std::ldexp(1.0, exponent);
            const Point to{at.x + step * random.integer(-1, 1), at.y + step * random.integer(-1, 1),
                           at.z + step * random.integer(-1, 1)};
            if (at == to) continue;
            check(scene, {at, to}, counts, "length 2^" + std::to_string(exponent));
            check(scene, {to, at}, counts, "length 2^" + std::to_string(exponent));
        }
    }
    EXPECT_GT(counts.missed, 50);
    EXPECT_GT(counts.left, 50);
}

}  // namespace
}  // namespace cob::test
