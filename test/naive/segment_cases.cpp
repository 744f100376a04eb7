#include "naive/family.hpp"

#include <cmath>

namespace cob::naive {

namespace {

Lattice lattice_point(Dice& dice, int low, int high) {
    return {dice.between(low, high), dice.between(low, high), dice.between(low, high)};
}

/// Triangles around one vertex, perhaps with a gap, a doubled or a reversed one.
void add_fan(Dice& dice, std::vector<LatticeLoop>& loops) {
    const Lattice apex = lattice_point(dice, 1, 3);
    const LatticeLoop rings[] = {
        {{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}},
        {{1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {-1, 1, 0}, {-1, 0, 0}, {-1, -1, 0}, {0, -1, 0}, {1, -1, 0}},
        {{1, 0, 0}, {-1, 1, 0}, {-1, -1, 0}},
    };
    LatticeLoop ring = dice.any(rings);
    for (Lattice& rim : ring) rim.z = dice.pick({0, 0, 0, 1, -1});
    const bool gap = dice.one_in(4);
    for (std::size_t k = gap ? 1 : 0; k < ring.size(); ++k) {
        LatticeLoop triangle{apex, apex + ring[k], apex + ring[(k + 1) % ring.size()]};
        if (dice.one_in(3)) triangle = reversed(triangle);
        loops.push_back(triangle);
        if (dice.one_in(12)) loops.push_back(triangle);
    }
}

/// A sheet of cells at heights of its own, cells cut into triangles one way or the other or left as quadrilaterals:
/// flat or folded seams, T-junctions where a cell is cut in the middle of a side.
void add_terrain(Dice& dice, std::vector<LatticeLoop>& loops) {
    const int size = 2;
    const bool flat = dice.one_in(3);
    std::int64_t height[size + 1][size + 1];
    for (auto& row : height)
        for (std::int64_t& z : row) z = 2 + (flat ? 0 : dice.below(2));
    const auto at = [&](int i, int j) { return Lattice{2 * i, 2 * j, height[i][j]}; };
    for (int i = 0; i < size; ++i) {
        for (int j = 0; j < size; ++j) {
            const Lattice a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
            switch (dice.below(flat ? 4 : 3)) {
                case 0:
                    loops.insert(loops.end(), {{a, b, c}, {a, c, d}});
                    break;
                case 1:
                    loops.insert(loops.end(), {{a, b, d}, {b, c, d}});
                    break;
                case 2:
                    loops.push_back({a, b, c, d});
                    break;  // often not planar
                default: {  // cut in the middle of two sides
                    const Lattice low{2 * i + 1, 2 * j, 2}, high{2 * i + 1, 2 * j + 2, 2};
                    loops.insert(loops.end(), {{a, low, high, d}, {low, b, c, high}});
                }
            }
        }
    }
}

/// A closed tetrahedron or cuboid, sides outward.
void add_solid(Dice& dice, std::vector<LatticeLoop>& loops) {
    if (dice.one_in(2)) {
        Lattice p[4];
        do {
            for (Lattice& corner : p) corner = lattice_point(dice, 0, 4);
        } while (dot(p[1] - p[0], cross(p[2] - p[0], p[3] - p[0])) == 0);
        loops.insert(loops.end(), {{p[0], p[2], p[1]}, {p[0], p[1], p[3]}, {p[1], p[2], p[3]}, {p[2], p[0], p[3]}});
        return;
    }
    const Lattice low = lattice_point(dice, 0, 2), size{dice.between(1, 2), dice.between(1, 2), dice.between(1, 2)};
    for (int axis = 0; axis < 3; ++axis) {
        Lattice e1{}, e2{}, e3{};
        e1[(axis + 1) % 3] = size[(axis + 1) % 3];
        e2[(axis + 2) % 3] = size[(axis + 2) % 3];
        e3[axis] = size[axis];
        const LatticeLoop square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
        loops.push_back(embed(square, low, e2, e1));
        loops.push_back(embed(square, low + e3, e1, e2));
    }
}

/// A stair, each tread and each riser a rectangle.
void add_stair(Dice& dice, std::vector<LatticeLoop>& loops) {
    for (int step = 0, steps = dice.between(1, 3); step < steps; ++step) {
        const LatticeLoop square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
        loops.push_back(embed(square, {0, step, step}, {4, 0, 0}, {0, 1, 0}));
        loops.push_back(embed(square, {0, step + 1, step}, {4, 0, 0}, {0, 0, 1}));
    }
}

std::vector<LatticeLoop> lattice_scene(Dice& dice) {
    std::vector<LatticeLoop> loops;
    for (int part = dice.between(1, 2); part > 0; --part) {
        switch (dice.below(6)) {
            case 0:
                add_fan(dice, loops);
                break;
            case 1:
                add_terrain(dice, loops);
                break;
            case 2:
                add_solid(dice, loops);
                break;
            case 3:
                add_stair(dice, loops);
                break;
            default:
                for (int k = dice.between(2, 4); k > 0; --k) loops.push_back(spatial_shape(dice));
        }
    }
    if (dice.one_in(4)) loops.push_back(reversed(dice.any(loops)));
    return loops;
}

/// A corner, a point of a side or of a plane's inside of some polygon: where contacts are awkward.
RationalPoint awkward_point(Dice& dice, const std::vector<Face>& faces) {
    const std::vector<Point>& corners = dice.any(faces).corners;
    const std::size_t count = corners.size(), k = static_cast<std::size_t>(dice.below(static_cast<int>(count)));
    const RationalPoint a = to_rational(corners[k]), b = to_rational(corners[(k + 1) % count]),
                        c = to_rational(corners[(k + 2) % count]);
    const Rational s = dice.pick<Rational>({Rational(1, 2), Rational(1, 4), Rational(1, 3)});
    switch (dice.below(4)) {
        case 0:
            return a;
        case 1:
            return a + s * (b - a);
        case 2:
            return a + s * (c - a);  // often a diagonal
        default:
            return a + Rational(1, 4) * (b - a) + Rational(1, 4) * (c - a);
    }
}

}  // namespace

SegmentCase segment_case(std::uint64_t seed) {
    Dice dice(seed);
    const Family family = family_of(seed);
    const Placement placement = placement_of(dice, family);
    SegmentCase result;
    for (const LatticeLoop& loop : lattice_scene(dice))
        result.faces.push_back({place(dice, family, placement, loop), dice.one_in(3)});

    const RationalPoint origin = placement(RationalPoint{});
    const auto direction = [&]() -> RationalPoint {
        const Lattice d = lattice_point(dice, -2, 2);
        return placement(RationalPoint{d.x, d.y, d.z}) - origin;
    };
    const auto lattice_place = [&]() -> RationalPoint {
        const Lattice p = lattice_point(dice, -1, 6);
        return placement(RationalPoint{p.x, p.y, p.z});
    };
    const int wanted = 12;
    for (int k = 0; k < wanted; ++k) {
        SegmentCase::Segment segment;
        switch (dice.below(5)) {
            case 0:  // between lattice points
                segment = {lattice_place(), lattice_place()};
                break;
            case 1:  // from a point on a polygon, or from one polygon to another
                segment = {awkward_point(dice, result.faces),
                           dice.one_in(2) ? awkward_point(dice, result.faces) : lattice_place()};
                break;
            default: {  // through such a point
                const RationalPoint through = awkward_point(dice, result.faces), along = direction();
                const Rational before =
                    family == Family::fraction ? Rational(2, 3) : dice.pick<Rational>({1, Rational(1, 2), 2});
                const Rational after = dice.pick<Rational>({1, Rational(1, 2), 2});
                segment = {through - before * along, through + after * along};
            }
        }
        if (segment.from != segment.to) result.segments.push_back(segment);
    }
    return result;
}

}  // namespace cob::naive
