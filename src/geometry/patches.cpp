// The first cut of a root, into patches of the wanted size (SPEC 3).
#include "arithmetic/lengths.hpp"
#include "cob/error.hpp"
#include "cob/geometry.hpp"

#include <algorithm>
#include <cmath>

namespace cob {
namespace {

constexpr int most_levels = 31;

/// The fewest halvings that bring a side to at most `edge`.
int halvings(const Scene& scene, const Root& root, std::size_t from, std::size_t to, double edge) {
    const Point &a = scene.position(root.corners[from]), &b = scene.position(root.corners[to]);
    int count = 0;
    while (compare_length(a, b, edge, count) == Sign::positive)
        if (++count > most_levels)
            throw InputError("edge is too short for the scene", {"", 0, to_text(edge), "choose a longer one"});
    return count;
}

void refuse_more_than_most(int levels_i, int levels_j, double edge) {
    if (levels_i + levels_j > most_levels)
        throw InputError("edge is too short: more than 2^31 patches on one piece",
                         {"", 0, to_text(edge), "choose a longer one"});
}

std::vector<Element> quadrilateral_patches(const Scene& scene, const Root& root, double edge) {
    const auto side = [&](std::size_t from, std::size_t to) { return halvings(scene, root, from, to, edge); };
    const int levels_i = std::max(side(0, 1), side(3, 2)), levels_j = std::max(side(1, 2), side(0, 3));
    refuse_more_than_most(levels_i, levels_j, edge);
    std::vector<Element> patches;
    patches.reserve(std::size_t{1} << (levels_i + levels_j));
    for (std::uint32_t j = 0; j < std::uint32_t{1} << levels_j; ++j)
        for (std::uint32_t i = 0; i < std::uint32_t{1} << levels_i; ++i)
            patches.push_back(
                {root.id, i, j, static_cast<std::uint8_t>(levels_i), static_cast<std::uint8_t>(levels_j), false});
    return patches;
}

std::vector<Element> triangle_patches(const Scene& scene, const Root& root, double edge) {
    const auto side = [&](std::size_t from, std::size_t to) { return halvings(scene, root, from, to, edge); };
    const int levels = std::max({side(0, 1), side(1, 2), side(2, 0)});
    refuse_more_than_most(levels, levels, edge);
    const auto level = static_cast<std::uint8_t>(levels);
    const std::uint32_t count = std::uint32_t{1} << levels;
    std::vector<Element> patches;
    patches.reserve(std::size_t{count} * count);
    for (std::uint32_t j = 0; j < count; ++j)
        for (std::uint32_t i = 0; i + j < count; ++i) {
            patches.push_back({root.id, i, j, level, level, false});
            if (i + j + 1 < count) patches.push_back({root.id, i, j, level, level, true});
        }
    return patches;
}

}  // namespace

std::vector<Element> patches(const Scene& scene, const Root& root, double edge) {
    if (!(edge > 0) || !std::isfinite(edge)) return {root_element(root.id)};
    return root.corner_count() == 4 ? quadrilateral_patches(scene, root, edge) : triangle_patches(scene, root, edge);
}

}  // namespace cob
