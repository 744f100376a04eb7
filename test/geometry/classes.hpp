/// \file
/// Random triangles against a box, by class: how the two meet and how many bits the coordinates have. Shared by
/// the tests of the stages and the benchmark.
#pragma once

#include "scenes.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>

namespace cob::test {

/// How a class makes its triangles. Coordinates are integers below 2^bits, times 2^step, plus offset, all exact.
struct InputClass {
    const char* name;
    int bits = 20;
    bool touching = false;  ///< A corner lies on a side of the box, a side on a box edge or the inside on a corner.
    bool coplanar = false;  ///< The triangle lies in the plane of a side or of the element.
    bool oblique = false;   ///< The box is parallel to no coordinate axis; the turn adds 6 bits.
    double offset = 0;
    int step = 0;
};

inline const std::array<InputClass, 9>& input_classes() {
    static const std::array<InputClass, 9> classes = {{
        {"generic", 52, false, false, false, 0, -52},
        {"touching_20_bit", 20, true},
        {"coplanar_20_bit", 20, false, true},
        {"touching_53_bit", 52, true, false, false, 0, -52},
        {"coplanar_53_bit", 52, false, true, false, 0, -52},
        {"oblique_20_bit", 13, true, false, true},
        {"oblique_53_bit", 46, true, false, true, 0, -46},
        {"offset_1e6", 32, true, false, false, 1e6, -32},
        {"scale_1e-6", 52, true, false, false, 0, -72},
    }};
    return classes;
}

/// Boxes and triangles of one class; query i is triangle i against box i % boxes.size().
struct Queries {
    std::vector<Box> boxes;
    std::vector<std::array<Point, 2>> extents;  ///< Of the boxes, exactly, before the turn of oblique ones.
    Scene scene;

    PolygonId size() const { return scene.polygon_count(); }
    const Box& box(PolygonId i) const { return boxes[static_cast<std::size_t>(i) % boxes.size()]; }
};

class QueryMaker {
public:
    QueryMaker(const InputClass& input_class, std::uint64_t seed) : class_(input_class), random_(seed) {}

    Queries make(int boxes, int triangles) {
        Queries queries;
        for (int i = 0; i < boxes; ++i) {
            // The element: a rectangle of about a third of the surroundings.
            const Point low = {coordinate(.25, .375), coordinate(.25, .375), coordinate(.25, .375)};
            const Point high = {coordinate(.625, .75), coordinate(.625, .75), low.z};
            Loop element = {low, {high.x, low.y, low.z}, high, {low.x, high.y, low.z}};
            for (Point& p : element) p = turned(p);
            queries.boxes.emplace_back(question_of(element, 0, 1));
            const double side = std::min(high.x - low.x, high.y - low.y);
            queries.extents.push_back({low, {high.x, high.y, low.z + side}});
        }
        std::vector<Loop> loops;
        while (static_cast<int>(loops.size()) < triangles) {
            const auto& [low, high] = queries.extents[loops.size() % queries.extents.size()];
            Loop loop = triangle(low, high);
            if (on_one_line(loop)) continue;
            for (Point& p : loop) p = turned(p);
            loops.push_back(loop);
        }
        queries.scene = scene_of(loops);
        return queries;
    }

private:
    double unit() { return std::ldexp(static_cast<double>(random_() >> 11), -53); }

    /// In [from, to) of the surroundings, which are a cube of 2^bits steps.
    double coordinate(double from, double to) {
        const double steps = std::floor(std::ldexp(from + (to - from) * unit(), class_.bits));
        return class_.offset + std::ldexp(steps, class_.step);
    }

    /// A step's multiple in [low, high).
    double between(double low, double high) {
        const double steps = std::floor(std::ldexp((high - low) * unit(), -class_.step));
        return low + std::ldexp(steps, class_.step);
    }

    Loop triangle(const Point& low, const Point& high) {
        Loop loop(3);
        for (Point& p : loop) p = {coordinate(0, 1), coordinate(0, 1), coordinate(0, 1)};
        const int axis = static_cast<int>(random_() % 3);
        const bool at_low = random_() % 2 != 0;
        const double side = at_low ? low[axis] : high[axis];
        if (class_.coplanar)
            for (Point& p : loop) p[axis] = side;
        if (!class_.touching) return loop;
        switch (random_() % 3) {
            case 0:  // a corner on a side of the box, the others not on its inner side
                for (Point& p : loop) p[axis] = at_low ? std::min(p[axis], side) : std::max(p[axis], side);
                loop[0] = {between(low.x, high.x), between(low.y, high.y), between(low.z, high.z)};
                loop[0][axis] = side;
                break;
            case 1: {  // a side of the triangle across a box edge, from outside
                const Point out = outward();
                Point on_edge = corner(low, high, out);
                on_edge[axis] = between(low[axis], high[axis]);
                const int i = (axis + 1) % 3, j = (axis + 2) % 3;
                Point along = small_vector(), away = small_vector();
                along[i] = std::abs(along[i]) * out[i];
                along[j] = -std::abs(along[j]) * out[j];
                away[i] = std::abs(away[i]) * out[i];
                away[j] = std::abs(away[j]) * out[j];
                loop = {on_edge + along, on_edge - along, on_edge + away};
                break;
            }
            default: {  // the inside on a corner: the normal points away from the box along every axis
                const Point out = outward(), on_corner = corner(low, high, out);
                Point p, q, n;
                do {
                    p = small_vector();
                    q = small_vector();
                    n = cross(p, q);
                } while (!(n.x * out.x > 0 && n.y * out.y > 0 && n.z * out.z > 0));
                loop = {on_corner + p, on_corner + q, on_corner - p - q};
            }
        }
        return loop;
    }

    /// A corner of the box by the signs of the directions that leave it there.
    Point outward() {
        const auto sign = [&] { return random_() % 2 ? 1.0 : -1.0; };
        return {sign(), sign(), sign()};
    }
    static Point corner(const Point& low, const Point& high, const Point& out) {
        return {out.x > 0 ? high.x : low.x, out.y > 0 ? high.y : low.y, out.z > 0 ? high.z : low.z};
    }

    /// Up to a quarter of the surroundings, either way.
    Point small_vector() {
        const auto any = [&] {
            return coordinate(0, .5) - class_.offset - std::ldexp(1, class_.bits + class_.step - 2);
        };
        return {any(), any(), any()};
    }

    /// By the rotation of quaternion (2, 1, 2, 4) times 25: exact on lattices.
    Point turned(const Point& p) const {
        if (!class_.oblique) return p;
        return {-15 * p.x - 12 * p.y + 16 * p.z, 20 * p.x - 9 * p.y + 12 * p.z, 20 * p.y + 15 * p.z};
    }

    static bool on_one_line(const Loop& loop) {
        const RationalPoint a = to_rational(loop[0]), b = to_rational(loop[1]), c = to_rational(loop[2]);
        return cross(b - a, c - a) == RationalPoint{};
    }

    InputClass class_;
    std::mt19937_64 random_;
};

}  // namespace cob::test
