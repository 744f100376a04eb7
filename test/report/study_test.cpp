// Error against time: the reference, a run, its line and the front.
#include "cob/study.hpp"

#include "report/stress_scene.hpp"

#include <gtest/gtest.h>

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
    EXPECT_LT(band + dark, 200u);
    EXPECT_DOUBLE_EQ(reference.receiver_share, 68.0 / 72);
}

// Issue: the buffer reaches a fine uniform mesh's error with far fewer elements; a finer mesh errs less.
TEST(Study, FinerMeshesErrLessAndTheBufferNeedsFewerElements) {
    const Scene scene = shaded_floor();
    const StudyReference reference = study_reference(scene, 400, {});
    const auto run = [&](Refinement refinement, double patch, double least) {
        StudySettings settings;
        settings.series = "budget";
        settings.refinement = refinement;
        settings.patch_edge = patch;
        settings.minimum_edge = least;
        return study_run(scene, reference, settings, 1, 1);
    };
    const StudyRun coarse = run(Refinement::none, 1, 1), fine = run(Refinement::none, 0.25, 0.25),
                   buffer = run(Refinement::buffer, 1, 0.25);
    EXPECT_LT(fine.all.l2, 0.6 * coarse.all.l2);
    EXPECT_LT(buffer.all.l2, coarse.all.l2);
    EXPECT_LT(3 * buffer.elements, fine.elements);

    const std::optional<StudyRun> again = study_run_from_line(to_line(buffer), buffer.settings);
    ASSERT_TRUE(again);
    EXPECT_EQ(to_line(*again), to_line(buffer));
    EXPECT_FALSE(study_run_from_line(to_line(buffer), coarse.settings));
    EXPECT_FALSE(study_run_from_line(to_line(buffer) + ",1", buffer.settings));
}

TEST(Study, TheFrontIsWhatNothingBeats) {
    EXPECT_EQ(pareto_front({{1, 9}, {2, 4}, {2, 5}, {3, 4}, {4, 1}}),
              (std::vector<bool>{true, true, false, false, true}));
}

}  // namespace
}  // namespace cob
