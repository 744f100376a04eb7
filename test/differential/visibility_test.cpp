// SPEC 6: clear, grazing and blocked against the naive twin.
#include "naive/visibility.hpp"
#include "differential/run.hpp"
#include "differential/scenes.hpp"
#include "naive/dice.hpp"

#include "cob/candidates.hpp"
#include "cob/visibility.hpp"

#include <algorithm>
#include <cmath>

namespace cob::test {
namespace {

/// All segments of a case, their candidates from this source.
void compare_case(const naive::SegmentCase& question, std::uint64_t seed, Source source, const std::string& where,
                  Tally& sum) {
    const Scene scene = library_scene(question.faces, seed % 4 < 2 ? Vertices::apart : Vertices::shared);
    const auto candidates = make_candidates(scene, source);
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
        const Segment segment{ExactPoint(from), ExactPoint(to)};
        sum.compare(to_text(oracle(segment)), to_text(naive::visibility(polygons, from, to)),
                    where + " segment " + std::to_string(k));
    }
}

TEST(VisibilityAgainstTwin, AdversarialSegments) {
    const Tally tally = run_cases(0, 10000 * length / 10, [](std::uint64_t seed, Tally& sum) {
        compare_case(naive::segment_case(seed), seed, seed % 2 == 0 ? Source::all : Source::tree,
                     "segment case " + std::to_string(seed) + " of " + naive::to_text(naive::family_of(seed)), sum);
    });
    expect_no_difference(tally);
    expect_shares(tally, {{"clear", 0.1}, {"grazing", 0.1}, {"blocked", 0.1}});
}

/// A rotated lattice case, so large or small, and its ends so far off along their lines, that products leave
/// binary64's range although nothing of the question does.
naive::SegmentCase at_the_limit_of_range(std::uint64_t seed) {
    naive::SegmentCase question = naive::segment_case(seed * naive::family_count + 1);
    naive::Dice dice(seed);
    // A normal of about 2^(2 size + 4) times an end at 2^(size + far + 3).
    const int size = dice.pick({-900, 0, 120, 160, 200, 335});
    const int far = std::clamp(1017 - 3 * size + dice.between(-3, 1), 0, 660);
    const double unit = std::ldexp(1.0, size);
    for (naive::Face& face : question.faces)
        for (Point& corner : face.corners) corner = unit * corner;
    for (auto& [from, to] : question.segments) {
        const Rational farther = Rational(Integer(1) << (dice.one_in(3) ? 0 : far));
        to = Rational(unit) * (from + farther * (to - from));
        from = Rational(unit) * from;
    }
    return question;
}

/// A lattice case squeezed between two neighbouring numbers along one axis, far from the origin: half an ulp of an end
/// is as long as the scene.
naive::SegmentCase thinner_than_an_ulp(std::uint64_t seed) {
    naive::SegmentCase question = naive::segment_case(seed * naive::family_count);
    naive::Dice dice(seed);
    const int axis = dice.below(3);
    const double plane = 0x1p50, unit = std::ldexp(1.0, -dice.between(8, 12));
    std::vector<naive::Face> flat;
    for (naive::Face face : question.faces) {
        const bool in_plane = std::all_of(face.corners.begin(), face.corners.end(),
                                          [&](const Point& corner) { return corner[axis] == face.corners[0][axis]; });
        if (!in_plane) continue;
        for (Point& corner : face.corners) {
            corner = unit * corner;
            corner[axis] = plane;
        }
        flat.push_back(face);
    }
    question.faces = flat;
    for (auto& [from, to] : question.segments) {
        // Through what was an end, and far to both sides of the plane.
        RationalPoint through = Rational(unit) * from, along = Rational(unit * dice.between(1, 30)) * (to - from);
        through[axis] = plane;
        along[axis] = Rational(dice.between(-40, 40), 50);
        from = through - Rational(dice.between(1, 8), 8) * along;
        to = through + Rational(dice.between(1, 8), 8) * along;
    }
    for (naive::SegmentCase::Segment& segment : question.segments)
        if (segment.from == segment.to) segment.to[axis] += 1;
    return question;
}

TEST(VisibilityAgainstTwin, LimitsOfRange) {
    const std::vector<Source> sources{Source::all, Source::tree, Source::octree};
    const Tally tally = run_cases(0, 500 * length, [&](std::uint64_t seed, Tally& sum) {
        const naive::SegmentCase question = seed % 2 == 0 ? at_the_limit_of_range(seed) : thinner_than_an_ulp(seed);
        if (!question.faces.empty())
            compare_case(question, seed, sources[seed % 3], "range case " + std::to_string(seed), sum);
    });
    expect_no_difference(tally);
    expect_shares(tally, {{"clear", 0.1}, {"grazing", 0.05}, {"blocked", 0.1}});
}

}  // namespace
}  // namespace cob::test
