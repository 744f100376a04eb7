/// \file
/// Scenes and segments for the benchmarks of visibility, made in code.
#pragma once

#include "visibility/random.hpp"

#include <cmath>
#include <cstdint>
#include <vector>

namespace cob::test {

/// A sphere of triangles, dented by waves so that segments through it meet it several times.
inline void add_dented_sphere(Scene::Input& input, const Point& centre, double radius, int rings, int sectors) {
    const VertexId first = static_cast<VertexId>(input.positions.size());
    const auto at = [&](double theta, double phi) {
        const double r = radius * (1 + 0.2 * std::sin(5 * theta) * std::cos(4 * phi));
        return Point{centre.x + r * std::sin(theta) * std::cos(phi), centre.y + r * std::sin(theta) * std::sin(phi),
                     centre.z + r * std::cos(theta)};
    };
    const double pi = std::acos(-1.0);
    input.positions.push_back(at(0, 0));
    for (int i = 1; i < rings; ++i)
        for (int j = 0; j < sectors; ++j) input.positions.push_back(at(pi * i / rings, 2 * pi * j / sectors));
    input.positions.push_back(at(pi, 0));
    const VertexId last = static_cast<VertexId>(input.positions.size()) - 1;
    const auto vertex = [&](int i, int j) { return first + 1 + (i - 1) * sectors + j % sectors; };
    for (int j = 0; j < sectors; ++j) {
        input.faces.push_back({{first, vertex(1, j), vertex(1, j + 1)}, 0, 0});
        input.faces.push_back({{last, vertex(rings - 1, j + 1), vertex(rings - 1, j)}, 0, 0});
        for (int i = 1; i + 1 < rings; ++i) {
            input.faces.push_back({{vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)}, 0, 0});
            input.faces.push_back({{vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)}, 0, 0});
        }
    }
}

/// A room with a few dented spheres: about `triangles` triangles in all.
inline Scene benchmark_scene(int triangles) {
    Scene::Input input;
    input.name = "benchmark";
    input.materials.push_back({});
    for (int k = 0; k < 8; ++k) input.positions.push_back({k & 1 ? 10.0 : 0.0, k & 2 ? 8.0 : 0.0, k & 4 ? 3.0 : 0.0});
    for (const auto& q :
         {std::array<VertexId, 4>{0, 1, 3, 2}, {4, 6, 7, 5}, {0, 4, 5, 1}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 5, 7, 3}}) {
        input.faces.push_back({{q[0], q[1], q[2]}, 0, 0});
        input.faces.push_back({{q[0], q[2], q[3]}, 0, 0});
    }
    constexpr int spheres = 5;
    Random random(1);
    // 2 sectors (rings - 1) triangles each, with sectors = 2 rings.
    const int rings = std::max(3, static_cast<int>(0.5 + std::sqrt((triangles - 12) / (4.0 * spheres))));
    for (int k = 0; k < spheres; ++k)
        add_dented_sphere(input, {1.5 + 7 * random.fraction(), 1.5 + 5 * random.fraction(), 0.9 + random.fraction()},
                          0.5 + 0.4 * random.fraction(), rings, 2 * rings);
    return Scene::build(std::move(input));
}

enum class Ends { free_space, surface, vertices };

/// Segments between random points of the room, exact points of surfaces (dyadic, with their pieces), or vertices.
inline std::vector<Segment> benchmark_segments(const Scene& scene, Ends ends, int count) {
    Random random(2);
    const auto index = [&](std::size_t size) {
        return static_cast<std::size_t>(random.fraction() * static_cast<double>(size));
    };
    const auto end = [&](ExactPoint& point, PieceId& piece) {
        if (ends == Ends::free_space) {
            const double x = 10 * random.fraction(), y = 8 * random.fraction();
            point = Point{x, y, 3 * random.fraction()};
        } else if (ends == Ends::vertices) {
            piece = static_cast<PieceId>(index(scene.pieces().size()));
            point = scene.position(scene.corners(scene.piece(piece))[random.integer(0, 2)]);
        } else {
            piece = static_cast<PieceId>(index(scene.pieces().size()));
            const View<VertexId> corners = scene.corners(scene.piece(piece));
            const RationalPoint a = to_rational(scene.position(corners[0])),
                                b = to_rational(scene.position(corners[1])),
                                c = to_rational(scene.position(corners[2]));
            const int s = random.integer(1, 62), t = random.integer(1, 63 - s);
            point = ExactPoint(a + (Rational(s, 64) * (b - a)) + (Rational(t, 64) * (c - a)));
        }
    };
    std::vector<Segment> segments;
    while (static_cast<int>(segments.size()) < count) {
        Segment segment;
        end(segment.from, segment.from_piece);
        end(segment.to, segment.to_piece);
        if (segment.from != segment.to) segments.push_back(segment);
    }
    return segments;
}

}  // namespace cob::test
