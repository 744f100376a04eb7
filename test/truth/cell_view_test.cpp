// What is seen from every point of a cell at once: against exact cones over single points.
#include "radiosity/cell_view.hpp"

#include "radiosity/cell_flux.hpp"
#include "radiosity/cells.hpp"
#include "truth/cell_rooms.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace cob::radiosity {
namespace {

using test::CellViews;
using test::Room;
using test::RoomBuilder;

// A receiver's first, second and last corner may lie on one line: it is the plane that decides, not that line.
TEST(PairShapes, DegenerateOnAStraightSideIsNotDegenerateOnThePlane) {
    ConvexPolygon receiver{{1, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 0}};
    for (int first = 0; first < 4; ++first) {
        PairShapes shapes(receiver, 1);
        const CornerLoop upright = shapes.add({{0, 0, 1}, {1, 0, 1}, {0, 0, 2}});  // over the side y = 0
        const CornerLoop beyond = shapes.add({{2, 0, 1}, {2, 1, 3}, {3, 0, 1}});   // its last side goes on with ab
        const VertexId b = upright.corners[1], c = upright.corners[2];
        const std::int32_t ab = upright.sides[0].index, bc = upright.sides[1].index, ca = upright.sides[2].index;
        EXPECT_FALSE(shapes.always_in_plane(ab, c));
        EXPECT_FALSE(shapes.always_in_line({ab, bc, ca}));
        EXPECT_TRUE(shapes.always_in_plane(ab, b)) << "its own end";
        EXPECT_TRUE(shapes.always_in_plane(ab, beyond.corners[0])) << "three points on one line";
        EXPECT_TRUE(shapes.always_in_line({ab, ca, beyond.sides[2].index})) << "two sides in one plane";
        EXPECT_EQ(shapes.common_side(ab, beyond), std::optional<std::size_t>(2));
        EXPECT_EQ(shapes.common_side(bc, beyond), std::nullopt);
        std::rotate(receiver.begin(), receiver.begin() + 1, receiver.end());
    }
}

// Wherever the structure is certain, the contour's form factor is the exact cones' at every point of the cell.
TEST_F(CellViews, ContoursOfCellsAreThoseOfTheirPoints) {
    std::array<int, 3> certain{}, undecided{}, partly{};
    for (int k = 0; k < 600; ++k) {
        const int kind = k % 3;
        const Room room(this->room(kind));
        const Triangle2D cell = this->cell();
        CellView view(room.shapes, cell);
        const auto occluders = view.between(room.lights, room.occluders);
        try {
            const Contour contour = view.visible_contour(room.lights, occluders);
            ++certain[kind];
            for (int i = 0; i < 3; ++i) {
                const Point2D point = point_in(cell);
                const double expected = room.visible_from(point);
                ASSERT_NEAR(form_factor_at(room.shapes, point, contour), expected, 1e-12) << k;
                partly[kind] += expected > 1e-6 && !occluders.empty();
            }
        } catch (const UndecidedSign&) {
            ++undecided[kind];
        }
    }
    for (int kind = 0; kind < 3; ++kind) {
        EXPECT_GT(certain[kind], 40);
        EXPECT_GT(undecided[kind], 20);
        EXPECT_GT(partly[kind], 40);
    }
}

// Of a single point nearly always, whatever is known of the cell around.
TEST_F(CellViews, ContoursOfPoints) {
    int decided = 0;
    for (int k = 0; k < 300; ++k) {
        const Room room(this->room(k % 3));
        const Triangle2D cell = this->cell();
        CellView around(room.shapes, cell);
        const auto occluders = around.between(room.lights, room.occluders);
        const Point2D point = point_in(cell);
        try {
            const Contour contour = CellView(around, point).visible_contour(room.lights, occluders);
            ASSERT_NEAR(form_factor_at(room.shapes, point, contour), room.visible_from(point), 1e-12) << k;
            ++decided;
        } catch (const UndecidedSign&) {
        }
    }
    EXPECT_GT(decided, 290);
}

// Beyond the tables' size, too: behind a hundred triangles.
TEST_F(CellViews, ContoursOfManyShapes) {
    RoomBuilder builder = RoomBuilder().sheet(0, 0, 1, 1, 0, true).sheet(0, 0, 1, 1, 1, false);
    for (int k = 0; k < 100; ++k) {
        const Point centre{number(), number(), 0.25 + 0.5 * number()};
        const auto corner = [&] { return centre + 0.1 * Point{number(), number(), number()}; };
        const Point a = corner(), b = corner(), c = corner();
        builder.polygon({a, b, c});
    }
    const Room room(builder);
    ASSERT_GT(room.shapes.side_count() * room.shapes.corner_count(), most_in_table);
    for (int k = 0; k < 10; ++k) {
        const Point2D point{number(), number()};
        CellView around(room.shapes, {point, mix(point, {0.5, 0.5}, 1e-3), mix(point, {1, 0}, 1e-3)});
        const auto occluders = around.between(room.lights, room.occluders);
        const Contour contour = CellView(around, point).visible_contour(room.lights, occluders);
        EXPECT_LT(occluders.size(), room.occluders.size());
        EXPECT_NEAR(form_factor_at(room.shapes, point, contour), room.visible_from(point), 1e-12);
    }
}

// Where only quadratic signs are doubtful, the contour is that of the centroid, and what it is off by elsewhere is no
// more than where a doubtful sign is wrong most, times what that is told to be beyond.
TEST_F(CellViews, DoubtfulContoursAreTheCentroids) {
    int doubtful = 0;
    for (int k = 0; k < 1500; ++k) {
        const Room room(this->room(0));
        const Triangle2D cell = this->cell();
        CellView view(room.shapes, cell);
        try {
            const Contour contour = view.visible_contour(room.lights, room.occluders, 0.25);
            if (contour.doubtful.empty()) continue;
            ++doubtful;
            const auto off = [&](const Point2D& point) {
                return std::abs(form_factor_at(room.shapes, point, contour) - room.visible_from(point));
            };
            ASSERT_LE(off(centroid(cell)), 1e-12) << k;
            double most = 1e-12;
            for (const DoubtfulSign& sign : contour.doubtful) most += off(sign.worst) * sign.beyond * sign.beyond;
            for (int i = 0; i < 8; ++i) ASSERT_LE(off(point_in(cell)), most) << k;
        } catch (const UndecidedSign&) {
        }
    }
    EXPECT_GT(doubtful, 20);
}

// Parts of a cut cover the triangle once; a line or a chord has what is on either side of it in parts of its own.
TEST(Cells, CutsCoverTheTriangle) {
    const Triangle2D t{{{0, 0}, {1, 0.25}, {0.25, 1}}};
    const std::vector<UndecidedSign> events = {
        {true, {1, -1, -2, 0, 0, 0}},    {true, {0, 1, -1, 0, 0, 0}},      {false, {1, -1, -2, 0.25, -1, -0.5}},
        {false, {0, 1, -1, 0.5, 0, -1}}, {false, {0, 0, 0, 1, -1, 0.5}},   {false, {1, 1, 1, -2, 1, 1}},
        {false, {1, -1, 1, 0, 0, 1}},    {false, {1e-20, 0, 0, 1, -1, 0}}, {false, {1, -1e-15, -1, 0.5, 0, 0}}};
    for (const UndecidedSign& event : events) {
        const std::vector<Triangle2D> parts = cut(t, event);
        double sum = 0;
        for (const Triangle2D& part : parts) {
            EXPECT_GT(turn(part), 0);
            EXPECT_LT(area(part), 0.999 * area(t));
            sum += area(part);
        }
        EXPECT_NEAR(sum, area(t), 1e-14);
    }
    EXPECT_EQ(cut(t, events[0]).size(), 3u);
    EXPECT_EQ(cut(t, events[1]).size(), 2u);
    EXPECT_EQ(cut(t, events[2]).size(), 3u);
    EXPECT_EQ(cut(t, events[3]).size(), 2u);
    EXPECT_EQ(cut(t, events[4]).size(), 4u);
    EXPECT_EQ(cut(t, events[5]).size(), 4u);
}

}  // namespace
}  // namespace cob::radiosity
