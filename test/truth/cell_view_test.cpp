// The shapes of a certified pair: what is decided exactly, once for all points of the receiver's plane.
#include "radiosity/cell_view.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace cob::radiosity {
namespace {

// A receiver's first, second and last corner may lie on one line: it is the plane that decides, not that line.
TEST(PairShapes, DegenerateOnAStraightSideIsNotDegenerateOnThePlane) {
    ConvexPolygon receiver{{1, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 0}};
    for (int first = 0; first < 4; ++first) {
        PairShapes shapes(receiver, 1);
        const CornerLoop upright = shapes.add({{0, 0, 1}, {1, 0, 1}, {0, 0, 2}});  // over the side y = 0
        const VertexId a = upright[0], b = upright[1], c = upright[2];
        EXPECT_FALSE(shapes.always_in_plane(a, b, c));
        EXPECT_FALSE(shapes.always_in_line({a, b, b, c, c, a}));

        const VertexId beyond = shapes.add({{2, 0, 1}, {2, 1, 3}, {3, 0, 1}})[0];
        EXPECT_TRUE(shapes.always_in_plane(a, b, beyond)) << "three points on one line";
        EXPECT_TRUE(shapes.always_in_line({a, b, a, c, a, beyond})) << "three sides through one point";
        std::rotate(receiver.begin(), receiver.begin() + 1, receiver.end());
    }
}

}  // namespace
}  // namespace cob::radiosity
