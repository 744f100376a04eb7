// How many answers hang on the last bit of the coordinates.
#include "cob/error.hpp"
#include "cob/stress.hpp"
#include "report/stress_scene.hpp"
#include "report/text.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

namespace cob {
namespace {

/// A fixed pattern of bits (splitmix64).
std::uint64_t mixed(std::uint64_t x) {
    x += 0x9e3779b97f4a7c15U;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9U;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebU;
    return x ^ (x >> 31);
}

/// Every coordinate one ulp up or down. Positions that were equal stay so: the direction hangs on the position alone.
Scene moved(const Scene& scene, std::uint64_t pattern) {
    Scene::Input input = input_of(scene);
    std::map<Point, std::uint64_t> number;
    for (Point& p : input.positions) {
        const std::uint64_t bits = mixed(pattern ^ mixed(number.emplace(p, number.size()).first->second));
        for (int axis = 0; axis < 3; ++axis) {
            const double infinity = std::numeric_limits<double>::infinity();
            p[axis] = std::nextafter(p[axis], (bits >> axis) & 1 ? infinity : -infinity);
        }
    }
    return Scene::build(std::move(input), Scene::Options{true});
}

struct Changes {
    std::uint64_t boxes = 0, relations = 0, relations_changed = 0, close_changed = 0, states_changed = 0;
    std::uint64_t segments = 0, segments_changed = 0;
    std::uint64_t now_blocked = 0, no_longer_blocked = 0;  ///< Of them.
    std::uint64_t refused = 0;                             ///< Boxes over triangles without area, before.
};

/// The same triangles in both scenes: those that the moved polygons are cut into, each on its vertices.
class Comparison {
public:
    Comparison(const Scene& before, const Scene& after)
        : before_(before),
          after_(after),
          roots_(after),
          sources_{make_candidates(before, Source::tree), make_candidates(after, Source::tree)},
          oracles_{VisibilityOracle(before, *sources_[0]), VisibilityOracle(after, *sources_[1])} {}

    Changes run(std::size_t most_boxes, std::size_t most_segments) {
        for (RootId r = 0; r < roots_.size(); r += stride(most_boxes / 4))
            for (const Element& element : children(roots_[r], root_element(r))) compare_box(roots_[r], element);
        for (std::size_t s = 0; s < most_segments; ++s) compare_segment(s);
        return changes_;
    }

private:
    RootId stride(std::size_t most) const {
        return std::max<RootId>(1, roots_.size() / static_cast<RootId>(std::max<std::size_t>(1, most)));
    }

    std::optional<Box> box(const Scene& scene, const Root& root, const Element& element) const {
        try {
            return Box(box_question(scene, root, element, Rational(1, 8), Rational(1, 4)));
        } catch (const InputError&) {
            return std::nullopt;  // three vertices in a row, until they are moved
        }
    }

    void compare_box(const Root& root, const Element& element) {
        const std::optional<Box> a = box(before_, root, element), b = box(after_, root, element);
        if (!a || !b) {
            ++changes_.refused;
            return;
        }
        ++changes_.boxes;
        std::uint64_t changed_close = 0;
        for (PolygonId p = 0; p < before_.polygon_count(); ++p) {
            if (p == root.polygon || !before_.polygon(p).valid || !after_.polygon(p).valid) continue;
            const BoxAnswer x = relate(before_, p, *a), y = relate(after_, p, *b);
            if (x.relation == Relation::disjoint && y.relation == Relation::disjoint) continue;
            ++changes_.relations;
            if (x.relation != y.relation || x.covers != y.covers) ++changes_.relations_changed;
            if (is_close(x.relation) != is_close(y.relation)) ++changed_close;
        }
        changes_.close_changed += changed_close;
        if (changed_close > 0) ++changes_.states_changed;
    }

    /// Between inner points of two triangles, which move with them.
    void compare_segment(std::size_t s) {
        const auto pick = [&](std::uint64_t seed) {
            return roots_[static_cast<RootId>(mixed(seed) % static_cast<std::uint64_t>(roots_.size()))];
        };
        const Root from = pick(2 * s), to = pick(2 * s + 1);
        if (from.polygon == to.polygon) return;
        const auto point = [](const Scene& scene, const Root& root) {
            return point_in(scene, root, root_element(root.id), 0.25, 0.375);
        };
        const auto see = [&](int side, const Scene& scene) {
            return oracles_[static_cast<std::size_t>(side)](Segment{point(scene, from), point(scene, to), -1, -1});
        };
        if (point(before_, from) == point(before_, to) || point(after_, from) == point(after_, to)) return;
        const Visibility x = see(0, before_), y = see(1, after_);
        ++changes_.segments;
        if (x != y) ++changes_.segments_changed;
        if (x != Visibility::blocked && y == Visibility::blocked) ++changes_.now_blocked;
        if (x == Visibility::blocked && y != Visibility::blocked) ++changes_.no_longer_blocked;
    }

    const Scene& before_;
    const Scene& after_;
    Roots roots_;
    std::array<std::unique_ptr<CandidateSource>, 2> sources_;
    std::array<VisibilityOracle, 2> oracles_;
    Changes changes_;
};

}  // namespace

std::vector<StressRow> stress_sensitivity(const Scene& scene, const std::string& name, const StressOptions& options) {
    std::vector<StressRow> rows;
    for (const std::uint64_t pattern : {1, 2, 3}) {
        if (options.quick && pattern > 1) break;
        if (options.progress) options.progress(pattern, 0);
        const Scene after = moved(scene, pattern);
        const Changes c = Comparison(scene, after).run(options.quick ? 100 : 1000, options.quick ? 500 : 5000);
        const std::string text = printed(
            "of %llu relations not disjoint %llu change, %llu of them between close and not, at %llu of %llu "
            "boxes; of %llu segments %llu change, %llu to blocked, %llu from it; %zu polygons were not "
            "planar, %zu are not now",
            static_cast<unsigned long long>(c.relations), static_cast<unsigned long long>(c.relations_changed),
            static_cast<unsigned long long>(c.close_changed), static_cast<unsigned long long>(c.states_changed),
            static_cast<unsigned long long>(c.boxes), static_cast<unsigned long long>(c.segments),
            static_cast<unsigned long long>(c.segments_changed), static_cast<unsigned long long>(c.now_blocked),
            static_cast<unsigned long long>(c.no_longer_blocked),
            static_cast<std::size_t>(std::count_if(scene.polygons().begin(), scene.polygons().end(),
                                                   [](const Polygon& p) { return !p.planar; })),
            static_cast<std::size_t>(std::count_if(after.polygons().begin(), after.polygons().end(),
                                                   [](const Polygon& p) { return !p.planar; })));
        rows.push_back(
            {"sensitivity", name + ", one ulp, pattern " + std::to_string(pattern), "a figure", text, Verdict::figure});
    }
    return rows;
}

}  // namespace cob
