// What all commands share: bad options are refused before the work, failed work leaves nothing, names of files may be
// in any encoding, what is skipped is said.
#include "cob/scene.hpp"
#include "program.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <set>
#include <sstream>

namespace cob {
namespace {

using test::run_program;

const std::string figure2 = COB_DATA "/figure2.obj";

// "Bad input gives one line with file, line, value and remedy, and exit code 2; nothing is written by half." NaN lies
// in every range of CLI11.
TEST(Commands, NumbersThatAreNoneAreRefused) {
    const test::TemporaryFolder folder;
    const char* rows[][2] = {{"render", "--unshot nan"},
                             {"render", "--exposure nan"},
                             {"render", "--fov nan"},
                             {"render", "--edge inf"},
                             {"render", "--gradient-threshold nan"},
                             {"render", "--gradient-threshold 0.1,nan,0.1"},
                             {"render", "--gradient-threshold=-1"},
                             {"render", "--strength-threshold nan"},
                             {"render", "--margin nan"},
                             {"render", "--position nan 0 0"},
                             {"render", "--line 0 0 0 nan 1 0"},
                             {"render", "--threads 100000"},
                             {"study", "--within 0 0 0 nan 1 1"},
                             {"study", "--threads 100000"}};
    for (const auto& [command, option] : rows) {
        const std::string arguments = command + (" " + figure2) + " " + option;
        const auto run = run_program(arguments + " -o " + folder / "out");
        const std::string text = run.out + run.error;
        EXPECT_EQ(run.code, 2) << arguments;
        EXPECT_NE(text.find(std::string(option).substr(0, std::string(option).find_first_of(" ="))), std::string::npos)
            << arguments << ": " << text;
        EXPECT_FALSE(std::filesystem::exists(folder / "out")) << arguments;
    }
}

// "One line", whatever it quotes: option parsing has the form of all bad input, and names may hold line breaks.
TEST(Commands, BadInputIsOneLine) {
    const test::TemporaryFolder folder;
    for (const std::string& arguments :
         {"classify " + figure2 + " --level 99 -o " + folder / "out", "classify " + figure2,
          "classify " + figure2 + " --bogus -o " + folder / "out", std::string("bogus"), std::string(),
          "formfactors " + figure2 + " --evaluations 0 -o " + folder / "out", "render " + figure2 + " --edge",
          "render " + figure2 + " --edge=-1 -o " + folder / "out",
          "classify " + figure2 + " --mode \"$(printf 'a\\nb')\" -o " + folder / "out",
          "golden " + figure2 + " --seed " + std::string(5000, 'x') + " -o " + folder / "out",
          "info \"" + folder / "$(printf 'no\\nsuch\\033[1mfile')" + "\"", "answer " + folder / "none" + " -o out"}) {
        const auto run = run_program(arguments);
        EXPECT_EQ(run.code, 2) << arguments;
        EXPECT_EQ(run.out, "") << arguments;
        EXPECT_EQ(run.error.rfind("cob: ", 0), 0u) << arguments << ": " << run.error;
        EXPECT_EQ(std::count(run.error.begin(), run.error.end(), '\n'), 1) << arguments << ": " << run.error;
        EXPECT_EQ(run.error.find('\033'), std::string::npos) << arguments;
        EXPECT_NE(run.error.find(": ", 5), std::string::npos) << arguments << " has no remedy: " << run.error;
        EXPECT_LT(run.error.size(), 500u) << arguments;
    }
}

// "an unlit scene" and the like are found after the folder is there.
TEST(Commands, FailedWorkLeavesNoFolder) {
    const test::TemporaryFolder folder;
    write_file(folder / "dark.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const std::string out = " -o " + folder / "out/in";
    for (const std::string& arguments :
         {"study " + folder / "missing.obj", "study " + folder / "dark.obj --picture-shots 0",
          "study --claims --data " + folder / "missing", "bench " + folder / "missing", "render " + folder / "dark.obj",
          "render " + figure2 + " --line 100 100 0 101 100 0",
          "golden " + figure2 + " --merge " + folder / "missing"}) {
        const auto run = run_program(arguments + out);
        EXPECT_EQ(run.code, 2) << arguments << ": " << run.error;
        EXPECT_FALSE(std::filesystem::exists(folder / "out")) << arguments;
    }
}

// Paths are bytes, JSON is UTF-8.
TEST(Commands, PathsInAnyEncoding) {
    const test::TemporaryFolder folder;
    const std::string place = folder / "caf\xe9";
    create_folder(place);
    for (const char* ending : {".obj", ".mtl"})
        std::filesystem::copy(COB_DATA "/figure2" + std::string(ending), place + "/figure2" + ending);
    const std::string scene = place + "/figure2.obj", out = folder / "out";
    for (const std::string& arguments :
         {"classify " + scene + " -o " + out,
          "render " + scene + " --shots 1 --width 16 --picture-height 16 --antialias 1 -o " + out}) {
        const auto run = run_program(arguments);
        ASSERT_EQ(run.code, 0) << arguments << ": " << run.error;
        const std::string text = read_file(out + "/summary.json");
        EXPECT_TRUE(nlohmann::json::accept(text));
        EXPECT_NE(text.find("caf\xef\xbf\xbd/figure2.obj"), std::string::npos);
    }
}

// "they are listed": by every command that takes --skip-invalid, and without it the scene is refused.
TEST(Commands, SkippedPolygonsAreListed) {
    const test::TemporaryFolder folder;
    for (const char* ending : {".obj", ".mtl"})
        std::filesystem::copy(COB_DATA "/figure2" + std::string(ending), folder / ("figure2" + std::string(ending)));
    const std::string scene = folder / "figure2.obj";
    const std::size_t valid = read_obj(scene, ReadOptions{}).polygons().size();
    write_file(scene, read_file(scene) + "f 1 2 1\n");
    const std::string expected = "cob: skipped polygon " + std::to_string(valid) + " (" + scene;
    const std::string out = " -o " + folder / "out";
    for (const std::string& arguments :
         {"classify " + scene + out, "occlude " + scene + " 0 0 1 0 0 2", "stress --quick --scene " + scene + out,
          "render " + scene + " --shots 1 --width 16 --picture-height 16 --antialias 1" + out,
          "study " + scene + " --budgets 1 --points 10 --repeats 1 --picture-shots 0" + out}) {
        EXPECT_EQ(run_program(arguments).code, 2) << arguments;
        const auto run = run_program(arguments + " --skip-invalid");
        EXPECT_EQ(run.code, 0) << arguments << ": " << run.error;
        EXPECT_EQ(run.error.compare(0, expected.size(), expected), 0) << arguments << ": " << run.error;
    }
}

// A folder that can be created only in part is not created at all.
TEST(Commands, FoldersAreCreatedWholly) {
    const test::TemporaryFolder folder;
    EXPECT_EQ(run_program("classify " + figure2 + " -o " + folder / "a/b/" + std::string(300, 'c')).code, 2);
    EXPECT_FALSE(exists(folder / "a"));
}

// A number may begin with its point, behind a minus, too.
TEST(Commands, NegativeNumbersAreNoOptions) {
    const auto occlude = [](const std::string& x) {
        return run_program("occlude " + figure2 + " " + x + " 1 1 1 1 -2");
    };
    const auto with_zero = occlude("-0.5"), without = occlude("-.5");
    EXPECT_EQ(with_zero.code, 0) << with_zero.error;
    EXPECT_EQ(without.code, 0) << without.error;
    EXPECT_EQ(without.out, with_zero.out);
}

// "A missing one is a warning, everything grey": from every command that reads a scene.
TEST(Commands, WarningsAreTold) {
    const test::TemporaryFolder folder;
    write_file(folder / "scene.obj", "mtllib gone.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 2\n");
    write_file(folder / "segments.csv", "segment,x0,y0,z0,x1,y1,z1,from,to\n0,0,0,1,0,0,2,-1,-1\n");
    const std::string path = folder / "scene.obj";
    for (const std::string& command :
         {"classify " + path, "golden " + path, "answer " + folder.path(), "occlude " + path + " 0 0 1 0 0 2"}) {
        const std::string output = command[0] == 'o' ? "" : " -o " + folder / "out" + command[0];
        const auto run = run_program(command + " --skip-invalid" + output);
        EXPECT_EQ(run.code, 0) << command << run.error;
        EXPECT_NE(run.error.find("warning: "), std::string::npos) << command;
        EXPECT_NE(run.error.find("skipped polygon 1 "), std::string::npos) << command;
    }
}

// "`-o` folders are created": of a table, too.
TEST(Commands, FoldersOfTablesAreCreated) {
    const test::TemporaryFolder folder;
    EXPECT_EQ(run_program("formfactors " + figure2 + " -o " + folder / "new/F.csv").code, 0);
    EXPECT_EQ(test::files_in(folder / "new"), std::set<std::string>{"F.csv"});
}

// A quota is a full disk: one line, no part of a file, and no end by a signal.
TEST(Commands, FilesThatMayNotGrow) {
    const test::TemporaryFolder folder;
    write_file(folder / "points.csv", "point,x,y,z,nx,ny,nz\n0,0,0,0,0,0,1\n");
    const std::string out = " -o " + folder / "out";
    for (const std::string& arguments :
         {"classify " + figure2 + out, "golden " + figure2 + out, "formfactors " + figure2 + out,
          "irradiance " + figure2 + " " + folder / "points.csv" + out, "info " + figure2 + " --json " + folder / "info",
          "render " + figure2 + " --shots 1 --width 16 --picture-height 16 --antialias 1" + out}) {
        // Through a pipe: what it prints must not meet the quota, too.
        const auto run =
            test::run_shell("{ ulimit -f 0; " COB_PROGRAM " " + arguments + " 2>&1; echo code $?; } | cat");
        EXPECT_NE(run.out.find("code 2"), std::string::npos) << arguments << run.out;
        EXPECT_NE(run.out.find("cannot write 'File too large'"), std::string::npos) << arguments << run.out;
        EXPECT_EQ(test::files_in(folder.path()), std::set<std::string>{"points.csv"}) << arguments;
    }
}

// What a command reads it does not write over.
TEST(Commands, InputsAreNotOverwritten) {
    const test::TemporaryFolder folder;
    for (const char* ending : {".obj", ".mtl"})
        std::filesystem::copy(COB_DATA "/figure2" + std::string(ending), folder / ("figure2" + std::string(ending)));
    std::filesystem::copy(COB_DATA "/figure2.obj", folder / "scene.obj");
    std::filesystem::copy(COB_DATA "/figure2.obj", folder / "scene.csv");
    write_file(folder / "points.csv", "point,x,y,z,nx,ny,nz\n0,0,0,0,0,0,1\n");
    std::filesystem::create_symlink("points.csv", folder / "link.csv");
    const auto before = test::bytes_of(folder.path());
    const std::string scene = folder / "scene.obj", points = folder / "points.csv";
    for (const std::string& arguments :
         {"info " + scene + " --json " + folder / "../" + std::filesystem::path(folder.path()).filename().string() +
              "/scene.obj",
          "golden " + scene + " -o " + folder.path(), "irradiance " + scene + " " + points + " -o " + points,
          "irradiance " + scene + " " + points + " -o " + folder / "link.csv",
          "formfactors " + folder / "scene.csv" + " -o " + folder / "scene.csv"}) {
        const auto run = run_program(arguments);
        EXPECT_EQ(run.code, 2) << arguments;
        EXPECT_NE(run.error.find("would overwrite an input"), std::string::npos) << arguments << run.error;
        EXPECT_EQ(test::bytes_of(folder.path()), before) << arguments;
    }
}

// The picture that stands beside is the one there was, also where this run replaces it.
TEST(Commands, ThePictureBesideIsReadFirst) {
    const test::TemporaryFolder folder;
    const auto render = [&](const std::string& options) {
        const auto run =
            run_program("render " + figure2 + " --shots 1 --width 16 --picture-height 16 --antialias 1 " + options);
        ASSERT_EQ(run.code, 0) << run.error;
    };
    render("--exposure 9 -o " + folder / "a");
    std::filesystem::copy(folder / "a/picture.png", folder / "before.png");
    render("--beside " + folder / "before.png" + " -o " + folder / "b");
    render("--beside " + folder / "a/picture.png" + " -o " + folder / "a");
    EXPECT_NE(read_file(folder / "before.png"), read_file(folder / "b/picture.png"));
    EXPECT_EQ(read_file(folder / "a/beside.png"), read_file(folder / "b/beside.png"));
    write_file(folder / "no.png", "no picture");
    EXPECT_EQ(run_program("render " + figure2 + " --beside " + folder / "no.png" + " -o " + folder / "c").code, 2);
    EXPECT_FALSE(exists(folder / "c"));
}

// The mark that spreadsheets put before UTF-8.
TEST(Commands, TablesMayBeginWithAByteOrderMark) {
    const test::TemporaryFolder folder;
    const std::string set = COB_DATA "/golden/side", mark = "\xef\xbb\xbf";
    write_file(folder / "points.csv", mark + "point,x,y,z,nx,ny,nz\r\n0,0,0,0,0,0,1\r\n");
    EXPECT_EQ(run_program("irradiance " + figure2 + " " + folder / "points.csv" + " -o " + folder / "out").code, 0);
    write_file(folder / "relations.csv", mark + read_file(set + "/relations.csv"));
    EXPECT_EQ(run_program("verify " + set + " " + folder.path()).code, 0);
    write_file(folder / "relations.csv", "box,\x1b[31m" + std::string(1, '\0') + ",close\n");
    const auto run = run_program("verify " + set + " " + folder.path());
    EXPECT_EQ(run.code, 2);
    EXPECT_NE(run.error.find("'box,?[31m?,close': expected box,polygon,relation"), std::string::npos) << run.error;
}

// A table, a sheet over it and a lamp, 10^decimal wide: beyond binary32, which is told or answered and ends nothing.
TEST(Commands, ScenesBeyondBinary32) {
    for (const std::string decimal : {"e-110", "e155", "e300"}) {
        const test::TemporaryFolder folder;
        std::string text = "mtllib scene.mtl\n";
        for (const char* corner : {"0 0 0", "1 0 0", "1 1 0", "0 1 0", ".4 .4 .1", ".7 .4 .1", ".7 .8 .1", ".4 .8 .1",
                                   "0 0 2", "0 1 2", "1 1 2", "1 0 2"}) {
            std::string number;
            text += "v";
            for (std::istringstream numbers(corner); numbers >> number;) text += " " + number + decimal;
            text += "\n";
        }
        write_file(folder / "scene.obj", text + "f 1 2 3 4\nf 5 6 7 8\nusemtl lamp\nf 9 10 11 12\n");
        write_file(folder / "scene.mtl", "newmtl lamp\nKe 1 1 1\n");
        const std::string set = folder / "set", out = folder / "out", golden = "golden " + folder / "scene.obj";

        const auto narrow = run_program(golden + " --float --segments 20 -o " + set);
        EXPECT_EQ(narrow.code, 2) << decimal << narrow.error;
        EXPECT_NE(narrow.error.find("for exact binary32 numbers"), std::string::npos) << narrow.error;
        EXPECT_FALSE(exists(set)) << decimal;

        ASSERT_EQ(run_program(golden + " --segments 20 --hard 10 -o " + set).code, 0) << decimal;
        for (const std::string arithmetic : {"float", "double"}) {
            ASSERT_EQ(run_program("answer " + set + " --arithmetic " + arithmetic + " -o " + out).code, 0) << decimal;
            const auto verified = run_program("verify " + set + " " + out + " --junit " + folder / "report.xml");
            EXPECT_LE(verified.code, 1) << decimal << verified.error;
            EXPECT_EQ((verified.out + read_file(folder / "report.xml")).find("inf ulps"), std::string::npos) << decimal;
        }
        // Where the program is built without Embree, that is told.
        const auto embree = run_program("answer " + set + " --arithmetic embree -o " + folder / "embree");
        EXPECT_TRUE(embree.code == 0 || embree.error.find("without Embree") != std::string::npos) << embree.error;
        EXPECT_EQ(run_program("bench " + set + " --most 2 --repetitions 1 -o " + folder / "bench").code, 0) << decimal;
    }
}

}  // namespace
}  // namespace cob
