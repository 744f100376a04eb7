// The figures of the paper, as scenes: the states that it shows there.
#include "buffer/scenes.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <stdexcept>

namespace cob {
namespace {

/// The elements of one scene, from the whole scene.
class Figure {
public:
    Figure(const std::string& name, int level)
        : scene_(test::data_scene(name)),
          roots_(scene_),
          elements_(scene_, roots_, Meshing{0, level}),
          source_(make_candidates(scene_, Source::tree)) {}

    ClassifiedElement classified(std::uint64_t number) const {
        ClassifiedElement result;
        ElementClassifier classifier(elements_, *source_, options_);
        classifier(number, result);
        return result;
    }
    /// The element of polygon 0, a table [0,1]^2 in z = 0, in which a point lies.
    ClassifiedElement at(double x, double y) const {
        const double n = static_cast<double>(1u << elements_.meshing().level);
        const auto i = static_cast<std::uint32_t>(x * n), j = static_cast<std::uint32_t>(y * n);
        for (std::uint64_t k = 0; k < elements_.size(); ++k)
            if (const Element e = elements_[k]; e.root == 0 && e.i == i && e.j == j) return classified(k);
        throw std::out_of_range("no such element");
    }
    BufferState state(double x, double y) const { return at(x, y).found.state; }
    const ElementList& elements() const { return elements_; }

private:
    Scene scene_;
    Roots roots_;
    ElementList elements_;
    std::unique_ptr<CandidateSource> source_;
    ClassifyOptions options_;
};

// Figure 2: where the small object stands, the buffer is not empty; elsewhere it is.
TEST(PaperFigures, Figure2SmallObjectOnATable) {
    const Figure figure("figure2", 4);
    int close = 0, empty = 0;
    for (std::uint64_t k = 0; k < 256; ++k) {
        const ClassifiedElement element = figure.classified(k);
        ASSERT_EQ(element.question.polygon, 0);
        close += element.found.state == BufferState::close;
        empty += element.found.state == BufferState::empty;
    }
    EXPECT_EQ(close + empty, 256);
    EXPECT_GT(close, 0);
    EXPECT_LT(close, 64);  // only around the object
    EXPECT_EQ(figure.state(0.99, 0.99), BufferState::empty);
}

// Figure 3: two polygons that share an edge: along it the wall is close to the table's elements, though nothing
// stands on them.
TEST(PaperFigures, Figure3SharedEdge) {
    const Figure figure("figure3", 3);
    for (double x = 0.05; x < 1; x += 0.1) {
        const ClassifiedElement element = figure.at(x, 0.99);
        EXPECT_EQ(element.found.state, BufferState::close);
        EXPECT_EQ(element.found.close, std::vector<PolygonId>{1});
        EXPECT_EQ(figure.state(x, 0.5), BufferState::empty);
    }
}

// Figure 4: total occlusion: the sheet covers the elements under its middle; under its rim it is only close.
TEST(PaperFigures, Figure4TotalOcclusion) {
    const Figure figure("figure4", 3);
    const ClassifiedElement middle = figure.at(0.5, 0.5);
    EXPECT_EQ(middle.found.state, BufferState::occluded);
    EXPECT_EQ(middle.found.cover, (std::vector<PolygonId>{1, 2}));
    EXPECT_EQ(figure.state(0.2, 0.5), BufferState::close);
    EXPECT_EQ(figure.state(0.01, 0.01), BufferState::empty);
}

// Figure 5: tangential light is ignored: the light that reaches under the sheet from the side is not close.
TEST(PaperFigures, Figure5TangentialLight) {
    const Figure figure("figure5", 3);
    EXPECT_EQ(figure.state(0.5, 0.5), BufferState::occluded);
    EXPECT_TRUE(figure.at(0.5, 0.5).found.light.empty());
}

// Figure 6: a light below the sheet: the covered elements that it is close to are not occluded.
TEST(PaperFigures, Figure6LightBelowTheSheet) {
    const Figure figure("figure6", 3);
    const ClassifiedElement middle = figure.at(0.5, 0.5);
    EXPECT_EQ(middle.found.state, BufferState::close);
    EXPECT_EQ(middle.found.light, std::vector<PolygonId>{3});
    EXPECT_EQ(middle.found.cover, (std::vector<PolygonId>{1, 2}));
    EXPECT_EQ(figure.state(0.3, 0.3), BufferState::occluded);  // covered, and the light is not close
}

// Figure 7: two levels: on a polygon with nothing near, no element needs a test; on the other, its list serves.
TEST(PaperFigures, Figure7TwoLevels) {
    const Figure figure("figure7", 4);
    const Scene& scene = figure.elements().scene();
    const auto source = make_candidates(scene, Source::tree);
    BufferBuilder builder(scene, figure.elements().roots(), *source, BufferOptions{});
    BufferStatistics statistics;
    const CloseObjectBuffer table = builder.build(root_element(0)), beside = builder.build(root_element(1));
    EXPECT_EQ(table.state(), BufferState::close);
    EXPECT_EQ(test::to_vector(builder.polygons(table)), (std::vector<PolygonId>{2, 3, 4, 5, 6}));
    EXPECT_EQ(beside.state(), BufferState::empty);
    for (std::uint64_t k = 256; k < 512; ++k) {
        const Element element = figure.elements()[k];
        ASSERT_EQ(element.root, 1);
        EXPECT_EQ(builder.build(element, beside, &statistics).state(), BufferState::empty);
    }
    EXPECT_EQ(statistics.inherited, 256u);
    EXPECT_EQ(statistics.tested, 0u);
}

}  // namespace
}  // namespace cob
