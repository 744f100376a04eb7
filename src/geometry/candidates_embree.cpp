// Embree as a tree only: every piece is a user geometry with widened bounds, and its occlusion callback asks the exact
// test, so that a piece that blocks ends the walk.
#include <embree3/rtcore.h>

#include "cob/error.hpp"
#include "geometry/bounds.hpp"
#include "geometry/candidates_trees.hpp"

#include <atomic>
#include <cmath>
#include <future>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

namespace cob {
namespace {

/// Segments are cut to this cube of the moved and scaled scene, which itself lies in [-1, 1].
constexpr double reach = 4;
/// Ends beyond this are too far off to be cut in binary64 with an error that the margin covers.
constexpr double farthest = 0x1p20;

/// Larger scenes would need a subnormal scale, which Embree's threads take for zero.
constexpr double largest_extent = 0x1p1020;

/// What walking along a segment in binary32 costs, in the moved and scaled scene. Ends in [-4, 4] are rounded by at
/// most 2^-23 and the direction in [-8, 8] by 2^-22, so every point of the segment is off by less than 2^-21; cutting
/// it adds 2^-31, the bounds' own rounding 2^-24, and Embree's robust walk takes care of its own. 2^-18 has room to
/// spare.
constexpr double walking_margin = 0x1p-18;

/// The map into [-1, 1]: p -> (p - centre) scale, a power of two.
struct Normalisation {
    Point centre;
    double scale = 1;
    double extent = 0;
    double margin = walking_margin;

    explicit Normalisation(const Bounds& all) {
        double greatest = 0;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            centre[static_cast<int>(axis)] = all.middle(axis);
            extent = std::max(extent, all.high[axis] / 2 - all.low[axis] / 2);
            greatest = std::max({greatest, std::abs(all.high[axis]), std::abs(all.low[axis])});
        }
        // Scenes smaller than 2^-1000 stay small, and everything is a candidate.
        scale = std::ldexp(1.0, -std::max(-1000, std::ilogb(extent) + 1));
        // Where the scene is far from the origin: the rounding of the ends to binary64, and of the subtraction.
        margin += 16 * 0x1p-53 * (greatest * scale + reach);
    }
    Point operator()(const Point& p) const {
        return {(p.x - centre.x) * scale, (p.y - centre.y) * scale, (p.z - centre.z) * scale};
    }
};

double greatest_coordinate(const Point& p) {
    return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
}

/// The part of the segment in the cube of `reach`; nothing where there is none.
std::optional<std::pair<Point, Point>> cut(const Point& from, const Point& to) {
    double first = 0, last = 1;
    for (int axis = 0; axis < 3; ++axis) {
        const double x = from[axis], d = to[axis] - x;
        if (d == 0) {
            if (std::abs(x) > reach) return std::nullopt;
            continue;
        }
        const double a = (-reach - x) / d, b = (reach - x) / d;
        first = std::max(first, std::min(a, b));
        last = std::min(last, std::max(a, b));
    }
    if (!(first < last)) return std::nullopt;
    const Point d = to - from;
    return std::pair{from + first * d, from + last * d};
}

class EmbreeCandidates final : public CandidateSource {
public:
    explicit EmbreeCandidates(const Scene& scene) : scene_(scene), others_(make_cgal_candidates(scene)) {}
    ~EmbreeCandidates() override {
        if (tree_) rtcReleaseScene(tree_);
        if (device_) rtcReleaseDevice(device_);
    }
    EmbreeCandidates(const EmbreeCandidates&) = delete;
    EmbreeCandidates& operator=(const EmbreeCandidates&) = delete;

    void polygons_in(const std::array<double, 6>& bounds, Callback callback) const override {
        others_->polygons_in(bounds, callback);
    }

    void pieces_along(const Point& from, const Point& to, Callback callback) const override {
        std::call_once(built_, [this] { build(); });
        if (!tree_) return others_->pieces_along(from, to, callback);
        // 1. Into the cube in which binary32 is near enough; what comes from too far is left to the other tree.
        Point x = (*normalisation_)(from), y = (*normalisation_)(to);
        if (!(greatest_coordinate(x) <= reach && greatest_coordinate(y) <= reach)) {
            const bool in_range = greatest_coordinate(x) <= farthest && greatest_coordinate(y) <= farthest;
            if (!in_range) return others_->pieces_along(from, to, callback);  // NaN as well
            const auto inside = cut(x, y);
            if (!inside) return;
            std::tie(x, y) = *inside;
        }
        // 2. A ray from parameter 0 to 1.
        RTCRay ray{};
        ray.org_x = static_cast<float>(x.x);
        ray.org_y = static_cast<float>(x.y);
        ray.org_z = static_cast<float>(x.z);
        ray.dir_x = static_cast<float>(y.x - x.x);
        ray.dir_y = static_cast<float>(y.y - x.y);
        ray.dir_z = static_cast<float>(y.z - x.z);
        ray.tfar = 1;
        ray.mask = ~0u;
        // 3. Down the tree.
        Context context;
        rtcInitIntersectContext(&context.embree);
        context.callback = callback;
        rtcOccluded1(tree_, &context.embree, &ray);
    }

    std::size_t memory() const override {
        return sizeof *this + static_cast<std::size_t>(bytes_.load()) + others_->memory();
    }

private:
    /// Embree hands its context to the callback; ours goes with it.
    struct Context {
        RTCIntersectContext embree;
        Callback callback;
    };

    static void bound(const RTCBoundsFunctionArguments* arguments) {
        const EmbreeCandidates& self = *static_cast<const EmbreeCandidates*>(arguments->geometryUserPtr);
        const Normalisation& normalise = *self.normalisation_;
        const Bounds bounds =
            bounds_of(self.scene_, self.scene_.corners(self.scene_.piece(static_cast<PieceId>(arguments->primID))));
        const Point low = normalise({bounds.low[0], bounds.low[1], bounds.low[2]});
        const Point high = normalise({bounds.high[0], bounds.high[1], bounds.high[2]});
        // Nothing is ever asked beyond the cube, and Embree refuses infinite bounds.
        const auto down = [&](double v) { return static_cast<float>(std::max(v - normalise.margin, -2 * reach)); };
        const auto up = [&](double v) { return static_cast<float>(std::min(v + normalise.margin, 2 * reach)); };
        RTCBounds& out = *arguments->bounds_o;
        out.lower_x = down(low.x);
        out.lower_y = down(low.y);
        out.lower_z = down(low.z);
        out.upper_x = up(high.x);
        out.upper_y = up(high.y);
        out.upper_z = up(high.z);
    }

    static void occluded(const RTCOccludedFunctionNArguments* arguments) {
        if (arguments->valid[0] == 0) return;
        const Context& context = *reinterpret_cast<const Context*>(arguments->context);
        if (context.callback.call(context.callback.context, static_cast<std::int32_t>(arguments->primID))) return;
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
        Bounds all;
        for (const Piece& piece : scene_.pieces()) all.add(bounds_of(scene_, scene_.corners(piece)));
        normalisation_.emplace(all);
        if (normalisation_->extent >= largest_extent) return;  // the other tree serves alone

        device_ = rtcNewDevice(nullptr);
        if (!device_) throw InputError("Embree cannot start here", {"", 0, "", "choose another source of candidates"});
        rtcSetDeviceMemoryMonitorFunction(
            device_,
            [](void* bytes, ssize_t change, bool) {
                static_cast<std::atomic<std::int64_t>*>(bytes)->fetch_add(change);
                return true;
            },
            &bytes_);
        const RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_USER);
        rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(scene_.pieces().size()));
        rtcSetGeometryUserData(geometry, const_cast<EmbreeCandidates*>(this));
        rtcSetGeometryBoundsFunction(geometry, bound, nullptr);
        rtcSetGeometryOccludedFunction(geometry, occluded);
        rtcCommitGeometry(geometry);
        tree_ = rtcNewScene(device_);
        rtcSetSceneFlags(tree_, RTC_SCENE_FLAG_ROBUST);
        rtcAttachGeometry(tree_, geometry);
        rtcReleaseGeometry(geometry);
        rtcCommitScene(tree_);
        if (rtcGetDeviceError(device_) != RTC_ERROR_NONE)
            throw InputError("Embree cannot build its tree", {"", 0, "", "choose another source of candidates"});
    }

    const Scene& scene_;
    std::unique_ptr<CandidateSource> others_;  ///< For boxes, and for segments from far away.
    mutable std::once_flag built_;
    mutable std::optional<Normalisation> normalisation_;
    mutable RTCDevice device_ = nullptr;
    mutable RTCScene tree_ = nullptr;
    mutable std::atomic<std::int64_t> bytes_{0};
};

}  // namespace

std::unique_ptr<CandidateSource> make_embree_candidates(const Scene& scene) {
    return std::make_unique<EmbreeCandidates>(scene);
}

}  // namespace cob
