// The other arithmetics of the same formulas, on adversarial input: fractions alone agree with the product everywhere,
// intervals wherever they decide, and they do not decide always.
#include "differential/boxes.hpp"
#include "differential/run.hpp"
#include "differential/scenes.hpp"

#include "cob/candidates.hpp"
#include "cob/visibility.hpp"

namespace cob::test {
namespace {

TEST(Arithmetics, OfBoxesAgreeWhereTheyDecide) {
    const Tally tally = run_cases(4000000, 200 * length, [](std::uint64_t seed, Tally& sum) {
        const naive::BoxCase question = naive::box_case(seed);
        const Scene scene = library_scene(question.faces, Vertices::shared);
        for (const naive::BoxQuestion& asked : question.boxes) {
            const std::optional<Box> box = library_box(asked);
            if (!box) continue;
            for (PolygonId id = 0; id < scene.polygon_count(); ++id) {
                if (!scene.polygon(id).valid) continue;
                const std::string where = "box case " + std::to_string(seed) + " polygon " + std::to_string(id);
                const auto text = [](const BoxAnswer& answer) {
                    return std::string(to_text(answer.relation)) + (answer.covers ? " covers" : "");
                };
                const BoxAnswer expected = relate(scene, id, *box);
                sum.compare(text(relate(scene, id, *box, Arithmetic::rational)), text(expected), where + " rational");
                const BoxAnswer interval = relate(scene, id, *box, Arithmetic::interval);
                sum.count(interval.decided ? "decided" : "undecided");
                if (interval.decided) sum.compare(text(interval), text(expected), where + " interval");
            }
        }
    });
    expect_no_difference(tally);
    expect_shares(tally, {{"decided", 0.2}, {"undecided", 0.1}});
}

TEST(Arithmetics, OfSegmentsAgreeWhereTheyDecide) {
    const Tally tally = run_cases(5000000, 200 * length, [](std::uint64_t seed, Tally& sum) {
        const naive::SegmentCase question = naive::segment_case(seed);
        const Scene scene = library_scene(question.faces, Vertices::shared);
        const auto source = make_candidates(scene, Source::all);
        const VisibilityOracle oracle(scene, *source);
        for (const auto& [from, to] : question.segments) {
            const Segment segment{ExactPoint(from), ExactPoint(to)};
            const std::string where = "segment case " + std::to_string(seed), expected = to_text(oracle(segment));
            sum.compare(to_text(oracle(segment, Arithmetic::rational).visibility), expected, where + " rational");
            const VisibilityAnswer interval = oracle(segment, Arithmetic::interval);
            sum.count(interval.decided ? "decided" : "undecided");
            if (interval.decided) sum.compare(to_text(interval.visibility), expected, where + " interval");
        }
    });
    expect_no_difference(tally);
    expect_shares(tally, {{"decided", 0.2}, {"undecided", 0.1}});
}

}  // namespace
}  // namespace cob::test
