#include "naive/shapes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cob::naive {

namespace {

LatticeLoop flat(std::initializer_list<std::pair<int, int>> corners) {
    LatticeLoop loop;
    for (const auto& [s, t] : corners) loop.push_back({s, t, 0});
    return loop;
}

LatticeLoop random_corners(Dice& dice, int count, int size) {
    LatticeLoop loop;
    for (int k = 0; k < count; ++k) loop.push_back({dice.between(0, size), dice.between(0, size), 0});
    return loop;
}

}  // namespace

LatticeLoop random_way(Dice& dice) {
    LatticeLoop loop = random_corners(dice, dice.between(3, 9), dice.between(2, 4));
    // Ways along rows and columns touch themselves without crossing more often than others.
    if (dice.one_in(2))
        for (std::size_t k = 1; k < loop.size(); ++k)
            (k % 2 ? loop[k].x : loop[k].y) = (k % 2 ? loop[k - 1].x : loop[k - 1].y);
    return loop;
}

LatticeLoop flat_shape(Dice& dice) {
    const LatticeLoop catalogue[] = {
        flat({{0, 0}, {4, 0}, {4, 4}, {0, 4}}), flat({{0, 0}, {4, 0}, {0, 4}}),
        flat({{0, 0}, {2, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 1}}),                  // straight angles
        flat({{0, 0}, {4, 0}, {4, 2}, {2, 2}, {2, 4}, {0, 4}}),                  // L
        flat({{0, 0}, {4, 0}, {4, 4}, {3, 4}, {3, 1}, {1, 1}, {1, 4}, {0, 4}}),  // U
        flat({{0, 0}, {4, 0}, {2, 2}, {4, 4}, {0, 4}}),                          // arrow
        // a hole on a bridge that is run both ways
        flat({{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {1, 1}, {1, 3}, {3, 3}, {3, 1}, {1, 1}}),
        // two holes, the second on a bridge from the first
        flat({{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {1, 1}, {1, 2}, {2, 2}, {3, 3}, {3, 2}, {2, 2}, {2, 1}, {1, 1}}),
        flat({{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {1, 3}, {3, 3}, {3, 1}}),          // a hole on a corner
        flat({{0, 0}, {2, 0}, {2, 2}, {4, 2}, {4, 4}, {2, 4}, {2, 2}, {0, 2}}),          // pinched
        flat({{0, 0}, {4, 0}, {2, 2}, {4, 4}, {0, 4}, {2, 2}}),                          // an hourglass on its side
        flat({{0, 0}, {4, 0}, {4, 2}, {6, 2}, {4, 2}, {4, 4}, {0, 4}}),                  // a spike outside
        flat({{0, 0}, {4, 0}, {4, 2}, {2, 2}, {4, 2}, {4, 4}, {0, 4}}),                  // a spike inside
        flat({{0, 0}, {0, 0}, {4, 0}, {4, 4}, {4, 4}, {4, 4}, {0, 4}, {0, 0}}),          // repeated vertices
        flat({{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {4, 0}, {4, 4}, {0, 4}}),          // run twice
        flat({{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 2}, {0, 3}, {0, 1}}),                  // a side that goes back
        flat({{0, 0}, {1, 0}, {1, 2}, {3, 2}, {3, 0}, {4, 0}, {4, 4}, {2, 2}, {0, 4}}),  // M
        flat({{0, 0}, {3, 0}, {4, 1}, {4, 3}, {3, 4}, {1, 4}, {0, 3}, {0, 1}}),          // more than four corners
    };
    switch (dice.below(5)) {
        case 0:
            return random_corners(dice, 3, 4);
        case 1:
            return random_corners(dice, 4, 4);
        case 2:
            return dice.one_in(2) ? random_way(dice) : dice.any(catalogue);
        case 3:
            return catalogue[dice.below(2)];
        default: {
            LatticeLoop loop = dice.any(catalogue);
            std::rotate(loop.begin(), loop.begin() + dice.below(static_cast<int>(loop.size())), loop.end());
            return loop;
        }
    }
}

LatticeLoop embed(const LatticeLoop& shape, const Lattice& origin, const Lattice& e1, const Lattice& e2) {
    LatticeLoop loop;
    for (const Lattice& corner : shape) loop.push_back(origin + corner.x * e1 + corner.y * e2);
    return loop;
}

LatticeLoop reversed(LatticeLoop loop) {
    std::reverse(loop.begin(), loop.end());
    return loop;
}

Point Placement::operator()(const Lattice& point) const {
    Point result;
    for (int k = 0; k < 3; ++k) result[k] = std::ldexp(static_cast<double>(dot(rows[k], point) + offset[k]), exponent);
    return result;
}

RationalPoint Placement::operator()(const RationalPoint& point) const {
    const Rational scale = exponent < 0 ? Rational(1, Integer(1) << -exponent) : Rational(Integer(1) << exponent);
    RationalPoint result;
    for (int k = 0; k < 3; ++k) {
        const RationalPoint row{rows[k].x, rows[k].y, rows[k].z};
        result[k] = scale * (dot(row, point) + offset[k]);
    }
    return result;
}

Placement axis_placement(Dice& dice) {
    Placement placement;
    for (int k = 2; k > 0; --k) std::swap(placement.rows[k], placement.rows[dice.below(k + 1)]);
    for (Lattice& row : placement.rows)
        if (dice.one_in(2)) row = -row;
    return placement;
}

Placement rotated_placement(Dice& dice) {
    std::int64_t a = 0, b = 0, c = 0, d = 0;
    while ((a != 0) + (b != 0) + (c != 0) + (d != 0) < 2) {
        a = dice.between(-4, 4);
        b = dice.between(-4, 4);
        c = dice.between(-4, 4);
        d = dice.between(-4, 4);
    }
    Placement placement;
    placement.rows[0] = {a * a + b * b - c * c - d * d, 2 * (b * c - a * d), 2 * (b * d + a * c)};
    placement.rows[1] = {2 * (b * c + a * d), a * a - b * b + c * c - d * d, 2 * (c * d - a * b)};
    placement.rows[2] = {2 * (b * d - a * c), 2 * (c * d + a * b), a * a - b * b - c * c + d * d};
    return placement;
}

Placement sheared_placement(Dice& dice) {
    Placement placement;
    do {
        for (Lattice& row : placement.rows) row = {dice.between(-5, 5), dice.between(-5, 5), dice.between(-5, 5)};
    } while (dot(placement.rows[0], cross(placement.rows[1], placement.rows[2])) == 0);
    return placement;
}

void nudge(Dice& dice, std::vector<Point>& points, int rarity) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    for (Point& point : points)
        for (int k = 0; k < 3; ++k)
            // The neighbours of zero are subnormal and make every fraction long: more seldom.
            if (dice.one_in(point[k] == 0 ? 8 * rarity : rarity))
                point[k] = std::nextafter(point[k], dice.one_in(2) ? infinity : -infinity);
}

}  // namespace cob::naive
