/// The command `cob render` as its users run it.
#include "cob/files.hpp"
#include "report/image.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include <sys/wait.h>
#include <unistd.h>

namespace {

namespace fs = std::filesystem;

class Render : public testing::Test {
protected:
    Render() : folder_(fs::temp_directory_path() / ("cob-render-" + std::to_string(::getpid()))) {
        fs::remove_all(folder_);
        fs::create_directories(folder_);
    }
    ~Render() override { fs::remove_all(folder_); }

    /// Exit code of `cob render arguments`.
    int run(const std::string& arguments) const {
        const int status =
            std::system((std::string(COB_PROGRAM) + " render " + arguments + " >" + path("log") + " 2>&1").c_str());
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }
    std::string path(const std::string& name) const { return (folder_ / name).string(); }
    std::string text(const std::string& name) const { return cob::read_file(path(name)); }

    fs::path folder_;
};

const std::string figure2 = std::string(COB_DATA) + "/figure2.obj";
const std::string small = " --width 64 --picture-height 48 --antialias 1 --shots 6";

TEST_F(Render, WritesEveryFile) {
    ASSERT_EQ(run(figure2 + small + " -o " + path("a")), 0) << text("log");
    for (const char* name : {"picture.png", "mesh.png", "states.png"}) {
        const cob::report::Image image = cob::report::decode_png(path(std::string("a/") + name));
        EXPECT_EQ(image.width, 64);
        EXPECT_EQ(image.height, 48);
    }
    EXPECT_EQ(text("a/mesh.ply").substr(0, 4), "ply\n");
    EXPECT_NE(text("a/mesh.vtp").find("</VTKFile>"), std::string::npos);
    EXPECT_NE(text("a/exitance.csv").find("\n0,"), std::string::npos);
    EXPECT_NE(text("a/summary.json").find("\"bookkeeping\""), std::string::npos);
    EXPECT_EQ(text("a/summary.txt"), text("log"));
}

TEST_F(Render, AResumedRunGivesTheSameBytes) {
    ASSERT_EQ(run(figure2 + small + " -o " + path("a")), 0) << text("log");
    const std::string checkpoint = " --checkpoint " + path("state");
    ASSERT_EQ(run(figure2 + " --width 64 --picture-height 48 --antialias 1 --shots 2 -o " + path("b") + checkpoint), 0);
    EXPECT_NE(text("b/exitance.csv"), text("a/exitance.csv"));
    ASSERT_EQ(run(figure2 + small + " --threads 1 -o " + path("c") + checkpoint), 0) << text("log");
    for (const char* name : {"exitance.csv", "picture.png", "mesh.ply", "mesh.vtp", "states.png"})
        EXPECT_EQ(text(std::string("c/") + name), text(std::string("a/") + name)) << name;
}

TEST_F(Render, RefusesWithCodeTwoAndALine) {
    cob::write_file(path("dark.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    EXPECT_EQ(run(path("dark.obj") + " -o " + path("d")), 2);
    EXPECT_NE(text("log").find("no light"), std::string::npos);
    EXPECT_EQ(run(figure2 + " -o " + path("d") + " --margin -1"), 2);
    EXPECT_EQ(run(figure2 + " -o " + path("d") + " --position 0 0 0 --target 0 0 0"), 2);
    EXPECT_EQ(run(path("missing.obj") + " -o " + path("d")), 2);
    EXPECT_FALSE(fs::exists(path("d/picture.png")));
}

}  // namespace
