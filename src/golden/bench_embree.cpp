// Embree as a yes-or-no variant of visibility: single precision, any hit strictly between the ends.
#include "golden/bench_set.hpp"

#ifdef COB_HAS_EMBREE

#include <embree3/rtcore.h>

#include <atomic>
#include <future>
#include <memory>

namespace cob {

namespace {

template <auto Release>
struct ReleaseWith {
    template <class T>
    void operator()(T* handle) const {
        Release(handle);
    }
};
using Device = std::unique_ptr<RTCDeviceTy, ReleaseWith<rtcReleaseDevice>>;
using EmbreeScene = std::unique_ptr<RTCSceneTy, ReleaseWith<rtcReleaseScene>>;

bool count_bytes(void* total, ssize_t bytes, bool) {
    *static_cast<std::atomic<std::int64_t>*>(total) += bytes;
    return true;
}

/// All pieces as triangles of one geometry.
EmbreeScene build(RTCDevice device, const Scene& scene) {
    std::vector<std::array<std::uint32_t, 3>> triangles;
    for (const Piece& piece : scene.pieces()) {
        const auto corners = scene.corners(piece);
        for (const auto& [a, b, c] : cut_into_triangles(scene, piece))
            triangles.push_back({static_cast<std::uint32_t>(corners[a]), static_cast<std::uint32_t>(corners[b]),
                                 static_cast<std::uint32_t>(corners[c])});
    }
    EmbreeScene result(rtcNewScene(device));
    rtcSetSceneFlags(result.get(), RTC_SCENE_FLAG_ROBUST);
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* vertex = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                               3 * sizeof(float), scene.positions().size()));
    for (const Point& p : scene.positions())
        for (int axis = 0; axis < 3; ++axis) *vertex++ = static_cast<float>(p[axis]);
    auto* index = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), triangles.size()));
    for (const auto& triangle : triangles)
        for (const std::uint32_t corner : triangle) *index++ = corner;
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(result.get(), geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(result.get());
    return result;
}

bool hidden(RTCScene scene, const Segment& segment) {
    const Point &from = segment.from.nearest(), along = segment.to.nearest() - from;
    RTCRay ray{};
    ray.org_x = static_cast<float>(from.x), ray.org_y = static_cast<float>(from.y),
    ray.org_z = static_cast<float>(from.z);
    ray.dir_x = static_cast<float>(along.x), ray.dir_y = static_cast<float>(along.y),
    ray.dir_z = static_cast<float>(along.z);
    // The usual offset of shadow rays: without it every ray hits the surface that it leaves.
    ray.tnear = 1e-4F, ray.tfar = 1 - 1e-4F;
    ray.mask = ~0U;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcOccluded1(scene, &context, &ray);
    return ray.tfar < 0;
}

}  // namespace

void bench_embree(const BenchSet& set, const BenchOptions& options, std::vector<BenchRow>& rows) {
    if (set.segments.empty()) return;
    std::atomic<std::int64_t> bytes{0};
    Device device;
    EmbreeScene scene;
    // On a thread of its own: Embree builds with subnormal numbers flushed to zero, and where it is the first to use
    // oneTBB in a thread, that thread's tasks would work so ever after, exact decisions among them.
    std::async(std::launch::async, [&] {
        device.reset(rtcNewDevice("threads=1"));
        rtcSetDeviceMemoryMonitorFunction(device.get(), count_bytes, &bytes);
        scene = build(device.get(), set.scene);
    }).get();

    std::vector<BenchRow> kinds;
    for (const auto& [kind, segments] : set.segments) {
        std::vector<char> answers(segments.size());
        const auto ask = [&, &questions = segments](std::size_t k) {
            answers[k] = hidden(scene.get(), questions[k].segment);
        };
        BenchRow row = measure(segments.size(), options, ask, [&, &questions = segments](std::size_t k) {
            const Visibility exact = questions[k].visibility;
            const bool right = exact == Visibility::grazing || (answers[k] != 0) == (exact == Visibility::blocked);
            return right ? Outcome::right : Outcome::wrong;
        });
        row.question = "segment", row.variant = "embree", row.kind = kind;
        row.bytes = static_cast<std::uint64_t>(bytes);
        kinds.push_back(std::move(row));
    }
    add_rows(rows, std::move(kinds));
}

}  // namespace cob

#else

namespace cob {

void bench_embree(const BenchSet&, const BenchOptions&, std::vector<BenchRow>&) {}

}  // namespace cob

#endif
