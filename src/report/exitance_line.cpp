#include "report/exitance_line.hpp"

#include "cob/files.hpp"
#include "radiosity/mesh.hpp"
#include "report/gnuplot.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace cob::report {
namespace {

/// The root whose plane is nearest to a point that lies within it, and where in it.
struct Place {
    RootId root = -1;
    std::array<double, 2> at{};
};

Place nearest(const RadiositySolver& solver, const Point& point) {
    const Scene& scene = solver.mesh().scene();
    Place place;
    double least = std::numeric_limits<double>::infinity();
    for (RootId id = 0; id < solver.roots().size(); ++id) {
        const Root& root = solver.roots()[id];
        const std::array<double, 2> at = root_coordinates(scene, root, point);
        const double inside = root.corner_count() == 3 ? std::min({at[0], at[1], 1 - at[0] - at[1]})
                                                       : std::min({at[0], at[1], 1 - at[0], 1 - at[1]});
        if (!(inside >= -1e-9)) continue;
        const auto corner = [&](std::size_t k) { return scene.position(root.corners[k]); };
        const double u = at[0], v = at[1];
        const Point on = root.corner_count() == 3 ? (1 - u - v) * corner(0) + (u * corner(1) + v * corner(2))
                                                  : (1 - v) * ((1 - u) * corner(0) + u * corner(1)) +
                                                        v * ((1 - u) * corner(3) + u * corner(2));
        const Point off = point - on;
        const double distance = std::hypot(off.x, off.y, off.z);
        if (distance < least) {
            least = distance;
            place = {id, at};
        }
    }
    return place;
}

}  // namespace

void write_exitance_line(const RadiositySolver& solver, const LineOptions& options, const std::string& base) {
    const ExitanceField field(solver);
    const auto count = static_cast<std::size_t>(std::max(options.points, 2));
    std::vector<Rgb> solved(count), reference(count);
    const auto share = [&](std::size_t k) { return static_cast<double>(k) / static_cast<double>(count - 1); };
    const auto point = [&](std::size_t k) { return (1 - share(k)) * options.from + share(k) * options.to; };
    tbb::parallel_for(std::size_t(0), count, [&](std::size_t k) {
        const Place place = nearest(solver, point(k));
        if (place.root < 0) return;
        solved[k] = field.at(place.root, place.at[0], place.at[1]);
        reference[k] = solver.gather(place.root, place.at[0], place.at[1], options.samples);
    });

    std::string text = "share,x,y,z,r,g,b,reference_r,reference_g,reference_b\n";
    Plot plot;
    plot.title = "Exitance across the shadow";
    plot.x_label = "share of the line";
    plot.y_label = "exitance, green, W/m2";
    plot.curves = {{"elements", {}, Curve::Style::lines}, {"at the point itself", {}, Curve::Style::lines}};
    for (std::size_t k = 0; k < count; ++k) {
        const Point at = point(k);
        text += to_text(share(k));
        for (const double x : {at.x, at.y, at.z, solved[k][0], solved[k][1], solved[k][2], reference[k][0],
                               reference[k][1], reference[k][2]})
            text += "," + to_text(x);
        text += "\n";
        plot.curves[0].points.push_back({share(k), solved[k][1]});
        plot.curves[1].points.push_back({share(k), reference[k][1]});
    }
    write_file(base + ".csv", text);
    draw(plot, base);
}

}  // namespace cob::report
