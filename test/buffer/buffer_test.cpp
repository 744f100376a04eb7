// The lazy buffer: 4 bytes, built on demand from the scene or from the buffer around it, by several threads.
#include "buffer/scenes.hpp"

#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

#include <map>

namespace cob {
namespace {

TEST(CloseObjectBuffer, IsUninitialisedAndTakesFourBytes) {
    const CloseObjectBuffer buffer;
    EXPECT_EQ(sizeof buffer, 4u);  // the paper: at most 5 bytes an element
    EXPECT_EQ(buffer.state(), BufferState::uninitialised);
    EXPECT_FALSE(buffer.is_built());
}

/// The elements of a root from its buffer, each against the one built from the scene.
void compare_with_scene(BufferBuilder& builder, const Root& root, std::map<BufferState, int>& met) {
    const CloseObjectBuffer around = builder.build(root_element(root.id));
    for (const Element& element : descendants(root, root_element(root.id), 2)) {
        BufferStatistics statistics;
        const CloseObjectBuffer from_scene = builder.build(element);
        const CloseObjectBuffer from_parent = builder.build(element, around, &statistics);
        ++met[from_scene.state()];
        EXPECT_EQ(statistics.built[static_cast<std::size_t>(from_parent.state())], 1u);
        // Only a buffer in state close stores polygons.
        EXPECT_EQ(builder.polygons(from_scene).empty(), from_scene.state() != BufferState::close);
        if (builder.options().mode == BufferMode::inherit && around.state() == BufferState::occluded) {
            EXPECT_EQ(from_parent.state(), BufferState::occluded);
            EXPECT_EQ(statistics.tested, 0u);
            continue;
        }
        EXPECT_EQ(from_parent.state(), from_scene.state());
        EXPECT_EQ(test::to_vector(builder.polygons(from_parent)), test::to_vector(builder.polygons(from_scene)));
        EXPECT_EQ(statistics.from_scene, around.state() == BufferState::occluded ? 1u : 0u);
    }
}

TEST(BufferBuilder, FromTheSceneOrFromTheParent) {
    std::map<BufferState, int> met;
    for (std::uint64_t seed = 100; seed < 130; ++seed) {
        const Scene scene = test::random_room(seed);
        const Roots roots(scene);
        const auto source = make_candidates(scene, Source::tree);
        BufferOptions options;
        options.mode = seed % 2 == 0 ? BufferMode::strict : BufferMode::inherit;
        BufferBuilder builder(scene, roots, *source, options);
        for (const Root& root : roots.all()) compare_with_scene(builder, root, met);
    }
    EXPECT_GT(met[BufferState::empty], 100);
    EXPECT_GT(met[BufferState::close], 100);
    EXPECT_GT(met[BufferState::occluded], 20);
}

TEST(BufferBuilder, KeepsTheParentsListWhereNothingIsMissing) {
    const Scene scene = test::data_scene("figure3");
    const Roots roots(scene);
    const auto source = make_candidates(scene, Source::tree);
    BufferBuilder builder(scene, roots, *source, BufferOptions{});
    const Element table = root_element(0);
    const CloseObjectBuffer around = builder.build(table);
    ASSERT_EQ(around.state(), BufferState::close);
    const std::size_t before = builder.list_bytes();
    int close = 0;
    for (const Element& child : children(roots[0], table)) {
        const CloseObjectBuffer buffer = builder.build(child, around);
        if (buffer.state() != BufferState::close) continue;
        ++close;
        EXPECT_EQ(builder.polygons(buffer).begin(), builder.polygons(around).begin());
    }
    EXPECT_GT(close, 0);
    EXPECT_EQ(builder.list_bytes(), before);
}

// Lists of every length, some longer than what the pool takes up at a time, from several threads.
TEST(BufferBuilder, StoredListsStayWhatTheyAre) {
    const Scene scene = test::data_scene("figure3");
    const Roots roots(scene);
    const auto source = make_candidates(scene, Source::all);
    BufferBuilder builder(scene, roots, *source, BufferOptions{});
    const auto length = [](int k) { return k % 97 == 5 ? 150000 + k : 1 + (k * 7919) % 3000; };
    std::vector<CloseObjectBuffer> buffers(600);
    tbb::parallel_for(0, 600, [&](int k) {
        Classification found;
        found.state = BufferState::close;
        for (int n = 0; n < length(k); ++n) found.close.push_back(k + n);
        buffers[static_cast<std::size_t>(k)] = builder.keep(found);
    });
    std::size_t words = 0;
    for (int k = 0; k < 600; ++k) {
        const View<PolygonId> list = builder.polygons(buffers[static_cast<std::size_t>(k)]);
        ASSERT_EQ(list.size(), static_cast<std::size_t>(length(k)));
        for (int n = 0; n < length(k); ++n) ASSERT_EQ(list.begin()[n], k + n);
        words += list.size() + 1;
    }
    EXPECT_EQ(builder.list_bytes(), 4 * words);
}

TEST(BufferBuilder, ThreadsBuildWhatOneThreadBuilds) {
    const Scene scene = test::data_scene("desk");
    const Roots roots(scene);
    const ElementList elements(scene, roots, Meshing{0, 2});
    const auto source = make_candidates(scene, Source::tree);
    BufferBuilder one(scene, roots, *source, BufferOptions{}), many(scene, roots, *source, BufferOptions{});
    std::vector<CloseObjectBuffer> buffers(elements.size());
    tbb::parallel_for(std::uint64_t{0}, elements.size(),
                      [&](std::uint64_t k) { buffers[k] = many.build(elements[k]); });
    for (std::uint64_t k = 0; k < elements.size(); ++k) {
        const CloseObjectBuffer expected = one.build(elements[k]);
        ASSERT_EQ(buffers[k].state(), expected.state());
        ASSERT_EQ(test::to_vector(many.polygons(buffers[k])), test::to_vector(one.polygons(expected)));
    }
}

}  // namespace
}  // namespace cob
