// Differences from the naive twin that were found, each with its reason: SPEC 6.
#include "cob/candidates.hpp"
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

}  // namespace
}  // namespace cob::test
