// Which lights face an element (SPEC 5), exactly.
#include "arithmetic/orientation.hpp"
#include "geometry/prepared_box.hpp"
#include "scene/piece_plane.hpp"

#include <array>

namespace cob {
bool faces(const Scene& scene, PolygonId light, const Box& box, PredicateCounters* counters) {
    const Corners& corners = box.prepared().question.corners;
    for (const Piece& piece : scene.pieces_of(light)) {
        const std::array<Point, 3> plane = plane_of(scene, piece);
        for (int i = 0; i < corners.count; ++i) {
            const ExactPoint& corner = corners.points[static_cast<std::size_t>(i)];
            Stage stage = Stage::filter;
            const Sign side = corner.is_binary64() ? orientation(plane[0], plane[1], plane[2], corner.nearest(), &stage)
                                                   : orientation(ExactPoint(plane[0]), ExactPoint(plane[1]),
                                                                 ExactPoint(plane[2]), corner, &stage);
            if (counters != nullptr) {
                counters->filtered += stage == Stage::filter;
                counters->integer += stage == Stage::integer;
                counters->rational += stage == Stage::rational;
            }
            if (side == Sign::positive) return true;
        }
    }
    return false;
}

}  // namespace cob
