#include "report/exitance_line.hpp"

#include "arithmetic/shared_progress.hpp"
#include "arithmetic/threads.hpp"
#include "cob/error.hpp"
#include "cob/files.hpp"
#include "radiosity/mesh.hpp"
#include "report/gnuplot.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cob::report {

ExitanceLine::ExitanceLine(const RadiositySolver& solver, const LineOptions& options)
    : solver_(solver), options_(options), places_(static_cast<std::size_t>(std::max(options.points, 2))) {
    bool found = false;
    for (std::size_t k = 0; k < places_.size(); ++k) {
        places_[k] = nearest(point(k));
        found = found || places_[k].root >= 0;
    }
    if (!found)
        throw InputError(
            "no point of the line lies on a polygon",
            {solver.mesh().scene().name(), 0,
             to_text(options.from.x) + " " + to_text(options.from.y) + " " + to_text(options.from.z) + " ...",
             "draw it along a surface of the scene"});
}

double ExitanceLine::share(std::size_t k) const {
    return static_cast<double>(k) / static_cast<double>(places_.size() - 1);
}

Point ExitanceLine::point(std::size_t k) const {
    return (1 - share(k)) * options_.from + share(k) * options_.to;
}

ExitanceLine::Place ExitanceLine::nearest(const Point& point) const {
    const Scene& scene = solver_.mesh().scene();
    Place place;
    double least = std::numeric_limits<double>::infinity();
    for (RootId id = 0; id < solver_.roots().size(); ++id) {
        const Root& root = solver_.roots()[id];
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

bool ExitanceLine::write(const std::string& base, const Progress& progress) const {
    const ExitanceField field(solver_);
    std::vector<Rgb> solved(places_.size()), reference(places_.size());
    SharedProgress counter(progress, places_.size());
    in_parallel(options_.threads, places_.size(), [&](std::size_t k) {
        counter.step();
        const auto& [root, at] = places_[k];
        if (root < 0) return;
        solved[k] = field.at(root, at[0], at[1]);
        reference[k] = solver_.gather(root, at[0], at[1], options_.samples);
    });

    std::string text = "share,x,y,z,r,g,b,reference_r,reference_g,reference_b\n";
    Plot plot;
    plot.title = "Exitance across the shadow";
    plot.x_label = "share of the line";
    plot.y_label = "exitance, green, W/m2";
    plot.curves = {{"elements", {}, Curve::Style::lines}, {"at the point itself", {}, Curve::Style::lines}};
    for (std::size_t k = 0; k < places_.size(); ++k) {
        const Point at = point(k);
        const bool known = places_[k].root >= 0;
        text += to_text(share(k));
        for (const double x : {at.x, at.y, at.z}) text += "," + to_text(x);
        for (const Rgb& rgb : {solved[k], reference[k]})
            for (const double x : rgb) text += known ? "," + to_text(x) : ",";
        text += "\n";
        if (!known) continue;
        plot.curves[0].points.push_back({share(k), solved[k][1]});
        plot.curves[1].points.push_back({share(k), reference[k][1]});
    }
    write_file(base + ".csv", text);
    return draw(plot, base);
}

}  // namespace cob::report
