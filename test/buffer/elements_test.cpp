// The order of elements, and their addresses.
#include "buffer/scenes.hpp"
#include "cob/error.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace cob {
namespace {

/// One refinement, of one way or both, or of a triangle.
void expect_cell_of(const Root& root, const Element& inner, const Element& outer) {
    const int by_i = inner.level_i - outer.level_i, by_j = inner.level_j - outer.level_j;
    EXPECT_EQ(std::max(by_i, by_j), 1);
    EXPECT_GE(std::min(by_i, by_j), 0);
    if (root.corner_count() == 3) {
        EXPECT_EQ(parent(root, inner), outer);
    } else {
        EXPECT_EQ(inner.i >> by_i, outer.i);
        EXPECT_EQ(inner.j >> by_j, outer.j);
    }
}

// "Ascending by root, then patches, then depth first": the list that is never stored, against the one written out.
TEST(ElementList, IsTheOrderWrittenOut) {
    const Scene scene = test::data_scene("cornell");
    const Roots roots(scene);
    for (const Meshing meshing : {Meshing{0, 0}, Meshing{0, 2}, Meshing{200, 0}, Meshing{150, 1}}) {
        const ElementList elements(scene, roots, meshing);
        std::uint64_t number = 0;
        std::vector<Element> around;
        for (const Root& root : roots.all())
            for (const Element& patch : patches(scene, root, meshing.edge))
                for (const Element& expected : descendants(root, patch, meshing.level)) {
                    ASSERT_EQ(elements[number], expected);
                    // Around it: its root first, then always the parent of the next.
                    elements.around(number, around);
                    around.push_back(expected);
                    EXPECT_EQ(around.front(), root_element(root.id));
                    for (std::size_t k = around.size() - 1; k > 0 && around[k].level_i > patch.level_i; --k)
                        EXPECT_EQ(parent(root, around[k]), around[k - 1]);
                    for (std::size_t k = 1; k < around.size(); ++k) expect_cell_of(root, around[k], around[k - 1]);
                    ++number;
                }
        EXPECT_EQ(number, elements.size());
        EXPECT_GE(number, static_cast<std::uint64_t>(roots.size()));
    }
}

TEST(ElementList, RefusesLevelsOutOfRange) {
    const Scene scene = test::data_scene("figure2");
    const Roots roots(scene);
    EXPECT_THROW(ElementList(scene, roots, Meshing{0, -1}), InputError);
    EXPECT_THROW(ElementList(scene, roots, Meshing{0, 21}), InputError);
}

TEST(Address, ReadsBack) {
    const Scene scene = test::data_scene("cornell");
    const Roots roots(scene);
    int unequal = 0;
    for (const Meshing meshing : {Meshing{0, 2}, Meshing{150, 1}}) {
        const ElementList elements(scene, roots, meshing);
        for (std::uint64_t k = 0; k < elements.size(); ++k) {
            const std::string text = to_address(roots, elements[k]);
            ASSERT_EQ(parse_address(scene, roots, text), elements[k]) << text;
            unequal += text.find(':') != std::string::npos;
        }
    }
    EXPECT_GT(unequal, 0);
}

TEST(Address, RefusesWhatIsNone) {
    const Scene scene = test::data_scene("cornell");
    const Roots roots(scene);
    for (const char* text : {"", "x", "0", "0.", "0.9", "99.0", "0.0/4", "0.0/1x", "0.0:1,1:2,0", "0.0:1,1", "-1.0",
                             "0.0 ", "0.0:40,0:0,0", "0.0/00000000000000000000000000000000"})
        EXPECT_THROW(parse_address(scene, roots, text), InputError) << text;
    EXPECT_EQ(parse_address(scene, roots, "0.0/"), root_element(0));
}

}  // namespace
}  // namespace cob
