// The command `cob info`: exit codes, and that what it prints and writes agrees with the scene.
#include "temporary_folder.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <nlohmann/json.hpp>

#include <cstdio>
#include <fstream>
#include <string>

namespace {

struct Outcome {
    int code = -1;
    std::string output;  ///< Both streams.
};

Outcome run(const std::string& arguments) {
    Outcome result;
    std::FILE* pipe = ::popen((std::string(COB_PROGRAM) + " " + arguments + " 2>&1").c_str(), "r");
    if (!pipe) return result;
    char block[4096];
    for (std::size_t n; (n = std::fread(block, 1, sizeof block, pipe)) > 0;) result.output.append(block, n);
    const int status = ::pclose(pipe);
    result.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    return result;
}

std::string temporary(const cob::test::TemporaryFolder& folder, const std::string& name, const std::string& text) {
    std::ofstream(folder / name) << text;
    return folder / name;
}

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

// "`--skip-invalid` lists such polygons": info lists them in any case, by number, line and reason.
TEST(Info, NamesInvalidPolygons) {
    const cob::test::TemporaryFolder folder;
    const std::string path = temporary(folder, "invalid.obj",
                                       "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nv 2 2 1\n"
                                       "f 1 2 3 4\nf 1 2 4 3\nf 1 2 3 5 4\nf 1 2\nfoo bar\n");
    const std::string json_path = path + ".json";
    const Outcome result = run("info " + path + " --json " + json_path);
    EXPECT_EQ(result.code, 0) << result.output;
    EXPECT_TRUE(contains(result.output, "4, 2 valid, 2 invalid")) << result.output;
    EXPECT_TRUE(contains(result.output, "polygon 1, line 7: zero area")) << result.output;
    EXPECT_TRUE(contains(result.output, "polygon 3, line 9: fewer than 3 distinct vertices")) << result.output;
    EXPECT_TRUE(contains(result.output, "other commands refuse this scene")) << result.output;
    EXPECT_TRUE(contains(result.output, "foo, 1 time")) << result.output;

    const auto json = nlohmann::json::parse(std::ifstream(json_path));
    EXPECT_EQ(json["polygons"], 4);
    EXPECT_EQ(json["valid"], 2);
    EXPECT_EQ(json["invalid"][1]["line"], 9);
    EXPECT_EQ(json["not_planar"], nlohmann::json::parse(R"([{"polygon": 2, "line": 8}])"));
    EXPECT_EQ(json["shared_edges"], 3);
    EXPECT_EQ(json["coplanar_overlaps"][0]["same_facing"], true);
    EXPECT_EQ(json["bounding_box"]["high"], nlohmann::json({2.0, 2.0, 1.0}));
}

TEST(Info, EndsWithTwoOnBadInput) {
    EXPECT_EQ(run("info /nowhere/scene.obj").code, 2);
    EXPECT_EQ(run("info").code, 2);
    const cob::test::TemporaryFolder folder;
    const std::string path = temporary(folder, "bad.obj", "v 0 0 zero\n");
    const Outcome result = run("info " + path);
    EXPECT_EQ(result.code, 2);
    EXPECT_TRUE(contains(result.output, path + ":1: not a finite number 'zero'")) << result.output;
    const std::string good = temporary(folder, "good.obj", "v 0 0 0\n");
    EXPECT_EQ(run("info " + good).code, 0);
    EXPECT_EQ(run("info " + good + " --json /nowhere/out.json").code, 2);
}

// The measured Cornell box: "mind that its red wall is not planar".
TEST(Info, KnowsTheCornellBox) {
    const cob::test::TemporaryFolder folder;
    const std::string json_path = folder / "cornell.json";
    ASSERT_EQ(run(std::string("info ") + COB_DATA + "/cornell.obj --json " + json_path).code, 0);
    const auto json = nlohmann::json::parse(std::ifstream(json_path));
    EXPECT_EQ(json["not_planar"].size(), 1u);
    EXPECT_EQ(json["lights"].size(), 1u);
    EXPECT_EQ(json["invalid"].size(), 0u);
    EXPECT_GE(json["coplanar_overlap_pairs"], 1);  // the lamp lies in the ceiling's plane
}

}  // namespace
