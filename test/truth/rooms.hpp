// Scenes of a few polygons for the tests of exact irradiance, form factors and patches.
#pragma once

#include "cob/candidates.hpp"
#include "cob/scene.hpp"

#include <vector>

namespace cob::test {

// Polygons one by one; every one of them emits 1 W/m2 in all channels, so that any can be the light.
class RoomBuilder {
public:
    RoomBuilder& polygon(const std::vector<Point>& corners) {
        Scene::Face face;
        for (const Point& corner : corners) {
            face.corners.push_back(static_cast<VertexId>(input_.positions.size()));
            input_.positions.push_back(corner);
        }
        input_.faces.push_back(std::move(face));
        return *this;
    }
    // The rectangle at height z, seen from above (up) or from below.
    RoomBuilder& sheet(double x0, double y0, double x1, double y1, double z, bool up) {
        return up ? polygon({{x0, y0, z}, {x1, y0, z}, {x1, y1, z}, {x0, y1, z}})
                  : polygon({{x0, y1, z}, {x1, y1, z}, {x1, y0, z}, {x0, y0, z}});
    }
    Scene build() const {
        Scene::Input input = input_;
        input.name = "test";
        input.materials.emplace_back();
        input.materials.back().emitted_exitance = {1, 1, 1};
        return Scene::build(std::move(input));
    }

private:
    Scene::Input input_;
};

// Names everything, always: the simplest source of candidates.
class EveryPolygon : public CandidateSource {
public:
    explicit EveryPolygon(const Scene& scene) : scene_(&scene) {}
    void polygons_in(const std::array<double, 6>&, Callback callback) const override {
        for (PolygonId k = 0; k < scene_->polygon_count(); ++k)
            if (scene_->polygon(k).valid && !callback.call(callback.context, k)) return;
    }
    void pieces_along(const Point&, const Point&, PieceCallback callback) const override {
        for (std::size_t k = 0; k < scene_->pieces().size(); ++k)
            if (!callback.call(callback.context, static_cast<PieceId>(k), false)) return;
    }
    std::size_t memory() const override { return 0; }

private:
    const Scene* scene_;
};

}  // namespace cob::test
