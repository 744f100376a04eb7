/// \file
/// The questions of a golden set as pure functions of scene, parameters and number, so that shards are independent.
#pragma once

#include "cob/candidates.hpp"
#include "cob/classify.hpp"
#include "cob/geometry.hpp"
#include "cob/golden.hpp"
#include "cob/scene.hpp"
#include "cob/visibility.hpp"
#include "golden/dice.hpp"
#include "golden/number_format.hpp"

#include <vector>

namespace cob {

/// A question about a box. Kind "element": a box of the meshing; else one of hard_boxes.hpp.
struct BoxTask {
    BoxQuestion question;
    const char* kind = "element";
};

/// A question about a segment. Kinds "light" (to a sample point of a light) and "surface" (to one of any element);
/// else one of hard_segments.hpp.
struct SegmentTask {
    Segment segment;
    PolygonId from = no_polygon, to = no_polygon;  ///< Polygons that the ends lie on.
    const char* kind = "surface";
};

/// An exact point of an element, strictly inside it.
struct Sample {
    ExactPoint point;
    PieceId piece = -1;
    PolygonId polygon = no_polygon;
};

/// Everything that questions are made from; immutable.
class Questions {
public:
    /// Scene and candidates must outlive it. Throws InputError where there is nothing to ask about.
    Questions(const Scene& scene, const CandidateSource& candidates, const GoldenParameters& parameters);

    std::uint64_t box_count() const { return element_boxes_ + hard_boxes_; }
    std::uint64_t segment_count() const { return parameters_.segments + hard_segments_; }
    /// number below box_count(): first the elements, in their order, then the hard ones.
    BoxTask box(std::uint64_t number) const;
    /// number below segment_count(): first those between sample points, then the hard ones.
    SegmentTask segment(std::uint64_t number) const;

    // What the makers of hard questions work with.
    const Scene& scene() const { return scene_; }
    const CandidateSource& candidates() const { return candidates_; }
    const Roots& roots() const { return roots_; }
    const ElementList& elements() const { return elements_; }
    NumberFormat format() const { return format_; }
    Rational margin() const { return Rational(parameters_.margin); }
    Rational height() const { return Rational(parameters_.height); }
    const std::vector<PolygonId>& valid_polygons() const { return valid_; }
    Sample sample(const Root& root, const Element& element, Dice& dice) const;
    Sample sample_element(Dice& dice) const;

private:
    SegmentTask sampled_segment(std::uint64_t number) const;

    const Scene& scene_;
    const CandidateSource& candidates_;
    GoldenParameters parameters_;
    NumberFormat format_;
    Roots roots_;
    ElementList elements_;
    std::vector<RootId> light_roots_;
    std::vector<PolygonId> valid_;
    std::vector<std::size_t> box_kinds_, segment_kinds_;  ///< Of hard questions, which take turns.
    std::uint64_t element_boxes_ = 0, hard_boxes_ = 0, hard_segments_ = 0;
};

}  // namespace cob
