/// \file
/// Small scenes for the tests of visibility, written down as loops of points.
#pragma once

#include "cob/candidates.hpp"
#include "cob/scene.hpp"
#include "cob/visibility.hpp"

#include <map>
#include <memory>
#include <vector>

namespace cob::test {

using Loop = std::vector<Point>;

/// One polygon for each loop; corners at one position are one vertex.
inline Scene scene_of(const std::vector<Loop>& loops, bool skip_invalid = false) {
    Scene::Input input;
    input.name = "test";
    input.materials.push_back({});
    std::map<Point, VertexId> vertices;
    for (const Loop& loop : loops) {
        Scene::Face face;
        for (const Point& point : loop) {
            const auto [entry, added] = vertices.emplace(point, static_cast<VertexId>(input.positions.size()));
            if (added) input.positions.push_back(point);
            face.corners.push_back(entry->second);
        }
        input.faces.push_back(face);
    }
    return Scene::build(std::move(input), {skip_invalid});
}

/// Every source of candidates that this build has.
inline std::vector<Source> sources() {
    std::vector<Source> all;
    for (const Source source : {Source::all, Source::cgal, Source::octree, Source::embree})
        if (is_available(source)) all.push_back(source);
    return all;
}

/// A scene with an oracle over it.
struct Asked {
    explicit Asked(const std::vector<Loop>& loops, Source source = Source::cgal, bool skip_invalid = false)
        : scene(scene_of(loops, skip_invalid)),
          candidates(make_candidates(scene, source)),
          oracle(scene, *candidates) {}
    Visibility operator()(const ExactPoint& from, const ExactPoint& to) const { return oracle({from, to}); }

    Scene scene;
    std::unique_ptr<CandidateSource> candidates;
    VisibilityOracle oracle;
};

}  // namespace cob::test
