// "The same answers, byte for byte, from every source of candidates on every shipped scene and 10^6 random segments".
// SPEC 6: the source of candidates is no part of the answer.
#include "cob/shooter.hpp"
#include "geometry/candidate_list.hpp"
#include "visibility/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

namespace cob::test {
namespace {

#ifdef COB_LONG_TESTS
constexpr int random_scenes = 20000, scene_segments = 20000;
#else
constexpr int random_scenes = 300, scene_segments = 1000;
#endif

std::string answers(const std::vector<Visibility>& visibilities) {
    std::string text;
    for (const Visibility v : visibilities) text += std::to_string(static_cast<int>(v));
    return text;
}

void expect_one_answer(const Scene& scene, const std::vector<Segment>& segments, const std::string& name) {
    std::string expected;
    for (const Source source : sources()) {
        const auto candidates = make_candidates(scene, source);
        const std::string answer = answers(visibilities(VisibilityOracle(scene, *candidates), segments));
        if (source == Source::all) expected = answer;
        ASSERT_TRUE(answer == expected) << name << " over " << to_text(source);
    }
}

/// A point on a random piece (a corner, or a dyadic point of its first triangle), or anywhere around the scene.
ExactPoint random_point(const Scene& scene, Random& random, double far) {
    const PieceId piece = random.integer(0, static_cast<int>(scene.pieces().size()) - 1);
    const View<VertexId> corners = scene.corners(scene.piece(piece));
    const Point a = scene.position(corners[0]), b = scene.position(corners[1]), c = scene.position(corners[2]);
    switch (random.integer(0, 2)) {
        case 0:
            return a;
        case 1:
            return ExactPoint(to_rational(a) + (Rational(random.integer(1, 7), 16) * to_rational(b - a)) +
                              (Rational(random.integer(1, 7), 16) * to_rational(c - a)));
        default:
            return Point{a.x + far * (random.fraction() - 0.5), a.y + far * (random.fraction() - 0.5),
                         a.z + far * (random.fraction() - 0.5)};
    }
}

TEST(Sources, OneAnswerOnEveryShippedScene) {
    std::vector<std::string> files;
    for (const auto& entry : std::filesystem::directory_iterator(COB_DATA))
        if (entry.path().extension() == ".obj") files.push_back(entry.path().string());
    std::sort(files.begin(), files.end());
    ASSERT_FALSE(files.empty());
    for (const std::string& file : files) {
        const Scene scene = read_obj(file, {}, nullptr);
        Random random(scene.pieces().size());
        std::vector<Segment> segments;
        while (static_cast<int>(segments.size()) < scene_segments) {
            const double far = random.integer(0, 9) == 0 ? 1e5 : 3;
            const Segment segment{random_point(scene, random, far), random_point(scene, random, far)};
            if (segment.from != segment.to) segments.push_back(segment);
        }
        expect_one_answer(scene, segments, file);
    }
}

// Small and large scenes near and far from the origin, up to the largest binary64 numbers, with segments from within
// and from far outside.
TEST(Sources, OneAnswerWhateverTheScale) {
    for (int seed = 0; seed < random_scenes; ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        const int exponents[] = {0, 0, 0, 30, -30, 500, -500, -1060, 1010, 1021};
        const int exponent = exponents[random.integer(0, 9)];
        const double offset = random.integer(0, 3) == 0 ? 1048576.0 * random.integer(1, 1000) : 0;
        std::vector<Loop> loops = random.integer(0, 1) == 0 ? lattice_terrain(random, 6, 2)
                                                            : lattice_soup(random, random.integer(1, 20), 6, 3);
        const auto placed = [&](Point p) {
            for (int axis = 0; axis < 3; ++axis)
                p[axis] = std::ldexp(p[axis] + offset, exponent - (offset > 0 ? 30 : 0));
            return p;
        };
        for (Loop& loop : loops)
            for (Point& p : loop) p = placed(p);
        const Scene scene = scene_of(loops, Vertices::shared, true);
        std::vector<Segment> segments;
        for (int k = 0; k < 50; ++k) {
            const int finite = exponent > 1010 ? 7 : 5000;
            const int far = std::min(finite, random.integer(0, 5) == 0 ? 5000 : random.integer(0, 5) == 0 ? 30 : 7);
            const Segment segment{placed(random.lattice_point(-1, 7)), placed(random.lattice_point(-far, far))};
            if (segment.from != segment.to) segments.push_back(segment);
        }
        expect_one_answer(scene, segments, "scene " + std::to_string(seed));
    }
}

TEST(Sources, BoundsNameEveryPolygonThatMeetsThem) {
    for (int seed = 0; seed < 100; ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        const Scene scene = scene_of(lattice_soup(random, random.integer(1, 30), 6), Vertices::shared, true);
        for (int k = 0; k < 10; ++k) {
            const Point low = random.lattice_point(0, 5);
            const std::array<double, 6> bounds{low.x, low.y, low.z, low.x + 1, low.y + random.integer(0, 2), low.z + 1};
            std::vector<std::vector<PolygonId>> named;
            for (const Source source : sources()) {
                named.push_back(polygons_in(*make_candidates(scene, source), bounds));
                EXPECT_EQ(named.back(), named.front()) << seed << ' ' << to_text(source);
            }
        }
    }
}

}  // namespace
}  // namespace cob::test
