#include "cob/classify.hpp"

#include <algorithm>

namespace cob {

ClassifyStatistics& ClassifyStatistics::operator+=(const ClassifyStatistics& other) {
    for (std::size_t k = 0; k < elements.size(); ++k) elements[k] += other.elements[k];
    inherited += other.inherited;
    inherited_otherwise += other.inherited_otherwise;
    around += other.around;
    tested += other.tested;
    compared += other.compared;
    predicates += other.predicates;
    return *this;
}

ElementClassifier::ElementClassifier(const ElementList& elements, const CandidateSource& source,
                                     const ClassifyOptions& options)
    : elements_(elements), source_(source), options_(options), classifier_(elements.scene()) {}

void ElementClassifier::operator()(std::uint64_t number, ClassifiedElement& result) {
    result.element = elements_[number];
    const Root& root = elements_.root_of(result.element);
    result.question =
        box_question(elements_.scene(), root, result.element, options_.buffer.margin, options_.buffer.height);
    const Box box(result.question);

    // The buffers around it, then its own, through them.
    renew_around(number);
    const bool compared = inherits_;
    classify(box, depth_ > 0 ? &around_[depth_ - 1] : nullptr, result.found, compared);

    // What the paper's mode says without a test.
    result.inherited.reset();
    if (inherits_) {
        result.inherited = BufferState::occluded;
        ++statistics_.inherited;
        statistics_.inherited_otherwise += result.found.state != BufferState::occluded;
    }
    ++statistics_.elements[static_cast<std::size_t>(result.found.state)];
}

void ElementClassifier::renew_around(std::uint64_t number) {
    if (options_.levels == BufferLevels::element) return;
    elements_.around(number, wanted_);
    if (options_.levels == BufferLevels::polygon && wanted_.size() > 1) wanted_.resize(1);

    // Those that the element before had, too.
    std::size_t kept = 0;
    while (kept < std::min(depth_, wanted_.size()) && around_[kept].element == wanted_[kept]) ++kept;
    if (around_.size() < wanted_.size()) around_.resize(wanted_.size());

    inherits_ = false;
    for (depth_ = 0; depth_ < wanted_.size(); ++depth_) {
        Around& here = around_[depth_];
        if (depth_ >= kept) {
            here.element = wanted_[depth_];
            const Box box(box_question(elements_.scene(), elements_.root_of(here.element), here.element,
                                       options_.buffer.margin, options_.buffer.height));
            classify(box, depth_ > 0 ? &around_[depth_ - 1] : nullptr, here.found, inherits_);
            ++statistics_.around;
            here.candidates.clear();
            if (options_.relations)
                for (const Neighbour& neighbour : here.found.neighbours) here.candidates.push_back(neighbour.polygon);
            else
                here.candidates = here.found.close;
        }
        inherits_ =
            inherits_ || (options_.buffer.mode == BufferMode::inherit && here.found.state == BufferState::occluded);
    }
}

void ElementClassifier::classify(const Box& box, const Around* around, Classification& found, bool compared) {
    // Boxes nest: what meets the box of an element meets the box around it. An occluded buffer stores no polygons
    // and is only a hint (SPEC 5).
    if (around == nullptr || around->found.state == BufferState::occluded)
        classifier_.from_scene(box, source_, found);
    else
        classifier_.among(box, {around->candidates.data(), around->candidates.data() + around->candidates.size()},
                          found);
    (compared ? statistics_.compared : statistics_.tested) += found.tested;
}

ClassifyStatistics ElementClassifier::statistics() const {
    ClassifyStatistics result = statistics_;
    result.predicates = classifier_.counters();
    return result;
}

}  // namespace cob
