// `.view` files: "Bad input gets one clear line: file, line, value, what to do".
#include "cob/error.hpp"
#include "cob/files.hpp"
#include "report/camera.hpp"
#include "temporary_folder.hpp"

#include <gtest/gtest.h>

#include <array>

namespace cob {
namespace {

const char* const good = "position 1 2 3  # where\ntarget 0 0 0\r\n\nup 0 0 1\nfov 40\n";

TEST(View, IsReadWithCommentsAndWindowsLineEnds) {
    const test::TemporaryFolder folder;
    write_file(folder / "scene.view", good);
    const report::Camera camera = report::read_view(folder / "scene.view");
    EXPECT_EQ(camera.position, (Point{1, 2, 3}));
    EXPECT_EQ(camera.target, (Point{0, 0, 0}));
    EXPECT_EQ(camera.fov, 40);
}

TEST(View, WhatIsWrongIsToldWithFileLineAndValue) {
    const std::array<std::array<std::string, 3>, 8> cases{{
        {"eye 0 0 1\n", ":1:", "'eye'"},
        {"position 1 2\n", ":1:", "not a number"},
        {"position 1 2 nan\n", ":1:", "'nan'"},
        {"position 1 2 3 4\n", ":1:", "'4'"},
        {"position 1 2 3\ntarget 0 0 0\nfov 180\n", ":3:", "'180'"},
        {"position 1 2 3\n", "", "needs a position and a target"},
        {"position 1 2 3\ntarget 1 2 3\n", "", "'1 2 3'"},
        {"position 0 0 3\ntarget 0 0 0\n", "", "'0 0 1'"},
    }};
    for (const auto& [text, line, value] : cases) {
        const test::TemporaryFolder folder;
        write_file(folder / "scene.view", text);
        try {
            report::read_view(folder / "scene.view");
            ADD_FAILURE() << text;
        } catch (const InputError& error) {
            const std::string told = error.what();
            EXPECT_NE(told.find((folder / "scene.view") + line), std::string::npos) << told;
            EXPECT_NE(told.find(value), std::string::npos) << told;
        }
    }
}

}  // namespace
}  // namespace cob
