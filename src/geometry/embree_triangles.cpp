#include "geometry/embree_triangles.hpp"

#include "geometry/embree_handles.hpp"

#include <cmath>
#include <future>
#include <vector>

namespace cob {
namespace {

RTCRay offset_ray(const Segment& segment) {
    RTCRay ray = embree_ray(segment.from.nearest(), segment.to.nearest());
    ray.tnear = EmbreeTriangles::offset;
    ray.tfar = 1 - EmbreeTriangles::offset;
    return ray;
}

/// What Embree takes for a ray: some builds of it end the program where one is none.
bool is_in_range(const RTCRay& ray) {
    constexpr float most = 1.8e18F;
    for (const float x : {ray.org_x, ray.org_y, ray.org_z, ray.dir_x, ray.dir_y, ray.dir_z})
        if (!(std::abs(x) < most)) return false;
    return true;
}

}  // namespace

struct EmbreeTriangles::Implementation {
    void build(const Scene& of);

    std::atomic<std::int64_t> bytes{0};
    EmbreeDevice device;
    EmbreeScene scene;
    std::vector<PieceId> pieces;  ///< Of every triangle.
};

void EmbreeTriangles::Implementation::build(const Scene& of) {
    device = new_embree_device("threads=1");
    count_bytes(device.get(), bytes);
    std::vector<std::uint32_t> corners;
    for (PieceId id = 0; id < static_cast<PieceId>(of.pieces().size()); ++id) {
        const View<VertexId> loop = of.corners(of.piece(id));
        for (const auto& triangle : cut_into_triangles(of, of.piece(id))) {
            for (const std::uint32_t corner : triangle) corners.push_back(static_cast<std::uint32_t>(loop[corner]));
            pieces.push_back(id);
        }
    }
    const RTCGeometry geometry = rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* position = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                                 3 * sizeof(float), of.positions().size()));
    check_for_errors(device.get());
    for (const Point& p : of.positions())
        for (int axis = 0; axis < 3; ++axis) *position++ = static_cast<float>(p[axis]);
    auto* index = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), pieces.size()));
    check_for_errors(device.get());
    for (const std::uint32_t corner : corners) *index++ = corner;
    rtcCommitGeometry(geometry);
    scene.reset(rtcNewScene(device.get()));
    rtcSetSceneFlags(scene.get(), RTC_SCENE_FLAG_ROBUST);
    rtcAttachGeometry(scene.get(), geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene.get());
    check_for_errors(device.get());
}

// On a thread of its own: Embree builds with subnormal numbers flushed to zero, and where it is the first to use oneTBB
// in a thread, that thread's tasks would work so ever after, exact decisions among them.
EmbreeTriangles::EmbreeTriangles(const Scene& scene) : implementation_(std::make_unique<Implementation>()) {
    std::async(std::launch::async, [&] { implementation_->build(scene); }).get();
}

EmbreeTriangles::~EmbreeTriangles() = default;

bool EmbreeTriangles::hidden(const Segment& segment) const {
    RTCRay ray = offset_ray(segment);
    if (!is_in_range(ray)) return false;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcOccluded1(implementation_->scene.get(), &context, &ray);
    return ray.tfar < 0;
}

std::optional<EmbreeTriangles::Hit> EmbreeTriangles::first_hit(const Segment& segment) const {
    RTCRayHit hit{};
    hit.ray = offset_ray(segment);
    if (!is_in_range(hit.ray)) return std::nullopt;
    hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(implementation_->scene.get(), &context, &hit);
    if (hit.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
    return Hit{implementation_->pieces[hit.hit.primID], static_cast<double>(hit.ray.tfar)};
}

std::size_t EmbreeTriangles::memory() const {
    return sizeof(Implementation) + static_cast<std::size_t>(implementation_->bytes.load()) +
           implementation_->pieces.capacity() * sizeof(PieceId);
}

}  // namespace cob
