// Differences from the naive twin that were found, each with its reason.
#include "cob/candidates.hpp"
#include "cob/classification.hpp"
#include "cob/geometry.hpp"
#include "cob/visibility.hpp"
#include "differential/scenes.hpp"
#include "naive/visibility.hpp"

#include <gtest/gtest.h>

namespace cob::test {
namespace {

struct VisibilityRow {
    const char* reason;
    std::vector<std::vector<Point>> faces;
    RationalPoint from, to;
    Visibility answer;
};

const VisibilityRow visibility_rows[] = {
    {"A third sheet ends, seen along the segment, where two others are joined, and deeper in space: it must not open "
     "their seam (adding a polygon never turns blocked into grazing).",
     {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
      {{0, 0, 0}, {0, 1, 0}, {-1, 0, 0}},
      {{0, 0, 0}, {-1, 0, 0}, {0, -1, 0}},
      {{0, 0, 0}, {0, -1, 0}, {1, 0, 0}},
      {{0, 0, 0}, {1, 0, 1}, {1, 1, 1}}},
     {0, 0, -2},
     {0, 0, 2},
     Visibility::blocked},
    {"The same where the joined sheets are half planes, and the third ends on the seam's other end.",
     {{{-1, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{1, 0, 0}, {-1, 0, 0}, {0, -1, 0}}, {{0, 0, 0}, {-1, 0, 1}, {-1, -1, 1}}},
     {0, 0, -2},
     {0, 0, 2},
     Visibility::blocked},
    {"Opposite to a seam is not on it: the gap between the first two sheets stays open.",
     {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
      {{0, 0, 0}, {0, 1, 0}, {-1, 0, 0}},
      {{0, 0, 0}, {0, -1, 1}, {1, 0, 0}},
      {{0, 0, 0}, {-1, 0, 0}, {0, -1, 2}}},
     {0, 0, -4},
     {0, 0, 4},
     Visibility::grazing},
    {"One product of the side of an end overflows, and two others outweigh it.",
     {{{-6.8000000000000005e+50, 3.8e+50, 3.8e+50},
       {3.4000000000000003e+50, -9.900000000000002e+50, 6.1e+50},
       {3.4000000000000003e+50, 6.1e+50, -9.900000000000002e+50}}},
     to_rational(Point{-1e40, 1e40, 1e40}),
     to_rational(Point{1.042e206, -1.042e206, -1.042e206}),
     Visibility::blocked},
    {"Half an ulp of an end is many times the scene.",
     {{{1e15, -0x1p-8, -0x1p-8}, {1e15, 0x1p-8, -0x1p-8}, {1e15, 0, 0x1p-8}}},
     {Rational(1024000000000000065, 1024), Rational(-325, 4096), 0},
     {Rational(1023999999999999937, 1024), Rational(315, 4096), 0},
     Visibility::blocked},
};

TEST(Regressions, Visibility) {
    for (const VisibilityRow& row : visibility_rows) {
        std::vector<naive::Face> faces;
        for (const auto& corners : row.faces) faces.push_back({corners, false});
        const Scene scene = library_scene(faces);
        const ExactPoint from(row.from), to(row.to);
        for (const Source kind : {Source::all, Source::tree, Source::octree, Source::embree}) {
            if (!is_available(kind)) continue;
            const auto source = make_candidates(scene, kind);
            const VisibilityOracle oracle(scene, *source);
            EXPECT_EQ(oracle({from, to}), row.answer) << to_text(kind) << ": " << row.reason;
            EXPECT_EQ(oracle({to, from}), row.answer) << to_text(kind) << ": " << row.reason;
        }

        const auto items = naive_scene(faces);
        std::vector<const naive::Polygon*> polygons;
        for (const naive::SceneItem& item : items) polygons.push_back(&item.polygon);
        EXPECT_STREQ(naive::to_text(naive::visibility(polygons, row.from, row.to)), to_text(row.answer)) << row.reason;
    }
}

// SPEC 5: "p lies in the element's plane", where p is the union of its pieces (SPEC 2): the spike out of the plane is
// dropped when the loop is cut, and the polygon casts no shadow beside it.
TEST(Regressions, CoplanarIsSaidOfThePieces) {
    const std::vector<Point> spiked{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {6, 4, 1}, {4, 4, 0}, {0, 4, 0}};
    const Scene scene = library_scene({{spiked, false}});
    ASSERT_FALSE(scene.polygon(0).planar);
    BoxQuestion question;
    question.corners = {{Point{0, 0, 0}, Point{2, 0, 0}, Point{0, 2, 0}, Point{}}, 3};
    question.u = Point{1, 0, 0};
    EXPECT_EQ(relate(scene, 0, Box(question)).relation, Relation::coplanar);
}

// SPEC 4: only the direction of u counts, be it a fraction that no binary64 number is near.
TEST(Regressions, DirectionsMayBeTinyFractions) {
    const Scene scene = library_scene({{{{2.25, 1.2, 0.1}, {2.3, 1.2, 0.1}, {2.25, 1.22, 0.2}}, false}});
    const auto source = make_candidates(scene, Source::tree);
    const Rational unit(1, 3 * (Integer(1) << 1074)), huge(Integer(1) << 1100);
    for (const Rational& length : {Rational(1), unit, huge}) {
        BoxQuestion question;
        question.corners = {{Point{0, 0, 0}, Point{2, 2, 0}, Point{0, 4, 0}, Point{-2, 2, 0}}, 4};
        question.u = ExactPoint(RationalPoint{2 * length, length, 0});
        question.margin = 0;
        question.height = Rational(1, 4);
        EXPECT_EQ(relate(scene, 0, Box(question)).relation, Relation::crossing) << length;
        Classification found;
        BoxClassifier(scene).from_scene(Box(question), *source, found);
        EXPECT_EQ(found.state, BufferState::close);
    }
}

}  // namespace
}  // namespace cob::test
