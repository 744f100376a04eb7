// Embree as a tree only: every piece is a user geometry with widened bounds, and its occlusion callback asks the exact
// test of what binary32 does not exclude, so that a piece that blocks ends the walk.
#include "cob/error.hpp"
#include "geometry/candidates_trees.hpp"
#include "geometry/embree_handles.hpp"
#include "geometry/piece_tree.hpp"

#include <future>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace cob {
namespace {

/// What walking along a segment in binary32 costs, in the normalised scene. Ends in [-4, 4] are rounded by at most
/// 2^-23 and the direction in [-8, 8] by 2^-22, so every point of the segment is off by less than 2^-21; the bounds'
/// own rounding adds 2^-24, and Embree's robust walk takes care of its own. 2^-18 has room to spare.
constexpr double walking_margin = 0x1p-18;

class EmbreeCandidates final : public CandidateSource {
public:
    explicit EmbreeCandidates(const Scene& scene) : scene_(scene), boxes_(make_tree_candidates(scene)) {}

    void polygons_in(const std::array<double, 6>& bounds, Callback callback) const override {
        boxes_->polygons_in(bounds, callback);
    }

    void pieces_along(const Point& from, const Point& to, PieceCallback callback) const override {
        std::call_once(built_, [this] { build(); });
        if (!tree_) return;
        // 1. Into the coordinates of the tree; what comes from too far is not walked.
        const NormalSegment segment = normalised(*normalisation_, from, to);
        if (segment.kind == NormalSegment::Kind::outside) return;
        if (segment.kind == NormalSegment::Kind::far_off) return walk_all_pieces(scene_, from, to, callback);
        // 2. A ray from parameter 0 to 1.
        RTCRay ray = embree_ray(segment.from, segment.to);
        // 3. Down the tree.
        Context context{{}, callback, outlines_.data(), OutlineSegment(segment)};
        rtcInitIntersectContext(&context.embree);
        rtcOccluded1(tree_.get(), &context.embree, &ray);
    }

    std::size_t memory() const override {
        return sizeof *this + static_cast<std::size_t>(bytes_.load()) + outlines_.capacity() * sizeof(PieceOutline) +
               boxes_->memory();
    }

private:
    /// Embree hands its context to the callback; ours goes with it.
    struct Context {
        RTCIntersectContext embree;
        PieceCallback callback;
        const PieceOutline* outlines;
        OutlineSegment segment;
    };

    static void bound(const RTCBoundsFunctionArguments* arguments) {
        const auto& bounds = *static_cast<const std::vector<RTCBounds>*>(arguments->geometryUserPtr);
        *arguments->bounds_o = bounds[arguments->primID];
    }

    /// Made here and not when Embree asks: its threads take subnormal numbers for zero.
    RTCBounds bounds_of_piece(const Piece& piece) const {
        const Bounds bounds = bounds_of(scene_, scene_.corners(piece));
        const Point low = (*normalisation_)({bounds.low[0], bounds.low[1], bounds.low[2]});
        const Point high = (*normalisation_)({bounds.high[0], bounds.high[1], bounds.high[2]});
        // Nothing is ever asked beyond reach, and Embree refuses infinite bounds.
        constexpr double beyond = 2 * Normalisation::reach;
        const double margin = walking_margin + 5 * normalisation_->greatest_error();
        const auto down = [&](double v) { return static_cast<float>(std::max(v - margin, -beyond)); };
        const auto up = [&](double v) { return static_cast<float>(std::min(v + margin, beyond)); };
        return {down(low.x), down(low.y), down(low.z), 0, up(high.x), up(high.y), up(high.z), 0};
    }

    static void occluded(const RTCOccludedFunctionNArguments* arguments) {
        if (arguments->valid[0] == 0) return;
        const Context& context = *reinterpret_cast<const Context*>(arguments->context);
        if (hand_over(context.outlines[arguments->primID], context.segment, context.callback)) return;
        RTCRayN_tfar(arguments->ray, arguments->N, 0) = -std::numeric_limits<float>::infinity();
    }

    void build() const {
        if (scene_.pieces().empty()) return;
        // On a thread of its own: Embree builds with subnormal numbers flushed to zero, and where it is the first to
        // use oneTBB in a thread, that thread's tasks would work so ever after; exact decisions cannot bear that. Nor
        // can the thread, while it waits, be given tasks that wait for this tree.
        std::async(std::launch::async, [this] { build_here(); }).get();
    }

    void build_here() const {
        normalisation_.emplace(bounds_of(scene_));
        std::vector<RTCBounds> bounds;
        for (PieceId id = 0; id < static_cast<PieceId>(scene_.pieces().size()); ++id) {
            bounds.push_back(bounds_of_piece(scene_.piece(id)));
            outlines_.emplace_back(scene_, id, *normalisation_);
        }

        device_ = new_embree_device(nullptr);
        count_bytes(device_.get(), bytes_);
        const RTCGeometry geometry = rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_USER);
        rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(bounds.size()));
        rtcSetGeometryUserData(geometry, &bounds);
        rtcSetGeometryBoundsFunction(geometry, bound, nullptr);
        rtcSetGeometryOccludedFunction(geometry, occluded);
        rtcCommitGeometry(geometry);
        tree_.reset(rtcNewScene(device_.get()));
        rtcSetSceneFlags(tree_.get(), RTC_SCENE_FLAG_ROBUST);
        rtcAttachGeometry(tree_.get(), geometry);
        rtcReleaseGeometry(geometry);
        rtcCommitScene(tree_.get());
        if (rtcGetDeviceError(device_.get()) != RTC_ERROR_NONE)
            throw InputError("Embree cannot build its tree", {"", 0, "", "choose another source of candidates"});
    }

    const Scene& scene_;
    std::unique_ptr<CandidateSource> boxes_;  ///< Asked for polygons.
    mutable std::once_flag built_;
    mutable std::optional<Normalisation> normalisation_;
    mutable std::atomic<std::int64_t> bytes_{0};
    mutable EmbreeDevice device_;
    mutable EmbreeScene tree_;
    mutable LargeVector<PieceOutline> outlines_;
};

}  // namespace

std::unique_ptr<CandidateSource> make_embree_candidates(const Scene& scene) {
    return std::make_unique<EmbreeCandidates>(scene);
}

}  // namespace cob
