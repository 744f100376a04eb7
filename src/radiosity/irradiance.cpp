#include "cob/irradiance.hpp"

#include "cob/error.hpp"
#include "radiosity/plane_sheets.hpp"
#include "radiosity/visible_light.hpp"

#include <limits>
#include <optional>

namespace cob {

using namespace radiosity;

struct IrradianceOracle::Implementation {
    struct Light {
        LightPieces pieces;
        std::array<double, 6> bounds{};  ///< Of the polygon.
    };

    Implementation(const Scene& s, const CandidateSource& c) : scene(s), candidates(c), pieces(s) {
        for (PolygonId polygon = 0; polygon < scene.polygon_count(); ++polygon)
            if (scene.is_light(polygon)) lights.push_back(polygon);
        prepared.reserve(lights.size());
        for (PolygonId light : lights) prepared.push_back(prepare(light));
    }

    Light prepare(PolygonId polygon) const {
        Light light;
        append_pieces(polygon, light.pieces.pieces);
        for (PolygonId sheet : sheets_on_top(scene, polygon, candidates)) append_pieces(sheet, light.pieces.on_top);
        light.bounds = bounds_of_polygon(scene, polygon);
        return light;
    }

    void append_pieces(PolygonId polygon, std::vector<PieceId>& list) const {
        const Polygon& shape = scene.polygon(polygon);
        for (std::uint32_t k = 0; k < shape.piece_count; ++k)
            list.push_back(static_cast<PieceId>(shape.first_piece + k));
    }

    /// Every piece that meets the bounds of the point and the light together.
    std::vector<PieceId> occluders(const ExactPoint& point, std::array<double, 6> bounds) const {
        constexpr double infinity = std::numeric_limits<double>::infinity();
        for (int axis = 0; axis < 3; ++axis) {
            bounds[axis] = std::min(bounds[axis], std::nextafter(point.nearest()[axis], -infinity));
            bounds[axis + 3] = std::max(bounds[axis + 3], std::nextafter(point.nearest()[axis], infinity));
        }
        struct Search {
            const Implementation& self;
            std::vector<PieceId> found;
        } search{*this, {}};
        candidates.polygons_in(bounds, {&search, [](void* context, std::int32_t polygon) {
                                            auto& s = *static_cast<Search*>(context);
                                            s.self.append_pieces(polygon, s.found);
                                            return true;
                                        }});
        // Trees name them in their own order; regions do not depend on it, but the rounding of their sums does.
        std::sort(search.found.begin(), search.found.end());
        return std::move(search.found);
    }

    const Scene& scene;
    const CandidateSource& candidates;
    PreparedPieces pieces;
    std::vector<PolygonId> lights;
    std::vector<Light> prepared;  ///< In the order of lights.
};

IrradianceOracle::IrradianceOracle(const Scene& scene, const CandidateSource& candidates)
    : implementation_(std::make_unique<Implementation>(scene, candidates)) {}
IrradianceOracle::~IrradianceOracle() = default;

const std::vector<PolygonId>& IrradianceOracle::lights() const {
    return implementation_->lights;
}

LightAtPoint IrradianceOracle::operator()(const ExactPoint& point, const RationalPoint& normal, PolygonId light) const {
    if (normal == RationalPoint{}) throw InputError("the normal is zero: give a direction");
    const Implementation& self = *implementation_;
    const auto known = std::lower_bound(self.lights.begin(), self.lights.end(), light);
    const bool is_light = known != self.lights.end() && *known == light;
    std::optional<Implementation::Light> other;
    const Implementation::Light& prepared = is_light
                                                ? self.prepared[static_cast<std::size_t>(known - self.lights.begin())]
                                                : other.emplace(self.prepare(light));
    const LightView view = view_light(Viewpoint(self.pieces, point), ReceiverNormal(normal), prepared.pieces,
                                      self.occluders(point, prepared.bounds), Precision::certain);
    return {view.unobstructed, view.visible, view.solid_angle, view.parts};
}

}  // namespace cob
