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

/// How a class makes its triangles.
struct InputClass {
    const char* name;
    int bits = 20;          ///< Of the coordinates: on a lattice of that many bits, or 53: any binary64 number.
    bool touching = false;  ///< A corner lies on a side of the box, or the triangle in the plane of one.
    bool coplanar = false;  ///< The triangle lies in the plane of a side or of the element.
    bool oblique = false;   ///< The box is parallel to no coordinate axis.
    double offset = 0;      ///< Added to every coordinate.
    double scale = 1;
};

inline const std::array<InputClass, 9>& input_classes() {
    static const std::array<InputClass, 9> classes = {{
        {"generic", 53},
        {"touching_20_bit", 20, true},
        {"coplanar_20_bit", 20, false, true},
        {"touching_53_bit", 53, true},
        {"coplanar_53_bit", 53, false, true},
        {"oblique_20_bit", 14, true, false, true},  // 6 bits more after the turn
        {"oblique_53_bit", 46, true, false, true},
        {"offset_1e6", 53, true, false, false, 1e6},
        {"scale_1e-6", 53, true, false, false, 0, 1e-6},
    }};
    return classes;
}

/// Boxes and triangles of one class; query i is triangle i against box i % boxes.size().
struct Queries {
    std::vector<Box> boxes;
    Scene scene;

    PolygonId size() const { return scene.polygon_count(); }
    const Box& box(PolygonId i) const { return boxes[static_cast<std::size_t>(i) % boxes.size()]; }
};

class QueryMaker {
public:
    QueryMaker(const InputClass& input_class, std::uint64_t seed) : class_(input_class), random_(seed) {}

    Queries make(int boxes, int triangles) {
        Queries queries;
        std::vector<std::array<Point, 2>> extents;
        for (int i = 0; i < boxes; ++i) {
            // The element: a rectangle of about a third of the surroundings.
            const Point low = {coordinate(.25, .375), coordinate(.25, .375), coordinate(.25, .375)};
            const Point high = {coordinate(.625, .75), coordinate(.625, .75), low.z};
            Loop element = {low, {high.x, low.y, low.z}, high, {low.x, high.y, low.z}};
            for (Point& p : element) p = turned(p);
            queries.boxes.emplace_back(question_of(element, 0, 1));
            const double side = std::min(high.x - low.x, high.y - low.y);
            extents.push_back({low, {high.x, high.y, low.z + side}});
        }
        std::vector<Loop> loops;
        while (static_cast<int>(loops.size()) < triangles) {
            const auto& [low, high] = extents[loops.size() % extents.size()];
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

    /// In [from, to) of the surroundings, which are the unit cube scaled and shifted.
    double coordinate(double from, double to) {
        const double value = from + (to - from) * unit();
        if (class_.bits < 53) return class_.offset + std::floor(std::ldexp(value, class_.bits - 1)) * class_.scale;
        return class_.offset + value * class_.scale;
    }

    double between(double low, double high) {
        const double inside = (high - low) * unit();
        return low + (class_.bits < 53 ? std::floor(inside) : inside);
    }

    Loop triangle(const Point& low, const Point& high) {
        Loop loop(3);
        for (Point& p : loop) p = {coordinate(0, 1), coordinate(0, 1), coordinate(0, 1)};
        const int axis = static_cast<int>(random_() % 3);
        const double side = random_() % 2 ? low[axis] : high[axis];
        if (class_.touching) {
            // A corner on a side of the box, the others not on its inner side.
            for (Point& p : loop) p[axis] = side == low[axis] ? std::min(p[axis], side) : std::max(p[axis], side);
            loop[0][axis] = side;
            for (int k = 0; k < 3; ++k)
                if (k != axis) loop[0][k] = between(low[k], high[k]);
            if (random_() % 4 == 0) loop[1] = {low.x, low.y, high.z};  // and one on a corner
        }
        if (class_.coplanar)
            for (Point& p : loop) p[axis] = side;
        return loop;
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
