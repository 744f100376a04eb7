// The reader of OBJ and MTL: what it takes, what it refuses and where it says so (SPEC sections 1 and 2).
#include "cob/error.hpp"
#include "cob/files.hpp"
#include "cob/scene.hpp"
#include "temporary_folder.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace cob {
namespace {

/// A folder of its own for each test.
class ObjFile : public testing::Test {
protected:
    std::string path(const std::string& name) const { return folder_ / name; }
    void write(const std::string& name, const std::string& text) const {
        std::ofstream(path(name), std::ios::binary) << text;
    }
    Scene read(const std::string& text, const ReadOptions& options = {}) {
        write("scene.obj", text);
        report_ = {};
        return read_obj(path("scene.obj"), options, &report_);
    }

    test::TemporaryFolder folder_;
    ReadReport report_;
};

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST_F(ObjFile, TakesEveryFormOfAFace) {
    for (const char* face : {"f 1 2 3 4", "f 1/1 2/2 3/3 4/4", "f 1//1 2//2 3//3 4//4", "f 1/9/9 2/9/9 3/9/9 4/9/9",
                             "f -4 -3 -2 -1", "f -4/1 -3//-7 3 -1/2/3", "f\t1  2\t3 4 # comment", "f 1 2 \\\n3 \\\n4",
                             "  f 1 2 3 4   ", "f 1 2 3 4#comment"}) {
        const Scene scene = read(square + face);
        ASSERT_EQ(scene.polygon_count(), 1) << face;
        const auto loop = scene.loop(0);
        EXPECT_EQ(std::vector<VertexId>(loop.begin(), loop.end()), (std::vector<VertexId>{0, 1, 2, 3})) << face;
        EXPECT_EQ(scene.polygon(0).line, 5u) << face;
    }
}

// Indices count from the vertices known so far where they are negative; positive ones may come later in the file.
TEST_F(ObjFile, NegativeIndicesAreRelative) {
    const Scene scene = read("f 1 2 3\n" + square + "f -2 -3 -4\nv 5 5 5\nf -1 -5 -4\n");
    ASSERT_EQ(scene.polygon_count(), 3);
    EXPECT_EQ(scene.loop(1)[0], 2);
    EXPECT_EQ(scene.loop(2)[0], 4);
    EXPECT_EQ(scene.loop(2)[1], 0);
}

TEST_F(ObjFile, TakesEveryEndOfLine) {
    const std::string unix_text = square + "\n# comment\n\nusemtl a\nf 1 2 3\n";
    for (const std::string end : {"\n", "\r\n", "\r"}) {
        std::string text;
        for (const char c : unix_text) text += c == '\n' ? end : std::string(1, c);
        const Scene scene = read("\xEF\xBB\xBF" + text + "f 1 3 4");
        ASSERT_EQ(scene.polygon_count(), 2);
        EXPECT_EQ(scene.polygon(0).line, 9u);
        EXPECT_EQ(scene.polygon(1).line, 10u);
    }
}

// SPEC 1: "the binary64 number nearest to its text (decimal or C hex-float)".
TEST_F(ObjFile, CoordinatesAreTheNearestNumbers) {
    const Scene scene = read(
        "v 0.1 0x1.999999999999ap-4 1e-400\nv 1e308 -0 4.9e-324 1\nv +.5 5. 1E0 0.2 0.3 0.4\n"
        "v 1 2 3 0.5 1 1 1\nv 0.1000000000000000055511151231257827021181583404541015625 "
        "0.10000000000000000555111512312578270211815834045410156250000001 9007199254740993\n");
    EXPECT_EQ(scene.position(0), (Point{0.1, 0.1, 0}));
    EXPECT_EQ(scene.position(1), (Point{1e308, 0, 5e-324}));
    EXPECT_FALSE(std::signbit(scene.position(1).y));
    EXPECT_EQ(scene.position(2), (Point{0.5, 5, 1}));
    EXPECT_EQ(scene.position(3), (Point{1, 2, 3}));
    EXPECT_EQ(scene.position(4), (Point{0.1, 0.1, 9007199254740992.0}));
    EXPECT_EQ(report_.skipped["v(weight)"], 2u);
}

TEST_F(ObjFile, SkipsAndCountsWhatItDoesNotKnow) {
    const std::string binary("\x01\x02\xff\x00\x7f junk", 10);
    const Scene scene =
        read(square + "vn 0 0 1\nvt 0 0\ng a b\no x\ns off\nl 1 2\nl 2 3\ncurv 1\n" + binary + "\nf 1 2 3\n");
    EXPECT_EQ(scene.polygon_count(), 1);
    EXPECT_EQ(report_.skipped["l"], 2u);
    EXPECT_EQ(report_.skipped["curv"], 1u);
    EXPECT_EQ(report_.skipped.size(), 3u);
    EXPECT_TRUE(report_.warnings.empty());
}

// A comment ends with its line.
TEST_F(ObjFile, CommentsAreNotContinued) {
    const Scene scene = read("# from C:\\models\\\n" + square + "f 1 2 3\n");
    EXPECT_EQ(scene.positions().size(), 4u);
    EXPECT_EQ(scene.polygon_count(), 1);
}

TEST_F(ObjFile, ManyUnknownStatementsStayFew) {
    std::string text;
    for (int k = 0; k < 5000; ++k) text += "word" + std::to_string(k) + " 1\n";
    read(text);
    EXPECT_LT(report_.skipped.size(), 100u);
}

struct Refusal {
    const char* text;
    std::size_t line;
    const char* what;
};

// "Refused with file, line, value and remedy": by nothing, --skip-invalid included.
TEST_F(ObjFile, RefusesBadNumbersAndIndices) {
    const Refusal rows[] = {
        {"v 0 0\n", 1, "bad vertex '0 0'"},
        {"\nv 0 0 nan\n", 2, "not a finite number 'nan'"},
        {"v 0 0 inf\n", 1, "'inf'"},
        {"v 0 0 1e309\n", 1, "'1e309'"},
        {"v 0 0 1,5\n", 1, "'1,5'"},
        {"v 0 0 0x\n", 1, "'0x'"},
        {"v 0 0 0 0 0 nan\n", 1, "'nan'"},
        {"v 1 2 3 4 5 6 7 8 9\n", 1, "bad vertex"},
        {"v 0 0 \\\n\n1 nonsense\n", 1, "bad vertex"},
        {"f 1 2 3\n", 1, "vertex does not exist '1'"},
        {"v 0 0 0\nf 1 1 0\n", 2, "vertex does not exist '0'"},
        {"v 0 0 0\nf 1 1 -2\n", 2, "vertex does not exist '-2'"},
        {"v 0 0 0\nf 1 1 2\n", 2, "vertex does not exist '2'"},
        {"v 0 0 0\nf 1 1 99999999999999999999\n", 2, "bad corner of a face"},
        {"v 0 0 0\nf 1 1 4294967297\n", 2, "vertex does not exist"},
        {"v 0 0 0\nf 1 1 1/2/3/4\n", 2, "bad corner of a face '1/2/3/4'"},
        {"v 0 0 0\nf 1 1 1/\n", 2, "bad corner of a face '1/'"},
        {"v 0 0 0\nf 1 1 /1\n", 2, "bad corner of a face"},
        {"v 0 0 0\nf 1 1 1.5\n", 2, "bad corner of a face"},
        {"v 0 0 0\nf 1 1 one\n", 2, "bad corner of a face 'one'"},
        {"v 0 0 0\nf 1 1 +1\n", 2, "bad corner of a face"},
    };
    for (const Refusal& row : rows) {
        try {
            read(row.text, {true, false});
            ADD_FAILURE() << row.text;
        } catch (const InputError& error) {
            EXPECT_EQ(error.where().file, path("scene.obj"));
            EXPECT_EQ(error.where().line, row.line) << row.text;
            EXPECT_FALSE(error.where().remedy.empty());
            EXPECT_NE(std::string(error.what()).find(row.what), std::string::npos) << error.what();
        }
    }
}

// Refused polygons "keep their numbers and occur in no answer".
TEST_F(ObjFile, SkipsInvalidPolygonsWhenAsked) {
    const std::string text = square + "f 1 2\nf 1 2 3 4\nf 1 2 4 3\nf 1 2 1 2\nf 2 3 4\n";
    try {
        read(text);
        ADD_FAILURE();
    } catch (const InputError& error) {
        EXPECT_EQ(error.where().line, 5u);
        EXPECT_NE(error.where().remedy.find("--skip-invalid"), std::string::npos);
    }
    const Scene scene = read(text, {true, false});
    ASSERT_EQ(scene.polygon_count(), 5);
    ASSERT_EQ(scene.invalid().size(), 3u);
    EXPECT_EQ(scene.invalid()[1].polygon, 2);
    EXPECT_EQ(scene.invalid()[1].line, 7u);
    for (const PolygonId id : {0, 2, 3}) EXPECT_TRUE(scene.pieces_of(id).empty());
    for (const PolygonId id : {1, 4}) EXPECT_EQ(scene.pieces_of(id).size(), 1u);
    EXPECT_EQ(scene.pieces()[1].polygon, 4);
}

TEST_F(ObjFile, ReadsMaterialsWhereverTheLibraryStands) {
    write("two words.mtl", "newmtl grey\nKd .25\nnewmtl lamp # bright\nKd 0 .5 1\nKe 1 2 3 # W/m2\n");
    for (const char* library : {"mtllib two words.mtl", "mtllib C:\\models\\two words.mtl",
                                "mtllib /gone/two words.mtl", "mtllib missing.mtl two words.mtl other.mtl"}) {
        const Scene scene = read(square + "f 1 2 3\nusemtl lamp\nf 1 3 4\nusemtl grey\nf 1 2 4\n" + library);
        EXPECT_EQ(scene.material(0).reflectance, (std::array<double, 3>{0.5, 0.5, 0.5}));
        EXPECT_EQ(scene.material(1).reflectance, (std::array<double, 3>{0, 0.5, 1}));
        EXPECT_EQ(scene.material(1).emitted_exitance, (std::array<double, 3>{1, 2, 3}));
        EXPECT_EQ(scene.material(2).reflectance, (std::array<double, 3>{0.25, 0.25, 0.25}));
        EXPECT_FALSE(scene.is_light(0) || scene.is_light(2));
        EXPECT_TRUE(scene.is_light(1));
        EXPECT_EQ(report_.warnings.size(), std::string(library).find("missing") == std::string::npos ? 0u : 2u);
    }
}

TEST_F(ObjFile, RadianceIsExitanceOverPi) {
    write("a.mtl", "newmtl lamp\nKe 1 0 0\n");
    const Scene scene = read("mtllib a.mtl\nusemtl lamp\n" + square + "f 1 2 3\n", {false, true});
    EXPECT_DOUBLE_EQ(scene.material(0).emitted_exitance[0], 3.14159265358979323846);
}

// "a missing one is a warning, everything grey"
TEST_F(ObjFile, MissingMaterialsAreGreyAndAWarning) {
    const Scene scene =
        read("mtllib gone.mtl\n" + square + "usemtl a\nf 1 2 3\nusemtl a\nf 1 3 4\nusemtl b\nf 1 2 4\n");
    EXPECT_EQ(report_.warnings.size(), 3u);
    for (PolygonId id = 0; id < 3; ++id) {
        EXPECT_EQ(scene.material(id).reflectance, (std::array<double, 3>{0.5, 0.5, 0.5}));
        EXPECT_FALSE(scene.is_light(id));
    }
}

TEST_F(ObjFile, RefusesImpossibleMaterials) {
    const Refusal rows[] = {
        {"newmtl a\nKd 1.5 0 0\n", 2, "reflectance outside [0, 1]"},
        {"newmtl a\nKd -0.1 0 0\n", 2, "reflectance outside [0, 1]"},
        {"newmtl a\nKd nan 0 0\n", 2, "bad colour"},
        {"newmtl a\nKd 0 0\n", 2, "bad colour"},
        {"newmtl a\nKd 0 0 0 0\n", 2, "bad colour"},
        {"newmtl a\nKd\n", 2, "bad colour"},
        {"newmtl a\n\nKe -1 0 0\n", 3, "emission is negative"},
        {"newmtl a\nKe 1e999 0 0\n", 2, "bad colour"},
        {"Kd 1 1 1\n", 1, "no material"},
    };
    for (const Refusal& row : rows) {
        write("a.mtl", row.text);
        try {
            read("mtllib a.mtl\n");
            ADD_FAILURE() << row.text;
        } catch (const InputError& error) {
            EXPECT_EQ(error.where().file, path("a.mtl"));
            EXPECT_EQ(error.where().line, row.line);
            EXPECT_NE(std::string(error.what()).find(row.what), std::string::npos) << error.what();
        }
    }
}

TEST_F(ObjFile, RefusesWhatIsNoFile) {
    EXPECT_THROW(read_obj(path("gone.obj"), {}), InputError);
    EXPECT_THROW(read_obj(folder_.path(), {}), InputError);
    EXPECT_THROW(read_obj(path(std::string(300, 'x')), {}), InputError);
    std::filesystem::create_symlink("circle", path("circle"));
    EXPECT_THROW(read_obj(path("circle"), {}), InputError);
    EXPECT_THROW(create_folder(path("circle/below")), InputError);
    const Scene scene = read("mtllib . .. / /dev/zero\n");
    EXPECT_EQ(scene.polygon_count(), 0);
    EXPECT_EQ(report_.warnings.size(), 4u);
}

// Long lines, and one polygon with very many corners.
TEST_F(ObjFile, LongLinesAreOrdinary) {
    std::string text = square + "# " + std::string(10'000'000, 'x') + "\n" + std::string(10'000'000, 'y') + "\n";
    text += "v " + std::string(1'000'000, '0') + "2.5 0 0\n";
    text += "f 1 2 3 4";
    for (int k = 0; k < 200000; ++k) text += " 1";
    const Scene scene = read(text + "\nusemtl " + std::string(100000, 'z') + "\n");
    EXPECT_EQ(scene.polygon(0).corner_count, 4u);
    EXPECT_EQ(scene.position(4).x, 2.5);
}

}  // namespace
}  // namespace cob
