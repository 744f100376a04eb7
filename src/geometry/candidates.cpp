#include "cob/candidates.hpp"

#include "cob/error.hpp"
#include "geometry/bounds.hpp"
#include "geometry/candidates_trees.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace cob {
namespace {

/// Everything, without a tree: for scenes of few polygons, and as a witness for the trees.
class AllCandidates final : public CandidateSource {
public:
    explicit AllCandidates(const Scene& scene) {
        for (PolygonId id = 0; id < scene.polygon_count(); ++id)
            polygons_.push_back(scene.polygon(id).valid ? bounds_of(scene, scene.loop(id)) : Bounds{});
        for (const Piece& piece : scene.pieces()) pieces_.push_back(bounds_of(scene, scene.corners(piece)));
    }

    void polygons_in(const std::array<double, 6>& bounds, Callback callback) const override {
        const Bounds wanted{{bounds[0], bounds[1], bounds[2]}, {bounds[3], bounds[4], bounds[5]}};
        for (std::size_t id = 0; id < polygons_.size(); ++id)
            if (polygons_[id].meets(wanted) && !callback.call(callback.context, static_cast<PolygonId>(id))) return;
    }
    void pieces_along(const Point& from, const Point& to, PieceCallback callback) const override {
        // Each end is off the exact one by half an ulp at most.
        Bounds along;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double x = from[static_cast<int>(axis)], y = to[static_cast<int>(axis)];
            const double ulp = std::max(std::abs(x), std::abs(y)) * 0x1p-52 + std::numeric_limits<double>::denorm_min();
            along.low[axis] = std::min(x, y) - ulp;
            along.high[axis] = std::max(x, y) + ulp;
        }
        for (std::size_t id = 0; id < pieces_.size(); ++id)
            if (pieces_[id].meets(along) && !callback.call(callback.context, static_cast<PieceId>(id), false)) return;
    }
    std::size_t memory() const override {
        return sizeof *this + (polygons_.capacity() + pieces_.capacity()) * sizeof(Bounds);
    }

private:
    std::vector<Bounds> polygons_, pieces_;  ///< By number; empty of polygons that are not valid, and so never met.
};

}  // namespace

const char* to_text(Source source) {
    switch (source) {
        case Source::all:
            return "all";
        case Source::tree:
            return "tree";
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
        case Source::tree:
            return make_tree_candidates(scene);
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
