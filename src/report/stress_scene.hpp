/// \file
/// A small scene in code with questions about it, and answers in any arithmetic.
#pragma once

#include "cob/candidates.hpp"
#include "cob/geometry.hpp"
#include "cob/visibility.hpp"

#include <functional>
#include <vector>

namespace cob::stress {

using Loop = std::vector<Point>;

/// Polygons of one grey material; those listed as lights emit 1 W/m2. Every corner is a vertex of its own.
struct Shapes {
    std::vector<Loop> loops;
    std::vector<PolygonId> lights;
};
Scene scene_of(const Shapes& shapes, double reflectance = 0.5);

/// The same with every coordinate sent through a function.
Shapes mapped(Shapes shapes, const std::function<Point(const Point&)>& map);

/// Integer coordinates with every kind of contact: a floor, a wall on its side, a block that stands on it, a sheet on
/// it, sheets low above it, a tilted triangle through a corner, an L, a light.
Shapes still_life();

struct Questions {
    std::vector<BoxQuestion> boxes;
    std::vector<Segment> segments;
};

/// Boxes over the patches of every root after `level` refinements, at most so many; segments between centroids and
/// corners of elements, which see each other along edges and through corners, at most so many.
Questions ask(const Scene& scene, int level, const Rational& margin, const Rational& height, std::size_t boxes,
              std::size_t segments);

struct Answers {
    std::vector<BoxAnswer> relations;  ///< Box by box, every polygon but the box's own.
    std::vector<Visibility> visibility;
    PredicateCounters predicates;
};
Answers answer(const Scene& scene, const Questions& questions, Arithmetic arithmetic, Source source);

}  // namespace cob::stress
