/// \file
/// Cutting convex cones and subtracting them: by signs alone.
#pragma once

#include "radiosity/cone.hpp"

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <utility>

namespace cob::radiosity {

using SideSigns = boost::container::small_vector<Sign, 8>;

/// Both sides of a plane in a cone, each nothing where it has no inside.
struct SplitCone {
    std::optional<Cone> positive, negative;
};

/// Does one plane of `cone` have all of `other` on its outside?
inline bool separates(const PlanesThroughPoint& planes, const Cone& cone, const Cone& other) {
    for (const PlaneRef& plane : cone.planes) {
        bool outside = true;
        for (std::size_t k = 0; k < other.rays.size() && outside; ++k)
            outside = planes.side(plane, other.rays[k]) != Sign::positive;
        if (outside) return true;
    }
    return false;
}

/// The part on the positive side, given the sides of the rays: some positive, some negative.
inline Cone keep(const PlanesThroughPoint& planes, const Cone& cone, PlaneRef plane, const SideSigns& sides) {
    const std::size_t n = cone.planes.size();
    // Begin behind the ray that is the last not to be positive, so that what is kept is one run.
    std::size_t start = 0;
    while (!(sides[start] == Sign::positive && sides[(start + n - 1) % n] != Sign::positive)) ++start;
    Cone result;
    result.planes.reserve(n + 1), result.rays.reserve(n + 1);
    // Plane `start` ends in ray `start`, the first positive one: it is cut by the new plane and begins the run.
    std::size_t k = start;
    result.planes.push_back(cone.planes[k]);
    while (sides[k] == Sign::positive) {
        result.rays.push_back(cone.rays[k]);
        k = (k + 1) % n;
        result.planes.push_back(cone.planes[k]);
    }
    result.rays.push_back(planes.meet(result.planes.back(), plane));
    result.planes.push_back(plane);
    result.rays.push_back(planes.meet(plane, result.planes.front()));
    return result;
}

inline SplitCone split(const PlanesThroughPoint& planes, const Cone& cone, PlaneRef plane) {
    SideSigns sides;
    bool positive = false, negative = false;
    for (const Ray& ray : cone.rays) {
        sides.push_back(planes.side(plane, ray));
        positive = positive || sides.back() == Sign::positive;
        negative = negative || sides.back() == Sign::negative;
    }
    SplitCone result;
    if (!negative) {
        result.positive = cone;
    } else if (!positive) {
        result.negative = cone;
    } else {
        result.positive = keep(planes, cone, plane, sides);
        for (Sign& side : sides) side = -side;
        result.negative = keep(planes, cone, -plane, sides);
    }
    return result;
}

/// Appends to `rest` what of the cone lies outside all shadows, as cones without common inside; what has no inside is
/// dropped. Large shadows should come first.
inline void subtract(const PlanesThroughPoint& planes, const Cone& cone, std::vector<const Cone*> shadows,
                     std::vector<Cone>& rest) {
    // Each part goes on with the shadows that meet it alone, so that far ones are not asked again and again.
    shadows.erase(std::remove_if(shadows.begin(), shadows.end(),
                                 [&](const Cone* shadow) {
                                     return separates(planes, *shadow, cone) || separates(planes, cone, *shadow);
                                 }),
                  shadows.end());
    if (shadows.empty()) {
        rest.push_back(cone);
        return;
    }
    const Cone& shadow = *shadows.front();
    const std::vector<const Cone*> others(shadows.begin() + 1, shadows.end());
    std::optional<Cone> inside = cone;
    for (std::size_t k = 0; k < shadow.planes.size() && inside; ++k) {
        SplitCone parts = split(planes, *inside, shadow.planes[k]);
        if (parts.negative) subtract(planes, *parts.negative, others, rest);
        inside = std::move(parts.positive);
    }
}

}  // namespace cob::radiosity
