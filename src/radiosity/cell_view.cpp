#include "radiosity/cell_view.hpp"

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <utility>

namespace cob::radiosity {
namespace {

/// A polygon's cone: planes with it on their positive sides, to the left; nothing where it is seen edge on.
struct CellCone {
    const CornerLoop* loop = nullptr;
    bool turned = false;   ///< Its corners run to the right as seen.
    bool decided = false;  ///< Else the plane of the polygon may cut the cell.

    std::pair<PlaneRef, VertexId> facing() const { return {loop->sides[0], loop->corners[2]}; }
    std::size_t size() const { return loop->corners.size(); }
    PlaneRef plane(std::size_t k) const { return turned ? -loop->sides[k] : loop->sides[k]; }
    VertexId corner(std::size_t k) const { return loop->corners[k % size()]; }
};

/// On the plane through x and a side, from ray to ray to the left.
struct Arc {
    PlaneRef plane;
    ContourRay from, to;
};

enum class Effect : std::uint8_t { keeps, removes };

/// What a cone does to an arc.
struct Clipper {
    Effect effect;
    const CellCone* cone;
    std::optional<std::size_t> common;  ///< The side in the arc's own plane for all x: it does not cut the arc.
    std::optional<std::pair<PlaneRef, VertexId>> waits_for;  ///< A sign without which nothing can be said.
};
using SidesOfCone = boost::container::small_vector<std::size_t, 8>;
using Clippers = std::vector<const Clipper*>;

enum class Common : std::uint8_t { none, some, undecided };

/// Finds the contour of one cell. Signs are asked for as late as can be: what is hidden or outside needs no more.
class ContourSearch {
public:
    ContourSearch(const PairShapes& shapes, SignsOverCell& signs, double doubt)
        : shapes_(shapes), signs_(signs), doubt_(doubt), numbers_(shapes.side_count(), -1) {}

    Contour run(const std::vector<CornerLoop>& lights, const std::vector<const CornerLoop*>& occluders);

private:
    std::optional<CellCone> cone_over(const CornerLoop& loop);
    void add_side(const CellCone& cone, std::size_t k, Effect effect);
    Clipper clipper(const Arc& arc, const CellCone& cone, Effect effect) const;
    std::vector<Clipper> hiding(const CellCone& cone, const Arc& arc, bool of_light);
    void reduce(Arc arc, Clippers pending, Effect effect);
    bool cutting_sides(PlaneRef plane, const Clipper& clipper, SidesOfCone& sides);
    Common clip(Arc& arc, const Clipper& clipper);
    void emit(const Arc& arc, Effect effect);
    std::int32_t number(std::int32_t side);

    const PairShapes& shapes_;
    SignsOverCell& signs_;
    double doubt_;
    std::vector<CellCone> lights_, occluders_;
    std::vector<std::int32_t> numbers_;  ///< Of sides in the contour.
    Contour contour_;
};

std::optional<CellCone> ContourSearch::cone_over(const CornerLoop& loop) {
    const auto facing = signs_.side(loop.sides[0], loop.corners[2]);
    if (facing && *facing == Sign::zero) return std::nullopt;
    return CellCone{&loop, facing && *facing == Sign::negative, facing.has_value()};
}

Clipper ContourSearch::clipper(const Arc& arc, const CellCone& cone, Effect effect) const {
    Clipper result{effect, &cone, shapes_.common_side(arc.plane.index, *cone.loop), {}};
    if (!cone.decided) result.waits_for = cone.facing();
    return result;
}

/// Those of the occluders that may hide a side.
///
/// A side is a border where one of its sides, left or right, is seen. Another polygon with a side in the same plane
/// lies on one of these only: it hides a light's side from its own side alone; an occluder's is no border where another
/// lies on the other side, and of several on the same side the first one's counts.
std::vector<Clipper> ContourSearch::hiding(const CellCone& cone, const Arc& arc, bool of_light) {
    std::vector<Clipper> result;
    result.reserve(occluders_.size());
    bool before = true;
    for (const CellCone& other : occluders_) {
        if (other.loop == cone.loop) {
            before = false;
            continue;
        }
        Clipper found = clipper(arc, other, Effect::removes);
        if (found.common) {
            if (!cone.decided) continue;
            const VertexId apex = other.corner(*found.common + 2);
            const auto which = signs_.side(arc.plane, apex);
            if (!which)
                found.waits_for = {arc.plane, apex};
            else if (const bool same_side = *which == Sign::positive; of_light ? !same_side : same_side && !before)
                continue;
        }
        result.push_back(found);
    }
    return result;
}

void ContourSearch::add_side(const CellCone& cone, std::size_t k, Effect effect) {
    const VertexId a = cone.corner(k), b = cone.corner(k + 1);
    const Arc arc{cone.plane(k), {cone.turned ? b : a, {}, {}}, {cone.turned ? a : b, {}, {}}};
    const bool of_light = effect == Effect::keeps;
    const std::vector<Clipper> others = hiding(cone, arc, of_light);
    // Whichever way it is seen, nothing may be left of a polygon whose plane may cut the cell.
    const Clipper undecided{Effect::keeps, &cone, {}, cone.facing()};
    Clippers all;
    if (!cone.decided) all.push_back(&undecided);
    for (const Clipper& other : others) all.push_back(&other);
    signs_.allow_doubt(0);
    if (of_light) return reduce(arc, std::move(all), effect);
    for (const CellCone& light : lights_) {
        const Clipper before_light = clipper(arc, light, Effect::keeps);
        if (before_light.common) continue;  // nothing of it, or the light's own side is the border
        Clippers with_light{&before_light};
        for (const Clipper* other : all) with_light.push_back(other);
        reduce(arc, std::move(with_light), effect);
        signs_.allow_doubt(0);
    }
}

/// The sides of the cone that may cut an arc on the plane: those that cross it, where that is known, else all. False
/// where the whole cone lies on one side.
bool ContourSearch::cutting_sides(PlaneRef plane, const Clipper& clipper, SidesOfCone& sides) {
    const CellCone& cone = *clipper.cone;
    const std::size_t n = cone.size();
    if (clipper.common) {
        sides = {(*clipper.common + 1) % n, (*clipper.common + n - 1) % n};
        return true;
    }
    boost::container::small_vector<Sign, 8> signs;
    for (std::size_t k = 0; k < n; ++k) {
        const auto sign = signs_.side(plane, cone.corner(k));
        if (!sign) {
            for (std::size_t j = 0; j < n; ++j) sides.push_back(j);
            return true;
        }
        signs.push_back(*sign);
    }
    for (const Sign side : {Sign::positive, Sign::negative})
        if (std::none_of(signs.begin(), signs.end(), [side](Sign sign) { return sign == side; })) return false;
    for (std::size_t k = 0; k < n; ++k)
        if (signs[k] != signs[(k + 1) % n]) sides.push_back(k);
    return true;
}

/// The arc's part in the cone.
Common ContourSearch::clip(Arc& arc, const Clipper& clipper) {
    if (clipper.waits_for) {
        signs_.side(clipper.waits_for->first, clipper.waits_for->second);  // to note it
        return Common::undecided;
    }
    SidesOfCone pending;
    if (!cutting_sides(arc.plane, clipper, pending)) return Common::none;
    for (bool changed = true; changed && !pending.empty();) {
        changed = false;
        std::size_t undecided = 0;
        for (const std::size_t k : pending) {
            const PlaneRef plane = clipper.cone->plane(k);
            const auto from = signs_.side(plane, arc.from), to = signs_.side(plane, arc.to);
            if (!from || !to) {
                pending[undecided++] = k;
                continue;
            }
            if (*from != Sign::positive && *to != Sign::positive) return Common::none;
            if (*from == Sign::negative) arc.from = {-1, plane, arc.plane}, changed = true;
            if (*to == Sign::negative) arc.to = {-1, arc.plane, plane}, changed = true;
        }
        pending.resize(undecided);
    }
    return pending.empty() ? Common::some : Common::undecided;
}

void ContourSearch::reduce(Arc arc, Clippers pending, Effect effect) {
    bool in_doubt = false;
    while (!pending.empty()) {
        bool changed = false;
        signs_.forget_undecided();
        for (std::size_t k = 0; k < pending.size();) {
            const Clipper& clipper = *pending[k];
            Arc inside = arc;
            const Common common = clip(inside, clipper);
            if (common == Common::undecided) {
                ++k;
                continue;
            }
            pending.erase(pending.begin() + static_cast<std::ptrdiff_t>(k));
            if (clipper.effect == Effect::keeps) {
                if (common == Common::none) return;
                changed = changed || !(inside.from == arc.from && inside.to == arc.to);
                arc = inside;
                continue;
            }
            if (common == Common::none) continue;
            const bool left = !(inside.from == arc.from), right = !(inside.to == arc.to);
            if (!left && !right) return;
            changed = true;
            const Arc first{arc.plane, arc.from, inside.from}, second{arc.plane, inside.to, arc.to};
            if (left && right) {
                reduce(first, pending, effect);
                reduce(second, std::move(pending), effect);
                return;
            }
            arc = left ? first : second;
        }
        if (changed || pending.empty()) continue;
        if (in_doubt || doubt_ == 0) throw *signs_.undecided();
        in_doubt = true;
        signs_.allow_doubt(doubt_);
    }
    emit(arc, effect);
}

std::int32_t ContourSearch::number(std::int32_t side) {
    std::int32_t& known = numbers_[static_cast<std::size_t>(side)];
    if (known < 0) {
        known = static_cast<std::int32_t>(contour_.sides.size());
        contour_.sides.push_back(shapes_.side(side));
    }
    return known;
}

void ContourSearch::emit(const Arc& arc, Effect effect) {
    const auto numbered = [&](ContourRay ray) {
        if (ray.vertex < 0) ray.first.index = number(ray.first.index), ray.second.index = number(ray.second.index);
        return ray;
    };
    const ContourRay from = numbered(arc.from), to = numbered(arc.to);
    const bool of_light = effect == Effect::keeps;
    contour_.arcs.push_back({number(arc.plane.index), of_light ? from : to, of_light ? to : from, of_light});
}

Contour ContourSearch::run(const std::vector<CornerLoop>& lights, const std::vector<const CornerLoop*>& occluders) {
    for (const CornerLoop& light : lights)
        if (const auto cone = cone_over(light)) lights_.push_back(*cone);
    for (const CornerLoop* occluder : occluders)
        if (const auto cone = cone_over(*occluder)) occluders_.push_back(*cone);
    for (const CellCone& light : lights_)
        for (std::size_t k = 0; k < light.size(); ++k) add_side(light, k, Effect::keeps);
    for (const CellCone& occluder : occluders_)
        for (std::size_t k = 0; k < occluder.size(); ++k) add_side(occluder, k, Effect::removes);
    contour_.sliver = signs_.sliver();
    contour_.doubtful = signs_.doubtful();
    return std::move(contour_);
}

}  // namespace

Contour CellView::visible_contour(const std::vector<CornerLoop>& lights,
                                  const std::vector<const CornerLoop*>& occluders, double doubt) {
    return ContourSearch(*shapes_, signs_, doubt).run(lights, occluders);
}

/// The side of the plane through x and a side on which all of the other lies, if it is one.
std::optional<Sign> CellView::outside_of(PlaneRef side, const CornerLoop& other) {
    std::optional<Sign> common;
    for (VertexId v : other.corners) {
        const auto sign = signs_.side_without_sliver(side, v);
        if (!sign) return std::nullopt;
        if (*sign == Sign::zero) continue;
        if (common && *common != *sign) return std::nullopt;
        common = sign;
    }
    return common;
}

bool CellView::apart(const CornerLoop& one, const CornerLoop& other) {
    // A plane through x and a side that has the two on different sides.
    for (const auto& [loop, against] : {std::pair{&one, &other}, std::pair{&other, &one}})
        for (const PlaneRef& side : loop->sides) {
            const auto own = outside_of(side, *loop);
            const auto others = own ? outside_of(side, *against) : std::nullopt;
            if (own && others && *own != *others) return true;
        }
    return false;
}

std::vector<const CornerLoop*> CellView::between(const std::vector<CornerLoop>& lights,
                                                 const std::vector<const CornerLoop*>& occluders) {
    std::vector<const CornerLoop*> result;
    for (const CornerLoop* occluder : occluders)
        if (!std::all_of(lights.begin(), lights.end(),
                         [&](const CornerLoop& light) { return apart(light, *occluder); }))
            result.push_back(occluder);
    return result;
}

}  // namespace cob::radiosity
