#include "cob/omissions.hpp"

#include "arithmetic/orientation.hpp"
#include "cob/error.hpp"
#include "geometry/bounds.hpp"
#include "scene/piece_plane.hpp"

#include <algorithm>

namespace cob {
namespace {

/// Most pairs that are looked at for one fact: some milliseconds.
constexpr std::uint64_t most_pairs = 1 << 20;
/// Preparing a box costs about as much as looking at so many pairs.
constexpr std::uint64_t pairs_per_box = 256;

std::string name(PolygonId polygon) {
    return "polygon " + std::to_string(polygon);
}

/// A fact, and the reason for it or against it.
struct Fact {
    bool holds = false;
    std::string reason;
};

/// No piece reaches strictly behind the plane of another. Then a segment between two of them that leaves the one in
/// front and arrives at the other's front meets a third piece at its ends at most: a point of its inside that is on a
/// plane would put both ends on it, and with them, all being in front, both pieces.
Fact find_convex(const Scene& scene) {
    std::uint64_t looked = 0;
    for (const Piece& wall : scene.pieces()) {
        const std::array<Point, 3> plane = plane_of(scene, wall);
        for (const Piece& other : scene.pieces()) {
            for (const VertexId corner : scene.corners(other))
                if (orientation(plane[0], plane[1], plane[2], scene.position(corner)) == Sign::negative)
                    return {false, name(other.polygon) + " reaches behind the plane of " + name(wall.polygon)};
            if (++looked > most_pairs) return {false, "too many polygons to compare each with each"};
        }
    }
    return {true, "the scene is convex: no polygon reaches behind the plane of another"};
}

/// The bounds of the box over every root are met by no other polygon. Boxes of elements lie within.
Fact find_apart(const Scene& scene, const Roots& roots, const OmissionOptions& options) {
    std::vector<Bounds> bounds;
    for (PolygonId p = 0; p < scene.polygon_count(); ++p) bounds.push_back(bounds_of(scene, scene.loop(p)));
    std::uint64_t looked = 0;
    for (RootId id = 0; id < roots.size(); ++id) {
        const Root& root = roots[id];
        const Box box(box_question(scene, root, root_element(id), options.margin, options.height));
        const auto& b = box.bounds();
        const Bounds around{{b[0], b[1], b[2]}, {b[3], b[4], b[5]}};
        looked += pairs_per_box;
        for (PolygonId p = 0; p < scene.polygon_count(); ++p) {
            if (p != root.polygon && scene.polygon(p).valid && bounds[static_cast<std::size_t>(p)].meets(around))
                return {false, name(p) + " is near the box of " + name(root.polygon)};
            if (++looked > most_pairs) return {false, "too many polygons to compare each with each"};
        }
    }
    return {true, "no polygon is near the box of another"};
}

Fact find_grey(const Scene& scene) {
    const auto grey = [](const std::array<double, 3>& c) { return c[0] == c[1] && c[1] == c[2]; };
    for (PolygonId p = 0; p < scene.polygon_count(); ++p) {
        if (!scene.polygon(p).valid) continue;
        const Material& material = scene.material(p);
        if (!grey(material.reflectance) || !grey(material.emitted_exitance))
            return {false, name(p) + " is coloured ('" + material.name + "')"};
    }
    return {true, "all materials in use are grey"};
}

Fact find_black(const Scene& scene) {
    std::size_t black = 0, all = 0;
    for (PolygonId p = 0; p < scene.polygon_count(); ++p) {
        if (!scene.polygon(p).valid) continue;
        ++all;
        black += is_black(scene.material(p));
    }
    if (black == 0) return {false, "every polygon reflects or emits"};
    return {true, std::to_string(black) + " of " + std::to_string(all) + " polygons neither reflect nor emit"};
}

Fact find_lights(const Scene& scene) {
    std::size_t lights = 0;
    for (PolygonId p = 0; p < scene.polygon_count(); ++p) lights += scene.is_light(p);
    if (lights == 0) return {true, "the scene has no light"};
    return {true, "of " + std::to_string(lights) + (lights == 1 ? " light" : " lights") +
                      ", only what is close to an element is tested for facing it"};
}

Fact find_few(const Scene& scene) {
    const std::string count = std::to_string(scene.polygon_count());
    if (scene.polygon_count() > few_polygons) return {false, count + " polygons are looked for in a tree"};
    return {true, count + " polygons are looked through faster than a tree"};
}

Fact find(Omission omission, const Scene& scene, const Roots& roots, const OmissionOptions& options) {
    switch (omission) {
        case Omission::convex:
            return find_convex(scene);
        case Omission::shaft:
            return {true, "found out for each shooter and each patch"};
        case Omission::filter:
            return {true, "exact arithmetic only where the filter fails"};
        case Omission::lights:
            return find_lights(scene);
        case Omission::buffers:
            return find_apart(scene, roots, options);
        case Omission::grey:
            return find_grey(scene);
        case Omission::black:
            return find_black(scene);
        case Omission::tree:
            return find_few(scene);
        case Omission::levels:
            return {true, "a second level of buffers only where few polygons are around (--buffer auto)"};
    }
    return {};
}

}  // namespace

const char* to_text(Omission omission) {
    switch (omission) {
        case Omission::convex:
            return "convex";
        case Omission::shaft:
            return "shaft";
        case Omission::filter:
            return "filter";
        case Omission::lights:
            return "lights";
        case Omission::buffers:
            return "buffers";
        case Omission::grey:
            return "grey";
        case Omission::black:
            return "black";
        case Omission::tree:
            return "tree";
        case Omission::levels:
            return "levels";
    }
    return "";
}

OmissionSet OmissionSet::all() {
    OmissionSet result;
    result.bits_.set();
    return result;
}

OmissionSet OmissionSet::parse(const std::string& names) {
    OmissionSet result;
    for (std::size_t begin = 0; begin < names.size();) {
        const std::size_t end = std::min(names.find(',', begin), names.size());
        const std::string one = names.substr(begin, end - begin);
        const auto found = std::find_if(all_omissions.begin(), all_omissions.end(),
                                        [&](Omission omission) { return one == cob::to_text(omission); });
        if (found == all_omissions.end())
            throw InputError("no such omission", {"", 0, one, "choose of " + all().to_text()});
        result.add(*found);
        begin = end + 1;
    }
    return result;
}

std::string OmissionSet::to_text() const {
    std::string text;
    for (const Omission omission : all_omissions)
        if (has(omission)) text += (text.empty() ? "" : ",") + std::string(cob::to_text(omission));
    return text;
}

Omissions::Omissions(const Scene& scene, const Roots& roots, const OmissionOptions& options) {
    for (const Omission omission : all_omissions) {
        const Fact fact = find(omission, scene, roots, options);
        decisions_[static_cast<std::size_t>(omission)] = {omission, fact.holds, options.keep.has(omission),
                                                          fact.reason};
    }
}

}  // namespace cob
