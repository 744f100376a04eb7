// SPEC 4 and 5: relation, covers, shared, facing lights and the state of the buffer, against the naive twin.
#include "differential/boxes.hpp"
#include "differential/run.hpp"
#include "differential/scenes.hpp"
#include "naive/dice.hpp"

#include "cob/candidates.hpp"
#include "cob/classification.hpp"
#include "cob/geometry.hpp"

#include <cmath>

namespace cob::test {
namespace {

template <class Ids>
std::string joined(const Ids& ids) {
    std::string text;
    for (const int id : ids) text += std::to_string(id) + " ";
    return text;
}

/// One row of states.csv.
std::string row(const char* state, const std::string& close, const std::string& cover, const std::string& light) {
    return std::string(state) + "," + (state == std::string("occluded") ? "" : close) + "," + cover + "," + light;
}

/// How every polygon touches the box's own one.
void compare_shared(PolygonId own, const Scene& scene, const std::vector<naive::SceneItem>& items,
                    const std::string& where, Tally& sum) {
    if (own < 0 || !scene.polygon(own).valid) return;
    for (PolygonId id = 0; id < scene.polygon_count(); ++id)
        if (id != own && scene.polygon(id).valid)
            sum.compare(to_text(shared(scene, id, own)),
                        naive::to_text(naive::shared(items[static_cast<std::size_t>(id)].polygon,
                                                     items[static_cast<std::size_t>(own)].polygon)),
                        where + " polygon " + std::to_string(id));
}

/// One box of a case: every polygon by itself, then all of them.
void compare_box(const naive::BoxQuestion& question, const Scene& scene, const CandidateSource& source,
                 const std::vector<naive::SceneItem>& items, const std::string& where, Tally& sum) {
    const std::optional<Box> box = library_box(question);
    const naive::Box twin = naive::prepare(question);
    sum.compare(box ? "box" : "no box", twin.refused.empty() ? "box" : "no box", where + " " + twin.refused);
    if (!box || !twin.refused.empty()) return;

    const std::vector<naive::Answer> answers = naive::relate_all(items, question.polygon, twin);
    for (PolygonId id = 0; id < scene.polygon_count(); ++id) {
        if (id == question.polygon || !scene.polygon(id).valid) continue;
        const naive::Polygon& polygon = items[static_cast<std::size_t>(id)].polygon;
        const naive::Answer& expected = answers[static_cast<std::size_t>(id)];
        const std::string at = where + " polygon " + std::to_string(id);
        const BoxAnswer answer = relate(scene, id, *box);
        sum.compare(to_text(answer.relation), naive::to_text(expected.relation), at);
        sum.compare(answer.covers ? "covers" : "does not cover", expected.covers ? "covers" : "does not cover", at);
        if (scene.is_light(id))
            sum.compare(faces(scene, id, *box) ? "faces" : "turned away",
                        naive::faces(polygon, twin) ? "faces" : "turned away", at);
    }

    BoxClassifier classifier(scene);
    Classification classification;
    classifier.from_scene(*box, source, classification);
    const naive::State state = naive::state(answers);
    sum.count(state.name);
    const std::string expected = row(state.name, joined(state.close), joined(state.cover), joined(state.light));
    const std::string found = row(to_text(classification.state), joined(classification.close),
                                  joined(classification.cover), joined(classification.light));
    sum.compare(found == expected ? "same state" : found, found == expected ? "same state" : expected, where);
}

constexpr std::uint64_t pairs_per_case = 18;

/// All boxes of a case among all its polygons.
void compare_case(const naive::BoxCase& question, std::uint64_t seed, const std::string& where, Tally& sum) {
    const Scene scene = library_scene(question.faces, seed % 4 < 2 ? Vertices::apart : Vertices::shared);
    const auto source = make_candidates(scene, seed % 2 == 0 ? Source::all : Source::tree);
    std::vector<naive::SceneItem> items = naive_scene(question.faces);
    for (PolygonId id = 0; id < scene.polygon_count(); ++id)
        if (!scene.polygon(id).valid) items[static_cast<std::size_t>(id)].polygon.refused = "by the library";
    for (std::size_t k = 0; k < question.boxes.size(); ++k)
        compare_box(question.boxes[k], scene, *source, items, where + "box " + std::to_string(k), sum);
    compare_shared(question.boxes[0].polygon, scene, items, where, sum);
}

TEST(RelationsAgainstTwin, AdversarialBoxes) {
    const Tally tally = run_cases(0, 100000 * length / pairs_per_case, [](std::uint64_t seed, Tally& sum) {
        compare_case(naive::box_case(seed), seed,
                     "box case " + std::to_string(seed) + " of " + naive::to_text(naive::family_of(seed)) + " ", sum);
    });
    expect_no_difference(tally);
    expect_shares(tally,
                  {{"crossing", 0.1}, {"boundary", 0.01}, {"coplanar", 0.05}, {"base", 0.02}, {"disjoint", 0.1}});
    expect_shares(tally, {{"covers", 0.02}, {"does not cover", 0.1}});
    expect_shares(tally, {{"none", 0.1}, {"vertex", 0.05}, {"edge", 0.05}});
    expect_shares(tally, {{"faces", 0.1}, {"turned away", 0.1}});
    expect_shares(tally, {{"occluded", 0.05}, {"close", 0.1}, {"empty", 0.05}});
}

/// A lattice case blown up to so many bits that binary64 is just exact, or just not (geometry/grid_kernel.hpp): scaled
/// by a power of two, with some faces moved by single steps, and far from the origin by as many bits as that takes.
naive::BoxCase at_the_limit_of_bits(std::uint64_t seed) {
    naive::BoxCase question = naive::box_case(seed * naive::family_count);  // of the lattice family
    naive::Dice dice(seed);
    const double scale = std::ldexp(1.0, dice.between(16, 23)), unit = std::ldexp(1.0, dice.pick({0, -160, 120}));
    const double offset = dice.one_in(2) ? 0 : std::ldexp(1.0, dice.between(42, 47));
    Point shift;
    for (int axis = 0; axis < 3; ++axis) shift[axis] = dice.below(2) * offset;
    for (std::size_t k = 0; k < question.faces.size(); ++k) {
        const bool moved = k > 0 && dice.one_in(3);  // the first is what the boxes stand on
        for (Point& corner : question.faces[k].corners) {
            corner = scale * corner + shift;
            if (moved) corner[dice.below(3)] += dice.pick({-1.0, 0.0, 1.0});
            corner = unit * corner;
        }
    }
    for (naive::BoxQuestion& box : question.boxes)
        for (RationalPoint& corner : box.corners)
            corner = Rational(unit) * (Rational(scale) * corner + to_rational(shift));
    return question;
}

TEST(RelationsAgainstTwin, LimitsOfExactBinary64) {
    const Tally tally = run_cases(0, 15000 * length / pairs_per_case, [](std::uint64_t seed, Tally& sum) {
        compare_case(at_the_limit_of_bits(seed), seed, "limit case " + std::to_string(seed) + " ", sum);
    });
    expect_no_difference(tally);
    expect_shares(tally,
                  {{"crossing", 0.1}, {"boundary", 0.02}, {"coplanar", 0.03}, {"base", 0.02}, {"disjoint", 0.1}});
    expect_shares(tally, {{"covers", 0.01}, {"does not cover", 0.1}});
}

/// A box's question with one thing wrong with it, or nearly so.
naive::BoxQuestion spoilt(naive::BoxQuestion question, naive::Dice& dice) {
    auto& corners = question.corners;
    RationalPoint& corner = corners[static_cast<std::size_t>(dice.below(static_cast<int>(corners.size())))];
    const RationalPoint side = corners[1] - corners[0], other = corners.back() - corners[0];
    switch (dice.below(6)) {
        case 0:
            corner[dice.below(3)] += Rational(1, Integer(1) << dice.pick({1, 60, 1080}));
            break;
        case 1:
            corner = dice.any(std::vector<RationalPoint>(corners));
            break;
        case 2:
            corner = corners[0] + Rational(dice.between(1, 3), 2) * side;
            break;
        case 3:
            question.u[dice.below(3)] += Rational(1, Integer(1) << dice.pick({1, 60, 1080}));
            break;
        case 4:
            question.u = {};
            break;
        default:
            corner = corners[0] + Rational(dice.between(-2, 4), 2) * side + Rational(dice.between(-2, 4), 2) * other;
    }
    return question;
}

// SPEC 4: "corners that are not exactly coplanar and convex, or a u that is not exactly perpendicular to n, are
// refused".
TEST(RelationsAgainstTwin, SpoiltBoxesAreRefused) {
    const Tally tally = run_cases(0, 500 * length, [](std::uint64_t seed, Tally& sum) {
        naive::Dice dice(seed);
        for (const naive::BoxQuestion& question : naive::box_case(seed).boxes) {
            const naive::BoxQuestion asked = spoilt(question, dice);
            sum.compare(library_box(asked) ? "box" : "refused",
                        naive::prepare(asked).refused.empty() ? "box" : "refused", "box case " + std::to_string(seed));
            if (!naive::prepare(asked).refused.empty()) sum.count(naive::prepare(asked).refused);
        }
    });
    expect_no_difference(tally);
    expect_shares(tally, {{"box", 0.1}, {"refused", 0.1}});
    expect_shares(tally, {{"the corners are not convex", 0.1},
                          {"the corners are not coplanar", 0.05},
                          {"u is not perpendicular to the normal", 0.1},
                          {"no area or no direction", 0.1}});
}

}  // namespace
}  // namespace cob::test
