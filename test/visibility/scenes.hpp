/// \file
/// What the tests of visibility ask.
#pragma once

#include "cob/candidates.hpp"
#include "cob/visibility.hpp"
#include "loops.hpp"

#include <memory>
#include <vector>

namespace cob::test {

/// Every source of candidates that this build has.
inline std::vector<Source> sources() {
    std::vector<Source> all;
    for (const Source source : {Source::all, Source::tree, Source::octree, Source::embree})
        if (is_available(source)) all.push_back(source);
    return all;
}

/// A scene with an oracle over it.
struct Asked {
    explicit Asked(const std::vector<Loop>& loops, Source source = Source::tree, bool skip_invalid = false)
        : scene(scene_of(loops, Vertices::shared, skip_invalid)),
          candidates(make_candidates(scene, source)),
          oracle(scene, *candidates) {}
    Visibility operator()(const ExactPoint& from, const ExactPoint& to) const { return oracle({from, to}); }

    Scene scene;
    std::unique_ptr<CandidateSource> candidates;
    VisibilityOracle oracle;
};

}  // namespace cob::test
