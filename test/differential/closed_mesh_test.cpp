// "No light leaks through a seam" (SPEC 6): from inside a closed mesh to its outside no open segment is clear,
// whichever vertex, edge or face it passes.
#include "differential/run.hpp"
#include "differential/scenes.hpp"
#include "naive/dice.hpp"

#include "cob/candidates.hpp"
#include "cob/visibility.hpp"

#include <algorithm>
#include <array>

namespace cob::test {
namespace {

using naive::Dice;
using Tetrahedron = std::array<RationalPoint, 4>;

/// Six times the volume.
Rational volume(const RationalPoint& a, const RationalPoint& b, const RationalPoint& c, const RationalPoint& d) {
    return dot(b - a, cross(c - a, d - a));
}

Rational volume(const Tetrahedron& t) {
    return volume(t[0], t[1], t[2], t[3]);
}

/// A solid of some of the tetrahedra that fill a block of 2^3 cells (Kuhn's six to a cell), its grid points moved by
/// less than what would turn a tetrahedron over. Rarely convex, often pinched at an edge or a vertex.
class Solid {
public:
    explicit Solid(Dice& dice) {
        const int moved = dice.pick({0, 0, 1});
        for (int k = 0; k < 27; ++k) {
            const auto jitter = [&] { return static_cast<double>(moved * dice.between(-1, 1)); };
            grid_[static_cast<std::size_t>(k)] = {8.0 * (k % 3) + jitter(), 8.0 * (k / 3 % 3) + jitter(),
                                                  8.0 * (k / 9) + jitter()};
        }
        const bool whole = dice.one_in(4);
        for (int cell = 0; cell < 8; ++cell) add_cell(dice, cell % 2 + cell / 2 % 2 * 3 + cell / 4 * 9, whole);
    }

    /// The triangles that belong to one tetrahedron of the solid only, outward; none where the solid is empty.
    std::vector<naive::Face> faces() const {
        std::map<std::array<int, 3>, std::vector<std::array<int, 3>>> by_corners;
        for (const Corners& t : corners_) {
            for (const auto& face :
                 {std::array<int, 3>{t[1], t[2], t[3]}, {t[0], t[3], t[2]}, {t[0], t[1], t[3]}, {t[0], t[2], t[1]}}) {
                std::array<int, 3> key = face;
                std::sort(key.begin(), key.end());
                by_corners[key].push_back(face);
            }
        }
        std::vector<naive::Face> result;
        for (const auto& [key, faces] : by_corners)
            if (faces.size() == 1) result.push_back({{at(faces[0][0]), at(faces[0][1]), at(faces[0][2])}, false});
        return result;
    }
    bool contains_strictly(const RationalPoint& point) const { return strictly_in(solid_, point); }
    /// Strictly inside a tetrahedron that is not of the solid, or far away.
    bool leaves_out(const RationalPoint& point) const {
        for (int axis = 0; axis < 3; ++axis)
            if (point[axis] < -2 || point[axis] > 18) return true;
        return strictly_in(rest_, point);
    }

private:
    using Corners = std::array<int, 4>;

    Point at(int corner) const { return grid_[static_cast<std::size_t>(corner)]; }

    void add_cell(Dice& dice, int low, bool whole) {
        // One tetrahedron for each order in which the axes are stepped along.
        const std::array<int, 3> step{1, 3, 9};
        std::array<int, 3> order{0, 1, 2};
        do {
            Corners t{low, 0, 0, 0};
            for (std::size_t k = 0; k < 3; ++k) t[k + 1] = t[k] + step[static_cast<std::size_t>(order[k])];
            if (volume(exact(t)) < 0) std::swap(t[2], t[3]);
            ASSERT_GT(volume(exact(t)), 0);
            const bool solid = whole || dice.one_in(2);
            (solid ? solid_ : rest_).push_back(exact(t));
            if (solid) corners_.push_back(t);
        } while (std::next_permutation(order.begin(), order.end()));
    }
    Tetrahedron exact(const Corners& t) const {
        return {to_rational(at(t[0])), to_rational(at(t[1])), to_rational(at(t[2])), to_rational(at(t[3]))};
    }
    static bool strictly_in(const std::vector<Tetrahedron>& tetrahedra, const RationalPoint& p) {
        return std::any_of(tetrahedra.begin(), tetrahedra.end(), [&](const Tetrahedron& t) {
            return volume(p, t[1], t[2], t[3]) > 0 && volume(t[0], p, t[2], t[3]) > 0 &&
                   volume(t[0], t[1], p, t[3]) > 0 && volume(t[0], t[1], t[2], p) > 0;
        });
    }

    std::array<Point, 27> grid_;
    std::vector<Corners> corners_;  ///< Of the solid's tetrahedra.
    std::vector<Tetrahedron> solid_, rest_;
};

TEST(ClosedMesh, NeverLeaks) {
    const Tally tally = run_cases(0, 60 * length, [](std::uint64_t seed, Tally& sum) {
        Dice dice(seed);
        const Solid solid(dice);
        const std::vector<naive::Face> faces = solid.faces();
        if (faces.empty()) return;
        const Scene scene = library_scene(faces);
        const auto source = make_candidates(scene, Source::tree);
        const VisibilityOracle oracle(scene, *source);
        for (int k = 0; k < 60; ++k) {
            const auto& corners = dice.any(faces).corners;
            const std::size_t first = static_cast<std::size_t>(dice.below(3));
            const RationalPoint a = to_rational(corners[first]), b = to_rational(corners[(first + 1) % 3]),
                                c = to_rational(corners[(first + 2) % 3]);
            const char* const places[] = {"through a vertex", "through an edge", "through a face"};
            const int place = dice.pick({0, 0, 1, 2});
            const RationalPoint through = place == 0   ? a
                                          : place == 1 ? a + Rational(dice.between(1, 3), 4) * (b - a)
                                                       : a + Rational(1, 4) * (b - a) + Rational(1, 2) * (c - a);
            // Along axes and diagonals many faces are seen edge-on.
            const int reach = dice.pick({1, 9});
            const RationalPoint along{dice.between(-reach, reach), dice.between(-reach, reach),
                                      dice.between(-reach, reach)};
            const RationalPoint x = through - Rational(1, dice.between(2, 9)) * along;
            const RationalPoint y = through + Rational(dice.between(1, 9), 4) * along;
            if (x == y) continue;
            const bool leaves = solid.contains_strictly(x) && solid.leaves_out(y);
            const bool enters = solid.leaves_out(x) && solid.contains_strictly(y);
            const bool passes = solid.leaves_out(x) && solid.leaves_out(y);
            if (!leaves && !enters && !passes) continue;
            const Visibility answer = oracle({ExactPoint(x), ExactPoint(y)});
            sum.count(to_text(answer));
            if (passes) continue;  // only for its answers, which may be any
            sum.count(places[place]);
            sum.compare(answer == Visibility::clear ? "leaks" : "does not leak", "does not leak",
                        "solid " + std::to_string(seed) + " segment " + std::to_string(k));
        }
    });
    expect_no_difference(tally);
    expect_shares(tally, {{"through a vertex", 0.1}, {"through an edge", 0.1}, {"through a face", 0.1}});
    expect_shares(tally, {{"grazing", 0.01}, {"blocked", 0.1}});
}

}  // namespace
}  // namespace cob::test
