/// \file
/// A box and the polygons around it in the box's own coordinates, in plain fractions: for words, not for speed.
#pragma once

#include "cob/geometry.hpp"
#include "cob/scene.hpp"

#include <vector>

namespace cob {

/// A point in the coordinates of a box: a and b run from 0 to 1 across the widened rectangle, along u and along w; z
/// is n . (point - corner 0), the height over the element's plane times |n|.
struct BoxPoint {
    Rational a, b, z;
};

/// The box of SPEC 4, exactly.
class BoxCoordinates {
public:
    explicit BoxCoordinates(const BoxQuestion& question);

    BoxPoint operator()(const RationalPoint& point) const;
    /// z/h, squared and with the sign of z: 1 is the top, whose height is irrational in general.
    Rational signed_square_height(const Rational& z) const { return z.sign() * z * z / top_squared_; }

    const RationalPoint& u() const { return u_; }  ///< Base-edge direction.
    const RationalPoint& w() const { return w_; }  ///< n x u.
    const RationalPoint& n() const { return n_; }  ///< Normal.
    Rational extent_squared_u() const;             ///< Length of the widened rectangle along u, squared.
    Rational extent_squared_w() const;             ///< And along w.
    const Rational& height_squared() const { return height_squared_; }
    /// A corner of the widened rectangle: a and b are 0 or 1.
    RationalPoint base_corner(int a, int b) const;

private:
    RationalPoint origin_, u_, w_, n_;
    Rational first_u_, width_u_;  ///< u . (point - origin) at a = 0, and from there to a = 1.
    Rational first_w_, width_w_;
    Rational height_squared_;  ///< h^2.
    Rational top_squared_;     ///< (h |n|)^2.
};

/// What of a piece lies over (or under) the closed base rectangle: its corners, none where nothing does.
struct PieceOverBase {
    PieceId piece = -1;
    std::vector<BoxPoint> corners;  ///< In order around it; fewer than three where it only touches.
    bool over_interior = false;     ///< Some of it lies over the open rectangle.
    Rational lowest, highest;       ///< Of z, where there are corners.
    Rational area;                  ///< Of its projection, as a share of the rectangle.
};
PieceOverBase clip_to_base(const Scene& scene, PieceId piece, const BoxCoordinates& box);

/// SPEC 5 straight from its words, for one polygon.
Relation relation_in_words(const Scene& scene, PolygonId polygon, const BoxCoordinates& box,
                           const std::vector<PieceOverBase>& pieces);

}  // namespace cob
