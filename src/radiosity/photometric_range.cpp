#include "radiosity/photometric_range.hpp"

#include "cob/error.hpp"
#include "radiosity/mesh.hpp"

#include <cmath>

namespace cob::radiosity {
namespace {

constexpr double most_exitance = 1e300;  ///< Leaves room for channels, areas and reflections to add up.
constexpr double least_area = 1e-280;    ///< Near what binary64 holds.

/// In square units.
double area(const Scene& scene, const Polygon& polygon, int exponent) {
    double sum = 0;
    for (std::uint32_t k = 0; k < polygon.piece_count; ++k) {
        const View<VertexId> loop = scene.corners(scene.piece(static_cast<PieceId>(polygon.first_piece + k)));
        const auto at = [&](std::size_t corner) { return in_units(scene.position(loop[corner]), exponent); };
        Point twice{};
        for (std::size_t corner = 2; corner < loop.size(); ++corner)
            twice = twice + cross(at(corner - 1) - at(0), at(corner) - at(0));
        sum += std::hypot(twice.x, twice.y, twice.z) / 2;
    }
    return sum;
}

}  // namespace

void check_photometric_range(const Scene& scene) {
    const int exponent = unit_exponent(scene);
    for (PolygonId id = 0; id < scene.polygon_count(); ++id) {
        const Polygon& polygon = scene.polygon(id);
        if (!polygon.valid) continue;
        const Material& material = scene.material(id);
        for (const double emitted : material.emitted_exitance)
            if (emitted > most_exitance)
                throw InputError("material '" + material.name + "' emits too much",
                                 {scene.name(), polygon.line, to_text(emitted), "give a Ke of at most 1e300"});
        refuse_too_small(scene, id, area(scene, polygon, exponent));
    }
}

void refuse_too_small(const Scene& scene, PolygonId polygon, double area) {
    if (area < least_area)
        throw InputError(
            "polygon is too small beside the scene",
            {scene.name(), scene.polygon(polygon).line, std::to_string(polygon), "leave out what is so much larger"});
}

void check_solvable(const Scene& scene) {
    bool lit = false;
    for (PolygonId id = 0; id < scene.polygon_count(); ++id) {
        if (!scene.polygon(id).valid) continue;
        lit = lit || scene.is_light(id);
        for (const double rho : scene.material(id).reflectance)
            if (rho >= 1)
                throw InputError("material '" + scene.material(id).name +
                                     "' reflects everything: in a closed scene exitance would grow without end",
                                 {scene.name(), 0, to_text(rho), "give it a reflectance below 1"});
    }
    if (!lit)
        throw InputError("the scene has no light: everything stays black",
                         {scene.name(), 0, "", "give a material a Ke above 0"});
    check_photometric_range(scene);
}

}  // namespace cob::radiosity
