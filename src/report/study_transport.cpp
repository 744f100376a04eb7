// Full transport: a direct solution of the discrete system, with form factors from exact visibility.
//
// Letters as in SPEC 8. M_i = E_i + rho_i sum_j F_ij M_j for patches i, j of constant exitance M; F_ij from
// four points of i to what of j is seen from there, exactly found and in closed form. At any other point M follows by
// one more sum of the same kind, so that shadows are as sharp there as they truly are.
#include "arithmetic/threads.hpp"
#include "cob/form_factor.hpp"
#include "geometry/bounds.hpp"
#include "radiosity/mesh.hpp"
#include "radiosity/plane_sheets.hpp"
#include "radiosity/planes.hpp"
#include "radiosity/visible_light.hpp"
#include "report/study_points.hpp"

#include <Eigen/Dense>

#include <cmath>
#include <limits>
#include <mutex>

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
    std::array<double, 6> bounds{};
    std::array<Point, 4> corners{};  ///< Rounded.
    int corner_count = 0;
    LightPieces pieces;
};

/// What stands around one root: what lies on top of it, and what its patches can never be hidden by.
struct SystemRoot {
    std::vector<PieceId> on_top;
    std::vector<bool> apart;  ///< By piece: no corner strictly in front of it, so that it is never between.
    Point normal;             ///< Unit.
};

class TransportSystem {
public:
    TransportSystem(const Scene& scene, const Roots& roots, double edge)
        : scene_(scene), roots_(roots), candidates_(make_candidates(scene, Source::cgal)) {
        find_planes();
        Scene::Input input = input_of(scene);
        for (const Root& root : roots.all())
            for (const Element& element : patches(scene, root, edge)) add_patch(root, element, input);
        together_ = std::make_unique<Scene>(Scene::build(std::move(input), Scene::Options{true}));
        for (std::size_t k = 0; k < patches_.size(); ++k) {
            const Polygon& polygon = together_->polygon(scene.polygon_count() + static_cast<PolygonId>(k));
            for (std::uint32_t piece = 0; piece < polygon.piece_count; ++piece)
                patches_[k].pieces.pieces.push_back(static_cast<PieceId>(polygon.first_piece + piece));
            patches_[k].pieces.on_top = around_[static_cast<std::size_t>(patches_[k].root)].on_top;
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
        std::mutex mutex;
        std::uint64_t done = 0;
        in_parallel(threads, count, [&](std::size_t k) {
            act(k);
            if (!progress) return;
            const std::lock_guard<std::mutex> lock(mutex);
            progress(done++, count);
        });
    }

private:
    void find_planes() {
        const Planes planes(scene_, unit_exponent(scene_));
        for (const Root& root : roots_.all()) {
            SystemRoot around;
            around.normal = planes.normal(root.piece);
            for (std::size_t piece = 0; piece < scene_.pieces().size(); ++piece)
                around.apart.push_back(planes.closed_sides(static_cast<PieceId>(piece), root.piece).behind);
            for (const PolygonId sheet : sheets_on_top(scene_, root.polygon, *candidates_))
                for (std::uint32_t k = 0; k < scene_.polygon(sheet).piece_count; ++k)
                    around.on_top.push_back(static_cast<PieceId>(scene_.polygon(sheet).first_piece + k));
            around_.push_back(std::move(around));
        }
    }

    void add_patch(const Root& root, const Element& element, Scene::Input& input) {
        SystemPatch patch;
        patch.root = root.id;
        patch.element = element;
        Scene::Face face;
        face.material = scene_.polygon(root.polygon).material;
        const Corners exact = corners(scene_, root, element);
        std::array<Point, 4> p;
        for (int k = 0; k < exact.count; ++k) {
            const auto corner = static_cast<std::size_t>(k);
            p[corner] = exact.points[corner].nearest();
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const double x = p[corner][static_cast<int>(axis)];
                patch.bounds[axis] = k == 0 ? x : std::min(patch.bounds[axis], x);
                patch.bounds[axis + 3] = k == 0 ? x : std::max(patch.bounds[axis + 3], x);
            }
            face.corners.push_back(static_cast<VertexId>(input.positions.size()));
            input.positions.push_back(p[corner]);
        }
        patch.corners = p;
        patch.corner_count = exact.count;
        input.faces.push_back(std::move(face));
        patches_.push_back(std::move(patch));
    }

    const SystemRoot& around(RootId root) const { return around_[static_cast<std::size_t>(root)]; }
    bool apart(RootId root, RootId of) const { return around(of).apart[static_cast<std::size_t>(roots_[root].piece)]; }

    /// Form factors from a point of a root to what it sees of each patch.
    Eigen::RowVectorXd seen_from(const PointOnRoot& on, RootId receiver) const {
        const Point x = on.position.nearest();
        const Viewpoint viewpoint(*prepared_, on.position);
        const ReceiverNormal normal(on.normal);
        Eigen::RowVectorXd seen = Eigen::RowVectorXd::Zero(static_cast<Eigen::Index>(size()));
        for (std::size_t k = 0; k < size(); ++k) {
            const SystemPatch& patch = patches_[k];
            if (apart(patch.root, receiver) || apart(receiver, patch.root)) continue;
            const std::vector<PieceId> occluders = between(x, receiver, patch);
            double& value = seen(static_cast<Eigen::Index>(k));
            if (occluders.empty() && patch.pieces.on_top.empty()) {
                const Point* corner = patch.corners.data();
                value = form_factor(x, around(receiver).normal, {corner, corner + patch.corner_count}).value;
            } else {
                value = view_light(viewpoint, normal, patch.pieces, occluders, Precision::binary64).visible;
            }
        }
        return seen;
    }

    /// Pieces that meet the bounds of the point and the patch and reach in front of both their planes.
    std::vector<PieceId> between(const Point& x, RootId receiver, const SystemPatch& patch) const {
        std::array<double, 6> bounds = patch.bounds;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double value = x[static_cast<int>(axis)], infinity = std::numeric_limits<double>::infinity();
            bounds[axis] = std::nextafter(std::min(bounds[axis], value), -infinity);
            bounds[axis + 3] = std::nextafter(std::max(bounds[axis + 3], value), infinity);
        }
        struct Search {
            const Scene& scene;
            const std::vector<bool>& apart_from_receiver;
            const std::vector<bool>& apart_from_patch;
            std::vector<PieceId> found;
        } search{scene_, around(receiver).apart, around(patch.root).apart, {}};
        candidates_->polygons_in(bounds, {&search, [](void* context, std::int32_t polygon) {
                                              auto& s = *static_cast<Search*>(context);
                                              const Polygon& shape = s.scene.polygon(polygon);
                                              for (std::uint32_t k = 0; k < shape.piece_count; ++k) {
                                                  const std::size_t piece = shape.first_piece + k;
                                                  if (!s.apart_from_receiver[piece] && !s.apart_from_patch[piece])
                                                      s.found.push_back(static_cast<PieceId>(piece));
                                              }
                                              return true;
                                          }});
        std::sort(search.found.begin(), search.found.end());
        return std::move(search.found);
    }

    const Scene& scene_;
    const Roots& roots_;
    std::unique_ptr<CandidateSource> candidates_;
    std::vector<SystemRoot> around_;    ///< By root.
    std::vector<SystemPatch> patches_;  ///< Patch k is polygon k after those of the scene.
    std::unique_ptr<Scene> together_;   ///< The scene, and the patches.
    std::unique_ptr<PreparedPieces> prepared_;
    Eigen::Matrix<double, Eigen::Dynamic, 3> exitance_;
};

/// The longest edge, of extent / 2^k, that gives so many patches.
double edge_for(const Scene& scene, const Roots& roots, std::size_t wanted) {
    double edge = longest_extent(bounds_of(scene));
    for (int halvings = 0; halvings < 20; ++halvings, edge /= 2) {
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

    double difference = 0, whole = 0;
    reference.mean_exitance = 0;
    for (std::size_t k = 0; k < exitance.size(); ++k) {
        const auto [value, other] = exitance[k];
        reference.points[k].exitance = value;
        reference.mean_exitance += value / static_cast<double>(exitance.size());
        difference += (value - other) * (value - other);
        whole += value * value;
    }
    reference.own_error = std::sqrt(difference / whole);
    return reference;
}

}  // namespace cob
