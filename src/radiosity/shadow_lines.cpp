#include "radiosity/shadow_lines.hpp"

#include "radiosity/lambert.hpp"

#include <map>
#include <optional>
#include <utility>

namespace cob::radiosity {
namespace {

using Local = Vector3<double>;  ///< (s, t, h)
using Side = std::pair<Local, Local>;

constexpr double clearance = 1e-9;        ///< Of a height: nearer to it, projections run off to infinity.
constexpr std::size_t many_lines = 2000;  ///< Beyond, lines between two occluders cost more than they save.
constexpr double far_away = 1e3;          ///< In sizes of the scene.

/// Where the line through two points of different height meets the receiver's plane.
Point2D foot(const Local& p, const Local& q) {
    const double f = 1 / (p.z - q.z);
    return {(p.z * q.x - q.z * p.x) * f, (p.z * q.y - q.z * p.y) * f};
}

/// The part of a side with low <= h <= high.
std::optional<Side> between(Side side, double low, double high) {
    if (side.first.z > side.second.z) std::swap(side.first, side.second);
    auto& [a, b] = side;
    if (b.z < low || a.z > high) return std::nullopt;
    const Local from = a, to = b;
    const auto at = [&](double h) { return from + ((h - from.z) / (to.z - from.z)) * (to - from); };
    if (a.z < low) a = at(low), a.z = low;
    if (b.z > high) b = at(high), b.z = high;
    return side;
}

/// The shadow that a side below the point casts from it.
void add_shadow(std::vector<ShadowLine>& lines, const Local& point, const Side& side) {
    if (point.z <= 0) return;
    if (const auto below = between(side, 0, point.z * (1 - clearance)))
        lines.push_back({foot(point, below->first), foot(point, below->second)});
}

/// The shadow of a point, cast from along a side above it.
void add_sweep(std::vector<ShadowLine>& lines, const Local& point, const Side& side) {
    if (point.z <= 0) return;
    if (const auto above = between(side, point.z * (1 + clearance), HUGE_VAL))
        lines.push_back({foot(above->first, point), foot(above->second, point)});
}

/// Where the occluder's own plane meets the receiver's: there it is seen edge-on.
void add_plane(std::vector<ShadowLine>& lines, const Outline& occluder) {
    if (occluder.corners.size() < 3) return;
    const Local& origin = occluder.corners[0];
    Local normal;
    for (std::size_t k = 2; k < occluder.corners.size() && dot(normal, normal) == 0; ++k)
        normal = cross(occluder.corners[1] - origin, occluder.corners[k] - origin);
    const double slope = normal.x * normal.x + normal.y * normal.y;
    if (slope <= 1e-24 * dot(normal, normal)) return;
    const double distance = dot(normal, origin);
    const Point2D on{normal.x * distance / slope, normal.y * distance / slope};
    const double f = far_away / std::sqrt(slope);
    lines.push_back({{on.s - f * normal.y, on.t + f * normal.x}, {on.s + f * normal.y, on.t - f * normal.x}});
}

}  // namespace

Outline outline_of(const Scene& scene, const std::vector<PieceId>& pieces, const ReceiverFrame& frame) {
    Outline outline;
    std::map<std::pair<VertexId, VertexId>, int> sides;
    std::map<VertexId, Local> corners;
    for (PieceId piece : pieces) {
        outline.polygon = scene.piece(piece).polygon;
        const View<VertexId> loop = scene.corners(scene.piece(piece));
        for (std::size_t k = 0; k < loop.size(); ++k) {
            ++sides[std::minmax(loop[k], loop[(k + 1) % loop.size()])];
            corners.emplace(loop[k], frame.local(to_rational(scene.position(loop[k]))));
        }
    }
    for (const auto& [vertex, local] : corners) outline.corners.push_back(local);
    const bool planar = outline.polygon != no_polygon && scene.polygon(outline.polygon).planar;
    for (const auto& [ends, count] : sides)
        if (count == 1 || !planar) outline.sides.emplace_back(corners.at(ends.first), corners.at(ends.second));
    return outline;
}

std::vector<ShadowLine> shadow_lines(const Outline& light, const std::vector<Outline>& occluders) {
    std::vector<ShadowLine> lines;
    for (const Outline& occluder : occluders) {
        for (const Local& corner : light.corners)
            for (const Side& side : occluder.sides) add_shadow(lines, corner, side);
        for (const Local& corner : occluder.corners)
            for (const Side& side : light.sides) add_sweep(lines, corner, side);
        add_plane(lines, occluder);
    }
    std::size_t count = 0;
    for (const Outline& a : occluders)
        for (const Outline& b : occluders) count += a.polygon == b.polygon ? 0 : a.corners.size() * b.sides.size();
    if (lines.size() + count > many_lines) return lines;
    for (const Outline& a : occluders)
        for (const Outline& b : occluders)
            if (a.polygon != b.polygon)
                for (const Local& corner : a.corners)
                    for (const Side& side : b.sides) {
                        add_shadow(lines, corner, side);
                        add_sweep(lines, corner, side);
                    }
    return lines;
}

}  // namespace cob::radiosity
