#include "naive/cases.hpp"

#include "naive/family.hpp"

#include <cmath>

namespace cob::naive {

const char* to_text(Family family) {
    static const char* const names[family_count] = {"lattice", "rotated", "oblique",  "ulp",  "scaled",
                                                    "offset",  "sliver",  "fraction", "mixed"};
    return names[static_cast<int>(family)];
}

Family family_of(std::uint64_t seed) {
    return static_cast<Family>(seed % family_count);
}

Placement placement_of(Dice& dice, Family family) {
    Placement placement = family == Family::oblique || family == Family::mixed ? sheared_placement(dice)
                          : family == Family::rotated || dice.one_in(4)        ? rotated_placement(dice)
                                                                               : axis_placement(dice);
    switch (family) {
        case Family::scaled:
            placement.exponent = dice.pick({-1070, -300, 300, 900, 1008});
            break;
        case Family::offset: {
            const std::int64_t far = std::int64_t{1} << 40;
            for (int k = 0; k < 3; ++k) placement.offset[k] = dice.pick({-far, std::int64_t{0}, far});
            break;
        }
        case Family::sliver:
            placement.rows[dice.below(3)] = {1000000, 0, 0};
            break;
        default:
            placement.exponent = dice.pick({0, 0, -3, 7});
    }
    const Lattice* rows = placement.rows;
    if (dot(rows[0], cross(rows[1], rows[2])) == 0) return placement_of(dice, family);
    return placement;
}

std::vector<Point> place(Dice& dice, Family family, const Placement& placement, const LatticeLoop& loop) {
    std::vector<Point> points;
    for (const Lattice& corner : loop) points.push_back(placement(corner));
    if (family == Family::ulp) nudge(dice, points, dice.pick({3, 8, 30}));
    if (family == Family::mixed && dice.one_in(2))
        for (Point& point : points) point[dice.below(3)] *= std::ldexp(1.0, dice.pick({-900, -300, -60, 60, 300, 900}));
    return points;
}

LatticeLoop spatial_shape(Dice& dice) {
    const auto direction = [&]() -> Lattice {
        Lattice d{};
        while (d == Lattice{}) d = {dice.between(-1, 1), dice.between(-1, 1), dice.between(-1, 1)};
        return d;
    };
    Lattice e1 = direction(), e2 = direction();
    while (cross(e1, e2) == Lattice{}) e2 = direction();
    const Lattice origin{dice.between(-2, 4), dice.between(-2, 4), dice.between(-2, 3)};
    LatticeLoop loop = embed(flat_shape(dice), origin, e1, e2);
    if (dice.one_in(5)) {
        Lattice& moved = loop[static_cast<std::size_t>(dice.below(static_cast<int>(loop.size())))];
        moved = {dice.between(-2, 6), dice.between(-2, 6), dice.between(-2, 5)};
    }
    return loop;
}

std::vector<Point> polygon_case(std::uint64_t seed) {
    Dice dice(seed);
    const Family family = family_of(seed);
    const Placement placement = placement_of(dice, family);
    LatticeLoop loop = dice.one_in(3) ? random_way(dice) : flat_shape(dice);
    // A slant; then perhaps every corner at a height of its own: not planar.
    const Lattice slope{dice.between(-2, 2), dice.between(-2, 2), 0};
    const bool rough = dice.one_in(2);
    for (Lattice& corner : loop) corner.z = dot(slope, corner) + (rough ? dice.between(0, 2) : 0);
    return place(dice, family, placement, loop);
}

}  // namespace cob::naive
