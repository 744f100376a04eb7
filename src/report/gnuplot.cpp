#include "report/gnuplot.hpp"

#include "cob/arithmetic.hpp"
#include "cob/files.hpp"

#include <unistd.h>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace cob::report {
namespace {

/// In single quotes gnuplot takes everything literally, a doubled quote for a quote.
std::string quoted(const std::string& text) {
    std::string result = "'";
    for (const char c : text) {
        if (c == '\'') result += '\'';
        result += c == '\n' ? ' ' : c;
    }
    return result + "'";
}

const char* style_name(Curve::Style style) {
    switch (style) {
        case Curve::Style::points:
            return "points pt 7 ps 0.8";
        case Curve::Style::lines:
            return "lines lw 1.5";
        case Curve::Style::lines_and_points:
            return "linespoints pt 7 ps 0.7 lw 1.5";
        case Curve::Style::dashed:
            return "lines lw 1.5 dt 2";
    }
    return "points";
}

/// A single word for the shell.
std::string shell_quoted(const std::string& text) {
    std::string result = "'";
    for (const char c : text) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return result + "'";
}

bool run_gnuplot(const std::string& script_path) {
    return std::system(("gnuplot " + shell_quoted(script_path) + " >/dev/null 2>&1").c_str()) == 0;
}

/// A file beside the plot that nobody else writes, removed at the end.
class TemporaryFile {
public:
    explicit TemporaryFile(const std::string& path) : path_(path + ".tmp" + std::to_string(::getpid())) {}
    ~TemporaryFile() { std::remove(path_.c_str()); }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    const std::string& path() const { return path_; }

private:
    std::string path_;
};

bool draw_one(const Plot& plot, const std::string& terminal, const std::string& path) {
    // A script file rather than a pipe: where gnuplot is missing, writing to it would be a signal, not an error.
    const TemporaryFile drawing(path + ".drawing"), script(path + ".gnuplot");
    write_file(script.path(), gnuplot_script(plot, terminal, drawing.path()));
    if (!run_gnuplot(script.path()) || !exists(drawing.path())) return false;
    write_file(path, read_file(drawing.path()));
    return true;
}

}  // namespace

std::string gnuplot_script(const Plot& plot, const std::string& terminal, const std::string& output) {
    std::string script;
    script += "set terminal " + terminal + " size 800,520\n";
    script += "set output " + quoted(output) + "\n";
    script += "set title " + quoted(plot.title) + " noenhanced\n";
    script +=
        "set xlabel " + quoted(plot.x_label) + " noenhanced\nset ylabel " + quoted(plot.y_label) + " noenhanced\n";
    script += "set grid lc rgb '#dddddd'\nset key outside right top noenhanced\n";
    if (plot.logarithmic_x) script += "set logscale x\nset format x '10^{%L}'\n";
    if (plot.logarithmic_y) script += "set logscale y\nset format y '10^{%L}'\n";

    std::string commands;
    for (std::size_t k = 0; k < plot.curves.size(); ++k) {
        const Curve& curve = plot.curves[k];
        const std::string block = "$curve" + std::to_string(k);
        std::string rows;
        for (const auto& [x, value] : curve.points) {
            const double y = plot.least_y ? std::max(value, *plot.least_y) : value;
            const bool drawable = std::isfinite(x) && std::isfinite(y) && (!plot.logarithmic_x || x > 0) &&
                                  (!plot.logarithmic_y || y > 0);
            if (drawable) rows += to_text(x) + " " + to_text(y) + "\n";
        }
        if (rows.empty()) continue;
        script += block + " << EOD\n" + rows + "EOD\n";
        commands += (commands.empty() ? "plot " : ", ") + block + " using 1:2 with " + style_name(curve.style) +
                    " lc " + (curve.style == Curve::Style::dashed ? "rgb '#000000'" : std::to_string(k + 1)) +
                    " title " + quoted(curve.title);
    }
    // An empty plot is an error to gnuplot; an empty frame says as much.
    script += commands.empty() ? "set xrange [0:1]\nset yrange [0:1]\nplot NaN notitle\n" : commands + "\n";
    return script;
}

bool draw(const Plot& plot, const std::string& base) {
    const bool vector = draw_one(plot, "svg background '#ffffff'", base + ".svg");
    return draw_one(plot, "pngcairo", base + ".png") && vector;
}

}  // namespace cob::report
