#include "geometry/patch_refinement.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace cob {
namespace {

/// About the greatest difference of coordinates: it chooses what to cut, nothing else.
double size_of(const ConvexPatch& patch) {
    double size = 0;
    for (const ExactPoint& p : patch.corners)
        for (const ExactPoint& q : patch.corners) {
            const Point d = p.nearest() - q.nearest();
            size = std::max({size, std::abs(d.x), std::abs(d.y), std::abs(d.z)});
        }
    return size;
}

ExactPoint middle(const ExactPoint& p, const ExactPoint& q) {
    return ExactPoint(Rational(1, 2) * (p.rational() + q.rational()));
}

std::vector<ConvexPatch> in_four(const ConvexPatch& t) {
    const ExactPoint &a = t.corners[0], &b = t.corners[1], &c = t.corners[2];
    const ExactPoint p = middle(a, b), q = middle(b, c), r = middle(c, a);
    return {{{a, p, r}}, {{p, b, q}}, {{r, q, c}}, {{p, q, r}}};
}

/// The larger of both patches is cut.
std::vector<PatchPair> cut(const PatchPair& pair) {
    const bool cut_a = !pair.a.is_point() && (pair.b.is_point() || size_of(pair.a) >= size_of(pair.b));
    std::vector<PatchPair> parts;
    for (ConvexPatch& part : in_four(cut_a ? pair.a : pair.b))
        parts.push_back(cut_a ? PatchPair{std::move(part), pair.b, {}, pair.between}
                              : PatchPair{pair.a, std::move(part), {}, pair.between});
    return parts;
}

}  // namespace

PairState decide(const Scene& scene, PatchPair& pair, const std::function<void()>& pulse) {
    {
        const Shaft shaft(pair.a, pair.b);
        auto& list = pair.between;
        list.erase(std::remove_if(list.begin(), list.end(),
                                  [&](PieceId piece) {
                                      if (pulse) pulse();
                                      return !shaft.meets(scene, scene.piece(piece));
                                  }),
                   list.end());
    }
    if (pair.between.empty()) return PairState::clear;
    const bool blocked = std::any_of(pair.between.begin(), pair.between.end(), [&](PieceId piece) {
        return lies_across(scene, scene.piece(piece), pair.a, pair.b);
    });
    return blocked ? PairState::blocked : PairState::open;
}

std::vector<ConvexPatch> triangles_of(const ConvexPolygon& polygon) {
    std::vector<ConvexPatch> triangles;
    for (std::size_t k = 2; k < polygon.size(); ++k)
        triangles.push_back({{ExactPoint(polygon[0]), ExactPoint(polygon[k - 1]), ExactPoint(polygon[k])}});
    return triangles;
}

RefinedPairs refine(const Scene& scene, std::vector<PatchPair> pairs,
                    const std::function<Range(const PatchPair&, const PatchPair&)>& measure,
                    const std::function<void(const PatchPair&, PairState)>& decided, const RefinementOptions& options) {
    // Sums run upwards or downwards by more than they are rounded.
    constexpr double up = 1 + 0x1p-50, down = 1 - 0x1p-50;
    const auto start = std::chrono::steady_clock::now();
    const auto smaller = [](const PatchPair& p, const PatchPair& q) { return p.measure.high < q.measure.high; };
    RefinedPairs result;
    std::vector<PatchPair> open;
    double width = 0;
    const auto look = [&](PatchPair pair) {
        ++result.pairs;
        const PairState state = decide(scene, pair, options.pulse);
        if (decided) decided(pair, state);
        if (state == PairState::clear) {
            result.clear.low = (result.clear.low + pair.measure.low) * down;
            result.clear.high = (result.clear.high + pair.measure.high) * up;
        } else if (state == PairState::open) {
            width += pair.measure.high;
            open.push_back(std::move(pair));
            std::push_heap(open.begin(), open.end(), smaller);
        }
    };
    for (PatchPair& pair : pairs) look(std::move(pair));
    while (!open.empty() && width > options.width && result.pairs < options.max_pairs) {
        if (options.seconds > 0 &&
            std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() > options.seconds)
            break;
        std::pop_heap(open.begin(), open.end(), smaller);
        const PatchPair pair = std::move(open.back());
        open.pop_back();
        width -= pair.measure.high;
        for (PatchPair& part : cut(pair)) {
            part.measure = measure(part, pair);
            look(std::move(part));
        }
    }
    for (const PatchPair& pair : open) result.open = (result.open + pair.measure.high) * up;
    return result;
}

}  // namespace cob
