#include "cob/census.hpp"

#include "arithmetic/wide_integer.hpp"
#include "scene/box_tree.hpp"
#include "scene/contact.hpp"
#include "scene/edges.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <tuple>

namespace cob {
namespace {

void count_pieces(const Scene& scene, Census& census) {
    for (const Piece& piece : scene.pieces()) ++census.pieces[std::min<std::size_t>(piece.corner_count, 5) - 3];
}

/// What a loop looks like as seen, corner by corner.
struct LoopTraits {
    bool spikes = false, straight_angles = false;
};

LoopTraits traits_of(const Scene& scene, PolygonId id) {
    LoopTraits traits;
    const auto loop = scene.loop(id);
    const View2 view = scene.polygon(id).view;
    const auto seen = [&](std::size_t k) {
        const Point& p = scene.position(loop[k % loop.size()]);
        return Point2{p[view.first], p[view.second]};
    };
    for (std::size_t k = 0; k < loop.size(); ++k) {
        const Point2 before = seen(k), at = seen(k + 1), after = seen(k + 2);
        if (before == at || at == after || orientation(before, at, after) != Sign::zero) continue;
        (turns_back(before, at, after) ? traits.spikes : traits.straight_angles) = true;
    }
    return traits;
}

void describe_polygons(const Scene& scene, Census& census) {
    Bounds3 bounds;
    BitSpan bits;
    for (PolygonId id = 0; id < scene.polygon_count(); ++id) {
        const Polygon& polygon = scene.polygon(id);
        if (!polygon.valid) continue;
        ++census.valid;
        census.most_corners = std::max<std::size_t>(census.most_corners, polygon.corner_count);
        if (!polygon.planar) census.not_planar.push_back(id);
        if (polygon.planar && !polygon.convex) census.not_convex.push_back(id);
        if (scene.is_light(id)) census.lights.push_back(id);
        const LoopTraits traits = traits_of(scene, id);
        if (traits.spikes) census.with_spikes.push_back(id);
        if (traits.straight_angles) census.with_straight_angles.push_back(id);
        for (const VertexId corner : scene.loop(id)) {
            const Point& position = scene.position(corner);
            bounds.add(position);
            for (int axis = 0; axis < 3; ++axis) bits.add(position[axis]);
        }
    }
    census.lowest = bounds.low;
    census.highest = bounds.high;
    census.bits = bits.bits();
    census.lowest_bit = bits.only_zeros() ? 0 : bits.low;
}

void count_shared_edges(const EdgeTable& table, Census& census) {
    for (std::size_t edge = 0; edge < table.edge_count(); ++edge) {
        const auto sides = table.sides_of(edge);
        // A polygon's sides follow each other.
        std::size_t polygons = 0;
        for (std::size_t k = 0, next; k < sides.size(); k = next, ++polygons) {
            bool forward = false, backward = false;
            for (next = k; next < sides.size() && sides[next].polygon == sides[k].polygon; ++next)
                (sides[next].forward ? forward : backward) = true;
            if (forward && backward) census.with_bridges.push_back(sides[k].polygon);
        }
        if (polygons >= 2) ++census.shared_edges;
        if (polygons >= 3) ++census.crowded_edges;
    }
    std::sort(census.with_bridges.begin(), census.with_bridges.end());
    census.with_bridges.erase(std::unique(census.with_bridges.begin(), census.with_bridges.end()),
                              census.with_bridges.end());
}

/// A polygon with a corner at the position, and another one with the edge as a side; none: the same one has both.
std::optional<TJunction> t_junction(const EdgeTable& table, std::size_t position, std::size_t edge) {
    for (const EdgeTable::Side& side : table.sides_of(edge))
        for (const PolygonId polygon : table.polygons_at(position))
            if (polygon != side.polygon) return TJunction{polygon, side.polygon, table.vertex(position), side.number};
    return std::nullopt;
}

void find_t_junctions(const EdgeTable& table, const CensusOptions& options, Census& census) {
    std::vector<Bounds3> boxes(table.edge_count());
    for (std::size_t edge = 0; edge < boxes.size(); ++edge) {
        boxes[edge].add(table.from(edge));
        boxes[edge].add(table.to(edge));
    }
    const BoxTree tree(std::move(boxes));
    for (std::size_t position = 0; position < table.position_count(); ++position) {
        const Point& point = table.position(position);
        Bounds3 here;
        here.add(point);
        std::vector<std::size_t> edges;
        tree.find(here, [&](std::uint32_t edge) {
            if (is_between(point, table.from(edge), table.to(edge))) edges.push_back(edge);
        });
        std::sort(edges.begin(), edges.end());
        bool any = false;
        for (const std::size_t edge : edges) {
            const auto junction = t_junction(table, position, edge);
            if (!junction) continue;
            any = true;
            if (census.t_junction_pairs++ < options.most_listed) census.t_junctions.push_back(*junction);
        }
        census.t_junction_corners += any ? 1 : 0;
    }
    std::sort(census.t_junctions.begin(), census.t_junctions.end(), [](const TJunction& a, const TJunction& b) {
        return std::tie(a.side_of, a.side, a.corner_of, a.corner) < std::tie(b.side_of, b.side, b.corner_of, b.corner);
    });
}

void find_overlaps(const Scene& scene, const CensusOptions& options, Census& census) {
    std::vector<Bounds3> boxes(scene.pieces().size());
    for (std::size_t piece = 0; piece < boxes.size(); ++piece)
        for (const VertexId corner : scene.corners(scene.pieces()[piece])) boxes[piece].add(scene.position(corner));
    const BoxTree tree(std::move(boxes));

    std::vector<bool> is_repeat(scene.polygons().size());
    for (PolygonId first = 0; first < scene.polygon_count(); ++first) {
        // Both polygons' pieces are met one by one; a pair of polygons counts once.
        std::map<PolygonId, bool> met;
        const auto begin = scene.polygon(first).first_piece, end = begin + scene.polygon(first).piece_count;
        for (std::uint32_t piece = begin; piece < end; ++piece) {
            const Sheet sheet(scene, scene.pieces()[piece]);
            tree.find(tree.box(piece), [&](std::uint32_t other) {
                const Piece& candidate = scene.pieces()[other];
                if (candidate.polygon <= first || met.count(candidate.polygon) > 0) return;
                const Overlap overlap = sheet.overlap(scene, candidate);
                if (overlap != Overlap::none) met[candidate.polygon] = overlap == Overlap::same_facing;
            });
        }
        for (const auto& [second, same_facing] : met) {
            const bool duplicate = is_duplicate(scene, first, second);
            if (duplicate) is_repeat[static_cast<std::size_t>(second)] = true;
            if (same_facing) ++census.same_facing_overlap_pairs;
            if (census.overlap_pairs++ < options.most_listed)
                census.overlaps.push_back({first, second, same_facing, duplicate});
        }
    }
    census.duplicates = static_cast<std::size_t>(std::count(is_repeat.begin(), is_repeat.end(), true));
}

}  // namespace

Census take_census(const Scene& scene, const CensusOptions& options) {
    Census census;
    count_pieces(scene, census);
    describe_polygons(scene, census);
    const EdgeTable table(scene);
    count_shared_edges(table, census);
    find_t_junctions(table, options, census);
    find_overlaps(scene, options, census);
    return census;
}

}  // namespace cob
