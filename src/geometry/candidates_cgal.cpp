// CGAL's AABB tree, with bounds and traversal of our own: CGAL's would construct primitives and intersect them, where
// only names are wanted. For segments it is copied into a flat tree.
#include <CGAL/AABB_tree.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Simple_cartesian.h>

#include "geometry/bounds.hpp"
#include "geometry/candidates_trees.hpp"
#include "geometry/piece_tree.hpp"

#include <array>
#include <mutex>
#include <optional>
#include <vector>

namespace cob {
namespace {

using Kernel = CGAL::Simple_cartesian<double>;

/// A polygon or a piece, by its number.
struct NumberedPrimitive {
    using Id = std::int32_t;
    using Point = Kernel::Point_3;
    using Datum = std::int32_t;
    using Datum_reference = std::int32_t;
    using Point_reference = Kernel::Point_3;

    explicit NumberedPrimitive(const std::int32_t* number) : number_(*number) {}
    Id id() const { return number_; }
    Datum_reference datum() const { return number_; }
    Point_reference reference_point() const { return Point(0, 0, 0); }  // of distance queries, which are not made

private:
    std::int32_t number_;
};

/// Model of AABBTraits as far as building and walking a tree go. The bounds of the primitives are needed only while
/// it is built. A kernel, too, and traits of a search, because the tree's (unused) search for nearest points wants one
/// or the other (before and since CGAL 6).
class TreeTraits : public Kernel, public CGAL::Search_traits_3<Kernel> {
public:
    using FT = Kernel::FT;
    using Point = Kernel::Point_3;
    using Geom_traits = Kernel;
    using Primitive = NumberedPrimitive;
    using Bounding_box = Bounds;
    using Point_and_primitive_id = std::pair<Point_3, Primitive::Id>;
    using Object_and_primitive_id = std::pair<CGAL::Object, Primitive::Id>;
    template <class Query>
    struct Intersection_and_primitive_id {
        using Type = Object_and_primitive_id;
    };

    TreeTraits() = default;
    explicit TreeTraits(const std::vector<Bounds>* bounds) : bounds_(bounds) {}

    struct Compute_bbox {
        const std::vector<Bounds>* bounds;
        template <class Iterator>
        Bounds operator()(Iterator first, Iterator beyond) const {
            Bounds all;
            for (; first != beyond; ++first) all.add((*bounds)[static_cast<std::size_t>(first->id())]);
            return all;
        }
    };
    struct Split_primitives {
        const std::vector<Bounds>* bounds;
        template <class Iterator>
        void operator()(Iterator first, Iterator beyond, const Bounds& all) const {
            // Walls among details stay together, else every one of them would widen the nodes above some details.
            const std::size_t axis = all.longest_axis();
            const double large = all.half_extent(axis) / 2;
            const auto place = [&](const NumberedPrimitive& primitive) {
                const Bounds& b = (*bounds)[static_cast<std::size_t>(primitive.id())];
                return b.half_extent(axis) > large ? -Bounds::infinity : b.middle(axis);
            };
            std::nth_element(first, first + (beyond - first) / 2, beyond, [&](const auto& a, const auto& b) {
                const double place_a = place(a), place_b = place(b);
                return place_a != place_b ? place_a < place_b : a.id() < b.id();
            });
        }
    };
    Compute_bbox compute_bbox_object() const { return {bounds_}; }
    Split_primitives split_primitives_object() const { return {bounds_}; }

private:
    const std::vector<Bounds>* bounds_ = nullptr;
};

using Tree = CGAL::AABB_tree<TreeTraits>;

/// `bounds` by id; needed only while the tree is built.
Tree build(const std::vector<std::int32_t>& ids, const std::vector<Bounds>& bounds) {
    Tree tree{TreeTraits(&bounds)};
    tree.insert(ids.data(), ids.data() + ids.size());
    if (!tree.empty()) tree.build();
    return tree;
}

/// Walks a tree down wherever it may meet the bounds; hands every polygon reached to the callback.
class WalkInBounds {
public:
    WalkInBounds(const Scene& scene, CandidateSource::Callback callback) : scene_(scene), callback_(callback) {}
    bool go_further() const { return going_; }
    void intersection(const Bounds& wanted, const NumberedPrimitive& primitive) {
        // The tree tests its nodes; the primitives below the last ones are tested here.
        if (bounds_of(scene_, scene_.loop(primitive.id())).meets(wanted))
            going_ = callback_.call(callback_.context, primitive.id());
    }
    template <class Node>
    bool do_intersect(const Bounds& wanted, const Node& node) const {
        return wanted.meets(node.bbox());
    }

private:
    const Scene& scene_;
    CandidateSource::Callback callback_;
    bool going_ = true;
};

/// A part of a tree: a node with everything below it, or a primitive alone.
struct Subtree {
    const CGAL::AABB_node<TreeTraits>* node = nullptr;
    std::int32_t id = -1;  ///< Of the primitive, where there is no node.
    std::size_t size = 1;  ///< Primitives.
};

/// Takes the two halves of a node from a walk that goes no deeper.
class TakeHalves {
public:
    explicit TakeHalves(std::size_t size) : sizes_{size / 2, size - size / 2} {}
    bool go_further() const { return true; }
    void intersection(int, const NumberedPrimitive& primitive) { halves_[count_++] = {nullptr, primitive.id(), 1}; }
    bool do_intersect(int, const CGAL::AABB_node<TreeTraits>& node) {
        halves_[count_] = {&node, -1, sizes_[count_]};
        ++count_;
        return false;
    }
    const std::array<Subtree, 2>& halves() const { return halves_; }

private:
    std::array<std::size_t, 2> sizes_;
    std::array<Subtree, 2> halves_;
    std::size_t count_ = 0;
};

/// One tree of polygons for boxes, one of pieces for segments, each built when it is first asked.
class CgalCandidates final : public CandidateSource {
public:
    explicit CgalCandidates(const Scene& scene) : scene_(scene) {}

    void polygons_in(const std::array<double, 6>& bounds, Callback callback) const override {
        std::call_once(polygons_built_, [this] { build_polygons(); });
        if (polygons_.empty()) return;
        const Bounds wanted{{bounds[0], bounds[1], bounds[2]}, {bounds[3], bounds[4], bounds[5]}};
        WalkInBounds walk(scene_, callback);
        polygons_.traversal(wanted, walk);
    }

    void pieces_along(const Point& from, const Point& to, PieceCallback callback) const override {
        std::call_once(pieces_built_, [this] { pieces_.emplace(build_piece_tree(scene_)); });
        pieces_->walk(from, to, callback);
    }

    std::size_t memory() const override {
        const std::size_t polygons = polygons_.empty()
                                         ? 0
                                         : polygons_.size() * sizeof(NumberedPrimitive) +
                                               (polygons_.size() - 1) * sizeof(CGAL::AABB_node<TreeTraits>);
        return sizeof *this + polygons + (pieces_ ? pieces_->memory() : 0);
    }

private:
    void build_polygons() const {
        std::vector<std::int32_t> ids;
        std::vector<Bounds> bounds(static_cast<std::size_t>(scene_.polygon_count()));
        for (PolygonId id = 0; id < scene_.polygon_count(); ++id) {
            if (!scene_.polygon(id).valid) continue;
            ids.push_back(id);
            bounds[static_cast<std::size_t>(id)] = bounds_of(scene_, scene_.loop(id));
        }
        polygons_ = build(ids, bounds);
    }

    const Scene& scene_;
    mutable std::once_flag polygons_built_, pieces_built_;
    mutable Tree polygons_;
    mutable std::optional<PieceTree> pieces_;
};

/// Copies CGAL's binary tree of pieces into a flat one: every other level goes, and what fits a packet becomes one.
class Flattening {
public:
    Flattening(const Scene& scene, const std::vector<Bounds>& bounds, const Normalisation& normalise,
               LargeVector<PieceTreeNode>& nodes, LargeVector<PiecePacket>& packets)
        : scene_(scene), bounds_(bounds), normalise_(normalise), nodes_(nodes), packets_(packets) {}

    void run(const Tree& tree) {
        nodes_.emplace_back();
        if (tree.size() == 1) {
            fill(0, {{nullptr, 0, 1}});
            return;
        }
        TakeHalves take(tree.size());
        tree.traversal(0, take);
        fill(0, {take.halves()[0], take.halves()[1]});
    }

private:
    static std::array<Subtree, 2> halves(const Subtree& subtree) {
        TakeHalves take(subtree.size);
        subtree.node->traversal(0, take, subtree.size);
        return take.halves();
    }
    void collect(const Subtree& subtree, std::vector<PieceId>& ids) const {
        if (!subtree.node) return ids.push_back(subtree.id);
        for (const Subtree& half : halves(subtree)) collect(half, ids);
    }
    /// The pieces of a subtree where they fit one packet; else nothing.
    std::vector<PieceId> fitting(const Subtree& subtree) const {
        std::vector<PieceId> ids;
        if (subtree.size > 4) return ids;
        collect(subtree, ids);
        int lanes = 0;
        for (const PieceId id : ids) lanes += PiecePacket::lanes_of(scene_.piece(id));
        if (lanes > 4) ids.clear();
        return ids;
    }
    /// Makes the node of these subtrees, with two levels in one; returns its bounds.
    Bounds fill(std::size_t node, const std::vector<Subtree>& parts) {
        std::vector<Subtree> children;
        for (const Subtree& part : parts) {
            if (!fitting(part).empty())
                children.push_back(part);
            else
                for (const Subtree& half : halves(part)) children.push_back(half);
        }
        Bounds all;
        for (std::size_t lane = 0; lane < children.size(); ++lane) {
            Bounds bounds;
            std::int32_t child;
            const std::vector<PieceId> ids = fitting(children[lane]);
            if (ids.empty()) {
                child = static_cast<std::int32_t>(nodes_.size());
                nodes_.emplace_back();
                const std::array<Subtree, 2> two = halves(children[lane]);
                bounds = fill(static_cast<std::size_t>(child), {two[0], two[1]});
            } else {
                child = ~static_cast<std::int32_t>(packets_.size());
                packets_.emplace_back(scene_, ids, normalise_);
                for (const PieceId id : ids) bounds.add(bounds_[static_cast<std::size_t>(id)]);
            }
            nodes_[node].set(lane, bounds, normalise_, child);
            all.add(bounds);
        }
        return all;
    }

    const Scene& scene_;
    const std::vector<Bounds>& bounds_;
    const Normalisation& normalise_;
    LargeVector<PieceTreeNode>& nodes_;
    LargeVector<PiecePacket>& packets_;
};

}  // namespace

PieceTree build_piece_tree(const Scene& scene) {
    PieceTree result(scene);
    std::vector<std::int32_t> ids(scene.pieces().size());
    std::vector<Bounds> bounds(ids.size());
    for (std::size_t k = 0; k < ids.size(); ++k) {
        ids[k] = static_cast<std::int32_t>(k);
        bounds[k] = bounds_of(scene, scene.corners(scene.pieces()[k]));
    }
    if (ids.empty()) return result;
    Flattening(scene, bounds, result.normalisation_, result.nodes_, result.packets_).run(build(ids, bounds));
    result.nodes_.shrink_to_fit();
    result.packets_.shrink_to_fit();
    return result;
}

std::unique_ptr<CandidateSource> make_cgal_candidates(const Scene& scene) {
    return std::make_unique<CgalCandidates>(scene);
}

}  // namespace cob
