/// \file
/// What a picture's rays meet first: visible sides only, so that one looks into closed rooms from outside. For
/// pictures; answers about the scene come from the exact predicates.
#pragma once

#include "cob/scene.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

namespace cob::report {

struct Hit {
    PieceId piece = -1;  ///< -1: nothing.
    double distance = 0;
    double cosine = 0;  ///< Of the angle between the ray and the normal, > 0.
};

/// Says whether the first polygon lies on top of the second where both are met at one place.
using OnTop = std::function<bool(PolygonId, PolygonId)>;

/// A tree of bounds over the pieces' triangles; thread-safe after construction.
class RayCaster {
public:
    /// Of the scene in units of 2^exponent (mesh.hpp).
    RayCaster(const Scene& scene, int exponent, OnTop on_top);
    Hit first(const Point& origin, const Point& unit_direction) const;

private:
    struct Triangle {
        Point corner, first, second;  ///< A corner and the sides to the others.
        PieceId piece;
    };
    struct Branch {
        std::array<double, 6> bounds;
        std::int32_t first = 0;  ///< Of its triangles; or the second child, the first one follows.
        std::int32_t count = 0;  ///< Of triangles; 0: not a leaf.
    };

    std::int32_t build(std::int32_t first, std::int32_t last);
    void meet(const Triangle& triangle, const Point& origin, const Point& direction, Hit& hit) const;

    const Scene& scene_;
    OnTop on_top_;
    std::vector<Triangle> triangles_;
    std::vector<Branch> branches_;
};

}  // namespace cob::report
