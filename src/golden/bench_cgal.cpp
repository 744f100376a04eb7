// CGAL's own do_intersect(Triangle_3, Iso_cuboid_3) as a yes-or-no variant: does the polygon meet the closed box?
// CGAL 5.5 answers wrongly for triangles with two coincident vertices, exact kernels included; the pieces of a scene
// have none.
#include "geometry/convex_polygon.hpp"
#include "golden/bench_set.hpp"
#include "golden/cgal_variant.hpp"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>

namespace cob {

std::optional<std::array<double, 6>> cuboid_of(const BoxQuestion& question) {
    const ConvexPolygon corners = polygon_of(question.corners);
    const RationalPoint u = question.u.rational(), n = area_vector(corners);
    const auto axis_of = [](const RationalPoint& v) {
        int axis = -1, count = 0;
        for (int k = 0; k < 3; ++k)
            if (v[k] != 0) axis = k, ++count;
        return count == 1 ? axis : -1;
    };
    const int axis_u = axis_of(u), axis_n = axis_of(n);
    if (axis_u < 0 || axis_n < 0) return {};

    // The widened rectangle, and the height from its shorter side.
    RationalPoint low = corners[0], high = corners[0];
    for (const RationalPoint& corner : corners)
        for (int axis = 0; axis < 3; ++axis) {
            low[axis] = std::min(low[axis], corner[axis]);
            high[axis] = std::max(high[axis], corner[axis]);
        }
    std::optional<Rational> shorter;
    for (int axis = 0; axis < 3; ++axis) {
        if (axis == axis_n) continue;
        const Rational extent = high[axis] - low[axis];
        low[axis] -= question.margin * extent, high[axis] += question.margin * extent;
        const Rational widened = high[axis] - low[axis];
        if (!shorter || widened < *shorter) shorter = widened;
    }
    const Rational height = question.height * *shorter;
    if (n[axis_n] > 0)
        high[axis_n] += height;
    else
        low[axis_n] -= height;

    std::array<double, 6> bounds{};
    for (int axis = 0; axis < 3; ++axis) {
        const auto from = to_binary64(low[axis]), to = to_binary64(high[axis]);
        if (!from || !to) return {};
        bounds[static_cast<std::size_t>(axis)] = *from, bounds[static_cast<std::size_t>(axis + 3)] = *to;
    }
    return bounds;
}

namespace {

using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
using Epeck = CGAL::Exact_predicates_exact_constructions_kernel;

template <class Kernel>
class KernelVariant final : public CgalVariant {
public:
    explicit KernelVariant(const Scene& scene) : triangles_(scene.polygons().size()) {
        const auto point = [&](VertexId id) {
            const Point& p = scene.position(id);
            return typename Kernel::Point_3(p.x, p.y, p.z);
        };
        for (const Piece& piece : scene.pieces()) {
            const auto corners = scene.corners(piece);
            for (const auto& [a, b, c] : cut_into_triangles(scene, piece))
                triangles_[static_cast<std::size_t>(piece.polygon)].emplace_back(point(corners[a]), point(corners[b]),
                                                                                 point(corners[c]));
        }
    }

    void bench(const BenchSet& set, const BenchOptions& options, const char* name, std::vector<BenchRow>& rows) const {
        std::vector<BenchRow> kinds;
        for (const auto& [kind, boxes] : set.boxes) {
            std::vector<const BenchBox*> asked;
            std::vector<typename Kernel::Iso_cuboid_3> cuboids;
            for (const BenchBox& box : boxes)
                if (const auto corners = cuboid_of(box.question)) {
                    asked.push_back(&box);
                    cuboids.push_back(in_kernel(*corners));
                }
            std::vector<std::vector<char>> answers(asked.size());
            for (std::size_t k = 0; k < asked.size(); ++k) answers[k].resize(asked[k]->pairs.size());
            const auto ask = [&](std::size_t k) {
                for (std::size_t p = 0; p < asked[k]->pairs.size(); ++p)
                    answers[k][p] = meets(asked[k]->pairs[p].polygon, cuboids[k]);
            };
            const auto judge = [&](std::size_t k) {
                for (std::size_t p = 0; p < asked[k]->pairs.size(); ++p)
                    if ((answers[k][p] != 0) != (asked[k]->pairs[p].relation != Relation::disjoint))
                        return Outcome::wrong;
                return Outcome::right;
            };
            BenchRow row = measure(asked.size(), options, ask, judge);
            row.question = "box", row.variant = name, row.kind = kind;
            for (const auto& triangles : triangles_)
                row.bytes += triangles.size() * sizeof(typename Kernel::Triangle_3);
            if (row.questions > 0) kinds.push_back(std::move(row));
        }
        add_rows(rows, std::move(kinds));
    }

    bool meets(PolygonId polygon, const std::array<double, 6>& cuboid) const override {
        return meets(polygon, in_kernel(cuboid));
    }

private:
    static typename Kernel::Iso_cuboid_3 in_kernel(const std::array<double, 6>& corners) {
        return {typename Kernel::Point_3(corners[0], corners[1], corners[2]),
                typename Kernel::Point_3(corners[3], corners[4], corners[5])};
    }
    bool meets(PolygonId polygon, const typename Kernel::Iso_cuboid_3& cuboid) const {
        const auto& triangles = triangles_[static_cast<std::size_t>(polygon)];
        return std::any_of(triangles.begin(), triangles.end(),
                           [&](const auto& triangle) { return CGAL::do_intersect(triangle, cuboid); });
    }

    std::vector<std::vector<typename Kernel::Triangle_3>> triangles_;
};

}  // namespace

void bench_cgal(const BenchSet& set, const BenchOptions& options, std::vector<BenchRow>& rows) {
    if (set.boxes.empty()) return;
    KernelVariant<Epick>(set.scene).bench(set, options, "cgal-epick", rows);
    KernelVariant<Epeck>(set.scene).bench(set, options, "cgal-epeck", rows);
}

std::unique_ptr<const CgalVariant> make_cgal_variant(const Scene& scene, Peer kernel) {
    if (kernel == Peer::cgal_epeck) return std::make_unique<KernelVariant<Epeck>>(scene);
    return std::make_unique<KernelVariant<Epick>>(scene);
}

}  // namespace cob
