// `cob irradiance` and `cob formfactors`, end to end: the photometric tables of SPEC 8 against closed forms.
#include "cob/tables.hpp"
#include "program.hpp"
#include "tables.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace cob {
namespace {

using test::read_all;

const double pi = std::acos(-1.0);

std::size_t lines_of(const std::string& text) {
    return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

const std::string points_header = "point,x,y,z,nx,ny,nz\n";

/// Two lamps at height 1 over [0,1]^2 and [-1,0] x [0,1], and a sheet at 1/2 over [0,1/4] x [0,1]: polygons 0, 2, 1.
class IrradianceCommand : public testing::Test {
protected:
    void SetUp() override {
        create_folder(set_);
        write_file(set_ + "/scene.mtl",
                   "newmtl grey\nKd .5 .5 .5\nnewmtl lamp\nKe 1 2 4\nnewmtl blue\nKd 0 0 0\nKe 0 0 8\n");
        write_file(set_ + "/scene.obj",
                   "mtllib scene.mtl\nv 0 0 1\nv 0 1 1\nv 1 1 1\nv 1 0 1\nv 0 0 .5\nv .25 0 .5\nv .25 1 .5\nv 0 1 .5\n"
                   "v -1 0 1\nv -1 1 1\nusemtl lamp\nf 1 2 3 4\nusemtl grey\nf 5 6 7 8\nusemtl blue\nf 9 10 2 1\n");
    }
    test::ProgramResult irradiance(const std::string& rows, const std::string& options = "") const {
        write_file(set_ + "/points.csv", points_header + rows);
        return test::run_program("irradiance " + set_ + "/scene.obj " + set_ + "/points.csv -o " + out_ + " " +
                                 options);
    }
    /// Form factor from a point under a corner of a rectangle a by b at height 1 (Howell's B-4).
    static double corner(double a, double b) {
        const double u = std::hypot(a, 1), v = std::hypot(b, 1);
        return (a / u * std::atan(b / u) + b / v * std::atan(a / v)) / (2 * pi);
    }

    test::TemporaryFolder folder_;
    std::string set_ = folder_ / "set", out_ = folder_ / "irradiance.csv";
};

// A light that is tiny and seen at a graze: less than 1e-1000, which is 0 in binary64 and no NaN.
TEST_F(IrradianceCommand, WhatIsTooSmallForAnyNumberIsZero) {
    const auto run = irradiance("0,1e300,1e300,0,0,0,1\n1,-1e300,0.5,0,1e300,0,5e-324\n");
    ASSERT_EQ(run.code, 0) << run.error;
    const auto rows = read_all<IrradianceRow>(out_);
    ASSERT_EQ(rows.size(), 4u);
    for (const IrradianceRow& row : rows) {
        EXPECT_EQ(row.unobstructed, 0) << row.point;
        EXPECT_EQ(row.visible, 0) << row.point;
    }
}

// "One row for each point and light", ascending; irradiance is the visible form factor times Ke; error below 1e-13 of
// the unobstructed value.
TEST_F(IrradianceCommand, ClosedForms) {
    const auto run = irradiance(
        "3,0,0,0,0,0,5\n"         // the sheet's shadow on lamp 0 is [0,1/2] x [0,2]; normals have any length
        "4,0,0,3/4,0,0,1/3\n"     // above the sheet: from 1/4 below a corner
        "20,0,0,2,0,0,1\n"        // above the lamps
        "21,0,0,0,0,0,-1\n"       // turned away
        "30,1/8,0.5,0,0,0,1\n");  // under the sheet, whose shadow is [-1/8,3/8] x [-1/2,3/2]
    ASSERT_EQ(run.code, 0) << run.error;
    const std::string text = read_file(out_);
    EXPECT_EQ(text.substr(0, text.find('\n')), "point,light,unobstructed,visible,r,g,b");
    const auto rows = read_all<IrradianceRow>(out_);
    ASSERT_EQ(rows.size(), 10u);

    const double all = corner(1, 1), shadow = corner(0.5, 1), near = corner(4, 4);
    // Of point 30: the lamps reach from -9/8 over -1/8 to 7/8 of it, the shadow from -1/4 to 1/4.
    const auto within = [](double x) { return 2 * corner(x, 0.5); };
    const struct {
        RowId point;
        double unobstructed[2], visible[2];
    } expected[] = {{3, {all, all}, {all - shadow, all}},
                    {4, {near, near}, {near, near}},
                    {20, {0, 0}, {0, 0}},
                    {21, {0, 0}, {0, 0}},
                    {30,
                     {within(0.875) + within(0.125), within(1.125) - within(0.125)},
                     {within(0.875) - within(0.25), within(1.125) - within(0.25)}}};
    for (std::size_t k = 0; k < 10; ++k) {
        SCOPED_TRACE(k);
        const auto& e = expected[k / 2];
        EXPECT_EQ(rows[k].point, e.point);
        EXPECT_EQ(rows[k].light, k % 2 ? 2 : 0);
        EXPECT_NEAR(rows[k].unobstructed, e.unobstructed[k % 2], 1e-13 * e.unobstructed[k % 2]);
        EXPECT_NEAR(rows[k].visible, e.visible[k % 2], 1e-13 * e.unobstructed[k % 2]);
        const std::array<double, 3> emitted = k % 2 ? std::array<double, 3>{0, 0, 8} : std::array<double, 3>{1, 2, 4};
        for (std::size_t c = 0; c < 3; ++c) EXPECT_EQ(rows[k].irradiance[c], rows[k].visible * emitted[c]);
    }
}

// The same bytes for any number of threads and source, and from `answer`, which writes that table and nothing else.
TEST_F(IrradianceCommand, SameBytes) {
    std::string rows;
    for (int k = 0; k < 80; ++k)
        rows += std::to_string(k) + "," + std::to_string(k % 17) + "/16," + std::to_string(k % 23) + "/22,0,0," +
                std::to_string(k % 3) + ",7\n";
    ASSERT_EQ(irradiance(rows, "--threads 1").code, 0);
    const std::string first = read_file(out_);
    EXPECT_EQ(lines_of(first), 161u);
    for (const char* options : {"--threads 2", "--threads 2 --source all"}) {
        ASSERT_EQ(irradiance(rows, options).code, 0);
        EXPECT_EQ(read_file(out_), first) << options;
    }
    ASSERT_EQ(test::run_program("answer " + set_ + " -o " + folder_ / "answers").code, 0);
    EXPECT_EQ(read_file(folder_ / "answers/irradiance.csv"), first);
    EXPECT_FALSE(std::filesystem::exists(folder_ / "answers/states.csv"));
}

// Bad input: exit code 2, one line that names the file and the line, and no file.
TEST_F(IrradianceCommand, RefusesWithoutLeavingFiles) {
    const auto expect_refused = [&](const test::ProgramResult& run, const std::string& place) {
        EXPECT_EQ(run.code, 2);
        EXPECT_EQ(lines_of(run.error), 1u) << run.error;
        EXPECT_NE(run.error.find(place), std::string::npos) << run.error;
        for (const auto& entry : std::filesystem::directory_iterator(folder_.path()))
            EXPECT_NE(entry.path().filename().string().find("set"), std::string::npos) << entry.path();
    };
    for (const char* bad : {
             "4,0,0,0,0,0,0\n",    // no normal
             "4,0,0,nan,0,0,1\n",  // no number
             "4,0,0,0,0,0,inf\n",  //
             "4,0,0,0,0,0,1/0\n",  //
             "4,0,0,0,0,0\n",      // a column too few,
             "4,0,0,0,0,0,1,1\n",  // too many
             "4,0,0,0,0,0,1",      // cut off: the number may have gone on
             "2,0,0,0,0,0,1\n",    // not ascending
         }) {
        SCOPED_TRACE(bad);
        expect_refused(irradiance(std::string("3,0,0,0,0,0,1\n") + bad), "points.csv:3:");
    }
    // Nor an empty folder that would have held the table.
    const std::string folder = folder_ / "new/deeper";
    expect_refused(test::run_program("irradiance " + set_ + "/scene.obj " + set_ + "/points.csv -o " + folder),
                   "points.csv:3:");
    expect_refused(test::run_program("answer " + set_ + " -o " + folder), "points.csv:3:");
    write_file(set_ + "/points.csv", "point,x,y,z,nx,ny\n3,0,0,0,0,0\n");
    expect_refused(test::run_program("irradiance " + set_ + "/scene.obj " + set_ + "/points.csv -o " + out_),
                   "points.csv:1:");
    expect_refused(test::run_program("irradiance " + set_ + "/scene.obj " + set_ + "/none.csv -o " + out_), "none.csv");
    expect_refused(test::run_program("irradiance " + set_ + "/none.obj " + set_ + "/points.csv -o " + out_),
                   "none.obj");
}

class FormFactorsCommand : public testing::Test {
protected:
    void SetUp() override {
        // Unit squares facing each other at distance 1, later with a square of side 1/2 in the middle.
        const std::string vertices =
            "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 1 1\nv 1 1 1\nv 1 0 1\nv 0 0 1\n"
            "v .25 .25 .5\nv .75 .25 .5\nv .75 .75 .5\nv .25 .75 .5\n";
        write_file(folder_ / "parallel.obj", vertices + "f 1 2 3 4\nf 5 6 7 8\n");
        write_file(folder_ / "between.obj", vertices + "f 1 2 3 4\nf 5 6 7 8\nf 9 10 11 12\n");
        write_file(folder_ / "edge.obj", vertices + "f 1 2 3 4\nf 1 4 5 8\n");
        write_file(folder_ / "hidden.obj",
                   vertices + "v 0 0 .5\nv 1 0 .5\nv 1 1 .5\nv 0 1 .5\n" + "f 1 2 3 4\nf 5 6 7 8\nf 13 14 15 16\n");
    }
    test::ProgramResult formfactors(const std::string& scene, const std::string& options = "") const {
        return test::run_program("formfactors " + folder_ / scene + ".obj -o " + out_ + " " + options);
    }
    /// All of the table is what these say, within its error, which stays below the tolerance.
    void expect_table(const std::vector<FormFactorRow>& expected, double tolerance) const {
        const auto rows = read_all<FormFactorRow>(out_);
        ASSERT_EQ(rows.size(), expected.size());
        for (std::size_t k = 0; k < rows.size(); ++k) {
            SCOPED_TRACE(k);
            EXPECT_EQ(rows[k].from, expected[k].from);
            EXPECT_EQ(rows[k].to, expected[k].to);
            EXPECT_LE(std::abs(rows[k].form_factor - expected[k].form_factor), rows[k].error);
            EXPECT_LE(rows[k].error, tolerance);
        }
    }

    // Howell's C-11 (squares of sides 1; of 1 and 1/2 at 1/2) and C-14, to all digits.
    const double parallel_ = 0.19982489569838745, edge_ = 0.20004377607540316, plate_ = 0.12941326987888340;
    // A square of side s in the middle hides the pairs of points with midpoints in it. Along each axis those at
    // distance d have length min(s, 1 - d): that is how far intervals of lengths s and 2 - s overlap, so what is
    // hidden is the exchange between squares of sides 1/2 and 3/2 at distance 1.
    const double between_ = 0.09950629459898484;

    test::TemporaryFolder folder_;
    std::string out_ = folder_ / "formfactors.csv";
};

// "All non-zero pairs", each with an error that "exceeds [the distance] on every value known in closed form".
TEST_F(FormFactorsCommand, ClosedForms) {
    ASSERT_EQ(formfactors("parallel").code, 0);
    const std::string text = read_file(out_);
    EXPECT_EQ(text.substr(0, text.find('\n')), "from,to,form_factor,error");
    expect_table({{0, 1, parallel_, 0}, {1, 0, parallel_, 0}}, 1e-11);
    ASSERT_EQ(formfactors("edge").code, 0);
    expect_table({{0, 1, edge_, 0}, {1, 0, edge_, 0}}, 1e-11);
    ASSERT_EQ(formfactors("between").code, 0);
    expect_table({{0, 1, between_, 0}, {1, 0, between_, 0}, {1, 2, plate_, 0}, {2, 1, 4 * plate_, 0}}, 1e-6);
    ASSERT_EQ(formfactors("between", "--tolerance 1e-8 --pairs 1,0").code, 0);
    expect_table({{0, 1, between_, 0}, {1, 0, between_, 0}}, 1e-8);
}

TEST_F(FormFactorsCommand, WhatIsHiddenHasNoRow) {
    const auto run = formfactors("hidden", "--pairs 0,1");
    ASSERT_EQ(run.code, 0) << run.error;
    EXPECT_NE(run.error.find("1 hidden"), std::string::npos) << run.error;
    EXPECT_EQ(read_file(out_), "from,to,form_factor,error\n");
}

// "Certified bounds hold always", and tighten with the budget.
TEST_F(FormFactorsCommand, CertifiedBoundsHold) {
    double width = 1;
    for (const char* budget : {"4", "400", "1000"}) {
        SCOPED_TRACE(budget);
        ASSERT_EQ(formfactors("between", std::string("--certified --pairs 0,1 --subdivisions ") + budget).code, 0);
        expect_table({{0, 1, between_, 0}, {1, 0, between_, 0}}, width);
        const double next = read_all<FormFactorRow>(out_).at(0).error;
        EXPECT_LT(next, width);
        width = next;
    }
    ASSERT_EQ(formfactors("edge", "--certified").code, 0);
    expect_table({{0, 1, edge_, 0}, {1, 0, edge_, 0}}, 1e-6);
}

TEST_F(FormFactorsCommand, SameBytesAndReciprocity) {
    for (const std::string options : {"", "--certified --subdivisions 200"}) {
        ASSERT_EQ(formfactors("between", "--threads 1 " + options).code, 0);
        const std::string first = read_file(out_);
        for (const char* other : {"--threads 2 ", "--threads 2 --source all "}) {
            ASSERT_EQ(formfactors("between", other + options).code, 0);
            EXPECT_EQ(read_file(out_), first) << other << options;
        }
    }
    const auto used = formfactors("between"), checked = formfactors("between", "--both-sides");
    EXPECT_NE(used.out.find("reciprocity: used"), std::string::npos) << used.out;
    EXPECT_NE(checked.out.find("reciprocity: both sides differ by at most"), std::string::npos) << checked.out;
    expect_table({{0, 1, between_, 0}, {1, 0, between_, 0}, {1, 2, plate_, 0}, {2, 1, 4 * plate_, 0}}, 1e-6);
}

// Bad input: exit code 2, one line, and no file.
TEST_F(FormFactorsCommand, RefusesWithoutLeavingFiles) {
    for (const char* options : {"--pairs 0,7", "--pairs 0,-1", "--pairs 0", "--pairs 0,1x", "--tolerance 0",
                                "--tolerance nan", "--evaluations 0"}) {
        const auto run = formfactors("between", options);
        EXPECT_EQ(run.code, 2) << options;
        EXPECT_FALSE(run.error.empty()) << options;
        EXPECT_FALSE(std::filesystem::exists(out_)) << options;
    }
    const auto run = formfactors("between", "--pairs 0,7");
    EXPECT_EQ(lines_of(run.error), 1u) << run.error;
    EXPECT_NE(run.error.find("no such polygon '7'"), std::string::npos) << run.error;
    // A folder that cannot be is told before the work is done, not after it.
    const auto nowhere =
        test::run_program("formfactors " + folder_ / "between.obj -o " + folder_ / "between.obj/f.csv");
    EXPECT_EQ(nowhere.code, 2);
    EXPECT_EQ(nowhere.error.find("form factors"), std::string::npos) << nowhere.error;
}

// What binary64 cannot hold is said, and in finite time.
TEST_F(FormFactorsCommand, PolygonsTooSmallBesideTheScene) {
    const std::string squares = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 2\nv 0 1 2\nv 1 1 2\nv 1 0 2\n";
    for (const std::string size : {"1e20", "1e160", "1e300"}) {
        write_file(folder_ / "large.obj", squares + "v " + size + " 0 -1\nv -" + size + " 0 -1\nv 0 " + size +
                                              " -1\nf 1 2 3 4\nf 5 6 7 8\nf 9 10 11\n");
        const auto run =
            test::run_program("formfactors " + folder_ / "large.obj" + " --pairs 0,1 -o " + folder_ / "large.csv");
        EXPECT_EQ(run.code, size == "1e20" ? 0 : 2) << run.error;
        EXPECT_EQ(run.error.find("too small") != std::string::npos, size != "1e20") << run.error;
    }
}

}  // namespace
}  // namespace cob
