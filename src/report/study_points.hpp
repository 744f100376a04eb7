/// \file
/// The points of a study.
#pragma once

#include "cob/study.hpp"

namespace cob {

/// Points without light, and the areas of the reference.
StudyReference study_points(const Scene& scene, const Roots& roots, std::size_t points, const StudyRegion& region);

/// The scene with every reflectance times `dimming`: what is reflected twice is below a millionth.
inline constexpr double dimming = 1.0 / (1 << 20);
Scene dimmed(const Scene& scene);

/// Exact point and normal.
struct PointOnRoot {
    ExactPoint position;
    RationalPoint normal;
};
PointOnRoot point_on_root(const Scene& scene, const Root& root, const std::array<double, 2>& coordinates);

}  // namespace cob
