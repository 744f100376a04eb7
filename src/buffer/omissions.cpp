#include "cob/omissions.hpp"

#include "buffer/scene_facts.hpp"
#include "cob/error.hpp"

#include <algorithm>
#include <limits>

namespace cob {
namespace {

std::string name(PolygonId polygon) {
    return "polygon " + std::to_string(polygon);
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
            return {true, "no buffer is built from one with many polygons around it, but from the scene"};
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

void Omissions::apply_to(BufferOptions& options) const {
    options.arithmetic = (*this)(Omission::filter) ? Arithmetic::exact : Arithmetic::rational;
    options.all_lights = !(*this)(Omission::lights);
    if (!(*this)(Omission::levels)) options.longest_list = std::numeric_limits<std::size_t>::max();
}

}  // namespace cob
