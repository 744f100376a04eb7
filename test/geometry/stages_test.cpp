// The stages of relate(): whatever stage decides, the answer is that of fractions alone; on every class of input
// every stage that should occur does. Metamorphic relations on exact input.
#include "classes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

namespace cob::test {
namespace {

/// Compares relate() with fractions on one class; which stages decided.
PredicateCounters compare_with_fractions(const InputClass& input, int triangles) {
    const Queries queries = QueryMaker(input, 1).make(16, triangles);
    PredicateCounters counters;
    std::map<Relation, int> seen;
    for (PolygonId i = 0; i < queries.size(); ++i) {
        const BoxAnswer fast = relate(queries.scene, i, queries.box(i), &counters);
        const BoxAnswer slow = relate(queries.scene, i, queries.box(i), Arithmetic::rational);
        EXPECT_STREQ(to_text(fast.relation), to_text(slow.relation)) << i;
        EXPECT_EQ(fast.covers, slow.covers) << i;
        if (testing::Test::HasFailure()) break;
        const BoxAnswer interval = relate(queries.scene, i, queries.box(i), Arithmetic::interval);
        if (interval.decided) {
            EXPECT_EQ(interval.relation, slow.relation) << i;
            EXPECT_EQ(interval.covers, slow.covers) << i;
        }
        ++seen[fast.relation];
    }
    EXPECT_GE(seen.size(), input.touching || input.coplanar ? 3u : 2u);
    EXPECT_GT(counters.filtered, 0u);
    EXPECT_EQ(counters.rational, 0u) << "all of these fit 1024 bits";
    return counters;
}

class Stages : public testing::TestWithParam<InputClass> {};

TEST_P(Stages, AgreeWithFractionsAlone) {
    const InputClass& input = GetParam();
    const PredicateCounters counters = compare_with_fractions(input, 1500);
    const bool ties = input.touching || input.coplanar, short_and_aligned = input.bits <= 24 && !input.oblique;
    EXPECT_EQ(counters.integer > 0, ties && !short_and_aligned);
}

INSTANTIATE_TEST_SUITE_P(Classes, Stages, testing::ValuesIn(input_classes()), [](const auto& row) {
    std::string name = row.param.name;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
});

/// A class at a limit of what grid_kernel.hpp takes, and whether all, some or none of its queries lie within.
struct GridLimit {
    InputClass input;
    enum { all, some, none } within;
};

class GridLimits : public testing::TestWithParam<GridLimit> {};

TEST_P(GridLimits, AnswersAreThoseOfFractions) {
    const PredicateCounters counters = compare_with_fractions(GetParam().input, 600);
    // What the grid does not take, the integers decide where it is a tie.
    EXPECT_EQ(counters.integer == 0, GetParam().within == GridLimit::all);
    EXPECT_GE(counters.integer, GetParam().within == GridLimit::none ? 600u / 3 : 0u);
}

// bits, touching, coplanar, oblique, offset, step. Coordinates relative to the box reach 3/4 of 2^bits; an offset may
// have 2^50 of the finest step that the largest of them admits.
INSTANTIATE_TEST_SUITE_P(Classes, GridLimits,
                         testing::Values(GridLimit{{"bits_24", 24, true}, GridLimit::all},
                                         GridLimit{{"bits_24_coplanar", 24, false, true}, GridLimit::all},
                                         GridLimit{{"bits_25", 25, true}, GridLimit::some},
                                         GridLimit{{"bits_26", 26, true}, GridLimit::none},
                                         GridLimit{{"offset_2_44", 20, true, false, false, 0x1p44}, GridLimit::all},
                                         GridLimit{{"offset_2_50", 20, true, false, false, 0x1p50}, GridLimit::none},
                                         GridLimit{{"smallest", 24, true, false, false, 0, -170}, GridLimit::all},
                                         GridLimit{{"too_small", 24, true, false, false, 0, -180}, GridLimit::none},
                                         GridLimit{{"largest", 24, true, false, false, 0, 125}, GridLimit::all},
                                         GridLimit{{"too_large", 24, true, false, false, 0, 130}, GridLimit::none}),
                         [](const auto& row) { return std::string(row.param.input.name); });

/// A scene's answers to one box as text, polygon by polygon.
std::string answers(const std::vector<Loop>& loops, const BoxQuestion& question) {
    const Scene scene = scene_of(loops);
    const Box box(question);
    std::string text;
    for (PolygonId i = 0; i < scene.polygon_count(); ++i) {
        const BoxAnswer answer = relate(scene, i, box);
        text += std::string(to_text(answer.relation)) + (answer.covers ? "+ " : " ");
    }
    return text;
}

/// Small integers, so that ties really happen; convex planar quadrilaterals, and triangles.
std::vector<Loop> lattice_polygons(std::mt19937_64& random, int count) {
    std::vector<Loop> loops;
    const auto any = [&] { return static_cast<double>(random() % 9) - 2; };
    while (static_cast<int>(loops.size()) < count) {
        const Point a{any(), any(), any()}, b{any(), any(), any()}, c{any(), any(), any()};
        if (cross(b - a, c - a) == Point{}) continue;
        loops.push_back(random() % 2 ? Loop{a, b, c} : Loop{a, b, b + c - a, c});
    }
    return loops;
}

const Loop lattice_element = {{0, 0, 1}, {4, 0, 1}, {4, 3, 1}, {0, 3, 1}};

/// The same scene and box under a map of points that changes no answer.
template <class Map>
void expect_unchanged_under(const Map& map, const char* what) {
    std::set<std::string> seen;
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        std::mt19937_64 random(seed);
        std::vector<Loop> loops = lattice_polygons(random, 12);
        Loop element = lattice_element;
        const std::string before = answers(loops, question_of(element, Rational(1, 4), Rational(1, 2)));
        for (Loop& loop : loops)
            for (Point& p : loop) p = map(p);
        for (Point& p : element) p = map(p);
        ASSERT_EQ(answers(loops, question_of(element, Rational(1, 4), Rational(1, 2))), before) << what << seed;
        seen.insert(before);
    }
    EXPECT_GT(seen.size(), 20u);
}

TEST(Metamorphic, AnswersFollowThePoints) {
    expect_unchanged_under([](const Point& p) { return Point{p.y, p.z, p.x}; }, "axes permuted ");
    expect_unchanged_under([](const Point& p) { return Point{p.y, -p.x, p.z}; }, "quarter turn ");
    expect_unchanged_under([](const Point& p) { return 0x1p300 * p; }, "scaled up ");
    expect_unchanged_under([](const Point& p) { return 0x1p-300 * p; }, "scaled down ");
    expect_unchanged_under([](const Point& p) { return 0x1p-1074 * p; }, "scaled to subnormals ");
    expect_unchanged_under([](const Point& p) { return p + Point{0x1p40, -0x1p45, 0x1p50}; }, "shifted ");
    expect_unchanged_under(
        [](const Point& p) {
            return Point{-15 * p.x - 12 * p.y + 16 * p.z, 20 * p.x - 9 * p.y + 12 * p.z, 20 * p.y + 15 * p.z};
        },
        "turned obliquely ");
}

// "no answer depends on which" pieces: a polygon's relation is the strongest of its parts, and they cover together
// exactly where the whole does.
TEST(Metamorphic, SplittingAQuadrilateralKeepsItsRelation) {
    int close = 0;
    const Box box(question_of(lattice_element, Rational(1, 4), Rational(1, 2)));
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        std::mt19937_64 random(seed);
        for (const Loop& loop : lattice_polygons(random, 4)) {
            if (loop.size() != 4) continue;
            const Relation whole = answer_of(loop, box).relation;
            const Relation first = answer_of({loop[0], loop[1], loop[2]}, box).relation;
            const Relation second = answer_of({loop[0], loop[2], loop[3]}, box).relation;
            ASSERT_EQ(whole, std::max(first, second)) << seed;
            close += is_close(whole);
        }
    }
    EXPECT_GT(close, 50);
}

}  // namespace
}  // namespace cob::test
