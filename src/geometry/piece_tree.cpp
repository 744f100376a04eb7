#include "geometry/piece_tree.hpp"

#include "geometry/piece_tree_builder.hpp"

#include <array>
#include <limits>

namespace cob {
namespace {

/// The line of an outline, or both of a node, which will be wanted soon.
void prefetch(const PieceOutline& outline) {
    __builtin_prefetch(&outline);
}
void prefetch(const PieceTreeNode& node) {
    __builtin_prefetch(&node);
    __builtin_prefetch(&node.children);
}

}  // namespace

PieceOutline::PieceOutline(const Scene& scene, PieceId id, const Normalisation& normalise) : piece(id) {
    const View<VertexId> loop = scene.corners(scene.piece(id));
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    std::array<Point, 4> outline;
    outline.fill({nan, nan, nan});
    if (loop.size() <= 4)
        for (std::size_t k = 0; k < loop.size(); ++k) outline[k] = normalise(scene.position(loop[k]));
    if (loop.size() == 3) outline[3] = 0.5 * (outline[2] + outline[0]);
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (std::size_t k = 0; k < 4; ++k) corners[axis][k] = static_cast<float>(outline[k][static_cast<int>(axis)]);
}

PieceTree::PieceTree(const Scene& scene)
    : scene_(&scene), normalisation_(bounds_of(scene)), children_met_(children_met_of_processor()) {
    if (children_met_ == nullptr) children_met_ = children_met;
    PieceTreeBuilder(scene, normalisation_, nodes_, outlines_).build();
}

std::size_t PieceTree::memory() const {
    return sizeof *this + nodes_.capacity() * sizeof(PieceTreeNode) + outlines_.capacity() * sizeof(PieceOutline);
}

void PieceTree::walk(const Point& from, const Point& to, CandidateSource::PieceCallback callback) const {
    if (nodes_.empty()) return;
    // 1. Into the coordinates of the tree.
    const NormalSegment segment = normalised(normalisation_, from, to);
    if (segment.kind == NormalSegment::Kind::outside) return;
    if (segment.kind == NormalSegment::Kind::far_off) return walk_all_pieces(*scene_, from, to, callback);
    const NodeSegment for_nodes(segment);
    const OutlineSegment for_outlines(segment);
    // 2. Down, the last child first. Every level leaves up to seven behind.
    std::array<PieceTreeNode::Child, 7 * PieceTreeBuilder::most_levels + 1> waiting;
    std::size_t count = 1;
    waiting[0] = 0;
    while (count > 0) {
        const PieceTreeNode::Child next = waiting[--count];
        if (next < 0) {
            if (!hand_over(outlines_[static_cast<std::size_t>(~next)], for_outlines, callback)) return;
            continue;
        }
        const PieceTreeNode& node = nodes_[static_cast<std::size_t>(next)];
        for (unsigned met = children_met_(node, for_nodes); met != 0; met &= met - 1) {
            const PieceTreeNode::Child child = node.children[static_cast<std::size_t>(__builtin_ctz(met))];
            waiting[count++] = child;
            if (child < 0)
                prefetch(outlines_[static_cast<std::size_t>(~child)]);
            else
                prefetch(nodes_[static_cast<std::size_t>(child)]);
        }
    }
}

void walk_all_pieces(const Scene& scene, const Point& from, const Point& to, CandidateSource::PieceCallback callback) {
    const SlabSegment segment(from, to);
    for (PieceId id = 0; id < static_cast<PieceId>(scene.pieces().size()); ++id)
        if (segment.may_meet(bounds_of(scene, scene.corners(scene.piece(id)))) &&
            !callback.call(callback.context, id, false))
            return;
}

}  // namespace cob
