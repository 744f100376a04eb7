#include "cob/candidates.hpp"

#include "cob/error.hpp"
#include "geometry/bounds.hpp"
#include "geometry/candidates_trees.hpp"

namespace cob {
namespace {

/// Everything, without a tree: for scenes of few polygons, and as a witness for the trees.
class AllCandidates final : public CandidateSource {
public:
    explicit AllCandidates(const Scene& scene) : scene_(scene) {}

    void polygons_in(const std::array<double, 6>& bounds, Callback callback) const override {
        const Bounds wanted{{bounds[0], bounds[1], bounds[2]}, {bounds[3], bounds[4], bounds[5]}};
        for (PolygonId id = 0; id < scene_.polygon_count(); ++id)
            if (scene_.polygon(id).valid && bounds_of(scene_, scene_.loop(id)).meets(wanted) &&
                !callback.call(callback.context, id))
                return;
    }
    void pieces_along(const Point&, const Point&, PieceCallback callback) const override {
        for (PieceId id = 0; id < static_cast<PieceId>(scene_.pieces().size()); ++id)
            if (!callback.call(callback.context, id, false)) return;
    }
    std::size_t memory() const override { return sizeof *this; }

private:
    const Scene& scene_;
};

}  // namespace

const char* to_text(Source source) {
    switch (source) {
        case Source::all:
            return "all";
        case Source::cgal:
            return "cgal";
        case Source::embree:
            return "embree";
        case Source::octree:
            return "octree";
    }
    return "";
}

bool is_available(Source source) {
#ifdef COB_HAS_EMBREE
    constexpr bool embree = true;
#else
    constexpr bool embree = false;
#endif
    return embree || source != Source::embree;
}

std::unique_ptr<CandidateSource> make_candidates(const Scene& scene, Source source) {
    switch (source) {
        case Source::all:
            return std::make_unique<AllCandidates>(scene);
        case Source::cgal:
            return make_cgal_candidates(scene);
        case Source::octree:
            return make_octree_candidates(scene);
        case Source::embree:
#ifdef COB_HAS_EMBREE
            return make_embree_candidates(scene);
#else
            break;
#endif
    }
    throw InputError("this program was built without Embree", {"", 0, "", "choose another source of candidates"});
}

}  // namespace cob
