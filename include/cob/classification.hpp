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
    /// The scene must outlive it.
    explicit BoxClassifier(const Scene& scene, Arithmetic arithmetic = Arithmetic::exact)
        : scene_(scene), arithmetic_(arithmetic) {}

    /// From the whole scene: every polygon that the source names. Fills the result anew.
    void from_scene(const Box& box, const CandidateSource& source, Classification& result);
    /// The same unless the source names more than so many polygons: then false, and the result is left as it is.
    bool from_scene(const Box& box, const CandidateSource& source, std::size_t most, Classification& result);
    /// Among the given polygons, ascending, which must hold all that are not disjoint (or, where only the state and
    /// its lists are wanted, all that are close). Fills the result anew; candidates may be lists of another result.
    void among(const Box& box, View<PolygonId> candidates, Classification& result);

    const PredicateCounters& counters() const { return counters_; }

private:
    void test(const Box& box, PolygonId polygon, Classification& result);
    bool bounds_meet(PolygonId polygon, const std::array<double, 6>& bounds) const;

    const Scene& scene_;
    Arithmetic arithmetic_;
    PredicateCounters counters_;
    std::vector<PolygonId> candidates_;
};

}  // namespace cob
