// SPEC 6 over random scenes: one answer from every arithmetic that is exact and from every source of candidates, and
// what adding, moving and turning around may do to it.
#include "visibility/random.hpp"
#include "cob/shooter.hpp"

#include <gtest/gtest.h>

#include <memory>

namespace cob::test {
namespace {

#ifdef COB_LONG_TESTS
constexpr int scenes = 20000;
#else
constexpr int scenes = 600;
#endif
constexpr int segments_of_a_scene = 50;

std::vector<Loop> random_scene(Random& random, int most_corners = 5) {
    return random.integer(0, 2) == 0 ? lattice_terrain(random, 3, 2)
                                     : lattice_soup(random, random.integer(8, 16), 2, most_corners);
}

/// Sheared and scaled by odd numbers of 30 bits, so that products no longer fit binary64 and ties need exactness.
Point stretched(const Point& p) {
    const double a = 1073741827, b = 805306457, c = 536870923;
    return {a * p.x + b * p.y, a * p.y + c * p.z, b * p.z - c * p.x};
}
std::vector<Loop> stretched(std::vector<Loop> loops) {
    for (Loop& loop : loops)
        for (Point& p : loop) p = stretched(p);
    return loops;
}

Segment random_segment(Random& random) {
    for (;;) {
        Segment segment{random.lattice_point(-1, 3), random.lattice_point(-1, 3)};
        if (random.integer(0, 3) == 0) {  // a middle, so that sides are met between lattice points
            const Point p = segment.to.nearest();
            segment.to = Point{p.x + 0.5, p.y, p.z + 0.5};
        }
        if (segment.from != segment.to) return segment;
    }
}

/// Counts the answers; a test in which one of them is rare has shown little.
struct Answers {
    std::array<int, 3> count{};
    void add(Visibility v) { ++count[static_cast<std::size_t>(v)]; }
    void expect_all_kinds() const {
        const int total = count[0] + count[1] + count[2];
        for (const int c : count) EXPECT_GE(10 * c, total) << count[0] << ' ' << count[1] << ' ' << count[2];
    }
};

// "evaluated in exact arithmetic; nothing here has a tolerance": the fast signs against fractions, and intervals,
// which may only be undecided.
TEST(VisibilityRandom, EveryExactArithmeticAndSourceAgree) {
    Answers answers;
    int undecided = 0;
    for (int seed = 0; seed < scenes; ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        // Triangles in the odd cases: how polygons that are not planar are cut depends on how they are seen.
        const bool triangles = seed % 2 == 1;
        const std::vector<Loop> loops = random_scene(random, triangles ? 3 : 5);
        const Asked asked(loops, Source::tree, true), far(stretched(loops), Source::tree, true);
        const auto all = make_candidates(asked.scene, Source::all);
        const VisibilityOracle unaided(asked.scene, *all);
        for (int k = 0; k < segments_of_a_scene; ++k) {
            const Segment segment = random_segment(random);
            const Visibility answer = asked.oracle(segment);
            answers.add(answer);
            ASSERT_EQ(answer, asked.oracle(segment, Arithmetic::rational).visibility) << seed << ' ' << k;
            ASSERT_EQ(answer, unaided(segment)) << seed << ' ' << k;
            ASSERT_EQ(answer, asked.oracle.explain(segment).visibility) << seed << ' ' << k;
            // The same question where nothing is short enough for binary64.
            const Segment longer{stretched(segment.from.nearest()), stretched(segment.to.nearest())};
            const Visibility far_answer = far.oracle(longer);
            if (triangles) {
                ASSERT_EQ(answer, far_answer) << seed << ' ' << k;
            }
            ASSERT_EQ(far_answer, far.oracle(longer, Arithmetic::rational).visibility) << seed << ' ' << k;
            const VisibilityAnswer intervals = far.oracle(longer, Arithmetic::interval);
            if (intervals.decided) {
                ASSERT_EQ(far_answer, intervals.visibility) << seed << ' ' << k;
            } else {
                ++undecided;
            }
        }
    }
    answers.expect_all_kinds();
    EXPECT_GT(undecided, 0);
}

// "Hints never change an answer."; "nearest blocker", "against" and "contacts" tell one story.
TEST(VisibilityRandom, TheWaysOfAskingAgree) {
    int hinted = 0, blockers = 0;
    for (int seed = 0; seed < scenes; ++seed) {
        Random random(static_cast<std::uint64_t>(seed) + 3000000);
        const Asked asked(random_scene(random), Source::tree, true);
        if (asked.scene.pieces().empty()) continue;
        for (int k = 0; k < 10; ++k) {
            const PieceId a = random.integer(0, static_cast<int>(asked.scene.pieces().size()) - 1);
            const PieceId b = random.integer(0, static_cast<int>(asked.scene.pieces().size()) - 1);
            const auto middle = [&](PieceId id, int third) {
                const View<VertexId> corners = asked.scene.corners(asked.scene.piece(id));
                const RationalPoint p = to_rational(asked.scene.position(corners[0]));
                const RationalPoint q = to_rational(asked.scene.position(corners[1]));
                const RationalPoint r = to_rational(asked.scene.position(corners[2]));
                return ExactPoint(Rational(1, third) * (p + q + (Rational(third - 2) * r)));
            };
            const int third = random.integer(2, 4);  // 2: on a side; 3: not binary64; 4: binary64
            const Segment plain{middle(a, third), middle(b, third)};
            if (plain.from == plain.to) continue;
            const Visibility answer = asked.oracle(plain);
            Segment hints = plain;
            hints.from_piece = a;
            hints.to_piece = b;
            ASSERT_EQ(answer, asked.oracle(hints)) << seed << ' ' << k;
            ++hinted;

            const PolygonId nearest = asked.oracle.nearest_blocker(plain);
            std::optional<Rational> first;
            for (const Contact& contact : asked.oracle.contacts(plain))
                if (contact.kind == ContactKind::inside && !first) first = contact.parameter;
            ASSERT_TRUE(!first || nearest != no_polygon);
            for (PolygonId id = 0; id < asked.scene.polygon_count(); ++id)
                if (asked.oracle.against(id, plain) == Visibility::blocked) {
                    ASSERT_NE(nearest, no_polygon) << seed << ' ' << k;
                }
            if (nearest == no_polygon) continue;
            ++blockers;
            ASSERT_EQ(asked.oracle.against(nearest, plain), Visibility::blocked) << seed << ' ' << k;
            ASSERT_EQ(answer, Visibility::blocked) << seed << ' ' << k;
        }
    }
    EXPECT_GT(hinted, scenes);
    EXPECT_GT(blockers, scenes / 10);
}

/// The surface of a box with every face cut into size * size squares.
std::vector<Loop> box(int size) {
    std::vector<Loop> loops;
    const double far = size;
    for (int i = 0; i < size; ++i)
        for (int j = 0; j < size; ++j) {
            const double u = i, v = j;
            loops.push_back({{u, v, 0}, {u, v + 1, 0}, {u + 1, v + 1, 0}, {u + 1, v, 0}});
            loops.push_back({{u, v, far}, {u + 1, v, far}, {u + 1, v + 1, far}, {u, v + 1, far}});
            loops.push_back({{u, 0, v}, {u + 1, 0, v}, {u + 1, 0, v + 1}, {u, 0, v + 1}});
            loops.push_back({{u, far, v}, {u, far, v + 1}, {u + 1, far, v + 1}, {u + 1, far, v}});
            loops.push_back({{0, u, v}, {0, u, v + 1}, {0, u + 1, v + 1}, {0, u + 1, v}});
            loops.push_back({{far, u, v}, {far, u + 1, v}, {far, u + 1, v + 1}, {far, u, v + 1}});
        }
    return loops;
}

// "no light leaks through a seam": from inside to outside through every vertex, edge and face of closed surfaces.
TEST(VisibilityClosed, NothingLeaksFromInsideToOutside) {
    const int size = 3;
    for (const int stretch : {0, 1}) {
        std::vector<Loop> loops = box(size);
        // Sheared, so that nothing lies along an axis; still convex, and coordinates stay exact.
        for (Loop& loop : loops)
            for (Point& p : loop)
                if (stretch == 1) p = {p.x + p.y / 4 - p.z / 8, p.y - p.z / 2, 3 * p.z + p.x / 2};
        const Asked asked(loops);
        const Point inside = stretch == 1 ? Point{1.5 + 1.5 / 4 - 1.5 / 8, 0.75, 5.25} : Point{1.5, 1.5, 1.5};
        int asked_for = 0;
        for (const Loop& loop : loops)
            for (std::size_t k = 0; k < loop.size(); ++k) {
                const Point a = loop[k], b = loop[(k + 1) % loop.size()], c = loop[(k + 2) % loop.size()];
                const Point targets[] = {a,
                                         {(a.x + b.x) / 2, (a.y + b.y) / 2, (a.z + b.z) / 2},
                                         {(a.x + c.x) / 2, (a.y + c.y) / 2, (a.z + c.z) / 2}};
                for (const Point& target : targets)
                    for (const Point& from : {inside, Point{inside.x + 0.125, inside.y, inside.z - 0.25}}) {
                        const Point to = 2.0 * target - from;  // as far beyond
                        ASSERT_EQ(asked(from, to), Visibility::blocked);
                        ASSERT_EQ(asked(to, from), Visibility::blocked);
                        ++asked_for;
                    }
            }
        EXPECT_EQ(asked_for, 6 * size * size * 4 * 3 * 2);
    }
}

// "exact sample points inside elements, visible fraction by counting, deterministic, several threads"
TEST(Shooter, CountsWhatIsSeenWhateverTheThreads) {
    // A table over the left half of a lamp.
    const Asked asked({{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}},
                       {{0, 0, 1}, {0, 2, 1}, {2, 2, 1}, {2, 0, 1}},
                       {{-5, -5, 0.5}, {1, -5, 0.5}, {1, 5, 0.5}, {-5, 5, 0.5}}});
    const Roots roots(asked.scene);
    const std::vector<SamplePoint> lamp = sample_points(asked.scene, roots[1], root_element(1), 8);
    const std::vector<SamplePoint> floor = sample_points(asked.scene, roots[0], root_element(0), 4);
    ASSERT_EQ(lamp.size(), 64u);
    // From x = 0.25 the table's edge at 1 hides everything left of 1.75, from 1.25 left of 0.75, and so on.
    const std::vector<double> seen = visible_fractions(asked.oracle, floor, lamp, {1});
    const double expected[] = {0.125, 0.375, 0.625, 0.875};
    for (std::size_t k = 0; k < seen.size(); ++k) EXPECT_EQ(seen[k], expected[k % 4]) << k;
    EXPECT_EQ(seen, visible_fractions(asked.oracle, floor, lamp, {2}));
    EXPECT_EQ(seen, visible_fractions(asked.oracle, floor, lamp));
}

TEST(Shooter, SamplePointsLieStrictlyInsideAndOnThePlane) {
    const Asked asked(
        {{{0.1, 0.2, 0.3}, {1.7, 0.4, 0.9}, {0.6, 2.1, 0.2}}, {{0, 0, 0}, {2, 0, 0}, {3, 2, 0}, {0, 2, 0}}});
    const Roots roots(asked.scene);
    for (RootId root = 0; root < roots.size(); ++root)
        for (const Element& element : descendants(roots[root], root_element(root), 2))
            for (const int per_side : {1, 3, 4}) {
                const auto samples = sample_points(asked.scene, roots[root], element, per_side);
                ASSERT_EQ(samples.size(), static_cast<std::size_t>(per_side * per_side));
                const Corners c = corners(asked.scene, roots[root], element);
                for (const SamplePoint& sample : samples) {
                    EXPECT_FALSE(sample.point.has_fraction());
                    for (int k = 0; k < c.count; ++k) {
                        const RationalPoint a = c.points[static_cast<std::size_t>(k)].rational();
                        const RationalPoint b = c.points[static_cast<std::size_t>((k + 1) % c.count)].rational();
                        const RationalPoint d = c.points[static_cast<std::size_t>((k + 2) % c.count)].rational();
                        const RationalPoint p = sample.point.rational();
                        const RationalPoint normal = cross(b - a, d - a);
                        EXPECT_EQ(dot(normal, p - a), 0);
                        EXPECT_GT(dot(normal, cross(b - a, p - a)), 0);
                    }
                }
            }
}

}  // namespace
}  // namespace cob::test
