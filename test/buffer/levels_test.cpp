// SPEC 4 and 5: "a buffer refined from its parent's equals one built from the whole scene, where the parent is not
// occluded"; two levels and any number of levels; the modes inherit and strict.
#include "buffer/scenes.hpp"

#include <gtest/gtest.h>

#include <map>

namespace cob {
namespace {

void expect_equal(const Classification& a, const Classification& b, bool neighbours) {
    ASSERT_EQ(a.state, b.state);
    ASSERT_EQ(a.close, b.close);
    ASSERT_EQ(a.cover, b.cover);
    ASSERT_EQ(a.light, b.light);
    if (!neighbours) return;
    ASSERT_EQ(a.neighbours.size(), b.neighbours.size());
    for (std::size_t k = 0; k < a.neighbours.size(); ++k) {
        ASSERT_EQ(a.neighbours[k].polygon, b.neighbours[k].polygon);
        ASSERT_EQ(a.neighbours[k].answer.relation, b.neighbours[k].answer.relation);
        ASSERT_EQ(a.neighbours[k].answer.covers, b.neighbours[k].answer.covers);
    }
}

std::vector<ClassifiedElement> classify_all(const ElementList& elements, const CandidateSource& source,
                                            const ClassifyOptions& options, ClassifyStatistics* statistics = nullptr) {
    std::vector<ClassifiedElement> all(elements.size());
    ElementClassifier classifier(elements, source, options);
    for (std::uint64_t k = 0; k < elements.size(); ++k) classifier(k, all[k]);
    if (statistics != nullptr) *statistics += classifier.statistics();
    return all;
}

/// Classifies with the options and compares with what the whole scene gives; how many elements inherit, and how many
/// of these are not occluded.
std::pair<int, int> compare_with_scene(const ElementList& elements, const CandidateSource& source,
                                       const ClassifyOptions& options, const std::vector<ClassifiedElement>& expected) {
    ClassifyStatistics statistics;
    const auto found = classify_all(elements, source, options, &statistics);
    int inherited = 0, otherwise = 0;
    for (std::size_t k = 0; k < found.size(); ++k) {
        SCOPED_TRACE("element " + std::to_string(k));
        expect_equal(found[k].found, expected[k].found, options.relations);
        if (!found[k].inherited) continue;
        EXPECT_EQ(options.buffer.mode, BufferMode::inherit);
        EXPECT_EQ(*found[k].inherited, BufferState::occluded);
        ++inherited;
        otherwise += expected[k].found.state != BufferState::occluded;
    }
    EXPECT_EQ(statistics.inherited, static_cast<std::uint64_t>(inherited));
    EXPECT_EQ(statistics.inherited_otherwise, static_cast<std::uint64_t>(otherwise));
    return {inherited, otherwise};
}

TEST(Levels, EveryLevelGivesWhatTheWholeSceneGives) {
    std::map<BufferState, int> met;
    int inherited = 0, otherwise = 0;
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const Scene scene = test::random_room(seed);
        const Roots roots(scene);
        const ElementList elements(scene, roots, Meshing{seed % 3 == 0 ? 3.0 : 0.0, seed % 3 == 0 ? 1 : 2});
        const auto tree = make_candidates(scene, seed % 2 == 0 ? Source::tree : Source::octree);
        const auto all = make_candidates(scene, Source::all);
        ClassifyOptions options;
        options.levels = BufferLevels::element;
        const auto expected = classify_all(elements, *all, options);
        for (const auto& element : expected) ++met[element.found.state];
        for (const BufferLevels levels :
             {BufferLevels::element, BufferLevels::polygon, BufferLevels::tree, BufferLevels::automatic})
            for (const BufferMode mode : {BufferMode::strict, BufferMode::inherit}) {
                options.levels = levels;
                options.buffer.mode = mode;
                options.relations = (seed + static_cast<std::uint64_t>(levels)) % 2 == 0;
                const auto counts = compare_with_scene(elements, *tree, options, expected);
                inherited += counts.first;
                otherwise += counts.second;
            }
    }
    // Nothing of this may have been tested on nothing.
    EXPECT_GT(met[BufferState::empty], 300);
    EXPECT_GT(met[BufferState::close], 300);
    EXPECT_GT(met[BufferState::occluded], 50);
    EXPECT_GT(inherited, 100);
    EXPECT_GT(otherwise, 10);
}

// A classifier that jumps between elements finds what one finds that goes through them.
TEST(Levels, OrderOfQuestionsDoesNotMatter) {
    const Scene scene = test::data_scene("desk");
    const Roots roots(scene);
    const ElementList elements(scene, roots, Meshing{0, 2});
    const auto source = make_candidates(scene, Source::tree);
    ClassifyOptions options;
    options.levels = BufferLevels::tree;
    const auto expected = classify_all(elements, *source, options);
    ElementClassifier classifier(elements, *source, options);
    ClassifiedElement element;
    std::uint64_t number = 0;
    for (int k = 0; k < 300; ++k) {
        number = (number + 977) % elements.size();
        classifier(number, element);
        expect_equal(element.found, expected[number].found, true);
    }
}

// With lists of parents no polygon is tested that the tree would not have named, and around nothing none at all.
TEST(Levels, ListsOfTheParentSpareTests) {
    const Scene scene = test::data_scene("figure7");
    const Roots roots(scene);
    const ElementList elements(scene, roots, Meshing{0, 4});
    const auto source = make_candidates(scene, Source::tree);
    ClassifyOptions options;
    options.relations = false;
    options.levels = BufferLevels::element;
    ClassifyStatistics one, two, of_roots;
    classify_all(elements, *source, options, &one);
    classify_all(ElementList(scene, roots, Meshing{}), *source, options, &of_roots);
    options.levels = BufferLevels::polygon;
    classify_all(elements, *source, options, &two);
    EXPECT_EQ(two.around, static_cast<std::uint64_t>(roots.size()));
    EXPECT_LE(two.tested, one.tested + of_roots.tested);
    EXPECT_GT(two.tested, 0u);
}

/// A floor of 64 by 64, on it rows of small sheets: as many a row, and so many rows.
Scene floor_under_sheets(int count, int rows) {
    std::vector<test::Loop> loops;
    const auto add = [&](double x, double y, double z, double side) {
        loops.push_back({{x, y, z}, {x + side, y, z}, {x + side, y + side, z}, {x, y + side, z}});
    };
    add(0, 0, 0, 64);
    for (int i = 0; i < count; ++i)
        for (int j = 0; j < rows; ++j) add(64.0 * i / count + 1, 64.0 * j / count + 1, 0.5, 1);
    return test::scene_of(loops);
}

// Two levels where the list is short, one where it would be gone through again and again; the same answers.
TEST(Levels, AutomaticBuildsBuffersWherePolygonsAreFew) {
    const auto run = [](const Scene& scene, const Meshing& meshing, BufferLevels levels) {
        const Roots roots(scene);
        const ElementList elements(scene, roots, meshing);
        const auto source = make_candidates(scene, Source::tree);
        ClassifyOptions options;
        options.levels = levels;
        options.relations = false;
        ClassifyStatistics statistics;
        const auto found = classify_all(elements, *source, options, &statistics);
        options.levels = BufferLevels::element;
        const auto expected = classify_all(elements, *source, options);
        for (std::size_t k = 0; k < found.size(); ++k) expect_equal(found[k].found, expected[k].found, false);
        return statistics;
    };
    // Few around every root: as with two levels.
    const Scene few = floor_under_sheets(5, 5);
    for (const Meshing meshing : {Meshing{0, 3}, Meshing{1, 1}})
        EXPECT_EQ(run(few, meshing, BufferLevels::automatic).around, run(few, meshing, BufferLevels::polygon).around);

    // 144 sheets on the floor. Cut into patches, it has no buffer; refined, each of its quarters has one, with 49.
    const Scene many = floor_under_sheets(12, 12);
    EXPECT_EQ(run(many, Meshing{4, 0}, BufferLevels::automatic).around, 0u);
    EXPECT_EQ(run(many, Meshing{0, 3}, BufferLevels::automatic).around, 4u + 144u) << "every sheet has one";
}

}  // namespace
}  // namespace cob
