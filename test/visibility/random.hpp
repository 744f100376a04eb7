/// \file
/// Random scenes and segments of small integers, so that ties really happen. The case's number is the seed.
#pragma once

#include "visibility/scenes.hpp"

#include <array>
#include <cstdint>
#include <random>

namespace cob::test {

class Random {
public:
    explicit Random(std::uint64_t seed) : engine_(seed) {}
    /// In [low, high]; raw bits of the engine, so that platforms agree.
    int integer(int low, int high) {
        return low + static_cast<int>(engine_() % static_cast<std::uint64_t>(high - low + 1));
    }
    /// Binary64, 53 bits in [0, 1).
    double fraction() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
    Point lattice_point(int low, int high) {
        const int x = integer(low, high), y = integer(low, high);
        return Point{static_cast<double>(x), static_cast<double>(y), static_cast<double>(integer(low, high))};
    }

private:
    std::mt19937_64 engine_;
};

/// A few triangles and quadrilaterals on a lattice, many of which share corners and sides; loops that SPEC 2 refuses
/// are left to the reader (skip_invalid).
inline std::vector<Loop> lattice_soup(Random& random, int polygons, int size, int most_corners = 5) {
    std::vector<Point> corners;
    for (int k = 0; k < polygons + 2; ++k) corners.push_back(random.lattice_point(0, size));
    std::vector<Loop> loops;
    for (int k = 0; k < polygons; ++k) {
        Loop loop;
        const int count = random.integer(3, most_corners);
        for (int c = 0; c < count; ++c)
            loop.push_back(corners[static_cast<std::size_t>(random.integer(0, static_cast<int>(corners.size()) - 1))]);
        loops.push_back(loop);
    }
    return loops;
}

/// The surface of a height field over a lattice: triangles around every lattice point, so that segments downward
/// meet its seams from every side.
inline std::vector<Loop> lattice_terrain(Random& random, int size, int height) {
    std::vector<std::vector<Point>> rows;
    for (int y = 0; y <= size; ++y) {
        rows.emplace_back();
        for (int x = 0; x <= size; ++x)
            rows.back().push_back(
                {static_cast<double>(x), static_cast<double>(y), static_cast<double>(random.integer(0, height))});
    }
    std::vector<Loop> loops;
    for (std::size_t y = 0; y < static_cast<std::size_t>(size); ++y)
        for (std::size_t x = 0; x < static_cast<std::size_t>(size); ++x) {
            const Point a = rows[y][x], b = rows[y][x + 1], c = rows[y + 1][x + 1], d = rows[y + 1][x];
            if (random.integer(0, 1) == 0) {
                loops.push_back({a, b, c});
                loops.push_back({a, c, d});
            } else {
                loops.push_back({a, b, d});
                loops.push_back({b, c, d});
            }
        }
    return loops;
}

}  // namespace cob::test
