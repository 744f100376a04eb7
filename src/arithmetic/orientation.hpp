/// \file
/// Exact signs of the orientation determinants of binary64 points, for any finite coordinates (SPEC 1). A
/// semi-static filter in binary64 first; where it cannot tell, fractions.
#pragma once

#include "cob/arithmetic.hpp"

namespace cob {

/// A point of a plane: exactly these coordinates.
struct Point2 {
    double x = 0, y = 0;
    friend bool operator==(const Point2& a, const Point2& b) { return a.x == b.x && a.y == b.y; }
    friend bool operator!=(const Point2& a, const Point2& b) { return !(a == b); }
};

/// Sign of det(b - a, c - a): positive where a, b, c turn left.
Sign orientation(const Point2& a, const Point2& b, const Point2& c);

/// Sign of det(b - a, c - a, d - a): positive where d lies on the side of the plane a, b, c from which these run
/// counter-clockwise.
Sign orientation(const Point& a, const Point& b, const Point& c, const Point& d);

/// Of three points on one line, a != b and b != c: true where the way a, b, c turns back at b. Needs no
/// arithmetic: along an axis on which a and b differ, the two steps have one sign or two.
inline bool turns_back(const Point2& a, const Point2& b, const Point2& c) {
    if (a.x != b.x) return (a.x < b.x) != (b.x < c.x);
    return (a.y < b.y) != (b.y < c.y);
}

}  // namespace cob
