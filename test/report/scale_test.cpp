// Photometry has no scale: what is said of a scene in metres is said of it in any other unit, and of lights twice as
// bright it is twice as much. No products of lengths, areas or squares of exitance leave binary64 on the way.
#include "cob/error.hpp"
#include "cob/files.hpp"
#include "cob/study.hpp"
#include "radiosity/mesh.hpp"
#include "radiosity/scenes.hpp"
#include "report/camera.hpp"
#include "report/exitance_line.hpp"
#include "report/picture.hpp"
#include "report/solution_files.hpp"
#include "temporary_folder.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <regex>
#include <sstream>

namespace cob::report {
namespace {

/// Every length times 2^exponent, every Ke times 2^light: both exact.
Scene scaled(const Scene& scene, int exponent, int light = 0) {
    Scene::Input input = input_of(scene);
    for (Point& p : input.positions)
        p = {std::scalbn(p.x, exponent), std::scalbn(p.y, exponent), std::scalbn(p.z, exponent)};
    for (Material& material : input.materials)
        for (double& emitted : material.emitted_exitance) emitted = std::scalbn(emitted, light);
    return Scene::build(std::move(input));
}

/// No NaN and no infinity, in any column.
void expect_numbers(const std::string& text, int exponent) {
    static const std::regex bad("(^|[^a-z])-?(nan|inf)", std::regex::icase);
    EXPECT_FALSE(std::regex_search(text, bad)) << exponent;
}

std::vector<std::string> column(const std::string& table, std::size_t index) {
    std::vector<std::string> values;
    std::istringstream lines(table);
    for (std::string line; std::getline(lines, line);) {
        std::istringstream cells(line);
        std::string cell;
        for (std::size_t k = 0; k <= index; ++k) std::getline(cells, cell, ',');
        values.push_back(cell);
    }
    return values;
}

struct Solved {
    std::vector<Rgb> exitance;
    std::vector<Image> pictures;
    std::vector<std::string> line, areas;
};

Solved solve(const Scene& scene, int exponent) {
    RadiosityOptions options;
    options.stop.shots = 5;
    RadiositySolver solver(scene, options);
    while (solver.step()) {
    }
    Solved result;
    for (const radiosity::NodeId leaf : solver.mesh().leaves()) result.exitance.push_back(solver.exitance(leaf));
    PictureOptions picture;
    picture.width = picture.height = 32;
    picture.antialiasing = 1;
    const Pictures drawn = render_pictures(solver, default_camera(scene), picture);
    result.pictures = {drawn.plain, drawn.mesh, drawn.states};

    const auto at = [&](double x, double y) { return Point{std::scalbn(x, exponent), std::scalbn(y, exponent), 0}; };
    const test::TemporaryFolder folder;
    ExitanceLine(solver, {at(0.1, 0.2), at(0.9, 0.7), 9, 16, 1}).write(folder / "line");
    const std::string line = read_file(folder / "line.csv");
    for (const std::size_t k : {4, 5, 6, 7, 8, 9})
        for (const std::string& cell : column(line, k)) result.line.push_back(cell);

    const std::string table = solution_csv(solver);
    const RunSummary summary = summarise(solver, {});
    expect_numbers(table + line + solution_vtp(solver) + summary.text, exponent);
    EXPECT_EQ(summary.json.find("exitance_flux_by_elements\": null"), std::string::npos);
    EXPECT_EQ(nlohmann::json::parse(summary.json)["bookkeeping"]["relative_difference"].is_number(), true);
    result.areas = column(table, 12);
    return result;
}

TEST(Scale, SolutionsPicturesAndLinesAreTheSame) {
    const Scene scene = scenes::plate_over_table();
    const Solved expected = solve(scene, 0);
    for (const int exponent : {-1000, -520, -270, 270, 520, 1000}) {
        const Solved found = solve(scaled(scene, exponent), exponent);
        EXPECT_EQ(found.exitance, expected.exitance) << exponent;
        EXPECT_EQ(found.line, expected.line) << exponent;
        for (std::size_t k = 0; k < 3; ++k)
            EXPECT_EQ(encode_png(found.pictures[k]), encode_png(expected.pictures[k])) << exponent << ", picture " << k;
    }
}

// Areas that binary64 does not hold are written all the same: 2^2000 is about 1.1e602.
TEST(Scale, AreasBeyondBinary64AreWritten) {
    const Scene scene = scenes::plate_over_table();
    const Solved one = solve(scene, 0), many = solve(scaled(scene, 1000), 1000);
    ASSERT_GT(one.areas.size(), 1u);
    for (std::size_t k = 1; k < one.areas.size(); ++k) {
        const long double expected = std::strtold(one.areas[k].c_str(), nullptr) * std::ldexp(1.0L, 2000);
        EXPECT_NEAR(static_cast<double>(std::strtold(many.areas[k].c_str(), nullptr) / expected), 1, 1e-15);
    }
}

TEST(Scale, ExitanceIsAsManyTimesTheLights) {
    const Scene scene = scenes::plate_over_table();
    const Solved expected = solve(scene, 0);
    for (const int light : {-900, 900}) {
        const Solved found = solve(scaled(scene, 0, light), 0);
        ASSERT_EQ(found.exitance.size(), expected.exitance.size());
        for (std::size_t k = 0; k < expected.exitance.size(); ++k)
            for (std::size_t c = 0; c < 3; ++c)
                EXPECT_EQ(found.exitance[k][c], std::scalbn(expected.exitance[k][c], light)) << light;
        EXPECT_EQ(encode_png(found.pictures[0]), encode_png(expected.pictures[0])) << light;
    }
}

TEST(Scale, StudiesAreTheSame) {
    const Scene scene = scenes::plate_over_table();
    const auto errors = [](const Scene& of) {
        const StudyReference reference = study_reference(of, 50, {});
        StudyRun run = study_run(of, reference, study_plan(of, StudyLight::direct, 1).front(), 1, 1);
        return std::vector<double>{run.all.l1, run.all.l2, run.all.most, run.shares.smooth_fine};
    };
    const std::vector<double> expected = errors(scene);
    for (const double x : expected) EXPECT_TRUE(std::isfinite(x));
    for (const auto& [exponent, light] : {std::pair{-800, 0}, {800, 0}, {0, 900}, {0, -900}}) {
        const std::vector<double> found = errors(scaled(scene, exponent, light));
        for (std::size_t k = 0; k < expected.size(); ++k) EXPECT_NEAR(found[k], expected[k], 1e-12) << exponent;
    }
}

// What binary64 cannot hold is refused with its line, before the work.
TEST(Scale, WhatLeavesBinary64IsRefused) {
    const auto problem = [](const Scene& scene) -> std::string {
        try {
            RadiositySolver(scene, {});
        } catch (const InputError& error) {
            return error.what();
        }
        return "";
    };
    const Scene scene = scenes::plate_over_table();
    EXPECT_EQ(problem(scene), "");
    EXPECT_NE(problem(scaled(scene, 0, 1020)).find("emits too much"), std::string::npos);
    EXPECT_NE(problem(scaled(scene, 0, -1060)).find("too faint"), std::string::npos);
    Scene::Input input = input_of(scene);
    for (const VertexId corner : input.faces.front().corners) {
        Point& p = input.positions[static_cast<std::size_t>(corner)];
        p = {std::scalbn(p.x, -500), std::scalbn(p.y, -500), p.z};
    }
    EXPECT_NE(problem(Scene::build(std::move(input))).find("too small beside the scene"), std::string::npos);
}

}  // namespace
}  // namespace cob::report
