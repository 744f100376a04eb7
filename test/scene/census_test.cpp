// The census behind `cob info`, against brute force over all pairs in fractions.
#include "cob/census.hpp"
#include "scene/scenes.hpp"
#include "temporary_folder.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <random>
#include <set>

namespace cob {
namespace {

Scene build(std::vector<Point> positions, std::vector<std::vector<VertexId>> faces) {
    Scene::Input input;
    input.name = "test";
    input.positions = std::move(positions);
    input.materials.resize(2);
    input.materials[1].emitted_exitance = {1, 1, 1};
    for (auto& face : faces) input.faces.push_back({std::move(face), 0, 0});
    return Scene::build(std::move(input), {true});
}

using Polygon3 = std::vector<RationalPoint>;

Polygon3 corners_of(const Scene& scene, const Piece& piece) {
    Polygon3 corners;
    for (const VertexId corner : scene.corners(piece)) corners.push_back(to_rational(scene.position(corner)));
    return corners;
}

RationalPoint normal_of(const Polygon3& p) {
    RationalPoint normal;
    for (std::size_t k = 0; k < p.size(); ++k) normal = normal + cross(p[k], p[(k + 1) % p.size()]);
    return normal;
}

/// What of a convex polygon is on the side of the plane where dot(normal, x - origin) >= 0.
Polygon3 clipped(const Polygon3& p, const RationalPoint& origin, const RationalPoint& normal) {
    Polygon3 result;
    for (std::size_t k = 0; k < p.size(); ++k) {
        const RationalPoint &a = p[k], &b = p[(k + 1) % p.size()];
        const Rational at_a = dot(normal, a - origin), at_b = dot(normal, b - origin);
        if (at_a >= 0) result.push_back(a);
        if ((at_a > 0 && at_b < 0) || (at_a < 0 && at_b > 0))
            result.push_back(a + Rational(at_a / (at_a - at_b)) * (b - a));
    }
    return result;
}

bool overlap(const Polygon3& p, const Polygon3& q) {
    const RationalPoint n = normal_of(q);
    for (const RationalPoint& corner : p)
        if (dot(n, corner - q[0]) != 0) return false;
    Polygon3 rest = p;
    for (std::size_t k = 0; k < q.size(); ++k) rest = clipped(rest, q[k], cross(n, q[(k + 1) % q.size()] - q[k]));
    return normal_of(rest) != RationalPoint{};
}

bool inside_segment(const RationalPoint& p, const RationalPoint& a, const RationalPoint& b) {
    return cross(b - a, p - a) == RationalPoint{} && dot(p - a, b - p) > 0;
}

struct Counts {
    std::size_t shared = 0, crowded = 0, junction_corners = 0, junction_pairs = 0, overlaps = 0, same_facing = 0;
};

Counts brute_force(const Scene& scene) {
    Counts counts;
    std::map<std::pair<Point, Point>, std::set<PolygonId>> edges;
    std::map<Point, std::set<PolygonId>> corners;
    for (PolygonId id = 0; id < scene.polygon_count(); ++id) {
        if (!scene.polygon(id).valid) continue;
        const auto loop = scene.loop(id);
        for (std::size_t k = 0; k < loop.size(); ++k) {
            const Point &a = scene.position(loop[k]), &b = scene.position(loop[(k + 1) % loop.size()]);
            edges[{std::min(a, b), std::max(a, b)}].insert(id);
            corners[a].insert(id);
        }
    }
    for (const auto& [edge, polygons] : edges) {
        counts.shared += polygons.size() >= 2 ? 1 : 0;
        counts.crowded += polygons.size() >= 3 ? 1 : 0;
    }
    for (const auto& [corner, at] : corners) {
        std::size_t pairs = 0;
        for (const auto& [edge, along] : edges) {
            const bool others = at.size() > 1 || along.size() > 1 || *at.begin() != *along.begin();
            if (others && inside_segment(to_rational(corner), to_rational(edge.first), to_rational(edge.second)))
                ++pairs;
        }
        counts.junction_pairs += pairs;
        counts.junction_corners += pairs > 0 ? 1 : 0;
    }
    for (PolygonId a = 0; a < scene.polygon_count(); ++a)
        for (PolygonId b = a + 1; b < scene.polygon_count(); ++b) {
            bool found = false, same = false;
            for (const Piece& p : scene.pieces_of(a))
                for (const Piece& q : scene.pieces_of(b)) {
                    const Polygon3 first = corners_of(scene, p), second = corners_of(scene, q);
                    if (found || !overlap(first, second)) continue;
                    found = true;
                    same = dot(normal_of(first), normal_of(second)) > 0;
                }
            counts.overlaps += found ? 1 : 0;
            counts.same_facing += same ? 1 : 0;
        }
    return counts;
}

TEST(Census, AgreesWithBruteForce) {
    std::mt19937_64 engine(31);
    Counts total;
    for (int round = 0; round < 150; ++round) {
        // Half of the rounds keep to two planes, where overlaps and T-junctions are frequent.
        const bool flat = round % 2 == 0;
        std::vector<Point> positions;
        for (int k = 0; k < 20; ++k) {
            const auto number = [&](unsigned n) { return static_cast<double>(engine() % n); };
            positions.push_back({number(4), number(4), number(flat ? 2 : 4)});
        }
        std::vector<std::vector<VertexId>> faces;
        for (int k = 0; k < 14; ++k) {
            faces.emplace_back();
            for (std::uint64_t corner = 3 + engine() % 2; corner > 0; --corner)
                faces.back().push_back(static_cast<VertexId>(engine() % positions.size()));
        }
        const Scene scene = build(positions, faces);
        const Census census = take_census(scene);
        const Counts expected = brute_force(scene);
        ASSERT_EQ(census.shared_edges, expected.shared);
        ASSERT_EQ(census.crowded_edges, expected.crowded);
        ASSERT_EQ(census.t_junction_corners, expected.junction_corners);
        ASSERT_EQ(census.t_junction_pairs, expected.junction_pairs);
        ASSERT_EQ(census.t_junctions.size(), expected.junction_pairs);
        ASSERT_EQ(census.overlap_pairs, expected.overlaps);
        // Pieces of polygons that are not planar may overlap both ways; one of them is reported.
        if (census.not_planar.empty()) {
            ASSERT_EQ(census.same_facing_overlap_pairs, expected.same_facing);
        }
        total.shared += expected.shared;
        total.crowded += expected.crowded;
        total.junction_pairs += expected.junction_pairs;
        total.overlaps += expected.overlaps;
        total.same_facing += expected.same_facing;
    }
    EXPECT_GT(total.shared, 100u);
    EXPECT_GT(total.crowded, 10u);
    EXPECT_GT(total.junction_pairs, 100u);
    EXPECT_GT(total.overlaps, 100u);
    EXPECT_GT(total.same_facing, 50u);
}

TEST(Census, NamesWhatIsSpecial) {
    const std::vector<Point> p{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {1, 1, 0}, {1, 2, 0},
                               {2, 2, 0}, {2, 1, 0}, {2, 0, 0}, {4, 4, 1}, {6, 0, 0}};
    const Scene scene = build(p, {{0, 1, 2, 3},                    // 0
                                  {0, 1, 2, 3, 0, 4, 5, 6, 7, 4},  // 1: a hole on a bridge
                                  {3, 2, 1, 0},                    // 2: the back of 0
                                  {0, 8, 1, 2, 3},                 // 3: a straight angle
                                  {0, 1, 9, 3},                    // 4: not planar
                                  {0, 1, 10, 1, 2, 3},             // 5: a spike
                                  {0, 1, 3, 2},                    // 6: invalid
                                  {2, 3, 0, 1}});                  // 7: 0 again
    const Census census = take_census(scene);
    using Ids = std::vector<PolygonId>;
    EXPECT_EQ(census.valid, 7u);
    EXPECT_EQ(census.not_planar, Ids{4});
    EXPECT_EQ(census.not_convex, (Ids{1, 5}));
    EXPECT_EQ(census.with_bridges, (Ids{1, 5}));
    EXPECT_EQ(census.with_straight_angles, (Ids{3, 5}));
    EXPECT_EQ(census.with_spikes, Ids{5});
    EXPECT_EQ(census.duplicates, 2u);
    EXPECT_EQ(census.lowest, (Point{0, 0, 0}));
    EXPECT_EQ(census.highest, (Point{6, 4, 1}));
    EXPECT_EQ(census.bits, 3);
    EXPECT_EQ(census.lowest_bit, 0);
    std::size_t duplicate_pairs = 0, opposite = 0;
    for (const CoplanarOverlap& pair : census.overlaps) {
        duplicate_pairs += pair.duplicate ? 1 : 0;
        opposite += pair.same_facing ? 0 : 1;
    }
    EXPECT_EQ(duplicate_pairs, 3u);
    EXPECT_EQ(opposite, 6u);  // 2 lies behind a piece of 4, too
}

// A bridge is a side "run in both directions"; a loop run twice has every side twice in one.
TEST(Census, ALoopRunTwiceHasNoBridges) {
    const Scene scene = build({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}}, {{0, 1, 2, 3, 0, 1, 2, 3}});
    const Census census = take_census(scene);
    EXPECT_EQ(census.valid, 1u);
    EXPECT_TRUE(census.with_bridges.empty());
}

// "planar as decimal text but not as binary64": the plane x + y + z = 0.3, whose corners are no binary64 numbers.
TEST(Census, FindsWhatIsPlanarAsWritten) {
    const test::TemporaryFolder folder;
    const std::string path = folder / "decimal.obj";
    std::ofstream(path)
        << "v 0.1 0.1 0.1\nv 0.3 0.1 -0.1\nv 0.3e0 +.4 -4E-1\nv 10e-2 0.7 -0.50\nv 0.1 0.7 -0.5000000000000001\n"
           "f 1 2 3 4\nf 1 2 3 5\nf 1 2 3\n";
    const Scene scene = read_obj(path, {});
    ASSERT_FALSE(scene.polygon(0).planar);
    ASSERT_FALSE(scene.polygon(1).planar);
    EXPECT_EQ(planar_as_decimal(scene, path), std::vector<PolygonId>{0});
}

}  // namespace
}  // namespace cob
