#include "cob/classification.hpp"

#include "cob/buffer.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace cob {

const char* to_text(BufferMode mode) {
    return mode == BufferMode::strict ? "strict" : "inherit";
}

const char* to_text(BufferLevels levels) {
    switch (levels) {
        case BufferLevels::element:
            return "element";
        case BufferLevels::polygon:
            return "polygon";
        case BufferLevels::tree:
            return "tree";
        case BufferLevels::automatic:
            return "auto";
    }
    return "";
}

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

namespace {

/// A cover shuts the element out unless a close light shines under it (paper, figures 4 and 6).
BufferState state_of(const Classification& result) {
    if (!result.cover.empty() && result.light.empty()) return BufferState::occluded;
    return result.close.empty() ? BufferState::empty : BufferState::close;
}

}  // namespace

BoxClassifier::BoxClassifier(const Scene& scene, Arithmetic arithmetic, bool all_lights)
    : scene_(scene), arithmetic_(arithmetic), all_lights_(all_lights) {
    for (PolygonId p = 0; all_lights && p < scene.polygon_count(); ++p)
        if (scene.is_light(p)) lights_.push_back(p);
}

void BoxClassifier::from_scene(const Box& box, const CandidateSource& source, Classification& result) {
    from_scene(box, source, std::numeric_limits<std::size_t>::max(), result);
}

bool BoxClassifier::from_scene(const Box& box, const CandidateSource& source, std::size_t most,
                               Classification& result) {
    struct Collector {
        std::vector<PolygonId>& candidates;
        std::size_t most;
    } collector{candidates_, most};
    candidates_.clear();
    source.polygons_in(box.bounds(), {&collector, [](void* context, std::int32_t id) {
                                          const Collector& to = *static_cast<const Collector*>(context);
                                          to.candidates.push_back(id);
                                          return to.candidates.size() <= to.most;
                                      }});
    if (candidates_.size() > most) return false;

    // A tree names them in an order of its own.
    std::sort(candidates_.begin(), candidates_.end());
    begin(box, result);
    for (const PolygonId polygon : candidates_) test(box, polygon, result);
    result.state = state_of(result);
    return true;
}

void BoxClassifier::among(const Box& box, View<PolygonId> candidates, Classification& result) {
    begin(box, result);
    for (const PolygonId polygon : candidates)
        if (bounds_meet(polygon, box.bounds())) test(box, polygon, result);
    result.state = state_of(result);
}

bool BoxClassifier::bounds_meet(PolygonId polygon, const std::array<double, 6>& bounds) const {
    for (int axis = 0; axis < 3; ++axis) {
        const double low = bounds[static_cast<std::size_t>(axis)], high = bounds[static_cast<std::size_t>(axis) + 3];
        bool all_below = true, all_above = true;
        for (const VertexId vertex : scene_.loop(polygon)) {
            const double at = scene_.position(vertex)[axis];
            all_below = all_below && at < low;
            all_above = all_above && at > high;
        }
        if (all_below || all_above) return false;
    }
    return true;
}

void BoxClassifier::begin(const Box& box, Classification& result) {
    result.decided = true;
    result.neighbours.clear();
    result.close.clear();
    result.cover.clear();
    result.light.clear();
    result.tested = 0;
    facing_.clear();
    for (const PolygonId light : lights_)
        if (cob::faces(scene_, light, box, &counters_)) facing_.push_back(light);
    light_tests_ += lights_.size();
}

/// Whether a close light faces the element.
bool BoxClassifier::faces(PolygonId light, const Box& box) {
    if (all_lights_) return std::binary_search(facing_.begin(), facing_.end(), light);
    ++light_tests_;
    return cob::faces(scene_, light, box, &counters_);
}

void BoxClassifier::test(const Box& box, PolygonId polygon, Classification& result) {
    if (polygon == box.polygon()) return;  // it is never in its own buffer
    ++result.tested;
    const BoxAnswer answer = relate(scene_, polygon, box, arithmetic_, &counters_);
    result.decided = result.decided && answer.decided;
    if (answer.relation == Relation::disjoint && answer.decided) return;
    result.neighbours.push_back({polygon, answer});
    if (!is_close(answer.relation)) return;
    result.close.push_back(polygon);
    if (answer.covers) result.cover.push_back(polygon);
    if (scene_.is_light(polygon) && faces(polygon, box)) result.light.push_back(polygon);
}

}  // namespace cob
