#include "cob/classification.hpp"

#include <algorithm>

namespace cob {

const char* to_text(BufferState state) {
    switch (state) {
        case BufferState::uninitialised:
            return "uninitialised";
        case BufferState::empty:
            return "empty";
        case BufferState::close:
            return "close";
        case BufferState::occluded:
            return "occluded";
    }
    return "";
}

void BoxClassifier::from_scene(const Box& box, const CandidateSource& source, Classification& result) {
    candidates_.clear();
    source.polygons_in(box.bounds(), {&candidates_, [](void* context, std::int32_t id) {
                                          static_cast<std::vector<PolygonId>*>(context)->push_back(id);
                                          return true;
                                      }});
    // A tree names them in an order of its own.
    std::sort(candidates_.begin(), candidates_.end());
    among(box, {candidates_.data(), candidates_.data() + candidates_.size()}, result);
}

void BoxClassifier::among(const Box& box, View<PolygonId> candidates, Classification& result) {
    result.decided = true;
    result.neighbours.clear();
    result.close.clear();
    result.cover.clear();
    result.light.clear();
    result.tested = 0;

    // Relations, of all but the own polygon: it is never in the buffer.
    for (const PolygonId polygon : candidates) {
        if (polygon == box.polygon()) continue;
        ++result.tested;
        const BoxAnswer answer = relate(scene_, polygon, box, arithmetic_, &counters_);
        result.decided = result.decided && answer.decided;
        if (answer.relation == Relation::disjoint && answer.decided) continue;
        result.neighbours.push_back({polygon, answer});
        if (!is_close(answer.relation)) continue;
        result.close.push_back(polygon);
        if (answer.covers) result.cover.push_back(polygon);
        if (scene_.is_light(polygon) && faces(scene_, polygon, box, &counters_)) result.light.push_back(polygon);
    }

    // State: a cover shuts the element out unless a close light shines under it (paper, section 5).
    if (!result.cover.empty() && result.light.empty())
        result.state = BufferState::occluded;
    else
        result.state = result.close.empty() ? BufferState::empty : BufferState::close;
}

}  // namespace cob
