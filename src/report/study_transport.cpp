// Full transport: a direct solution of the discrete system, with form factors from exact visibility.
//
// Letters as in SPEC 8. M_i = E_i + rho_i sum_j F_ij M_j for patches i, j of constant exitance M; F_ij from
// four points of i to what of j is seen from there, exactly found and in closed form. At any other point M follows by
// one more sum of the same kind, so that shadows are as sharp there as they truly are.
#include "arithmetic/shared_progress.hpp"
#include "arithmetic/threads.hpp"
#include "cob/form_factor.hpp"
#include "geometry/bounds.hpp"
#include "radiosity/between.hpp"
#include "radiosity/mesh.hpp"
#include "radiosity/plane_sheets.hpp"
#include "radiosity/planes.hpp"
#include "radiosity/visible_light.hpp"
#include "report/study_points.hpp"

#include <Eigen/Dense>

#include <cmath>

namespace cob {
namespace {

using namespace radiosity;

/// Four points with equal weights, inside patches.
constexpr std::array<std::array<double, 2>, 4> quadrilateral_points{
    {{0.2113, 0.2113}, {0.7887, 0.2113}, {0.2113, 0.7887}, {0.7887, 0.7887}}};
constexpr std::array<std::array<double, 2>, 4> triangle_points{
    {{1.0 / 6, 1.0 / 6}, {2.0 / 3, 1.0 / 6}, {1.0 / 6, 2.0 / 3}, {1.0 / 3, 1.0 / 3}}};

/// One patch of the system. It stands as a polygon of its own behind those of the scene, so that it can be looked at.
struct SystemPatch {
    RootId root = -1;
    Element element;
    std::array<Point, 4> corners{};  ///< Rounded.
    PatchShape shape;                ///< The same in units (mesh.hpp).
    LightPieces pieces;
};

class TransportSystem {
public:
    TransportSystem(const Scene& scene, const Roots& roots, double edge)
        : scene_(scene),
          roots_(roots),
          exponent_(unit_exponent(scene)),
          planes_(scene, exponent_),
          between_(scene, planes_) {
        find_sheets();
        Scene::Input input = input_of(scene);
        for (const Root& root : roots.all())
            for (const Element& element : patches(scene, root, edge)) add_patch(root, element, input);
        together_ = std::make_unique<Scene>(Scene::build(std::move(input), Scene::Options{true}));
        for (std::size_t k = 0; k < patches_.size(); ++k) {
            const Polygon& polygon = together_->polygon(scene.polygon_count() + static_cast<PolygonId>(k));
            for (std::uint32_t piece = 0; piece < polygon.piece_count; ++piece)
                patches_[k].pieces.pieces.push_back(static_cast<PieceId>(polygon.first_piece + piece));
            patches_[k].pieces.on_top = on_top_[static_cast<std::size_t>(patches_[k].root)];
        }
        prepared_ = std::make_unique<PreparedPieces>(*together_);
    }

    std::size_t size() const { return patches_.size(); }

    void solve(int threads, const Progress& progress) {
        const auto n = static_cast<Eigen::Index>(size());
        // Row by row: what each patch sees, from four points in it.
        Eigen::MatrixXd form_factors = Eigen::MatrixXd::Zero(n, n);
        for_each(size(), threads, progress, [&](std::size_t i) {
            const SystemPatch& patch = patches_[i];
            const Root& root = roots_[patch.root];
            const RationalPoint normal = point_on_root(scene_, root, {0, 0}).normal;
            for (const auto& [s, t] : root.corner_count() == 3 ? triangle_points : quadrilateral_points)
                form_factors.row(static_cast<Eigen::Index>(i)) +=
                    seen_from({point_in(scene_, root, patch.element, s, t), normal}, patch.root) / 4;
        });
        // Channel by channel.
        exitance_.resize(n, 3);
        for (int c = 0; c < 3; ++c) {
            Eigen::MatrixXd system = -form_factors;
            Eigen::VectorXd emitted(n);
            for (Eigen::Index i = 0; i < n; ++i) {
                const Material& material = scene_.material(roots_[patches_[static_cast<std::size_t>(i)].root].polygon);
                system.row(i) *= material.reflectance[static_cast<std::size_t>(c)];
                system(i, i) += 1;
                emitted(i) = material.emitted_exitance[static_cast<std::size_t>(c)];
            }
            exitance_.col(c) = system.partialPivLu().solve(emitted);
        }
    }

    /// Reflected exitance at a point of a root.
    Rgb reflected(const PointOnRoot& x, RootId root) const {
        const Eigen::RowVector3d irradiance = seen_from(x, root) * exitance_;
        Rgb result;
        for (std::size_t c = 0; c < 3; ++c)
            result[c] = scene_.material(roots_[root].polygon).reflectance[c] * irradiance(static_cast<Eigen::Index>(c));
        return result;
    }

    /// Calls act(0 ... count - 1) on several threads; `progress` may throw to end the work.
    template <class Act>
    static void for_each(std::size_t count, int threads, const Progress& progress, const Act& act) {
        SharedProgress done(progress, count);
        in_parallel(threads, count, [&](std::size_t k) {
            act(k);
            done.step();
        });
    }

private:
    void find_sheets() {
        const auto candidates = make_candidates(scene_, Source::tree);
        for (const Root& root : roots_.all()) {
            on_top_.emplace_back();
            for (const PolygonId sheet : sheets_on_top(scene_, root.polygon, *candidates))
                for (std::uint32_t k = 0; k < scene_.polygon(sheet).piece_count; ++k)
                    on_top_.back().push_back(static_cast<PieceId>(scene_.polygon(sheet).first_piece + k));
        }
    }

    void add_patch(const Root& root, const Element& element, Scene::Input& input) {
        SystemPatch patch;
        patch.root = root.id;
        patch.element = element;
        Scene::Face face;
        face.material = scene_.polygon(root.polygon).material;
        const Corners exact = corners(scene_, root, element);
        patch.shape.piece = root.piece;
        patch.shape.corner_count = exact.count;
        for (std::size_t k = 0; k < static_cast<std::size_t>(exact.count); ++k) {
            patch.corners[k] = exact.points[k].nearest();
            patch.shape.corners[k] = in_units(patch.corners[k], exponent_);
            face.corners.push_back(static_cast<VertexId>(input.positions.size()));
            input.positions.push_back(patch.corners[k]);
        }
        patch.shape.bounds = radiosity::bounds_of(patch.shape.corners.data(), exact.count);
        input.faces.push_back(std::move(face));
        patches_.push_back(std::move(patch));
    }

    /// Form factors from a point of a root to what it sees of each patch.
    Eigen::RowVectorXd seen_from(const PointOnRoot& on, RootId receiver) const {
        const Point x = on.position.nearest();
        PatchShape point;
        point.piece = roots_[receiver].piece;
        point.corners[0] = in_units(x, exponent_);
        point.corner_count = 1;
        point.bounds = radiosity::bounds_of(point.corners.data(), 1);
        const Viewpoint viewpoint(*prepared_, on.position);
        const ReceiverNormal normal(on.normal);
        Eigen::RowVectorXd seen = Eigen::RowVectorXd::Zero(static_cast<Eigen::Index>(size()));
        std::vector<Obstacle> obstacles;
        std::vector<PieceId> occluders;
        for (std::size_t k = 0; k < size(); ++k) {
            const SystemPatch& patch = patches_[k];
            if (between_.apart(point.piece, patch.shape.piece)) continue;
            between_.find(patch.shape, point, obstacles);
            double& value = seen(static_cast<Eigen::Index>(k));
            if (obstacles.empty() && patch.pieces.on_top.empty()) {
                const Point* corner = patch.corners.data();
                value = form_factor(x, planes_.normal(point.piece), {corner, corner + patch.shape.corner_count}).value;
                continue;
            }
            occluders.clear();
            for (const Obstacle& obstacle : obstacles) occluders.push_back(obstacle.piece);
            value = view_light(viewpoint, normal, patch.pieces, occluders, Precision::binary64).visible;
        }
        return seen;
    }

    const Scene& scene_;
    const Roots& roots_;
    int exponent_;
    Planes planes_;
    Between between_;
    std::vector<std::vector<PieceId>> on_top_;  ///< By root: what lies on top of it in its plane.
    std::vector<SystemPatch> patches_;          ///< Patch k is polygon k after those of the scene.
    std::unique_ptr<Scene> together_;           ///< The scene, and the patches.
    std::unique_ptr<PreparedPieces> prepared_;
    Eigen::Matrix<double, Eigen::Dynamic, 3> exitance_;
};

/// The longest edge, of extent / 2^(k/2), that gives so many patches.
double edge_for(const Scene& scene, const Roots& roots, std::size_t wanted) {
    double edge = longest_extent(bounds_of(scene));
    for (int k = 0; k < 40; ++k, edge /= std::sqrt(2.0)) {
        std::size_t count = 0;
        for (const Root& root : roots.all()) count += patches(scene, root, edge).size();
        if (count >= wanted) break;
    }
    return edge;
}

}  // namespace

StudyReference study_transport_reference(const Scene& scene, std::size_t points, std::size_t unknowns, int threads,
                                         const Progress& progress, const StudyRegion& region) {
    StudyReference reference = study_reference(scene, points, progress, region);
    reference.light = StudyLight::full;
    const Roots roots(scene);
    const double edge = edge_for(scene, roots, unknowns);
    TransportSystem fine(scene, roots, edge), coarse(scene, roots, 2 * edge);
    reference.unknowns = fine.size();
    std::vector<std::array<double, 2>> exitance(reference.points.size());
    int which = 0;
    for (TransportSystem* system : {&fine, &coarse}) {
        system->solve(threads, progress);
        TransportSystem::for_each(reference.points.size(), threads, progress, [&](std::size_t k) {
            const StudyPoint& point = reference.points[k];
            const Rgb value = system->reflected(point_on_root(scene, roots[point.root], point.coordinates), point.root);
            exitance[k][static_cast<std::size_t>(which)] = value[0] + value[1] + value[2];
        });
        ++which;
    }

    const double count = static_cast<double>(exitance.size());
    reference.mean_exitance = 0;
    for (std::size_t k = 0; k < exitance.size(); ++k) {
        reference.points[k].exitance = exitance[k][0];
        reference.mean_exitance += exitance[k][0] / count;
    }
    double difference = 0, whole = 0;  // by the mean, whose square may leave binary64
    for (const auto& [fine_value, coarse_value] : exitance) {
        const double value = fine_value / reference.mean_exitance, other = coarse_value / reference.mean_exitance;
        difference += (value - other) * (value - other);
        whole += value * value;
    }
    reference.own_error = std::sqrt(difference / whole);
    return reference;
}

}  // namespace cob
