/// \file
/// Small scenes for the tests of the radiosity room.
#pragma once

#include "cob/scene.hpp"

#include <array>
#include <utility>
#include <vector>

namespace scenes {

/// Collects polygons with a material of their own each.
class Builder {
public:
    Builder& add(std::vector<cob::Point> loop, std::array<double, 3> reflectance, std::array<double, 3> emitted = {}) {
        cob::Scene::Face face;
        for (const cob::Point& p : loop) {
            face.corners.push_back(static_cast<cob::VertexId>(input_.positions.size()));
            input_.positions.push_back(p);
        }
        face.material = static_cast<std::int32_t>(input_.materials.size());
        face.line = static_cast<std::uint32_t>(input_.faces.size() + 1);
        input_.materials.push_back({"m" + std::to_string(face.material), reflectance, emitted});
        input_.faces.push_back(std::move(face));
        return *this;
    }
    /// The six inner sides of a box, each with its material: x low, x high, y low, y high, floor, ceiling.
    Builder& room(const cob::Point& low, const cob::Point& high,
                  const std::array<std::array<double, 3>, 6>& reflectance,
                  const std::array<std::array<double, 3>, 6>& emitted) {
        const auto at = [&](int x, int y, int z) {
            return cob::Point{x ? high.x : low.x, y ? high.y : low.y, z ? high.z : low.z};
        };
        add({at(0, 0, 0), at(0, 1, 0), at(0, 1, 1), at(0, 0, 1)}, reflectance[0], emitted[0]);
        add({at(1, 0, 0), at(1, 0, 1), at(1, 1, 1), at(1, 1, 0)}, reflectance[1], emitted[1]);
        add({at(0, 0, 0), at(0, 0, 1), at(1, 0, 1), at(1, 0, 0)}, reflectance[2], emitted[2]);
        add({at(0, 1, 0), at(1, 1, 0), at(1, 1, 1), at(0, 1, 1)}, reflectance[3], emitted[3]);
        add({at(0, 0, 0), at(1, 0, 0), at(1, 1, 0), at(0, 1, 0)}, reflectance[4], emitted[4]);
        add({at(0, 0, 1), at(0, 1, 1), at(1, 1, 1), at(1, 0, 1)}, reflectance[5], emitted[5]);
        return *this;
    }
    cob::Scene scene() const { return cob::Scene::build(input_); }

private:
    cob::Scene::Input input_{"test", {}, {}, {}};
};

/// A room whose sides all reflect rho and emit e.
inline cob::Scene furnace(double rho, double e) {
    std::array<std::array<double, 3>, 6> r, m;
    r.fill({rho, rho, rho});
    m.fill({e, e, e});
    return Builder().room({0, 0, 0}, {1, 1, 1}, r, m).scene();
}

/// A table under a lamp, and a small plate close above the table that throws a sharp shadow.
inline cob::Scene plate_over_table(double plate_height = 0.02) {
    Builder b;
    b.add({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}, {0.5, 0.4, 0.3});
    b.add({{-0.125, -0.125, 2}, {-0.125, 0.125, 2}, {0.125, 0.125, 2}, {0.125, -0.125, 2}}, {0, 0, 0}, {40, 30, 20});
    const double h = plate_height;
    b.add({{0.1, 0.1, h}, {0.4, 0.1, h}, {0.4, 0.25, h}, {0.1, 0.25, h}}, {0.6, 0.6, 0.6});
    b.add({{0.1, 0.25, h}, {0.4, 0.25, h}, {0.4, 0.1, h}, {0.1, 0.1, h}}, {0.6, 0.6, 0.6});
    return b.scene();
}

}  // namespace scenes
