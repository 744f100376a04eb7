#include "scene/piece_plane.hpp"

#include "arithmetic/orientation.hpp"

namespace cob {

std::array<Point, 3> plane_of(const Scene& scene, const Piece& piece) {
    const View<VertexId> corners = scene.corners(piece);
    const auto at = [&](std::size_t k) { return scene.position(corners[static_cast<std::ptrdiff_t>(k)]); };
    // From the second corner on one is off the line of the first side, else there would be no area.
    std::size_t third = 2;
    while (third + 1 < corners.size() && collinear(at(0), at(1), at(third))) ++third;
    return {at(0), at(1), at(third)};
}

}  // namespace cob
