// Triangles of a planar polygon by its definition: "the closed set of the points that its loop winds around" (SPEC 2).
//
// No two sides cross, so all vertices of the arrangement of the sides are corners of the loop: the set is a union of
// triangles between corners. A constrained triangulation of the sides, cut where corners stand on them, contains
// them; going from triangle to triangle, the winding number changes by the sides that are stepped over.
#include "scene/seen.hpp"
#include "scene/side_tree.hpp"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <optional>
#include <stdexcept>
#include <utility>

namespace cob {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;  // the corner that stands there
using FaceBase = CGAL::Constrained_triangulation_face_base_2<
    Kernel, CGAL::Triangulation_face_base_with_info_2<std::optional<int>, Kernel>>;  // the winding number, once known
using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>,
                                               CGAL::No_constraint_intersection_tag>;
using Vertex = Triangulation::Vertex_handle;
using Face = Triangulation::Face_handle;

/// For each two places that a part of a side joins, from the lower corner number to the higher: how often it is run
/// that way, less how often the other way.
using NetSides = std::map<std::pair<std::uint32_t, std::uint32_t>, int>;

/// Corner numbers without repeated positions: the first corner at each position.
std::vector<std::uint32_t> first_at_position(const SeenLoop& loop) {
    const auto less = [](const Point2& a, const Point2& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; };
    std::map<Point2, std::uint32_t, decltype(less)> first(less);
    std::vector<std::uint32_t> result;
    for (std::uint32_t k = 0; k < loop.size(); ++k) result.push_back(first.emplace(loop.seen[k], k).first->second);
    return result;
}

/// The corners that stand on each side, its ends among them, in its direction.
std::vector<std::vector<std::uint32_t>> corners_on_sides(const SeenLoop& loop,
                                                         const std::vector<std::uint32_t>& first) {
    const auto bounds_of = [&](std::size_t k) { return Bounds2::of(loop.seen[k], loop.seen[loop.next(k)]); };
    SideTree tree(loop.size());
    tree.fill(loop.size(), bounds_of);
    std::vector<std::vector<std::uint32_t>> on_side(loop.size());
    for (std::uint32_t corner = 0; corner < loop.size(); ++corner) {
        if (first[corner] != corner) continue;
        const Point2& point = loop.seen[corner];
        tree.find(
            0, [&](const Bounds2& box) { return meets_closed(box, Bounds2::of(point, point)); },
            [&](std::size_t side) {
                if (orientation(loop.seen[side], loop.seen[loop.next(side)], point) == Sign::zero)
                    on_side[side].push_back(corner);
                return false;
            });
    }
    for (std::size_t side = 0; side < loop.size(); ++side) {
        const Point2 &from = loop.seen[side], &to = loop.seen[loop.next(side)];
        const auto along = [&](std::uint32_t a, std::uint32_t b) {
            const Point2 &p = loop.seen[a], &q = loop.seen[b];
            return p.x != q.x ? (p.x < q.x) == (from.x < to.x) : (p.y < q.y) == (from.y < to.y);
        };
        std::sort(on_side[side].begin(), on_side[side].end(), along);
    }
    return on_side;
}

NetSides net_sides(const SeenLoop& loop, const std::vector<std::uint32_t>& first) {
    NetSides net;
    for (const auto& corners : corners_on_sides(loop, first))
        for (std::size_t k = 0; k + 1 < corners.size(); ++k) {
            const std::uint32_t a = corners[k], b = corners[k + 1];
            net[std::minmax(a, b)] += a < b ? 1 : -1;
        }
    return net;
}

Triangulation triangulate(const SeenLoop& loop, const std::vector<std::uint32_t>& first, const NetSides& net) {
    Triangulation triangulation;
    std::vector<Vertex> vertices(loop.size());
    for (std::uint32_t k = 0; k < loop.size(); ++k) {
        if (first[k] != k) continue;
        vertices[k] = triangulation.insert({loop.seen[k].x, loop.seen[k].y});
        vertices[k]->info() = k;
    }
    for (const auto& [ends, times] : net)
        if (times != 0) triangulation.insert_constraint(vertices[ends.first], vertices[ends.second]);
    return triangulation;
}

/// How the winding number changes on the way out of a face over the side opposite to its k-th vertex: a side that
/// has the face on its left takes its turn away.
int change_across(const NetSides& net, const Face& face, int k) {
    const std::uint32_t a = face->vertex(Triangulation::ccw(k))->info(), b = face->vertex(Triangulation::cw(k))->info();
    const auto found = net.find(std::minmax(a, b));
    if (found == net.end()) return 0;
    return a < b ? -found->second : found->second;
}

/// Winding numbers of all faces, from 0 outside inwards.
void find_windings(Triangulation& triangulation, const NetSides& net) {
    std::vector<Face> front;
    for (auto face = triangulation.all_faces_begin(); face != triangulation.all_faces_end(); ++face)
        if (triangulation.is_infinite(face)) {
            face->info() = 0;
            front.push_back(face);
        }
    while (!front.empty()) {
        const Face face = front.back();
        front.pop_back();
        for (int k = 0; k < 3; ++k) {
            const Face neighbour = face->neighbor(k);
            if (neighbour->info()) continue;
            neighbour->info() = *face->info() + change_across(net, face, k);
            front.push_back(neighbour);
        }
    }
}

}  // namespace

bool touches_itself(const SeenLoop& loop) {
    const std::vector<std::uint32_t> first = first_at_position(loop);
    for (std::uint32_t k = 0; k < loop.size(); ++k)
        if (first[k] != k) return true;
    const auto on_sides = corners_on_sides(loop, first);
    return std::any_of(on_sides.begin(), on_sides.end(), [](const auto& corners) { return corners.size() > 2; });
}

WoundTriangles triangulate_wound(const SeenLoop& loop) {
    const std::vector<std::uint32_t> first = first_at_position(loop);
    const NetSides net = net_sides(loop, first);
    Triangulation triangulation = triangulate(loop, first, net);
    find_windings(triangulation, net);
    WoundTriangles result;
    for (auto face = triangulation.finite_faces_begin(); face != triangulation.finite_faces_end(); ++face) {
        result.most = std::max(result.most, std::abs(*face->info()));
        if (*face->info() != 0)
            result.triangles.push_back({face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
    }
    if (result.triangles.empty()) throw std::logic_error("a polygon of positive area winds around nothing");
    return result;
}

}  // namespace cob
