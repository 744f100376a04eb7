// A loose octree, the baseline that trees of bounds are measured against: space is halved along every axis, whatever
// lies in it. An item stands in the smallest cell of its size around its middle, so that it is named once.
#include "geometry/bounds.hpp"
#include "geometry/candidates_trees.hpp"

#include <mutex>
#include <numeric>
#include <vector>

namespace cob {
namespace {

/// Items that are smaller than half a cell go on into its eighths; what is left stays. Decisions are made by the exact
/// bounds of all that lies below a cell: where an item stands is a matter of speed only.
class LooseOctree {
public:
    explicit LooseOctree(std::vector<Bounds> bounds) : bounds_(std::move(bounds)), items_(bounds_.size()) {
        std::iota(items_.begin(), items_.end(), 0);
        if (items_.empty()) return;
        Bounds all;
        for (const Bounds& b : bounds_) all.add(b);
        Cell root;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            root.centre[axis] = all.middle(axis);
            root.half = std::max(root.half, all.high[axis] / 2 - all.low[axis] / 2);
        }
        build(root, 0, items_.size(), 0);
    }

    /// Names every item whose bounds may_meet, until name(item) is false.
    template <class MayMeet, class Name>
    void walk(const MayMeet& may_meet, const Name& name) const {
        for (std::size_t node = 0; node < nodes_.size();) {
            const Node& n = nodes_[node];
            if (!may_meet(n.bounds)) {
                node = n.next;
                continue;
            }
            for (std::size_t k = n.first; k < n.last; ++k) {
                const std::int32_t item = items_[k];
                if (may_meet(bounds_[static_cast<std::size_t>(item)]) && !name(item)) return;
            }
            ++node;
        }
    }
    std::size_t memory() const {
        return nodes_.size() * sizeof(Node) + items_.size() * (sizeof(std::int32_t) + sizeof(Bounds));
    }

private:
    static constexpr int most_levels = 24;
    static constexpr std::size_t few_items = 8;

    struct Cell {
        std::array<double, 3> centre{};
        double half = 0;
    };
    struct Node {
        Bounds bounds;                    ///< Of all items in it and below.
        std::size_t first = 0, last = 0;  ///< Its own items, [first, last) of items_.
        std::size_t next = 0;             ///< The node after all that lie below it, which follow it.
    };

    /// The eighth that the item goes into; 8 where it is too large for any.
    int eighth_of(std::int32_t item, const Cell& cell) const {
        const Bounds& b = bounds_[static_cast<std::size_t>(item)];
        const std::size_t longest = b.longest_axis();
        if (b.high[longest] / 2 - b.low[longest] / 2 > cell.half / 2) return 8;
        int eighth = 0;
        for (std::size_t axis = 0; axis < 3; ++axis) eighth |= (b.middle(axis) > cell.centre[axis] ? 1 : 0) << axis;
        return eighth;
    }

    void build(const Cell& cell, std::size_t first, std::size_t last, int level) {
        const std::size_t number = nodes_.size();
        nodes_.emplace_back();
        for (std::size_t k = first; k < last; ++k)
            nodes_[number].bounds.add(bounds_[static_cast<std::size_t>(items_[k])]);
        nodes_[number].first = first;
        nodes_[number].last = last;
        if (last - first > few_items && level < most_levels) {
            // What is too large for an eighth stays; the rest goes on.
            std::array<std::vector<std::int32_t>, 9> parts;
            for (std::size_t k = first; k < last; ++k)
                parts[static_cast<std::size_t>(eighth_of(items_[k], cell))].push_back(items_[k]);
            std::size_t begin = first;
            const auto put_back = [&](const std::vector<std::int32_t>& part) {
                std::copy(part.begin(), part.end(), items_.begin() + static_cast<std::ptrdiff_t>(begin));
                begin += part.size();
            };
            put_back(parts[8]);
            nodes_[number].last = begin;
            for (std::size_t eighth = 0; eighth < 8; ++eighth) {
                if (parts[eighth].empty()) continue;
                Cell part{cell.centre, cell.half / 2};
                for (std::size_t axis = 0; axis < 3; ++axis)
                    part.centre[axis] += (eighth >> axis & 1) != 0 ? part.half : -part.half;
                const std::size_t part_first = begin;
                put_back(parts[eighth]);
                build(part, part_first, begin, level + 1);
            }
        }
        nodes_[number].next = nodes_.size();
    }

    std::vector<Bounds> bounds_;       ///< By item.
    std::vector<std::int32_t> items_;  ///< Node by node.
    std::vector<Node> nodes_;          ///< Depth first.
};

/// One octree of polygons for boxes, one of pieces for segments, each built when it is first asked.
class OctreeCandidates final : public CandidateSource {
public:
    explicit OctreeCandidates(const Scene& scene) : scene_(scene) {}

    void polygons_in(const std::array<double, 6>& bounds, Callback callback) const override {
        std::call_once(polygons_built_, [this] {
            std::vector<Bounds> all;
            for (PolygonId id = 0; id < scene_.polygon_count(); ++id)
                if (scene_.polygon(id).valid) {
                    valid_.push_back(id);
                    all.push_back(bounds_of(scene_, scene_.loop(id)));
                }
            polygons_ = LooseOctree(std::move(all));
        });
        const Bounds wanted{{bounds[0], bounds[1], bounds[2]}, {bounds[3], bounds[4], bounds[5]}};
        polygons_.walk(
            [&](const Bounds& b) { return b.meets(wanted); },
            [&](std::int32_t item) { return callback.call(callback.context, valid_[static_cast<std::size_t>(item)]); });
    }

    void pieces_along(const Point& from, const Point& to, PieceCallback callback) const override {
        std::call_once(pieces_built_, [this] {
            std::vector<Bounds> all;
            for (const Piece& piece : scene_.pieces()) all.push_back(bounds_of(scene_, scene_.corners(piece)));
            pieces_ = LooseOctree(std::move(all));
        });
        const SlabSegment segment(from, to);
        pieces_.walk([&](const Bounds& b) { return segment.may_meet(b); },
                     [&](std::int32_t item) { return callback.call(callback.context, item, false); });
    }

    std::size_t memory() const override {
        return sizeof *this + valid_.size() * sizeof(PolygonId) + polygons_.memory() + pieces_.memory();
    }

private:
    const Scene& scene_;
    mutable std::once_flag polygons_built_, pieces_built_;
    mutable std::vector<PolygonId> valid_;
    mutable LooseOctree polygons_{{}}, pieces_{{}};
};

}  // namespace

std::unique_ptr<CandidateSource> make_octree_candidates(const Scene& scene) {
    return std::make_unique<OctreeCandidates>(scene);
}

}  // namespace cob
