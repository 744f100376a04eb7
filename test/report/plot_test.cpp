// Plots by gnuplot.
#include "report/gnuplot.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace cob::report {
namespace {

Plot error_against_time() {
    Plot plot;
    plot.title = "it's";
    plot.logarithmic_x = plot.logarithmic_y = true;
    plot.least_y = 1e-6;
    plot.curves = {{"float", {{10, 0.25}, {NAN, 1}, {0, 1}}, Curve::Style::points}, {"exact", {{20, 0}}}, {"none", {}}};
    return plot;
}

TEST(Plot, DrawsZeroAtTheLeastValueAndLeavesOutWhatHasNoPlace) {
    const std::string script = gnuplot_script(error_against_time(), "svg", "o'ut");
    EXPECT_NE(script.find("$curve0 << EOD\n10 0.25\nEOD\n"), std::string::npos) << script;
    EXPECT_NE(script.find("$curve1 << EOD\n20 1e-06\nEOD\n"), std::string::npos) << script;
    EXPECT_EQ(script.find("$curve2"), std::string::npos);
    EXPECT_NE(script.find("set output 'o''ut'"), std::string::npos);
    EXPECT_NE(script.find("set title 'it''s'"), std::string::npos);
}

TEST(Plot, EmptyPlotsAreFramesNotErrors) {
    EXPECT_NE(gnuplot_script(Plot{}, "svg", "x").find("plot NaN"), std::string::npos);
}

}  // namespace
}  // namespace cob::report
