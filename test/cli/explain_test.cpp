// `cob explain`, end to end.
#include "cob/tables.hpp"
#include "program.hpp"

#include <gtest/gtest.h>

namespace cob {
namespace {

test::ProgramResult explain(const std::string& arguments) {
    return test::run_program("explain " COB_DATA "/" + arguments);
}

bool says(const test::ProgramResult& run, const std::string& words) {
    return run.out.find(words) != std::string::npos;
}

// One element of each figure: the state and the sentence that it follows from.
TEST(Explain, SaysWhatTheFiguresShow) {
    const auto occluded = explain("figure4.obj 0.0/022");
    ASSERT_EQ(occluded.code, 0) << occluded.error;
    EXPECT_TRUE(says(occluded, "State: occluded") && says(occluded, "totally occluded. Step 1")) << occluded.out;
    const auto under_light = explain("figure6.obj 0.0/022");
    EXPECT_TRUE(says(under_light, "State: close") && says(under_light, "a light below the sheet")) << under_light.out;
    const auto shared = explain("figure3.obj 0.0/33");
    EXPECT_TRUE(says(shared, "State: close") && says(shared, "shared edge")) << shared.out;
    const auto empty = explain("figure2.obj 0.0/22");
    EXPECT_TRUE(says(empty, "State: empty") && says(empty, "an empty buffer: shoot")) << empty.out;
}

// The deciding values are exact: the sheet of figure 4 is at 1/64, the box of a quarter of the table 5/32 high.
TEST(Explain, ShowsExactValues) {
    const auto run = explain("figure4.obj 0.0/0");
    EXPECT_TRUE(says(run, "from (z/h)^2 = 1/100 (about 0.01) to 1/100 (about 0.01)")) << run.out;
}

// Squares of what binary64 just holds are beyond it, and named all the same.
TEST(Explain, NamesWhatIsBeyondBinary64) {
    for (const char* options : {"--height 1e308", "--height 1e-308", "--margin 1e308"}) {
        const auto run = explain(std::string("figure4.obj 0.0/0 ") + options);
        EXPECT_EQ(run.code, 0) << run.error;
        EXPECT_TRUE(says(run, "e+61") || says(run, "e-61") || says(run, "e+30")) << run.out;
        EXPECT_FALSE(says(run, "about inf") || says(run, "about 0)") || says(run, "nan")) << run.out;
    }
}

// Every element of a scene with coplanar, touching and non-planar neighbours: the words, made from plain fractions,
// contradict relate() nowhere (the program would end with an internal error), and the state is classify's.
TEST(Explain, AgreesWithClassify) {
    const test::TemporaryFolder folder;
    ASSERT_EQ(test::run_program("classify " COB_DATA "/cornell.obj -o " + folder.path()).code, 0);
    TableReader<StateRow> states(folder / "states.csv");
    int count = 0;
    for (StateRow row; states.next(row); ++count) {
        const auto run = explain("cornell.obj " + std::to_string(row.box));
        ASSERT_EQ(run.code, 0) << run.error;
        EXPECT_TRUE(says(run, std::string("State: ") + to_text(row.state))) << run.out;
    }
    EXPECT_GT(count, 15);
}

TEST(Explain, RefusesWhatIsNoElement) {
    for (const char* element : {"999999", "x", "0.7", "99.0", "0.0/5"}) {
        const auto run = explain("figure2.obj " + std::string(element));
        EXPECT_EQ(run.code, 2) << element;
        EXPECT_NE(run.error.find(element), std::string::npos) << run.error;
    }
}

}  // namespace
}  // namespace cob
