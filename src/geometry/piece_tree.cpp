#include "geometry/piece_tree.hpp"

#include <limits>

namespace cob {
namespace {

/// A segment, prepared for the bounds of nodes.
///
/// With e the ends' error, the segment from o in direction d, both in binary32 or d in binary64, is nowhere farther
/// from the exact one than 2^-23 + 3 e in any coordinate, which the bounds have been widened by. Parameters at which
/// it enters and leaves bounds are then wrong by 4 roundings of themselves, 8 2^-24 between the two.
struct NodeSegment {
    std::array<std::size_t, 3> enter, leave;  ///< Which bounds are met first and last, by axis.
    std::array<float, 3> origin, inverse;

    explicit NodeSegment(const NormalSegment& segment) {
        // Along an axis on which the segment runs this little, it does not: the bounds are widened by far more.
        constexpr double still = 0x1p-40, inverse_of_still = 0x1p100;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double x = segment.from[static_cast<int>(axis)], d = segment.to[static_cast<int>(axis)] - x;
            origin[axis] = static_cast<float>(x);
            inverse[axis] = static_cast<float>(std::abs(d) > still ? 1 / d : inverse_of_still);
            enter[axis] = inverse[axis] < 0 ? axis + 3 : axis;
            leave[axis] = inverse[axis] < 0 ? axis : axis + 3;
        }
    }
};

/// Bit k: the segment may meet child k.
unsigned may_meet(const PieceTreeNode& node, const NodeSegment& segment) {
    Lanes first = all_lanes(0), last = all_lanes(1);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        // Where zero is multiplied by infinity there is NaN, and greater() and lesser() leave what was.
        first = greater((node.bounds[segment.enter[axis]] - segment.origin[axis]) * segment.inverse[axis], first);
        last = lesser((node.bounds[segment.leave[axis]] - segment.origin[axis]) * segment.inverse[axis], last);
    }
    return bits_of(first <= last * (1 + 0x1p-20f));
}

/// The lines of a node, or the first of a packet, which will be wanted soon.
void prefetch(const void* memory) {
    __builtin_prefetch(memory);
    __builtin_prefetch(static_cast<const char*>(memory) + 64);
}

float rounded_down(double value) {
    const float nearest = static_cast<float>(value);
    return static_cast<double>(nearest) <= value ? nearest
                                                 : std::nextafter(nearest, -std::numeric_limits<float>::infinity());
}

}  // namespace

PiecePacket::PiecePacket(const Scene& scene, const std::vector<PieceId>& ids, const Normalisation& normalise) {
    std::size_t lane = 0;
    const auto put = [&](PieceId id, const std::array<Point, 3>& triangle) {
        pieces[lane] = id;
        for (std::size_t c = 0; c < 3; ++c)
            for (std::size_t axis = 0; axis < 3; ++axis)
                corners[c][axis][lane] = static_cast<float>(triangle[c][static_cast<int>(axis)]);
        ++lane;
    };
    for (const PieceId id : ids) {
        const View<VertexId> c = scene.corners(scene.piece(id));
        const auto at = [&](std::ptrdiff_t k) { return normalise(scene.position(c[k])); };
        constexpr double nan = std::numeric_limits<double>::quiet_NaN();
        constexpr Point nowhere{nan, nan, nan};
        if (lanes_of(scene.piece(id)) == 1 && c.size() > 3)
            put(id, {nowhere, nowhere, nowhere});
        else
            for (int k = 0; k < lanes_of(scene.piece(id)); ++k) put(id, {at(0), at(k + 1), at(k + 2)});
    }
    for (; lane < 4; ++lane) {
        pieces[lane] = pieces[lane - 1];
        for (auto& corner : corners)
            for (Lanes& coordinates : corner) coordinates[lane] = coordinates[lane - 1];
    }
}

PieceTreeNode::PieceTreeNode() {
    bounds.fill(all_lanes(std::numeric_limits<float>::infinity()));
    for (std::size_t axis = 3; axis < 6; ++axis) bounds[axis] = -bounds[axis];
    children.fill(nothing);
}

void PieceTreeNode::set(std::size_t lane, const Bounds& of, const Normalisation& normalise, std::int32_t child) {
    // What NodeSegment says, and the bounds' own error. Nothing is asked beyond reach, so infinity need not be kept.
    constexpr double beyond = 2 * Normalisation::reach;
    const double margin = std::min(0x1p-22 + 5 * normalise.greatest_error(), beyond);
    const Point low = normalise({of.low[0], of.low[1], of.low[2]});
    const Point high = normalise({of.high[0], of.high[1], of.high[2]});
    for (std::size_t axis = 0; axis < 3; ++axis) {
        bounds[axis][lane] = rounded_down(low[static_cast<int>(axis)] - margin);
        bounds[axis + 3][lane] = -rounded_down(-high[static_cast<int>(axis)] - margin);
    }
    children[lane] = child;
}

PieceTree::PieceTree(const Scene& scene) : scene_(&scene), normalisation_(bounds_of(scene)) {}

std::size_t PieceTree::memory() const {
    return sizeof *this + nodes_.capacity() * sizeof(PieceTreeNode) + packets_.capacity() * sizeof(PiecePacket);
}

void PieceTree::walk(const Point& from, const Point& to, CandidateSource::PieceCallback callback) const {
    if (nodes_.empty()) return;
    // 1. Into the coordinates of the tree.
    const NormalSegment segment = normalised(normalisation_, from, to);
    if (segment.kind == NormalSegment::Kind::outside) return;
    if (segment.kind == NormalSegment::Kind::far_off) return walk_all_pieces(*scene_, from, to, callback);
    const NodeSegment for_nodes(segment);
    const PacketSegment for_packets(segment);
    // 2. Down, the first child first. Every level leaves up to three behind, and there are at most 16 levels.
    std::array<std::int32_t, 64> waiting;
    std::size_t count = 1;
    waiting[0] = 0;
    while (count > 0) {
        const std::int32_t next = waiting[--count];
        if (next < 0) {
            if (!hand_over(packets_[static_cast<std::size_t>(~next)], for_packets, callback)) return;
            continue;
        }
        const PieceTreeNode& node = nodes_[static_cast<std::size_t>(next)];
        for (unsigned met = may_meet(node, for_nodes); met != 0; met &= met - 1) {
            const std::int32_t child = node.children[static_cast<std::size_t>(__builtin_ctz(met))];
            waiting[count++] = child;
            prefetch(child < 0 ? static_cast<const void*>(&packets_[static_cast<std::size_t>(~child)])
                               : static_cast<const void*>(&nodes_[static_cast<std::size_t>(child)]));
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
