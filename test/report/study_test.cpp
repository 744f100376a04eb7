// Error against time: the reference, a run, its line and the front.
#include "cob/study.hpp"

#include "arithmetic/process.hpp"
#include "report/stress_scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace cob {
namespace {

/// A floor, a light over it and a sheet between.
Scene shaded_floor() {
    stress::Shapes shapes;
    shapes.loops = {{{0, 0, 0}, {8, 0, 0}, {8, 8, 0}, {0, 8, 0}},
                    {{3, 3, 0.25}, {5, 3, 0.25}, {5, 5, 0.25}, {3, 5, 0.25}},
                    {{3, 3, 6}, {3, 5, 6}, {5, 5, 6}, {5, 3, 6}}};
    shapes.lights = {2};
    return scene_of(shapes);
}

TEST(Study, PointsLieOnWhatReceivesAndSomeInThePenumbra) {
    const StudyReference reference = study_reference(shaded_floor(), 400, {});
    ASSERT_EQ(reference.points.size(), 400u);
    std::size_t band = 0, dark = 0;
    for (const StudyPoint& point : reference.points) {
        EXPECT_LT(point.root, 2);  // not on the light
        EXPECT_DOUBLE_EQ(point.exitance, 0.5 * point.irradiance);
        band += point.in_band ? 1 : 0;
        dark += point.irradiance == 0 ? 1 : 0;
    }
    EXPECT_GT(band, 0u);
    EXPECT_GT(dark, 0u);
    EXPECT_LT(band, 150u);
    EXPECT_LT(dark, 100u);
    EXPECT_DOUBLE_EQ(reference.band_width, 8.0 / 48);
    EXPECT_DOUBLE_EQ(reference.receiver_share, 68.0 / 72);
}

// The buffer reaches a fine uniform mesh's error with far fewer elements; a finer mesh errs less.
TEST(Study, FinerMeshesErrLessAndTheBufferNeedsFewerElements) {
    const Scene scene = shaded_floor();
    const StudyReference reference = study_reference(scene, 400, {});
    const auto run = [&](Refinement refinement, double patch, double least) {
        StudySettings settings;
        settings.series = "budget";
        settings.refinement = refinement;
        settings.patch_edge = patch;
        settings.light_edge = 2;
        settings.minimum_edge = least;
        return study_run(scene, reference, settings, 1, 1);
    };
    const StudyRun coarse = run(Refinement::none, 1, 1), fine = run(Refinement::none, 0.25, 0.25),
                   buffer = run(Refinement::buffer, 1, 0.25);
    EXPECT_LT(fine.all.l2, 0.6 * coarse.all.l2);
    EXPECT_LT(buffer.all.l2, coarse.all.l2);
    EXPECT_LT(3 * buffer.elements, fine.elements);

    EXPECT_EQ(buffer.shots, fine.shots);  // lights are cut alike
    EXPECT_NEAR(
        buffer.shares.band_fine + buffer.shares.band_coarse + buffer.shares.smooth_fine + buffer.shares.smooth_coarse,
        1, 1e-12);

    // The line of a run holds all of it; also of one without a band.
    StudyRun no_band = buffer;
    no_band.band.reset();
    for (const StudyRun& one : {buffer, no_band}) {
        const std::optional<StudyRun> again = study_run_from_line(to_line(one), one.settings);
        ASSERT_TRUE(again);
        EXPECT_EQ(to_line(*again), to_line(one));
        EXPECT_EQ(again->band.has_value(), one.band.has_value());
    }
    EXPECT_FALSE(study_run_from_line(to_line(buffer), coarse.settings));
    EXPECT_FALSE(study_run_from_line(to_line(buffer) + ",1", buffer.settings));
}

// A region keeps points to its polygons and bounds.
TEST(Study, PointsStayInTheRegion) {
    const std::array<double, 6> bounds{2, 2, 0, 6, 3, 0};
    const StudyReference reference = study_reference(shaded_floor(), 50, {}, {{0}, bounds});
    ASSERT_EQ(reference.points.size(), 50u);
    for (const StudyPoint& point : reference.points) {
        EXPECT_EQ(point.root, 0);
        EXPECT_TRUE(point.coordinates[0] >= 2.0 / 8 && point.coordinates[0] <= 6.0 / 8);
        EXPECT_TRUE(point.coordinates[1] >= 2.0 / 8 && point.coordinates[1] <= 3.0 / 8);
    }
}

// Interruptible, in a run, too.
TEST(Study, ARunEndsWhereItIsTold) {
    const Scene scene = shaded_floor();
    const StudyReference reference = study_reference(scene, 20, {});
    StudySettings settings;
    settings.patch_edge = settings.minimum_edge = settings.light_edge = 1;
    std::uint64_t told = 0;
    const Progress stop = [&](std::uint64_t shots, std::uint64_t) {
        told = shots;
        if (shots == 2) throw std::runtime_error("stop");
    };
    EXPECT_THROW(study_run(scene, reference, settings, 1, 1, stop), std::runtime_error);
    EXPECT_EQ(told, 2u);
}

/// The floor with a wall at its side, so that light is reflected.
Scene shaded_corner(double reflectance) {
    stress::Shapes shapes;
    shapes.loops = {{{0, 0, 0}, {8, 0, 0}, {8, 8, 0}, {0, 8, 0}},
                    {{0, 8, 0}, {8, 8, 0}, {8, 8, 8}, {0, 8, 8}},
                    {{3, 3, 1}, {5, 3, 1}, {5, 5, 1}, {3, 5, 1}},
                    {{3, 3, 7}, {3, 5, 7}, {5, 5, 7}, {5, 3, 7}}};
    shapes.lights = {3};
    return scene_of(shapes, reflectance);
}

// Where next to nothing is reflected, the direct solution is the exact irradiance times reflectance.
TEST(StudyTransport, DirectLightIsExact) {
    const Scene scene = shaded_corner(1e-9);
    const StudyReference direct = study_reference(scene, 40, {});
    const StudyReference full = study_transport_reference(scene, 40, 10, 1, {});
    ASSERT_EQ(direct.points.size(), full.points.size());
    for (std::size_t k = 0; k < full.points.size(); ++k)
        EXPECT_NEAR(full.points[k].exitance, direct.points[k].exitance, 1e-8 * direct.mean_exitance);
    EXPECT_LT(full.own_error, 1e-8);
}

// The direct solution and shots agree; its own error, from two meshes, is about its distance to a finer one.
TEST(StudyTransport, AgreesWithProgressiveRefinement) {
    const Scene scene = shaded_corner(0.5);
    const StudyReference coarse = study_transport_reference(scene, 40, 20, 1, {});
    const StudyReference fine = study_transport_reference(scene, 40, 100, 1, {});
    EXPECT_GE(fine.unknowns, 100u);
    EXPECT_GT(fine.own_error, 0);
    EXPECT_LT(fine.own_error, coarse.own_error);
    double difference = 0, whole = 0;
    for (std::size_t k = 0; k < fine.points.size(); ++k) {
        difference += std::pow(coarse.points[k].exitance - fine.points[k].exitance, 2);
        whole += std::pow(fine.points[k].exitance, 2);
    }
    EXPECT_LT(std::sqrt(difference / whole), 2 * coarse.own_error);

    StudySettings settings;
    settings.patch_edge = settings.minimum_edge = 2;
    const StudyRun run = study_run(scene, fine, settings, 1, 1);
    settings.patch_edge = settings.minimum_edge = 0.5;
    const StudyRun finer = study_run(scene, fine, settings, 1, 1);
    EXPECT_LT(finer.all.l2, 0.5 * run.all.l2);
    EXPECT_LT(finer.all.l2, 0.1);  // the sheet's shadow
}

// 10 times fewer elements and 5 times less time; where not, the report says why.
TEST(Study, TheBarIsMetOrExplained) {
    StudyReference reference;
    reference.points.resize(10);
    const auto run = [](Refinement refinement, std::int64_t elements, double seconds, double error) {
        StudyRun r;
        r.settings.refinement = refinement;
        r.elements = elements;
        r.seconds_median = seconds;
        r.all.l2 = error;
        return r;
    };
    const StudyRun coarse = run(Refinement::none, 100, 0.1, 0.5), fine = run(Refinement::none, 1000, 1, 0.1),
                   good = run(Refinement::buffer, 100, 0.2, 0.1), slow = run(Refinement::both, 100, 0.3, 0.1),
                   gradient = run(Refinement::gradient, 10, 0.01, 0.01), poor = run(Refinement::buffer, 90, 0.1, 0.2);
    const std::vector<StudyBar> met = study_bars(reference, {coarse, fine, gradient, poor, good});
    ASSERT_EQ(met.size(), 1u);  // none in the band
    EXPECT_TRUE(met[0].met);
    EXPECT_DOUBLE_EQ(met[0].elements_ratio, 10);
    EXPECT_TRUE(met[0].reason.empty());
    for (const StudyRun& other : {slow, poor}) {
        const std::vector<StudyBar> missed = study_bars(reference, {coarse, fine, gradient, other});
        ASSERT_EQ(missed.size(), 1u);
        EXPECT_FALSE(missed[0].met);
        EXPECT_FALSE(missed[0].reason.empty());
        EXPECT_EQ(missed[0].reached.has_value(), other.all.l2 <= 0.1);
    }
    EXPECT_TRUE(study_bars(reference, {coarse, fine, gradient}).empty());
}

// What a run holds is seen, where the system lets it also when it was given back; what was held before is not.
TEST(MemoryWatch, SeesThePeak) {
    const std::size_t size = std::size_t{64} << 20;
    const MemoryWatch watch;
    {
        std::vector<char> held(size);
        for (std::size_t k = 0; k < size; k += 1024) held[k] = 1;
        EXPECT_EQ(std::count(held.begin(), held.end(), 1), static_cast<std::ptrdiff_t>(size / 1024));
        EXPECT_GT(watch.peak(), size / 2);
    }
    EXPECT_TRUE(watch.peak() == 0 || watch.peak() > size / 2) << watch.peak();
    EXPECT_LT(MemoryWatch().peak(), size / 2);
}

TEST(Study, TheFrontIsWhatNothingBeats) {
    EXPECT_EQ(pareto_front({{1, 9}, {2, 4}, {2, 5}, {3, 4}, {4, 1}}),
              (std::vector<bool>{true, true, false, false, true}));
}

}  // namespace
}  // namespace cob
