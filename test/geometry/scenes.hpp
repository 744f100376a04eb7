/// \file
/// Small scenes and boxes made by hand, for the tests and benchmarks of polygon against box.
#pragma once

#include "cob/geometry.hpp"
#include "loops.hpp"

namespace cob::test {

/// The box over an element by its corners; u is the first side.
inline BoxQuestion question_of(const Loop& element, Rational margin = Rational(1, 8),
                               Rational height = Rational(1, 4)) {
    BoxQuestion question;
    question.corners.count = static_cast<int>(element.size());
    for (std::size_t i = 0; i < element.size(); ++i) question.corners.points[i] = element[i];
    question.u = ExactPoint(to_rational(element[1]) - to_rational(element[0]));
    question.margin = margin;
    question.height = height;
    return question;
}

/// The unit square in z = 0, without margin and 1 high: the box is the unit cube.
inline Box unit_box() {
    return Box(question_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, 0, 1));
}

inline BoxAnswer answer_of(const Loop& polygon, const Box& box) {
    return relate(scene_of({polygon}), 0, box);
}

}  // namespace cob::test
