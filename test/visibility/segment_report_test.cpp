// "explains one segment in words: every contact in order, which piece, where (exact and rounded), inside, side,
// corner or in-plane, and why the answer follows".
#include "report/segment_report.hpp"
#include "visibility/scenes.hpp"

#include <gtest/gtest.h>

namespace cob::test {
namespace {

std::string told(const Asked& asked, const Segment& segment) {
    const Explanation explanation = asked.oracle.explain(segment);
    return segment_text({asked.scene, segment, explanation, asked.oracle.nearest_blocker(segment)});
}

TEST(SegmentReport, TellsOfASeamThatCloses) {
    const Asked asked({{{0, 0, 0}, {1, 0, 0}, {1, 2, 0}, {0, 2, 0}}, {{1, 0, 0}, {2, 0, 0}, {2, 2, 0}, {1, 2, 0}}});
    EXPECT_EQ(told(asked, {Point{1, 1, 1}, Point{1, 1, -2}}),
              "from (1, 1, 1)\n"
              "to   (1, 1, -2)\n"
              "visibility: blocked\n"
              "at (1, 1, 0) (parameter 1/3, rounded 0.3333333333333333):\n"
              "  polygon 0: touched on side 1, (1, 0, 0) to (1, 2, 0), from its visible side\n"
              "    its sector, seen along the segment, runs counter-clockwise\n"
              "      from the direction (1, 2, 0) -> (1, 0, 0), on a seam where two pieces meet,\n"
              "      to the direction   (1, 0, 0) -> (1, 2, 0), on a seam where two pieces meet\n"
              "  polygon 1: touched on side 3, (1, 2, 0) to (1, 0, 0), from its visible side\n"
              "    its sector, seen along the segment, runs counter-clockwise\n"
              "      from the direction (1, 0, 0) -> (1, 2, 0), on a seam where two pieces meet,\n"
              "      to the direction   (1, 2, 0) -> (1, 0, 0), on a seam where two pieces meet\n"
              "  => blocked here: the sectors and the seams between them cover the full turn.\n"
              "Blocked: by several polygons together, none of which blocks by itself.\n");
}

TEST(SegmentReport, TellsOfEveryKindInOrder) {
    const Loop low{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}}, high{{1, 1, 2}, {4, 1, 2}, {4, 4, 2}, {1, 4, 2}};
    const Loop wall{{2, 2, -4}, {4, 4, -4}, {4, 4, -2}, {2, 2, -2}};
    const Asked asked({low, high, wall});
    const std::string text = told(asked, {Point{1, 1, 4}, Point{4, 4, -8}});
    const std::size_t corner = text.find("polygon 1: crossed inside"), inside = text.find("polygon 0: crossed inside");
    const std::size_t in_plane = text.find("polygon 2: met within its plane, up to (3, 3, -4)");
    ASSERT_NE(corner, std::string::npos) << text;
    ASSERT_NE(inside, std::string::npos) << text;
    ASSERT_NE(in_plane, std::string::npos) << text;
    EXPECT_LT(corner, inside);
    EXPECT_LT(inside, in_plane);
    EXPECT_NE(text.find("the first polygon that blocks by itself is 1."), std::string::npos) << text;
    EXPECT_NE(told(asked, {Point{1, 1, 4}, Point{1, 1, 1}}).find("polygon 1: touched at corner 0, (1, 1, 2)"),
              std::string::npos);
    EXPECT_NE(told(asked, {Point{1, 1, 4}, Point{1, 1, 3}}).find("The open segment meets no piece."),
              std::string::npos);
}

}  // namespace
}  // namespace cob::test
