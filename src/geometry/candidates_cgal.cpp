// CGAL's AABB tree, with bounds and traversal of our own: CGAL's would construct primitives and intersect them, where
// only names are wanted.
#include <CGAL/AABB_tree.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Simple_cartesian.h>

#include "geometry/bounds.hpp"
#include "geometry/candidates_trees.hpp"

#include <mutex>
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
            const std::size_t axis = all.longest_axis();
            std::nth_element(first, first + (beyond - first) / 2, beyond, [&](const auto& a, const auto& b) {
                const double middle_a = (*bounds)[static_cast<std::size_t>(a.id())].middle(axis);
                const double middle_b = (*bounds)[static_cast<std::size_t>(b.id())].middle(axis);
                return middle_a != middle_b ? middle_a < middle_b : a.id() < b.id();
            });
        }
    };
    Compute_bbox compute_bbox_object() const { return {bounds_}; }
    Split_primitives split_primitives_object() const { return {bounds_}; }

private:
    const std::vector<Bounds>* bounds_ = nullptr;
};

using Tree = CGAL::AABB_tree<TreeTraits>;

/// Walks a tree down wherever the query may meet the bounds; hands every primitive reached to the callback.
template <class Query, class MayMeet>
class Walk {
public:
    Walk(CandidateSource::Callback callback, MayMeet may_meet) : callback_(callback), may_meet_(may_meet) {}
    bool go_further() const { return going_; }
    void intersection(const Query&, const NumberedPrimitive& primitive) {
        going_ = callback_.call(callback_.context, primitive.id());
    }
    template <class Node>
    bool do_intersect(const Query& query, const Node& node) const {
        return may_meet_(query, node.bbox());
    }

private:
    CandidateSource::Callback callback_;
    MayMeet may_meet_;
    bool going_ = true;
};

template <class Query, class MayMeet>
void walk(const Tree& tree, const Query& query, CandidateSource::Callback callback, MayMeet may_meet) {
    if (tree.empty()) return;
    Walk<Query, MayMeet> traits(callback, may_meet);
    tree.traversal(query, traits);
}

/// One tree of polygons for boxes, one of pieces for segments, each built when it is first asked.
class CgalCandidates final : public CandidateSource {
public:
    explicit CgalCandidates(const Scene& scene) : scene_(scene) {}

    void polygons_in(const std::array<double, 6>& bounds, Callback callback) const override {
        std::call_once(polygons_built_, [this] { build_polygons(); });
        const Bounds wanted{{bounds[0], bounds[1], bounds[2]}, {bounds[3], bounds[4], bounds[5]}};
        // The tree tests its nodes; the primitives below the last ones are tested here.
        struct Filter {
            const Scene& scene;
            const Bounds& wanted;
            Callback callback;
        } filter{scene_, wanted, callback};
        const Callback filtered{&filter, [](void* context, std::int32_t id) {
                                    const Filter& f = *static_cast<const Filter*>(context);
                                    return !bounds_of(f.scene, f.scene.loop(id)).meets(f.wanted) ||
                                           f.callback.call(f.callback.context, id);
                                }};
        walk(polygons_, wanted, filtered, [](const Bounds& query, const Bounds& node) { return query.meets(node); });
    }

    void pieces_along(const Point& from, const Point& to, Callback callback) const override {
        std::call_once(pieces_built_, [this] { build_pieces(); });
        walk(pieces_, SlabSegment(from, to), callback,
             [](const SlabSegment& query, const Bounds& node) { return query.may_meet(node); });
    }

    std::size_t memory() const override {
        const auto bytes = [](const Tree& tree) {
            return tree.empty() ? std::size_t{0}
                                : tree.size() * sizeof(NumberedPrimitive) +
                                      (tree.size() - 1) * sizeof(CGAL::AABB_node<TreeTraits>);
        };
        return sizeof *this + bytes(polygons_) + bytes(pieces_);
    }

private:
    static Tree build(const std::vector<std::int32_t>& ids, const std::vector<Bounds>& bounds) {
        Tree tree{TreeTraits(&bounds)};
        tree.insert(ids.data(), ids.data() + ids.size());
        if (!tree.empty()) tree.build();
        return tree;
    }
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
    void build_pieces() const {
        std::vector<std::int32_t> ids(scene_.pieces().size());
        std::vector<Bounds> bounds(ids.size());
        for (std::size_t k = 0; k < ids.size(); ++k) {
            ids[k] = static_cast<std::int32_t>(k);
            bounds[k] = bounds_of(scene_, scene_.corners(scene_.pieces()[k]));
        }
        pieces_ = build(ids, bounds);
    }

    const Scene& scene_;
    mutable std::once_flag polygons_built_, pieces_built_;
    mutable Tree polygons_, pieces_;
};

}  // namespace

std::unique_ptr<CandidateSource> make_cgal_candidates(const Scene& scene) {
    return std::make_unique<CgalCandidates>(scene);
}

}  // namespace cob
