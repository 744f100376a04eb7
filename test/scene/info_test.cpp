// The command `cob info`: exit codes, and that what it prints and writes agrees with the scene.
#include "program.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <string>

namespace {

/// Both streams as one.
cob::test::ProgramResult run(const std::string& arguments) {
    cob::test::ProgramResult result = cob::test::run_program(arguments);
    result.out += result.error;
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
    const auto result = run("info " + path + " --json " + json_path);
    EXPECT_EQ(result.code, 0) << result.out;
    EXPECT_TRUE(contains(result.out, "4, 2 valid, 2 invalid")) << result.out;
    EXPECT_TRUE(contains(result.out, "polygon 1, line 7: zero area")) << result.out;
    EXPECT_TRUE(contains(result.out, "polygon 3, line 9: fewer than 3 distinct vertices")) << result.out;
    EXPECT_TRUE(contains(result.out, "other commands refuse this scene")) << result.out;
    EXPECT_TRUE(contains(result.out, "foo, 1 time")) << result.out;

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
    const auto result = run("info " + path);
    EXPECT_EQ(result.code, 2);
    EXPECT_TRUE(contains(result.out, path + ":1: not a finite number 'zero'")) << result.out;
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
