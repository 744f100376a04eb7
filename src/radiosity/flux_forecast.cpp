#include "radiosity/flux_forecast.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <set>

namespace cob::radiosity {
namespace {

/// Triangles in general position that have as many corners as the occluders: the pieces of a box share theirs.
double triangles_between(const Scene& scene, const PiecePair& pair) {
    std::set<Point> corners;
    for (const PieceId piece : pair.occluders)
        for (const VertexId corner : scene.corners(scene.piece(piece))) corners.insert(scene.position(corner));
    return static_cast<double>(corners.size()) / 3;
}

/// How many times as many evaluations the goal will take as this error did.
double growth_until(double goal, double error, double area, double triangles) {
    // To a form factor's error of this, the error falls the faster the smaller it is, and the more slowly the more
    // triangles there are; of other goals, evaluations grow with the cube root.
    constexpr double fitted = 5e-7, order_of_goal = 1.0 / 3;
    const double missing = std::log(std::max(1.0, error / area / fitted));
    return std::exp((0.017 + 0.0042 * std::min(12.0, triangles)) * missing * missing) *
           std::pow(fitted * area / goal, order_of_goal);
}

}  // namespace

FluxForecast forecast_flux(const PairContext& context, const PiecePair& pair, const ForecastOptions& options) {
    QuadratureOptions quadrature = options.quadrature;
    const double goal = quadrature.tolerance, most = static_cast<double>(quadrature.max_evaluations);
    const double area = context.polygons[context.scene.piece(pair.receiver).polygon].area;
    const double triangles = triangles_between(context.scene, pair);
    const double sides = options.both_sides ? 2 : 1;
    // An evaluation takes about as long as the square of the triangles, and a certified triangle much longer.
    const double affordable =
        options.certified ? most
                          : std::max(1500.0, 4e6 / (triangles * triangles * static_cast<double>(options.samples)));
    double budget = std::min(most, options.certified ? 50.0 : std::clamp(affordable / 10, 1000.0, 2e4));
    for (;;) {
        quadrature.max_evaluations = static_cast<std::uint64_t>(budget);
        const auto start = std::chrono::steady_clock::now();
        const QuadratureResult begun = (options.certified ? certified_flux : flux_between)(context, pair, quadrature);
        const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        const double evaluations = static_cast<double>(begun.evaluations), error = begun.visible.error;
        if (error <= goal) return {sides * evaluations, sides * seconds};

        // Certified, the error falls about with the square root of the triangles.
        const double growth =
            options.certified ? std::pow(error / goal, 2) : std::max(1.0, growth_until(goal, error, area, triangles));
        const double times = std::min(growth, most / budget);
        const double next = std::min(budget * times / 10, affordable);
        if (next < 1.5 * budget) {
            // What falls short, as is likely where it nearly does, is begun again from the other side. The later an
            // evaluation, the cheaper.
            const double begins = std::clamp(2 * growth * budget / most, sides, 2.0);
            return {begins * times * evaluations, begins * std::pow(times, options.certified ? 1 : 0.85) * seconds};
        }
        budget = next;
    }
}

}  // namespace cob::radiosity
