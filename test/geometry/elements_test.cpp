// Elements: SPEC section 3. Witness: corners by repeated halving in fractions, which knows nothing of addresses.
#include "cob/error.hpp"
#include "cob/geometry.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>

namespace cob {
namespace {

/// A number from the engine's raw bits: an integer of `bits` bits, either sign, times 2^exponent.
double random_number(std::mt19937_64& engine, int bits, int exponent) {
    const auto integer = static_cast<std::int64_t>(engine() >> (64 - bits));
    return std::ldexp(static_cast<double>(engine() & 1 ? integer : -integer), exponent);
}

Point random_point(std::mt19937_64& engine, int bits, int exponent) {
    return {random_number(engine, bits, exponent), random_number(engine, bits, exponent),
            random_number(engine, bits, exponent)};
}

/// A parallelogram (exactly planar) where `corners` is 4, else a triangle.
Scene random_scene(std::mt19937_64& engine, int corners, int bits, int exponent) {
    for (;;) {
        const Point a = random_point(engine, bits, exponent), p = random_point(engine, bits - 2, exponent),
                    q = random_point(engine, bits - 2, exponent);
        Scene::Input input;
        input.materials.emplace_back();
        input.positions = {a, a + p, a + p + q, a + q};
        if (corners == 3) input.positions.pop_back();
        Scene::Face face;
        for (VertexId k = 0; k < corners; ++k) face.corners.push_back(k);
        input.faces.push_back(face);
        Scene scene = Scene::build(std::move(input), {true});
        if (scene.invalid().empty() && static_cast<int>(scene.piece(0).corner_count) == corners) return scene;
    }
}

using Loop = std::vector<RationalPoint>;

Loop loop_of(const Corners& corners) {
    Loop loop;
    for (int k = 0; k < corners.count; ++k) loop.push_back(corners.points[static_cast<std::size_t>(k)].rational());
    return loop;
}

/// "Refinement halves every side: a triangle into 4 triangles, a quadrilateral (bilinearly) into 4 quadrilaterals."
std::array<Loop, 4> halved(const Loop& p) {
    const auto middle = [&](std::size_t a, std::size_t b) { return Rational(1, 2) * (p[a] + p[b]); };
    if (p.size() == 3) {
        const RationalPoint ab = middle(0, 1), bc = middle(1, 2), ca = middle(2, 0);
        return {Loop{p[0], ab, ca}, {ab, p[1], bc}, {ca, bc, p[2]}, {bc, ca, ab}};
    }
    const RationalPoint ab = middle(0, 1), bc = middle(1, 2), cd = middle(2, 3), da = middle(3, 0);
    const RationalPoint centre = Rational(1, 2) * (ab + cd);
    return {Loop{p[0], ab, centre, da}, {ab, p[1], bc, centre}, {centre, bc, p[2], cd}, {da, centre, cd, p[3]}};
}

struct Range {
    int bits, exponent;
    const char* what;
};
const Range ranges[] = {{6, 0, "small integers"},      {50, -40, "full significands"}, {50, 900, "near overflow"},
                        {30, -1070, "subnormal"},      {50, -1074, "at the bottom"},   {12, -4, "grid"},
                        {50, 40, "large coordinates"}, {50, 973, "at the top"}};

TEST(Elements, ChildrenHalveTheirParentExactly) {
    std::mt19937_64 engine(7);
    int with_fraction = 0, pairs = 0, binary64 = 0;
    for (const Range& range : ranges)
        for (int corner_count = 3; corner_count <= 4; ++corner_count)
            for (int round = 0; round < 5; ++round) {
                const Scene scene = random_scene(engine, corner_count, range.bits, range.exponent);
                const Roots roots(scene);
                ASSERT_EQ(roots.size(), 1);
                Element element = root_element(0);
                for (int level = 0; level < 12; ++level) {
                    const Loop loop = loop_of(corners(scene, roots[0], element));
                    const auto expected = halved(loop);
                    const auto actual = children(roots[0], element);
                    for (std::size_t k = 0; k < 4; ++k) {
                        const Corners made = corners(scene, roots[0], actual[k]);
                        ASSERT_EQ(loop_of(made), expected[k]) << range.what << ", child " << k;
                        ASSERT_EQ(parent(roots[0], actual[k]), element);
                        for (int c = 0; c < made.count; ++c) {
                            const ExactPoint& point = made.points[static_cast<std::size_t>(c)];
                            ASSERT_EQ(point, ExactPoint(point.rational()));
                            ++(point.has_fraction() ? with_fraction : point.is_binary64() ? binary64 : pairs);
                        }
                    }
                    element = actual[engine() % 4];
                }
            }
    EXPECT_GT(with_fraction, 100);
    EXPECT_GT(pairs, 100);
    EXPECT_GT(binary64, 100);
}

// "corner0 + s (corner1 - corner0) + t (corner2 - corner0)", bilinear for four corners; s and t taken exactly.
TEST(Elements, PointsInsideAreExact) {
    std::mt19937_64 engine(8);
    for (const Range& range : ranges)
        for (int corner_count = 3; corner_count <= 4; ++corner_count)
            for (int round = 0; round < 20; ++round) {
                const Scene scene = random_scene(engine, corner_count, range.bits, range.exponent);
                const Roots roots(scene);
                Element element = root_element(0);
                for (std::uint64_t level = engine() % 6; level > 0; --level)
                    element = children(roots[0], element)[engine() % 4];
                const int bits = 1 + static_cast<int>(engine() % 53);
                const double s = std::abs(random_number(engine, bits, -bits));
                const double t = round == 0 ? 1.0 : std::abs(random_number(engine, bits, -bits - round));
                const Loop p = loop_of(corners(scene, roots[0], element));
                const Rational u(s), v(t);
                const RationalPoint expected = corner_count == 3 ? p[0] + u * (p[1] - p[0]) + v * (p[2] - p[0])
                                                                 : (1 - u) * (1 - v) * p[0] + u * (1 - v) * p[1] +
                                                                       u * v * p[2] + (1 - u) * v * p[3];
                const ExactPoint actual = point_in(scene, roots[0], element, s, t);
                ASSERT_EQ(actual.rational(), expected) << range.what;
                ASSERT_EQ(actual, ExactPoint(expected));
            }
}

// "2^a by 2^b patches, a triangle into 4^a, as few as bring the sides to the wanted length"
TEST(Patches, AreAsFewAsBringTheSidesToTheLength) {
    Scene::Input input;
    input.materials.emplace_back();
    input.positions = {{0, 0, 0}, {4, 0, 0}, {4, 1, 0}, {0, 1, 0}, {0, 3, 0}};
    input.faces = {{{0, 1, 2, 3}, 0, 1}, {{0, 1, 4}, 0, 2}};
    const Scene scene = Scene::build(std::move(input));
    const Roots roots(scene);
    ASSERT_EQ(roots.size(), 2);
    const auto count = [&](RootId root, double edge) { return patches(scene, roots[root], edge).size(); };
    EXPECT_EQ(count(0, 4.0), 1u);
    EXPECT_EQ(count(0, std::nextafter(4.0, 0.0)), 2u);
    EXPECT_EQ(count(0, 1.0), 4u);
    EXPECT_EQ(count(0, std::nextafter(1.0, 0.0)), 16u);
    EXPECT_EQ(count(1, 5.0), 1u);
    EXPECT_EQ(count(1, std::nextafter(5.0, 0.0)), 4u);
    EXPECT_EQ(count(1, 1.25), 16u);
    EXPECT_EQ(count(0, 0.0), 1u);
    EXPECT_EQ(count(0, -1.0), 1u);
    EXPECT_EQ(count(0, INFINITY), 1u);
    EXPECT_THROW(count(0, 1e-300), InputError);
    EXPECT_THROW(count(0, 1e-5), InputError);
    for (const Element& element : patches(scene, roots[1], 1.25)) EXPECT_EQ(element.root, 1);
}

// Patches of a triangle tile it: their doubled areas are equal and sum to its own, and each occurs once.
TEST(Patches, TileTheirRoot) {
    std::mt19937_64 engine(9);
    for (int corner_count = 3; corner_count <= 4; ++corner_count) {
        const Scene scene = random_scene(engine, corner_count, 8, 0);
        const Roots roots(scene);
        const auto normal = [](const Loop& p) {
            RationalPoint sum;
            for (std::size_t k = 0; k < p.size(); ++k) sum = sum + cross(p[k], p[(k + 1) % p.size()]);
            return sum;
        };
        RationalPoint sum;
        std::set<Loop> seen;
        const auto elements = patches(scene, roots[0], 5);
        EXPECT_GT(elements.size(), 10u);
        for (const Element& element : elements) {
            const Loop loop = loop_of(corners(scene, roots[0], element));
            EXPECT_TRUE(seen.insert(loop).second);
            sum = sum + normal(loop);
            EXPECT_EQ(Rational(elements.size()) * normal(loop),
                      normal(loop_of(corners(scene, roots[0], root_element(0)))));
        }
        EXPECT_EQ(sum, normal(loop_of(corners(scene, roots[0], root_element(0)))));
    }
}

TEST(Descendants, AreInDepthFirstOrder) {
    std::mt19937_64 engine(10);
    const Scene scene = random_scene(engine, 4, 8, 0);
    const Roots roots(scene);
    const auto elements = descendants(roots[0], root_element(0), 2);
    ASSERT_EQ(elements.size(), 16u);
    for (std::size_t k = 0; k < 16; ++k)
        EXPECT_EQ(elements[k], children(roots[0], children(roots[0], root_element(0))[k / 4])[k % 4]);
}

TEST(Children, StopAtLevel31) {
    std::mt19937_64 engine(11);
    const Scene scene = random_scene(engine, 3, 50, -40);
    const Roots roots(scene);
    Element element = root_element(0);
    for (int level = 0; level < 31; ++level) element = children(roots[0], element)[2];
    EXPECT_EQ(element.j, 0x7FFFFFFFu);
    EXPECT_EQ(corners(scene, roots[0], element).points[2].rational(), to_rational(scene.position(2)));
    EXPECT_THROW(children(roots[0], element), InputError);
}

// Choice 2: "the longest side of the piece, the first among equals".
TEST(BaseEdge, IsTheFirstLongestSide) {
    struct Row {
        std::vector<Point> loop;
        int side;
    };
    const Row rows[] = {
        {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, 0},
        {{{0, 0, 0}, {1, 0, 0}, {1, 2, 0}, {0, 2, 0}}, 1},
        {{{0, 0, 0}, {std::nextafter(1, 0), 0, 0}, {0, 1, 0}}, 1},
        {{{0, 0, 0}, {0, 3, 4}, {-5, 0, 0}}, 1},
        {{{0, 0, 0}, {5, 0, 0}, {5, 5e-324, 0}, {0, 5e-324, 0}}, 0},
        {{{0, 0, 0}, {1e200, 0, 0}, {1e200, 1e200, 0}, {0, 1e200, 0}}, 0},
        {{{-1e308, 0, 0}, {1e308, 0, 0}, {0, 1e308, 0}}, 0},
    };
    for (const Row& row : rows) {
        Scene::Input input;
        input.materials.emplace_back();
        input.positions = row.loop;
        input.faces.emplace_back();
        for (std::size_t k = 0; k < row.loop.size(); ++k) input.faces[0].corners.push_back(static_cast<VertexId>(k));
        const Scene scene = Scene::build(std::move(input));
        const Roots roots(scene);
        const Root& root = roots[0];
        EXPECT_EQ(root.longest_side, row.side);
        const auto from = static_cast<std::size_t>(row.side), to = (from + 1) % row.loop.size();
        const RationalPoint side = to_rational(row.loop[to]) - to_rational(row.loop[from]);
        const ExactPoint u = box_question(scene, root, root_element(0), Rational(1, 8), Rational(1, 4)).u;
        EXPECT_TRUE(std::isfinite(u.nearest().x));
        EXPECT_EQ(cross(u.rational(), side), RationalPoint{});
        EXPECT_GT(dot(u.rational(), side), 0);
        EXPECT_EQ(u, ExactPoint(u.rational()));
    }
}

// "pieces with more corners are cut into triangles as above"
TEST(Roots, CutPiecesWithMoreThanFourCorners) {
    Scene::Input input;
    input.materials.emplace_back();
    input.positions = {{0, 0, 0}, {2, 0, 0}, {3, 1, 0}, {1, 3, 0}, {-1, 1, 0}};
    input.faces = {{{0, 1, 2, 3, 4}, 0, 1}, {{0, 1, 2}, 0, 2}};
    const Scene scene = Scene::build(std::move(input));
    const Roots roots(scene);
    EXPECT_EQ(scene.pieces().size(), 2u);
    ASSERT_EQ(roots.size(), 4);
    EXPECT_EQ(roots.of(0), (std::pair<RootId, RootId>{0, 3}));
    EXPECT_EQ(roots.of(1), (std::pair<RootId, RootId>{3, 4}));
    for (RootId id = 0; id < roots.size(); ++id) EXPECT_EQ(roots[id].id, id);
    EXPECT_EQ(roots[0].corners, (std::array<VertexId, 4>{3, 4, 0, -1}));  // the ear at the smallest position
}

}  // namespace
}  // namespace cob
