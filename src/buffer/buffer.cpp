#include "cob/buffer.hpp"

#include "buffer/list_pool.hpp"

#include <algorithm>

namespace cob {

BufferStatistics& BufferStatistics::operator+=(const BufferStatistics& other) {
    for (std::size_t k = 0; k < built.size(); ++k) built[k] += other.built[k];
    inherited += other.inherited;
    from_scene += other.from_scene;
    tested += other.tested;
    light_tests += other.light_tests;
    predicates += other.predicates;
    return *this;
}

BufferBuilder::BufferBuilder(const Scene& scene, const Roots& roots, const CandidateSource& source,
                             BufferOptions options)
    : scene_(scene), roots_(roots), source_(source), options_(std::move(options)), pool_(std::make_unique<Pool>()) {}

BufferBuilder::~BufferBuilder() = default;

CloseObjectBuffer BufferBuilder::build(const Element& element, BufferStatistics* statistics) {
    return build(element, CloseObjectBuffer{}, statistics);
}

CloseObjectBuffer BufferBuilder::build(const Element& element, CloseObjectBuffer parent, BufferStatistics* statistics) {
    // 1. Where the parent decides: boxes nest, so around an empty one nothing is close to its elements either.
    const bool occluded = parent.state() == BufferState::occluded;
    if (parent.state() == BufferState::empty || (occluded && options_.mode == BufferMode::inherit)) {
        if (statistics != nullptr) {
            ++statistics->built[static_cast<std::size_t>(parent.state())];
            ++statistics->inherited;
        }
        return parent;
    }

    // 2. From the parent's list, or from the whole scene where it has none or a long one.
    const Box box(box_question(scene_, roots_[element.root], element, options_.margin, options_.height));
    BoxClassifier classifier(scene_, options_.arithmetic, options_.all_lights);
    Classification found;
    const bool listed = parent.state() == BufferState::close && polygons(parent).size() <= options_.longest_list;
    if (listed)
        classifier.among(box, polygons(parent), found);
    else
        classifier.from_scene(box, source_, found);
    if (statistics != nullptr) {
        ++statistics->built[static_cast<std::size_t>(found.state)];
        statistics->from_scene += listed ? 0 : 1;
        statistics->tested += found.tested;
        statistics->light_tests += classifier.light_tests();
        statistics->predicates += classifier.counters();
    }
    return keep(found, parent);
}

CloseObjectBuffer BufferBuilder::keep(const Classification& classification, CloseObjectBuffer parent) {
    const bool lists = classification.state == BufferState::close;
    const std::vector<PolygonId>& close = classification.close;
    // Boxes nest, so of a list as long as the parent's nothing is missing.
    if (lists && parent.state() == BufferState::close && polygons(parent).size() == close.size()) return parent;
    const std::uint32_t place = lists ? pool_->store({close.data(), close.data() + close.size()}) : 0;
    CloseObjectBuffer buffer;
    buffer.packed_ = place << 2 | static_cast<std::uint32_t>(classification.state);
    return buffer;
}

View<PolygonId> BufferBuilder::polygons(CloseObjectBuffer buffer) const {
    return pool_->list(buffer.packed_ >> 2);
}

std::size_t BufferBuilder::list_bytes() const {
    return pool_->bytes();
}

}  // namespace cob
