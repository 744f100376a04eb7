/// \file
/// Plots by gnuplot, which is looked for when a plot is drawn.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace cob::report {

/// One series of points.
struct Curve {
    enum class Style { points, lines, lines_and_points, dashed };  ///< Dashed ones are black.

    std::string title;
    std::vector<std::array<double, 2>> points;  ///< (x, y); points that are not finite are left out.
    Style style = Style::lines_and_points;
};

struct Plot {
    std::string title, x_label, y_label;
    bool logarithmic_x = false, logarithmic_y = false;
    /// Where set, smaller values are drawn here: "none wrong" has no place on a logarithmic axis.
    std::optional<double> least_y;
    std::vector<Curve> curves;
};

/// The commands and data that draw the plot on a gnuplot terminal ("svg", "pngcairo").
std::string gnuplot_script(const Plot& plot, const std::string& terminal, const std::string& output);

/// Draws base.svg and base.png, each whole or not at all. False where gnuplot is missing or fails: a plot is never
/// worth more than the run that it shows.
bool draw(const Plot& plot, const std::string& base);

}  // namespace cob::report
