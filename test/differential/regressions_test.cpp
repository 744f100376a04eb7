// Differences from the naive twin that were found, each with its reason.
#include "cob/candidates.hpp"
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
    Point from, to;
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
};

TEST(Regressions, Visibility) {
    for (const VisibilityRow& row : visibility_rows) {
        std::vector<naive::Face> faces;
        for (const auto& corners : row.faces) faces.push_back({corners, false});
        const Scene scene = library_scene(faces);
        const auto source = make_candidates(scene, Source::all);
        const VisibilityOracle oracle(scene, *source);
        EXPECT_EQ(oracle({row.from, row.to}), row.answer) << row.reason;
        EXPECT_EQ(oracle({row.to, row.from}), row.answer) << row.reason;

        const auto items = naive_scene(faces);
        std::vector<const naive::Polygon*> polygons;
        for (const naive::SceneItem& item : items) polygons.push_back(&item.polygon);
        EXPECT_STREQ(naive::to_text(naive::visibility(polygons, to_rational(row.from), to_rational(row.to))),
                     to_text(row.answer))
            << row.reason;
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

}  // namespace
}  // namespace cob::test
