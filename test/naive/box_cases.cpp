#include "naive/family.hpp"

#include <algorithm>
#include <cmath>

namespace cob::naive {

namespace {

RationalPoint exact(const Point& point) {
    return to_rational(point);
}

/// The element's face, in the plane z = 0.
LatticeLoop base_shape(Dice& dice) {
    const LatticeLoop shapes[] = {
        {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}},  //
        {{0, 0, 0}, {4, 0, 0}, {4, 2, 0}, {0, 2, 0}},  //
        {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}},             //
        {{0, 0, 0}, {4, 0, 0}, {1, 3, 0}},             //
        {{0, 0, 0}, {3, 0, 0}, {4, 2, 0}, {1, 2, 0}},  // parallelogram
        {{0, 0, 0}, {4, 0, 0}, {3, 2, 0}, {1, 2, 0}},  // trapezoid
        {{0, 0, 0}, {2, 0, 0}, {4, 0, 0}, {2, 3, 0}},  // a straight angle
    };
    LatticeLoop shape = dice.any(shapes);
    std::rotate(shape.begin(), shape.begin() + dice.below(static_cast<int>(shape.size())), shape.end());
    return shape;
}

/// A box over a face: over all of it, or over a parallelogram or triangle in it, whose corners are often fractions.
BoxQuestion question_over(Dice& dice, Family family, int polygon, const std::vector<Point>& face) {
    BoxQuestion question;
    question.polygon = polygon;
    const bool perturbed = family == Family::ulp || family == Family::mixed;
    const RationalPoint c0 = exact(face[0]), side = exact(face[1]) - c0, other = exact(face.back()) - c0;
    if (family != Family::fraction && !dice.one_in(4) && (!perturbed || face.size() == 3)) {
        for (const Point& corner : face) question.corners.push_back(exact(corner));
    } else {
        const int parts = family == Family::fraction ? dice.pick({3, 6, 7, 10}) : dice.pick({1, 2, 4});
        const auto at = [&](int i, int j) { return c0 + Rational(i, parts) * side + Rational(j, parts) * other; };
        const int i = dice.below(parts), j = dice.below(parts);
        if (dice.one_in(2))
            question.corners = {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)};
        else
            question.corners = {at(i, j), at(i + 1, j), at(i, j + 1)};
    }
    switch (dice.below(4)) {
        case 0:
            question.u = Rational(1, 7) * (question.corners[2] - question.corners[0]);
            break;
        case 1:
            question.u = Rational(dice.between(-3, 3)) * side + Rational(dice.between(1, 2)) * other;
            break;
        default:
            question.u = side;
    }
    if (question.u == RationalPoint{}) question.u = other;
    question.margin = dice.pick<Rational>({0, 0, Rational(1, 8), Rational(1, 4), Rational(1, 2), 1, Rational(1, 3)});
    question.height = dice.pick<Rational>(
        {Rational(1, 8), Rational(1, 4), Rational(1, 2), 1, Rational(3, 2), Rational(1, 6), Rational(1, 3)});
    return question;
}

/// The box in floating point, to put corners as near to its sides and top as binary64 goes: for making questions.
class Frame {
public:
    explicit Frame(const BoxQuestion& question) : box_(prepare(question)) {
        if (!box_.refused.empty()) return;
        length_u_ = length(box_.u);
        length_w_ = length(box_.w);
        length_n_ = length(box_.n);
        height_ = root(box_.top_squared / dot(box_.n, box_.n));
    }
    bool usable() const { return box_.refused.empty(); }

    /// a and b from 0 to 1 across the rectangle, z from 0 to 1 up to the top; rounded.
    Point at(const Rational& a, const Rational& b, const Rational& z) const {
        const Rational along_u = (box_.low_u + a * (box_.high_u - box_.low_u)) / dot(box_.u, box_.u);
        const Rational along_w = (box_.low_w + b * (box_.high_w - box_.low_w)) / dot(box_.w, box_.w);
        const RationalPoint point =
            box_.origin + along_u * box_.u + along_w * box_.w + (z * height_ / length_n_) * box_.n;
        return {to_nearest(point.x), to_nearest(point.y), to_nearest(point.z)};
    }

private:
    /// The square root to well beyond binary64: Newton's method from an integer root.
    static Rational root(const Rational& square) {
        const Integer p = numerator(square), q = denominator(square);
        const int shift = 200;
        return Rational(sqrt(Integer((p * q) << (2 * shift))), q << shift);
    }
    static Rational length(const RationalPoint& direction) { return root(dot(direction, direction)); }

    Box box_;
    Rational length_u_, length_w_, length_n_, height_;
};

Rational place_across(Dice& dice) {
    return dice.pick<Rational>(
        {-1, Rational(-1, 4), 0, 0, 0, Rational(1, 4), Rational(1, 2), 1, 1, 1, Rational(5, 4), 2});
}
Rational place_up(Dice& dice) {
    return dice.pick<Rational>({-1, 0, 0, Rational(1, 2), Rational(1, 2), 1, 1, 1, 1, Rational(5, 4)});
}

/// Polygons that touch a box's sides, edges and top, or miss them by an ulp.
std::vector<Point> tangent_face(Dice& dice, const Frame& frame) {
    std::vector<Point> face;
    const Rational z = place_up(dice), low = dice.pick<Rational>({-1, 0, 0, Rational(1, 4)});
    const Rational high = dice.pick<Rational>({Rational(3, 4), 1, 1, 2});
    switch (dice.below(5)) {
        case 0:  // a sheet
            face = {frame.at(low, low, z), frame.at(high, low, z), frame.at(high, high, z), frame.at(low, high, z)};
            break;
        case 1:  // half a sheet, larger
            face = {frame.at(low, low, z), frame.at(3 * high, low, z), frame.at(low, 3 * high, z)};
            break;
        case 2:  // a slanted sheet that touches the top or the base along one side
            face = {frame.at(low, low, z), frame.at(high, low, z), frame.at(high, high, 1), frame.at(low, high, 1)};
            break;
        case 3: {  // a wall on or beside a side
            const Rational a = place_across(dice), top = place_up(dice);
            face = {frame.at(a, low, z), frame.at(a, high, z), frame.at(a, high, top), frame.at(a, low, top)};
            break;
        }
        default:
            for (int k = dice.between(3, 4); k > 0; --k)
                face.push_back(frame.at(place_across(dice), place_across(dice), place_up(dice)));
    }
    if (dice.one_in(2)) nudge(dice, face, dice.pick({2, 4, 12}));
    if (dice.one_in(2)) std::reverse(face.begin(), face.end());
    return face;
}

/// Lattice loops that stand, lie or hang where a face in the plane z = 0 is.
LatticeLoop neighbour(Dice& dice, const LatticeLoop& base) {
    const std::size_t k = static_cast<std::size_t>(dice.below(static_cast<int>(base.size())));
    const Lattice a = base[k], b = base[(k + 1) % base.size()], up{0, 0, dice.between(1, 3)};
    const int z = dice.pick({-1, 0, 0, 1, 1, 1, 2, 2, 3});
    switch (dice.below(6)) {
        case 0:
            return {a, b, b + up, a + up};  // a wall on a side
        case 1:
            return {a, a + up, b + up};  // a wall on a corner
        case 2:
            return dice.one_in(2) ? base : reversed(base);  // a duplicate
        case 3:                                             // a sheet above, below or in the plane
            return embed(flat_shape(dice), {dice.between(-2, 1), dice.between(-2, 1), z}, {dice.between(1, 2), 0, 0},
                         {0, dice.between(1, 2), dice.pick({0, 0, 0, 1})});
        case 4: {  // a large sheet
            const LatticeLoop sheet{{-3, -3, z}, {7, -3, z}, {7, 7, z}, {-3, 7, z + dice.below(2)}};
            return dice.one_in(2) ? sheet : reversed(sheet);
        }
        default:
            return spatial_shape(dice);
    }
}

}  // namespace

BoxCase box_case(std::uint64_t seed) {
    Dice dice(seed);
    const Family family = family_of(seed);
    const Placement placement = placement_of(dice, family);
    BoxCase result;
    const auto add = [&](std::vector<Point> face) {
        for (const Point& corner : face)
            for (int k = 0; k < 3; ++k)
                if (!std::isfinite(corner[k])) return;
        result.faces.push_back({std::move(face), dice.one_in(3)});
    };

    const LatticeLoop base = base_shape(dice);
    const std::vector<Point> face = place(dice, family, placement, base);
    add(face);
    for (int k = dice.between(2, 5); k > 0; --k) add(place(dice, family, placement, neighbour(dice, base)));

    const int boxes = 3;
    for (int k = 0; k < boxes; ++k) {
        result.boxes.push_back(question_over(dice, family, dice.one_in(5) ? -1 : 0, face));
        const Frame frame(result.boxes.back());
        if (frame.usable())
            for (int j = dice.below(3); j > 0; --j) add(tangent_face(dice, frame));
    }
    return result;
}

}  // namespace cob::naive
