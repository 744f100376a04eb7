// What SPEC 6 says of several segments or scenes at once, without the naive twin.
#include "differential/run.hpp"
#include "differential/scenes.hpp"
#include "naive/dice.hpp"
#include "naive/visibility.hpp"

#include "cob/candidates.hpp"
#include "cob/visibility.hpp"

#include <algorithm>

namespace cob::test {
namespace {

using naive::Dice;

/// A scene, ready for segments.
class Prepared {
public:
    explicit Prepared(const std::vector<naive::Face>& faces)
        : scene_(library_scene(faces, Vertices::shared)),
          source_(make_candidates(scene_, Source::all)),
          oracle_(scene_, *source_) {}

    Visibility operator()(const RationalPoint& from, const RationalPoint& to) const {
        return oracle_({ExactPoint(from), ExactPoint(to)});
    }
    const Scene& scene() const { return scene_; }
    const VisibilityOracle& oracle() const { return oracle_; }

private:
    Scene scene_;
    std::unique_ptr<CandidateSource> source_;
    VisibilityOracle oracle_;
};

std::string name_of(std::uint64_t seed, std::size_t segment) {
    return "segment case " + std::to_string(seed) + " segment " + std::to_string(segment);
}

/// Runs a check on every segment of many cases.
template <class Check>
Tally over_segments(std::uint64_t first, Check check) {
    return run_cases(first, 200 * length, [&](std::uint64_t seed, Tally& sum) {
        const naive::SegmentCase question = naive::segment_case(seed);
        const Prepared scene(question.faces);
        for (std::size_t k = 0; k < question.segments.size(); ++k)
            check(scene, question, question.segments[k], name_of(seed, k), sum);
    });
}

// "Blocked is stable: so is every segment whose ends are near enough." Near: 2^-4000 of the segment's extent, less
// than anything that the coordinates of any family can put between two answers.
TEST(Metamorphic, BlockedSurvivesSmallPerturbations) {
    const Tally tally =
        over_segments(1000000, [](const Prepared& scene, const naive::SegmentCase&,
                                  const naive::SegmentCase::Segment& s, const std::string& where, Tally& sum) {
            const Visibility before = scene(s.from, s.to);
            sum.count(to_text(before));
            if (before != Visibility::blocked) return;
            const RationalPoint along = s.to - s.from;
            const Rational extent = std::max({abs(along.x), abs(along.y), abs(along.z)});
            Dice dice(static_cast<std::uint64_t>(where.size()) + sum.counts["blocked"]);
            const auto near = [&](const RationalPoint& point) {
                const Rational step = extent / Rational(Integer(1) << 4000);
                return point + RationalPoint{dice.between(-3, 3) * step, dice.between(-3, 3) * step,
                                             dice.between(-3, 3) * step};
            };
            for (int k = 0; k < 4; ++k) sum.compare(to_text(scene(near(s.from), near(s.to))), "blocked", where);
        });
    expect_no_difference(tally);
    expect_shares(tally, {{"clear", 0.1}, {"grazing", 0.1}, {"blocked", 0.1}});
}

// "Adding a polygon never turns blocked into grazing", and never makes a segment clearer in any other way.
TEST(Metamorphic, AddingPolygonsNeverClears) {
    const Tally tally = run_cases(2000000, 300 * length, [](std::uint64_t seed, Tally& sum) {
        const naive::SegmentCase question = naive::segment_case(seed);
        std::vector<naive::Face> faces = question.faces;
        std::vector<Visibility> before(question.segments.size(), Visibility::clear);
        // From the last polygon to all of them: what is added comes before and beside what was there.
        for (std::size_t first = faces.size(); first-- > 0;) {
            const Prepared scene({faces.begin() + static_cast<std::ptrdiff_t>(first), faces.end()});
            for (std::size_t k = 0; k < before.size(); ++k) {
                const Visibility now = scene(question.segments[k].from, question.segments[k].to);
                sum.compare(now >= before[k] ? "as blocked" : to_text(now), "as blocked",
                            name_of(seed, k) + " from polygon " + std::to_string(first));
                if (now != before[k]) sum.count(std::string(to_text(before[k])) + " to " + to_text(now));
                before[k] = now;
            }
        }
    });
    expect_no_difference(tally);
    expect_shares(tally, {{"clear to grazing", 0.1}, {"clear to blocked", 0.1}, {"grazing to blocked", 0.05}});
}

// A segment has no direction, a polygon is opaque from both sides, its pieces are polygons themselves, the union has
// no order; and hints spare arithmetic, nothing else.
TEST(Metamorphic, WhatMustNotMatterDoesNot) {
    const auto answers_as = [](const Prepared& scene, const naive::SegmentCase::Segment& s, Visibility expected,
                               const std::string& what,
                               Tally& sum) { sum.compare(to_text(scene(s.from, s.to)), to_text(expected), what); };
    const Tally tally = run_cases(3000000, 200 * length, [&](std::uint64_t seed, Tally& sum) {
        const naive::SegmentCase question = naive::segment_case(seed);
        const Prepared scene(question.faces);
        std::vector<naive::Face> turned(question.faces.rbegin(), question.faces.rend()), split, doubled = turned;
        // A loop that is not planar may be cut otherwise from its other end: "the first vertex" is another one.
        for (naive::Face& face : turned)
            if (naive::prepare(face.corners).planar) std::reverse(face.corners.begin(), face.corners.end());
        for (const Piece& piece : scene.scene().pieces()) {
            naive::Face part;
            for (const VertexId corner : scene.scene().corners(piece))
                part.corners.push_back(scene.scene().position(corner));
            split.push_back(part);
        }
        doubled.insert(doubled.end(), turned.begin(), turned.end());
        const Prepared turned_scene(turned), split_scene(split), doubled_scene(doubled);
        for (std::size_t k = 0; k < question.segments.size(); ++k) {
            const auto& s = question.segments[k];
            const Visibility expected = scene(s.from, s.to);
            const std::string where = name_of(seed, k);
            answers_as(scene, {s.to, s.from}, expected, where + " backwards", sum);
            answers_as(turned_scene, s, expected, where + " with turned polygons", sum);
            answers_as(split_scene, s, expected, where + " with pieces for polygons", sum);
            answers_as(doubled_scene, s, expected, where + " with doubled polygons", sum);
            Segment hinted{ExactPoint(s.from), ExactPoint(s.to)};
            for (PieceId id = 0; id < static_cast<PieceId>(scene.scene().pieces().size()); ++id) {
                naive::Piece piece;
                for (const VertexId corner : scene.scene().corners(scene.scene().piece(id)))
                    piece.corners.push_back(to_rational(scene.scene().position(corner)));
                piece.normal = naive::newell(piece.corners);
                if (naive::lies_on(s.from, piece)) hinted.from_piece = id;
                if (naive::lies_on(s.to, piece)) hinted.to_piece = id;
            }
            if (hinted.from_piece < 0 && hinted.to_piece < 0) continue;
            sum.count("hinted");
            sum.compare(to_text(scene.oracle()(hinted)), to_text(expected), where + " with hints");
        }
    });
    expect_no_difference(tally);
    expect_shares(tally, {{"clear", 0.1}, {"grazing", 0.1}, {"blocked", 0.1}});
    expect_shares(tally, {{"hinted", 0.02}, {"clear", 0.1}});
}

}  // namespace
}  // namespace cob::test
