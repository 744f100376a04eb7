// SPEC 6: clear, grazing and blocked against the naive twin.
#include "naive/visibility.hpp"
#include "differential/run.hpp"
#include "differential/scenes.hpp"

#include "cob/candidates.hpp"
#include "cob/visibility.hpp"

namespace cob::test {
namespace {

TEST(VisibilityAgainstTwin, AdversarialSegments) {
    const Tally tally = run_cases(0, 10000 * length / 10, [](std::uint64_t seed, Tally& sum) {
        const naive::SegmentCase question = naive::segment_case(seed);
        const Scene scene = library_scene(question.faces, seed % 4 < 2 ? Vertices::apart : Vertices::shared);
        const auto candidates = make_candidates(scene, seed % 2 == 0 ? Source::all : Source::cgal);
        const VisibilityOracle oracle(scene, *candidates);
        const auto items = naive_scene(question.faces);
        std::vector<const naive::Polygon*> polygons;
        for (const naive::SceneItem& item : items) {
            // What the library refuses and the twin does not is the pieces' test's to find.
            const PolygonId id = static_cast<PolygonId>(&item - items.data());
            if (item.polygon.refused.empty() && scene.polygon(id).valid) polygons.push_back(&item.polygon);
        }
        for (std::size_t k = 0; k < question.segments.size(); ++k) {
            const auto& [from, to] = question.segments[k];
            const std::string where = "segment case " + std::to_string(seed) + " segment " + std::to_string(k) +
                                      " of " + naive::to_text(naive::family_of(seed));
            const Segment segment{ExactPoint(from), ExactPoint(to)};
            sum.compare(to_text(oracle(segment)), to_text(naive::visibility(polygons, from, to)), where);
        }
    });
    expect_no_difference(tally);
    expect_shares(tally, {{"clear", 0.1}, {"grazing", 0.1}, {"blocked", 0.1}});
}

}  // namespace
}  // namespace cob::test
