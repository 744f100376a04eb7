// `cob answer`, end to end: sets by this program and by others.
#include "cob/tables.hpp"
#include "program.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <set>

namespace cob {
namespace {

/// A table [0,8]^2, a sheet 1/4 above its middle, and a lamp at 4.
const char* const scene =
    "mtllib scene.mtl\nv 0 0 0\nv 8 0 0\nv 8 8 0\nv 0 8 0\nv 2 2 0.25\nv 6 2 0.25\nv 6 6 0.25\nv 2 6 0.25\n"
    "v 3 3 4\nv 3 5 4\nv 5 5 4\nv 5 3 4\nusemtl grey\nf 1 2 3 4\nf 5 6 7 8\nusemtl lamp\nf 9 10 11 12\n";
const std::string boxes_header = "box,polygon,x0,y0,z0,x1,y1,z1,x2,y2,z2,x3,y3,z3,ux,uy,uz,margin,height\n";
const std::string segments_header = "segment,x0,y0,z0,x1,y1,z1,from,to\n";

class Answer : public testing::Test {
protected:
    void SetUp() override {
        create_folder(set_);
        write_file(set_ + "/scene.obj", scene);
        write_file(set_ + "/scene.mtl", "newmtl grey\nKd .5 .5 .5\nnewmtl lamp\nKd 0 0 0\nKe 9 9 9\n");
    }
    test::ProgramResult answer(const std::string& options = "") const {
        return test::run_program("answer " + set_ + " -o " + out_ + " " + options);
    }
    std::set<std::string> files() const { return test::files_in(out_); }
    std::string text(const std::string& name) const { return read_file(out_ + "/" + name); }

    test::TemporaryFolder folder_;
    std::string set_ = folder_ / "set", out_ = folder_ / "answers";
};

// Boxes "whatever program wrote it": triangles, no own polygon, fractions, hex-floats, any u, gaps in the ids, CRLF.
TEST_F(Answer, BoxesOfAnyProgram) {
    write_file(set_ + "/boxes.csv",
               boxes_header + "3,0,3,3,0,4,3,0,4,4,0,3,4,0,1,0,0,0.125,0.25\r\n" +  // under the sheet, h = 5/16
                   "5,0,3,3,0,4,3,0,4,4,0,3,4,0,7/3,0,0,0,1/4\r\n" +                // h = 1/4: the sheet is the top
                   "7,-1,3,3,0,4,3,0,3,0x1p2,0,,,,-1,0,0,0,1/8\r\n" +  // below it; now the table is coplanar
                   "40,0,1/3,1/3,0,2/3,1/3,0,2/3,2/3,0,1/3,2/3,0,0,0.1,0,0.125,0.25\r\n");
    const auto run = answer();
    ASSERT_EQ(run.code, 0) << run.error;
    EXPECT_EQ(files(), (std::set<std::string>{"relations.csv", "states.csv"}));
    EXPECT_EQ(text("states.csv"),
              "box,state,close,cover,light\n3,occluded,,1,\n5,occluded,,1,\n7,empty,,,\n40,empty,,,\n");
    EXPECT_EQ(text("relations.csv"),
              "box,polygon,relation,covers,shared\n3,1,crossing,1,none\n5,1,boundary,1,none\n7,0,coplanar,0,none\n");
}

TEST_F(Answer, SegmentsWithHintsTrueOrNot) {
    // Through the sheet, beside it, along its rim; then the same with hints that are not true.
    write_file(set_ + "/segments.csv", segments_header +
                                           "0,4,4,0,4,4,4,0,2\n1,1,1,0,4,4,4,0,2\n2,2,3,0,2,3,4,0,-1\n"
                                           "3,4,4,0,4,4,4,1,1\n4,1,1,0,4,4,4,1,0\n5,2,3,0,2,3,4,2,2\n");
    ASSERT_EQ(answer().code, 0);
    EXPECT_EQ(files(), std::set<std::string>{"visibility.csv"});
    EXPECT_EQ(text("visibility.csv"),
              "segment,visibility\n0,blocked\n1,clear\n2,grazing\n3,blocked\n4,clear\n5,grazing\n");
    write_file(set_ + "/segments.csv", "segment,x0,y0,z0,x1,y1,z1\n7,1/3,1,0,1/3,1,4\n");
    ASSERT_EQ(answer().code, 0);
    EXPECT_EQ(text("visibility.csv"), "segment,visibility\n7,clear\n");
}

// What `classify` writes is a set's questions, and `answer` gives its answers, on any number of threads.
TEST_F(Answer, AgreesWithClassify) {
    ASSERT_EQ(test::run_program("classify " COB_DATA "/desk.obj --level 1 --margin 1/3 -o " + folder_ / "c").code, 0);
    for (const char* name : {"desk.obj", "desk.mtl"})
        std::filesystem::copy(std::string(COB_DATA "/") + name, set_ + "/" + name);
    std::filesystem::rename(set_ + "/desk.obj", set_ + "/scene.obj");
    std::filesystem::copy(folder_ / "c/boxes.csv", set_ + "/boxes.csv");
    for (const char* options : {"--threads 1", "--threads 2 --source all", "--threads 2 --arithmetic rational"}) {
        ASSERT_EQ(answer(options).code, 0);
        for (const char* name : {"states.csv", "relations.csv"})
            EXPECT_EQ(text(name), read_file(folder_ / "c/" + name)) << name << " " << options;
    }
}

// Variants as subjects: other people's code answers yes or no, in short forms of the tables.
TEST_F(Answer, ByOtherPeoplesCode) {
    write_file(set_ + "/boxes.csv", boxes_header +
                                        "3,0,3,3,0,4,3,0,4,4,0,3,4,0,1,0,0,0.125,0.25\n" +  // under the sheet
                                        "4,0,0,0,0,1,0,0,1,1,0,0,1,0,1,0,0,0.125,0.25\n" +  // beside it
                                        "5,0,3,3,0,4,3,0,5,3,0,3,5,0,1,0,0,0.125,0.25\n");  // straight at corner 1
    write_file(set_ + "/segments.csv", segments_header + "1,4,4,1,4,4,0.125,-1,-1\n2,1,1,1,1,1,0.125,-1,-1\n");
    for (const char* kernel : {"cgal-epick", "cgal-epeck"}) {
        const auto run = answer(std::string("--arithmetic ") + kernel);
        ASSERT_EQ(run.code, 0) << run.error;
        EXPECT_EQ(text("relations.csv"), "box,polygon,close\n3,1,1\n5,1,1\n") << kernel;
    }
    const auto run = answer("--arithmetic embree");
    if (run.code == 0) {
        EXPECT_EQ(text("visibility.csv"), "segment,hidden\n1,1\n2,0\n");
        // What SPEC 6 refuses is refused here, too.
        for (const char* bad : {"1,4,4,1,4,4,0.125,9,-1\n", "1,4,4,1,4,4,1,-1,-1\n"}) {
            write_file(set_ + "/segments.csv", segments_header + bad);
            EXPECT_EQ(answer("--arithmetic embree").code, 2) << bad;
        }
    } else {
        EXPECT_NE(run.error.find("built without Embree"), std::string::npos) << run.error;
    }
    EXPECT_EQ(files().count("states.csv"), 0U);

    write_file(set_ + "/boxes.csv", boxes_header + "3,0,3,3,0,4,3,0,4,4,0,3,4,0,1,1,0,0.125,0.25\n");
    const auto refused = answer("--arithmetic cgal-epick");
    EXPECT_EQ(refused.code, 2);
    EXPECT_NE(refused.error.find("boxes.csv:2"), std::string::npos) << refused.error;
    EXPECT_NE(refused.error.find("not axis-aligned"), std::string::npos) << refused.error;
}

// Interval arithmetic alone never errs: what it cannot decide it says.
TEST_F(Answer, IntervalSaysUndecided) {
    write_file(set_ + "/boxes.csv", boxes_header + "0,0,3,3,0,4,3,0,4,4,0,3,4,0,1,0,0,0,1/4\n");
    const auto run = answer("--arithmetic interval");
    ASSERT_EQ(run.code, 0) << run.error;
    EXPECT_NE(text("relations.csv").find("0,1,undecided"), std::string::npos) << text("relations.csv");
    EXPECT_NE(text("states.csv").find("0,undecided"), std::string::npos) << text("states.csv");
}

// Questions that SPEC refuses: the line is named, exit code 2, and no answers appear, of other tables neither.
TEST_F(Answer, RefusesWithTheLine) {
    const std::string good = "0,0,3,3,0,4,3,0,4,4,0,3,4,0,1,0,0,0.125,0.25\n";
    for (const char* bad : {
             "1,3,3,3,0,4,3,0,4,4,0,3,4,0,1,0,0,0.125,0.25\n",       // no such polygon
             "1,0,3,3,0,4,3,0,4,4,0,3,4,1,1,0,0,0.125,0.25\n",       // not planar
             "1,0,3,3,0,4,3,0,3,4,0,4,4,0,1,0,0,0.125,0.25\n",       // not convex
             "1,0,3,3,0,4,3,0,5,3,0,,,,1,0,0,0.125,0.25\n",          // no area
             "1,0,3,3,0,4,3,0,4,4,0,3,4,0,1,0,1e-300,0.125,0.25\n",  // u not perpendicular
             "1,0,3,3,0,4,3,0,4,4,0,3,4,0,0,0,0,0.125,0.25\n",       // no u
             "1,0,3,3,0,4,3,0,4,4,0,3,4,0,1,0,0,-1/8,0.25\n",        // margin
             "1,0,3,3,0,4,3,0,4,4,0,3,4,0,1,0,0,0.125,0\n",          // height
         }) {
        write_file(set_ + "/boxes.csv", boxes_header + good + bad);
        const auto run = answer();
        EXPECT_EQ(run.code, 2) << bad;
        EXPECT_NE(run.error.find("boxes.csv:3:"), std::string::npos) << bad << run.error;
        EXPECT_TRUE(files().empty()) << bad;
    }
    write_file(set_ + "/boxes.csv", boxes_header + good);
    for (const char* bad : {"1,0,0,0,1,1,1,3,-1\n", "1,0,0,0,1,1,1,-1,7\n", "1,0,0,0,0,0,0,-1,-1\n"}) {
        write_file(set_ + "/segments.csv", segments_header + "0,0,0,1,1,1,1,-1,-1\n" + bad);
        const auto run = answer();
        EXPECT_EQ(run.code, 2) << bad;
        EXPECT_NE(run.error.find("segments.csv:3:"), std::string::npos) << bad << run.error;
        EXPECT_TRUE(files().empty()) << bad;
    }
}

// Of two lines that are refused the first is told, on any number of threads.
TEST_F(Answer, TellsTheFirstBadLine) {
    std::string rows;
    for (int k = 0; k < 5000; ++k)
        rows += std::to_string(k) + "," + (k >= 2500 ? "9" : "0") + ",3,3,0,4,3,0,4,4,0,3,4,0,1,0,0,0.125,0.25\n";
    write_file(set_ + "/boxes.csv", boxes_header + rows + "broken\n");
    for (const char* options : {"--threads 1", "--threads 4"}) {
        const auto run = answer(options);
        EXPECT_EQ(run.code, 2);
        EXPECT_NE(run.error.find("boxes.csv:2502: no such polygon '9'"), std::string::npos) << run.error;
    }
}

TEST_F(Answer, RefusesSetsWithoutQuestionsOrScene) {
    EXPECT_EQ(answer().code, 2);
    write_file(set_ + "/boxes.csv", boxes_header);
    EXPECT_EQ(answer().code, 0);  // no question is a question answered
    EXPECT_EQ(text("states.csv"), "box,state,close,cover,light\n");
    std::filesystem::remove(set_ + "/scene.obj");
    EXPECT_EQ(answer().code, 2);
}

}  // namespace
}  // namespace cob
