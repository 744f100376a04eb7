#include "golden/questions.hpp"

#include "cob/error.hpp"
#include "golden/hard_boxes.hpp"
#include "golden/hard_segments.hpp"
#include "golden/parameters.hpp"
#include "golden/snap.hpp"

#include <algorithm>

namespace cob {

namespace {

/// Streams of the dice: one for each way to make a question.
enum Stream : std::uint64_t { sampled_segments, hard_box_stream, hard_segment_stream };

/// What a snapped set promises of every question.
void require_fit(bool fit, const char* what, std::uint64_t number) {
    if (!fit)
        throw std::logic_error(std::string(what) + " " + std::to_string(number) + " of a snapped set does not fit");
}

bool is_in(const std::string& name, const std::vector<std::string>& names) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

/// Indices of the kinds that are wanted: all where none is named.
std::vector<std::size_t> chosen(const std::vector<std::string>& kinds, const std::vector<std::string>& wanted) {
    std::vector<std::size_t> indices;
    for (std::size_t k = 0; k < kinds.size(); ++k)
        if (wanted.empty() || is_in(kinds[k], wanted)) indices.push_back(k);
    return indices;
}

void refuse_unknown_kinds(const std::vector<std::string>& wanted) {
    std::vector<std::string> known = hard_box_kinds();
    for (const std::string& name : hard_segment_kinds())
        if (!is_in(name, known)) known.push_back(name);
    std::string list;
    for (const std::string& name : known) list += (list.empty() ? "" : ", ") + name;
    for (const std::string& name : wanted)
        if (!is_in(name, known))
            throw InputError("unknown kind of hard questions", {"", 0, name, "choose from " + list});
}

}  // namespace

Questions::Questions(const Scene& scene, const CandidateSource& candidates, const GoldenParameters& parameters)
    : scene_(scene),
      candidates_(candidates),
      parameters_(parameters),
      format_(format_of(parameters)),
      roots_(scene),
      elements_(scene, roots_, {parameters.edge.value_or(0), parameters.level}) {
    for (PolygonId id = 0; id < scene.polygon_count(); ++id) {
        if (!scene.polygon(id).valid) continue;
        valid_.push_back(id);
        if (!scene.is_light(id)) continue;
        for (auto [root, last] = roots_.of(id); root < last; ++root) light_roots_.push_back(root);
    }
    if (elements_.size() == 0) throw InputError("no valid polygon", {scene.name(), 0, "", "choose another scene"});
    element_boxes_ = parameters.boxes ? elements_.size() : 0;
    refuse_unknown_kinds(parameters.kinds);
    box_kinds_ = chosen(hard_box_kinds(), parameters.kinds);
    segment_kinds_ = chosen(hard_segment_kinds(), parameters.kinds);
    hard_boxes_ = box_kinds_.empty() ? 0 : parameters.hard;
    hard_segments_ = segment_kinds_.empty() ? 0 : parameters.hard;
}

BoxTask Questions::box(std::uint64_t number) const {
    BoxTask task;
    if (number < element_boxes_) {
        const Element element = elements_[number];
        task.question = box_question(scene_, roots_[element.root], element, margin(), height());
    } else {
        const std::uint64_t hard = number - element_boxes_;
        task = hard_box(*this, box_kinds_[hard % box_kinds_.size()], Dice(parameters_.seed, hard_box_stream, hard));
    }
    require_fit(fits(task.question, format_), "box", number);
    return task;
}

SegmentTask Questions::segment(std::uint64_t number) const {
    SegmentTask task;
    if (number < parameters_.segments) {
        task = sampled_segment(number);
    } else {
        const std::uint64_t hard = number - parameters_.segments;
        task = hard_segment(*this, segment_kinds_[hard % segment_kinds_.size()],
                            Dice(parameters_.seed, hard_segment_stream, hard));
    }
    require_fit(fits(task.segment.from, format_) && fits(task.segment.to, format_), "segment", number);
    return task;
}

Sample Questions::sample(const Root& root, const Element& element, Dice& dice) const {
    const std::uint64_t steps = std::uint64_t{1} << sample_bits(format_);
    std::uint64_t s = 1 + dice.below(steps - 1), t = 1 + dice.below(steps - 1);
    if (root.corner_count() == 3 && s + t >= steps) {
        // The other half of the square is the triangle turned over; on its long side, the point is pushed inside.
        s = steps - s, t = steps - t;
        if (s + t == steps) --(s > 1 ? s : t);
    }
    const double step = 1.0 / static_cast<double>(steps);
    return {point_in(scene_, root, element, static_cast<double>(s) * step, static_cast<double>(t) * step), root.piece,
            root.polygon};
}

Sample Questions::sample_element(Dice& dice) const {
    const Element element = elements_[dice.below(elements_.size())];
    return sample(roots_[element.root], element, dice);
}

/// From an element to a light (every other one, where there are lights) or to another element.
SegmentTask Questions::sampled_segment(std::uint64_t number) const {
    Dice dice(parameters_.seed, sampled_segments, number);
    const bool to_light = number % 2 == 0 && !light_roots_.empty();
    Sample from, to;
    // Mostly between different polygons: within one plane every answer is the same.
    for (int attempt = 0; attempt < 64; ++attempt) {
        from = sample_element(dice);
        if (to_light) {
            const Root& root = roots_[dice.of(light_roots_)];
            to = sample(root, root_element(root.id), dice);
        } else {
            to = sample_element(dice);
        }
        if (from.polygon != to.polygon) break;
    }
    if (from.point == to.point)
        throw InputError("too few sample points for segments",
                         {scene_.name(), 0, "", "choose a scene of more polygons"});
    return {{from.point, to.point, from.piece, to.piece}, from.polygon, to.polygon, to_light ? "light" : "surface"};
}

}  // namespace cob
