// The files of a solution and what they are made from.
#include "report/solution_files.hpp"

#include "cob/error.hpp"
#include "cob/files.hpp"
#include "cob/irradiance.hpp"
#include "cob/study.hpp"
#include "radiosity/scenes.hpp"
#include "report/camera.hpp"
#include "report/exitance_line.hpp"
#include "temporary_folder.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

namespace cob::report {
namespace {

std::string solved(const Scene& scene) {
    RadiosityOptions options;
    options.stop.shots = 3;
    RadiositySolver solver(scene, options);
    while (solver.step()) {
    }
    return solution_csv(solver);
}

// The scene is its polygons: a vertex that none uses has no part in its extent, its scale or its camera.
TEST(Solution, AnUnusedVertexChangesNothing) {
    const Scene scene = scenes::plate_over_table();
    const std::string expected = solved(scene);
    const Camera camera = default_camera(scene);
    const auto light_at = [](const Scene& of) {
        const auto candidates = make_candidates(of, Source::all);
        return IrradianceOracle(of, *candidates)(ExactPoint(Point{0.25, 0.3, 0}), {0, 0, 1}, 1).visible;
    };
    for (const double far : {1e6, 1e300}) {
        Scene::Input input = input_of(scene);
        input.positions.push_back({far, 0, 0});
        const Scene with = Scene::build(input);
        EXPECT_EQ(solved(with), expected) << far;
        EXPECT_EQ(default_camera(with).position, camera.position) << far;
        EXPECT_EQ(default_camera(with).target, camera.target) << far;
        EXPECT_EQ(light_at(with), light_at(scene)) << far;
        const auto plan = study_plan(scene, StudyLight::direct, 1), far_plan = study_plan(with, StudyLight::direct, 1);
        EXPECT_EQ(far_plan.front().key(), plan.front().key()) << far;
        EXPECT_EQ(study_reference(with, 20, {}).band_width, study_reference(scene, 20, {}).band_width) << far;
    }
}

TEST(Solution, NumbersThatAreNoneAreRefused) {
    const Scene scene = scenes::plate_over_table();
    const auto refused = [&](auto set) {
        RadiosityOptions options;
        set(options);
        EXPECT_THROW(RadiositySolver(scene, options), InputError);
    };
    for (const double bad : {std::nan(""), -1.0}) {
        refused([&](RadiosityOptions& o) { o.patch_edge = bad; });
        refused([&](RadiosityOptions& o) { o.light_edge = bad; });
        refused([&](RadiosityOptions& o) { o.buffer.minimum_edge = bad; });
        refused([&](RadiosityOptions& o) { o.buffer.threshold = bad; });
        refused([&](RadiosityOptions& o) { o.gradient.minimum_edge = bad; });
        refused([&](RadiosityOptions& o) { o.gradient.threshold[1] = bad; });
        refused([&](RadiosityOptions& o) { o.gradient.floor = bad; });
        refused([&](RadiosityOptions& o) { o.stop.unshot = bad; });
    }
}

// Half of the line runs beside the table: no light is known there, which is not darkness.
TEST(ExitanceLine, HasNoValuesWhereThereIsNoPolygon) {
    const Scene scene = scenes::plate_over_table();
    RadiosityOptions options;
    options.stop.shots = 1;
    RadiositySolver solver(scene, options);
    while (solver.step()) {
    }
    const test::TemporaryFolder folder;
    ExitanceLine(solver, {{-3, 0.5, 0}, {1, 0.5, 0}, 9, 4, 1}).write(folder / "line");
    std::istringstream lines(read_file(folder / "line.csv"));
    std::string line;
    std::getline(lines, line);
    for (int k = 0; k < 9; ++k) {
        ASSERT_TRUE(std::getline(lines, line));
        if (k < 4)
            EXPECT_EQ(line.substr(line.size() - 12), ",0.5,0,,,,,,") << line;
        else
            EXPECT_EQ(line.find(",,"), std::string::npos) << line;
    }
    EXPECT_THROW(ExitanceLine(solver, {{-3, 0.5, 0}, {-2, 0.5, 0}, 9, 4, 1}), InputError);
}

}  // namespace
}  // namespace cob::report
