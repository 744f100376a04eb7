/// \file
/// Owners of what Embree hands out. Only where the library is built with Embree.
#pragma once

#include "cob/arithmetic.hpp"
#include "cob/error.hpp"

#include <embree3/rtcore.h>

#include <atomic>
#include <cstdint>
#include <memory>
#include <new>

namespace cob {

template <auto Release>
struct ReleaseWith {
    template <class T>
    void operator()(T* handle) const {
        Release(handle);
    }
};
using EmbreeDevice = std::unique_ptr<RTCDeviceTy, ReleaseWith<rtcReleaseDevice>>;
using EmbreeScene = std::unique_ptr<RTCSceneTy, ReleaseWith<rtcReleaseScene>>;

/// Throws InputError where Embree does not start.
inline EmbreeDevice new_embree_device(const char* configuration) {
    EmbreeDevice device(rtcNewDevice(configuration));
    if (!device)
        throw InputError("Embree cannot start here",
                         {"", 0, "", "give it more memory, or choose what needs no Embree"});
    return device;
}

/// Throws std::bad_alloc where something has failed since the last call; nothing else is left to fail.
inline void check_for_errors(RTCDevice device) {
    if (rtcGetDeviceError(device) != RTC_ERROR_NONE) throw std::bad_alloc();
}

/// Counts the bytes that a device holds; must outlive it.
inline void count_bytes(RTCDevice device, std::atomic<std::int64_t>& bytes) {
    rtcSetDeviceMemoryMonitorFunction(
        device,
        [](void* total, ssize_t change, bool) {
            static_cast<std::atomic<std::int64_t>*>(total)->fetch_add(change);
            return true;
        },
        &bytes);
}

/// A ray of Embree from x, whose parameter is 1 at y.
inline RTCRay embree_ray(const Point& x, const Point& y) {
    RTCRay ray{};
    ray.org_x = static_cast<float>(x.x);
    ray.org_y = static_cast<float>(x.y);
    ray.org_z = static_cast<float>(x.z);
    ray.dir_x = static_cast<float>(y.x - x.x);
    ray.dir_y = static_cast<float>(y.y - x.y);
    ray.dir_z = static_cast<float>(y.z - x.z);
    ray.tfar = 1;
    ray.mask = ~0u;
    return ray;
}

}  // namespace cob
