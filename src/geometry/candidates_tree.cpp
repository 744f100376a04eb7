// CGAL's AABB tree of polygons for boxes, with bounds and traversal of our own: CGAL's would construct primitives and
// intersect them, where only names are wanted. For segments, a flat tree of pieces.
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

/// A polygon, by its number.
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

/// One tree of polygons for boxes, one of pieces for segments, each built when it is first asked.
class TreeCandidates final : public CandidateSource {
public:
    explicit TreeCandidates(const Scene& scene) : scene_(scene) {}

    void polygons_in(const std::array<double, 6>& bounds, Callback callback) const override {
        std::call_once(polygons_built_, [this] { build_polygons(); });
        if (polygons_.empty()) return;
        const Bounds wanted{{bounds[0], bounds[1], bounds[2]}, {bounds[3], bounds[4], bounds[5]}};
        WalkInBounds walk(scene_, callback);
        polygons_.traversal(wanted, walk);
    }

    void pieces_along(const Point& from, const Point& to, PieceCallback callback) const override {
        std::call_once(pieces_built_, [this] { pieces_.emplace(scene_); });
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
        if (ids.empty()) return;
        polygons_ = Tree{TreeTraits(&bounds)};  // needs the bounds only while it is built
        polygons_.insert(ids.data(), ids.data() + ids.size());
        polygons_.build();
    }

    const Scene& scene_;
    mutable std::once_flag polygons_built_, pieces_built_;
    mutable Tree polygons_;
    mutable std::optional<PieceTree> pieces_;
};

}  // namespace

std::unique_ptr<CandidateSource> make_tree_candidates(const Scene& scene) {
    return std::make_unique<TreeCandidates>(scene);
}

}  // namespace cob
