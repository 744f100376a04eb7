/// \file
/// Exact orientation of points: the sign of a determinant, decided in binary64 where an error bound allows it,
/// else in fixed-width integers, else in fractions.
#pragma once

#include "cob/arithmetic.hpp"

namespace cob {

/// Which arithmetic decided.
enum class Stage : std::uint8_t { filter, integer, rational };

/// A point of a plane: exactly these coordinates.
struct Point2 {
    double x = 0, y = 0;
    friend bool operator==(const Point2& a, const Point2& b) { return a.x == b.x && a.y == b.y; }
    friend bool operator!=(const Point2& a, const Point2& b) { return !(a == b); }
};

/// Sign of det(b - a, c - a): positive where a, b, c turn left. Right for any finite coordinates (SPEC 1), as are
/// all of these. stage, where given, says what decided.
Sign orientation(const Point2& a, const Point2& b, const Point2& c, Stage* stage = nullptr);
/// The same of exact points, seen in the plane of the coordinates `first` and `second`.
Sign orientation_seen(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c, int first, int second,
                      Stage* stage = nullptr);

/// Sign of det(b - a, c - a, d - a): positive where d lies on the side of the plane a, b, c from which these run
/// counter-clockwise; zero where the four are coplanar.
Sign orientation(const Point& a, const Point& b, const Point& c, const Point& d, Stage* stage = nullptr);
Sign orientation(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c, const ExactPoint& d,
                 Stage* stage = nullptr);
Sign orientation(const RationalPoint& a, const RationalPoint& b, const RationalPoint& c, const RationalPoint& d);

/// Sign of det(b - a, c - a, direction): zero where the direction is parallel to the plane of a, b and c. Made for
/// directions that usually are: goes to integers at once.
Sign orientation_of_direction(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c,
                              const ExactPoint& direction);

/// The three points lie on one line (or coincide).
bool collinear(const Point& a, const Point& b, const Point& c);

/// Of three points on one line, a != b and b != c: true where the way a, b, c turns back at b. Needs no
/// arithmetic: along an axis on which a and b differ, the two steps have one sign or two.
inline bool turns_back(const Point2& a, const Point2& b, const Point2& c) {
    if (a.x != b.x) return (a.x < b.x) != (b.x < c.x);
    return (a.y < b.y) != (b.y < c.y);
}

}  // namespace cob
