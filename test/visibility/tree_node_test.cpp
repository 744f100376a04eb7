// The bounds of a node's children, eight bits a number, never lose a segment that meets them, and say the same on
// every processor ("a source names pieces that may matter; it may name too many, never too few").
#include "geometry/piece_tree_node.hpp"

#include "visibility/random.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace cob::test {
namespace {

constexpr int node_count = 2000;

double small_number(Random& random) {
    return std::ldexp(random.integer(-64, 64), -6 - 6 * random.integer(0, 4));
}

/// Bounds of up to eight children in [-1, 1], some of them flat or a point, widened as the tree widens them.
std::vector<Bounds> random_children(Random& random) {
    std::vector<Bounds> children(static_cast<std::size_t>(random.integer(1, 8)));
    for (Bounds& child : children) {
        for (int corner = 0; corner < 2; ++corner)
            child.add(Point{small_number(random), small_number(random), small_number(random)});
        for (std::size_t axis = 0; axis < 3; ++axis) {
            child.low[axis] -= PieceTreeNode::margin;
            child.high[axis] += PieceTreeNode::margin;
        }
    }
    return children;
}

/// Some point of the bounds as they were before they were widened: a corner, or between.
Point random_point(Random& random, const Bounds& bounds) {
    Point p;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double low = bounds.low[axis] + PieceTreeNode::margin, high = bounds.high[axis] - PieceTreeNode::margin;
        p[static_cast<int>(axis)] = low + random.integer(0, 4) / 4.0 * (high - low);
    }
    return p;
}

TEST(TreeNode, NoSegmentThroughAChildIsLost) {
    Random random(1);
    int met = 0, missed = 0;
    for (int k = 0; k < node_count; ++k) {
        const std::vector<Bounds> children = random_children(random);
        PieceTreeNode node;
        node.set_bounds(children);
        for (std::size_t child = 0; child < children.size(); ++child) {
            const Point at = random_point(random, children[child]);
            const Point d{small_number(random), small_number(random), small_number(random)};
            if (d == Point{0, 0, 0}) continue;
            // Ends before and behind; one of them may be the point itself.
            const double before = random.integer(0, 3) / 2.0, behind = random.integer(1, 3) / 2.0;
            const NodeSegment segment({NormalSegment::Kind::within, at - before * d, at + behind * d, 0});
            const unsigned bits = children_met(node, segment);
            ASSERT_NE(bits >> child & 1, 0u) << "node " << k << ", child " << child;
            ASSERT_EQ(bits >> children.size(), 0u);
            for (std::size_t other = 0; other < children.size(); ++other) ++(bits >> other & 1 ? met : missed);
        }
    }
    EXPECT_GT(missed, met / 4);
}

TEST(TreeNode, EveryProcessorSaysTheSame) {
    const ChildrenMet special = children_met_of_processor();
    if (special == nullptr) GTEST_SKIP() << "this processor has nothing special";
    Random random(2);
    for (int k = 0; k < node_count; ++k) {
        PieceTreeNode node;
        node.set_bounds(random_children(random));
        for (int s = 0; s < 10; ++s) {
            const auto end = [&] {
                return Point{4 * small_number(random), 4 * small_number(random), 4 * small_number(random)};
            };
            const NodeSegment segment({NormalSegment::Kind::within, end(), end(), 0});
            ASSERT_EQ(special(node, segment), children_met(node, segment)) << "node " << k;
        }
    }
}

}  // namespace
}  // namespace cob::test
