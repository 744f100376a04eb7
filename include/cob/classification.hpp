/// \file
/// What SPEC section 5 says of one box: the polygons around it, and the state of a buffer built from them.
#pragma once

#include "cob/candidates.hpp"
#include "cob/geometry.hpp"
#include "cob/scene.hpp"

#include <cstdint>
#include <vector>

namespace cob {

/// State of the buffer of one element.
enum class BufferState : std::uint8_t { uninitialised, empty, close, occluded };
const char* to_text(BufferState state);

/// A polygon that is not disjoint from a box; in Arithmetic::interval also one that may be so.
struct Neighbour {
    PolygonId polygon = no_polygon;
    BoxAnswer answer;
};

/// One box among its candidates. All lists ascend by polygon.
struct Classification {
    BufferState state = BufferState::uninitialised;
    bool decided = true;                ///< False only in Arithmetic::interval: state and lists may be wrong.
    std::vector<Neighbour> neighbours;  ///< All candidates but the disjoint ones.
    std::vector<PolygonId> close;       ///< Crossing or boundary, also where the state is occluded.
    std::vector<PolygonId> cover;       ///< Those of close that cover the element.
    std::vector<PolygonId> light;       ///< Those of close that are lights and face the element.
    std::uint64_t tested = 0;  ///< Candidates whose bounds meet those of the box: their relation was evaluated.
};

/// Classifies boxes one after another, reusing its memory. One thread each.
class BoxClassifier {
public:
    /// The scene must outlive it. all_lights: test every light of the scene for facing every box, not only those that
    /// are close to it; same answers, more time.
    explicit BoxClassifier(const Scene& scene, Arithmetic arithmetic = Arithmetic::exact, bool all_lights = false);

    /// From the whole scene: every polygon that the source names. Fills the result anew.
    void from_scene(const Box& box, const CandidateSource& source, Classification& result);
    /// The same unless the source names more than so many polygons: then false, and the result is left as it is.
    bool from_scene(const Box& box, const CandidateSource& source, std::size_t most, Classification& result);
    /// Among the given polygons, ascending, which must hold all that are not disjoint (or, where only the state and
    /// its lists are wanted, all that are close). Fills the result anew; candidates may be lists of another result.
    void among(const Box& box, View<PolygonId> candidates, Classification& result);

    const PredicateCounters& counters() const { return counters_; }
    /// Facing tests made so far.
    std::uint64_t light_tests() const { return light_tests_; }

private:
    void begin(const Box& box, Classification& result);
    void test(const Box& box, PolygonId polygon, Classification& result);
    bool faces(PolygonId light, const Box& box);
    bool bounds_meet(PolygonId polygon, const std::array<double, 6>& bounds) const;

    const Scene& scene_;
    Arithmetic arithmetic_;
    bool all_lights_;
    PredicateCounters counters_;
    std::uint64_t light_tests_ = 0;
    std::vector<PolygonId> candidates_;
    std::vector<PolygonId> lights_, facing_;  ///< Of the whole scene, and of these those that face the box.
};

}  // namespace cob
