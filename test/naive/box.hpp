/// \file
/// The naive twin of SPEC 4 and 5: the relation of a polygon to a box by clipping the one with the other.
#pragma once

#include "naive/polygon.hpp"
#include "naive/surd.hpp"

#include <string>
#include <vector>

namespace cob::naive {

/// A box as a row of boxes.csv asks for it.
struct BoxQuestion {
    int polygon = -1;                    ///< Own polygon, -1: none.
    std::vector<RationalPoint> corners;  ///< Of the element, three or four.
    RationalPoint u;
    Rational margin, height;
};

/// The box in its own unscaled frame: p has the coordinates u . (p - origin), w . (p - origin), n . (p - origin).
struct Box {
    std::string refused;  ///< Why SPEC 4 refuses it; empty: it does not.
    std::vector<RationalPoint> corners;
    RationalPoint origin, u, w, n;
    Rational low_u, high_u, low_w, high_w;
    Rational top_squared;  ///< The square of the top's third coordinate.
};

Box prepare(const BoxQuestion& question);

enum class Relation { disjoint, base, coplanar, boundary, crossing };
enum class Shared { none, vertex, edge };
const char* to_text(Relation relation);
const char* to_text(Shared shared);

/// What a polygon is to a box.
struct Answer {
    Relation relation = Relation::disjoint;
    bool covers = false;
    bool lights_it = false;  ///< A close light that faces the element; only from relate_all().
    bool close() const { return relation == Relation::crossing || relation == Relation::boundary; }
};
Answer relate(const Polygon& polygon, const Box& box);
Shared shared(const Polygon& a, const Polygon& b);
bool faces(const Polygon& light, const Box& box);

/// A polygon of a scene.
struct SceneItem {
    Polygon polygon;
    bool emits = false;
};

/// Every polygon of a scene; disjoint for the own polygon and for refused ones.
std::vector<Answer> relate_all(const std::vector<SceneItem>& scene, int own_polygon, const Box& box);

/// The buffer of a box built from the whole scene (SPEC 5).
struct State {
    const char* name = "empty";            ///< occluded, close or empty.
    std::vector<int> close, cover, light;  ///< Ascending polygon numbers, as in states.csv.
};
State state(const std::vector<Answer>& answers);

}  // namespace cob::naive
