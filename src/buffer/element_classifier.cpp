#include "cob/classify.hpp"

#include <algorithm>

namespace cob {
namespace {

// Measured: with more polygons an element, a buffer around elements costs as much as it spares.
constexpr std::size_t most_an_element = 4;

}  // namespace

/// Whether elements are built from this buffer around them. Boxes nest: what meets the box of an element meets the box
/// around it. An occluded buffer stores no polygons and is only a hint (SPEC 5).
bool ElementClassifier::hands_down(const Around* around) const {
    return around != nullptr && around->found.state != BufferState::uninitialised &&
           around->found.state != BufferState::occluded && around->candidates.size() <= options_.buffer.longest_list;
}

ClassifyStatistics& ClassifyStatistics::operator+=(const ClassifyStatistics& other) {
    for (std::size_t k = 0; k < elements.size(); ++k) elements[k] += other.elements[k];
    inherited += other.inherited;
    inherited_otherwise += other.inherited_otherwise;
    around += other.around;
    tested += other.tested;
    compared += other.compared;
    light_tests += other.light_tests;
    predicates += other.predicates;
    return *this;
}

ElementClassifier::ElementClassifier(const ElementList& elements, const CandidateSource& source,
                                     const ClassifyOptions& options)
    : elements_(elements),
      source_(source),
      options_(options),
      classifier_(elements.scene(), options.buffer.arithmetic, options.buffer.all_lights) {}

void ElementClassifier::operator()(std::uint64_t number, ClassifiedElement& result) {
    result.element = elements_[number];
    result.inherited.reset();
    if (!options_.apart || options_.questions)
        result.question = box_question(elements_.scene(), elements_.root_of(result.element), result.element,
                                       options_.buffer.margin, options_.buffer.height);
    if (options_.apart) {
        result.found = Classification{};
        result.found.state = BufferState::empty;
        ++statistics_.elements[static_cast<std::size_t>(BufferState::empty)];
        return;
    }
    const Box box(result.question);

    // The buffers around it, then its own, through them.
    renew_around(number);
    const bool compared = inherits_;
    classify(box, depth_ > 0 ? &around_[depth_ - 1] : nullptr, result.found, compared);

    // What the paper's mode says without a test.
    if (inherits_) {
        result.inherited = BufferState::occluded;
        ++statistics_.inherited;
        statistics_.inherited_otherwise += result.found.state != BufferState::occluded;
    }
    ++statistics_.elements[static_cast<std::size_t>(result.found.state)];
}

void ElementClassifier::renew_around(std::uint64_t number) {
    if (options_.levels == BufferLevels::element) return;
    const bool strict = options_.buffer.mode == BufferMode::strict;
    if (options_.levels == BufferLevels::automatic && strict) return renew_automatic(number);
    elements_.around(number, wanted_);
    if (options_.levels != BufferLevels::tree && wanted_.size() > 1) wanted_.resize(1);

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
            const Around* const outer = depth_ > 0 ? &around_[depth_ - 1] : nullptr;
            if (strict && !hands_down(outer)) {
                // Of many polygons no list would be used, so it is not made: the buffer stays uninitialised.
                if (!classifier_.from_scene(box, source_, options_.buffer.longest_list, here.found)) {
                    here.found.state = BufferState::uninitialised;
                    continue;
                }
                statistics_.tested += here.found.tested;
            } else {
                classify(box, outer, here.found, inherits_);
            }
            ++statistics_.around;
            take_candidates(here);
        }
        inherits_ = inherits_ || (!strict && here.found.state == BufferState::occluded);
    }
}

/// A buffer around elements pays where its list is short: it is built at the price of a relation for each polygon, and
/// then every element goes through all of it, where the scene's tree would name a few.
void ElementClassifier::renew_automatic(std::uint64_t number) {
    elements_.consecutive_around(number, wanted_);
    std::size_t k = 0;
    while (k < std::min(crowded_.size(), wanted_.size()) && crowded_[k] == wanted_[k]) ++k;
    crowded_.resize(k);
    if (depth_ > 0 && k < wanted_.size() && around_[0].element == wanted_[k]) return;

    // From the outside in, the first with few polygons around.
    around_.resize(1);
    Around& here = around_[0];
    for (depth_ = 0; k < wanted_.size(); ++k) {
        const Element& element = wanted_[k];
        const Box box(box_question(elements_.scene(), elements_.root_of(element), element, options_.buffer.margin,
                                   options_.buffer.height));
        const std::uint64_t few = std::min<std::uint64_t>(options_.buffer.longest_list,
                                                          most_an_element * elements_.elements_in(number, element));
        if (classifier_.from_scene(box, source_, few, here.found)) {
            here.element = element;
            take_candidates(here);
            statistics_.tested += here.found.tested;
            ++statistics_.around;
            depth_ = 1;
            return;
        }
        crowded_.push_back(element);
    }
}

/// What a buffer hands down.
void ElementClassifier::take_candidates(Around& around) const {
    around.candidates.clear();
    if (options_.relations)
        for (const Neighbour& neighbour : around.found.neighbours) around.candidates.push_back(neighbour.polygon);
    else
        around.candidates = around.found.close;
}

void ElementClassifier::classify(const Box& box, const Around* around, Classification& found, bool compared) {
    if (!hands_down(around))
        classifier_.from_scene(box, source_, found);
    else
        classifier_.among(box, {around->candidates.data(), around->candidates.data() + around->candidates.size()},
                          found);
    (compared ? statistics_.compared : statistics_.tested) += found.tested;
}

ClassifyStatistics ElementClassifier::statistics() const {
    ClassifyStatistics result = statistics_;
    result.predicates = classifier_.counters();
    result.light_tests = classifier_.light_tests();
    return result;
}

}  // namespace cob
