// SPEC section 7: the tables, "rows ascending by their ids, lines end in LF; numbers are in shortest round-trip
// decimal, and where one is no binary64 number, as a fraction p/q in lowest terms".
#include "cob/tables.hpp"

#include "cob/error.hpp"
#include "cob/files.hpp"
#include "golden/exact_text.hpp"
#include "tables.hpp"
#include "temporary_folder.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <random>

namespace cob {
namespace {

using test::read_all;

/// What is written is read and written again to the same bytes, and the bytes are these.
template <class Row>
void expect_text(const std::string& text) {
    const test::TemporaryFolder folder;
    const std::string first = folder / "first.csv", second = folder / "second.csv";
    write_file(first, text);
    TableWriter<Row> writer(second);
    for (const Row& row : read_all<Row>(first)) writer.write(row);
    writer.commit();
    EXPECT_EQ(read_file(second), text);
}

const std::string boxes_header = "box,polygon,x0,y0,z0,x1,y1,z1,x2,y2,z2,x3,y3,z3,ux,uy,uz,margin,height\n";

TEST(Tables, EveryTableReadsBackToTheSameBytes) {
    expect_text<BoxRow>(
        boxes_header +
        "0,-1,0,0,0,1,0,0,0,1,0,,,,1,0,0,0.125,0.25\n"
        "7,3,0,0,0,1/3,0,0,1/3,1e-300,0,0,1e-300,0,2/3,0,0,0,1/7\n"
        "8,3,0,0,0,1/3,0,0,1/3,1e-300,0,0,1e-300,0,2/3,0,0,0,1/7\n"
        "9223372036854775807,2147483647,0,0,0,1e+300,0,0,0,5e-324,0,,,,1,0,0,1000,9007199254740993/1\n");
    expect_text<SegmentRow>("segment,x0,y0,z0,x1,y1,z1,from,to\n1,0,0,0,1,1,1/3,-1,4\n");
    expect_text<TriangleRow>("triangle,polygon,x0,y0,z0,x1,y1,z1,x2,y2,z2\n0,0,0,0,0,1,0,0,0.1,1,-2.5\n");
    expect_text<PointRow>("point,x,y,z,nx,ny,nz\n0,1/3,0,0,0,0,1\n");
    expect_text<TagRow>("question,id,kind,band\nbox,4,lattice,52\nsegment,0,seam-corner,0\n");
    expect_text<StateRow>("box,state,close,cover,light\n0,empty,,,\n1,close,2 5 9,,5\n2,occluded,,4 7,\n");
    expect_text<RelationRow>(
        "box,polygon,relation,covers,shared\n0,0,base,0,none\n0,3,crossing,1,vertex\n"
        "1,1,boundary,0,edge\n1,2,coplanar,0,none\n");
    expect_text<VisibilityRow>("segment,visibility\n0,clear\n1,blocked\n5,grazing\n");
    expect_text<IrradianceRow>("point,light,unobstructed,visible,r,g,b\n0,0,0.5,0.25,1,2,3\n0,4,0,0,0,0,0\n");
    expect_text<FormFactorRow>("from,to,form_factor,error\n0,1,0.5,1e-09\n1,0,0.25,0\n");
}

TEST(Tables, SegmentsMayLackFromAndTo) {
    const test::TemporaryFolder folder;
    write_file(folder / "segments.csv", "segment,x0,y0,z0,x1,y1,z1\n3,0,0,0,1,1,1\n");
    const auto rows = read_all<SegmentRow>(folder / "segments.csv");
    ASSERT_EQ(rows.size(), 1u);
    EXPECT_EQ(rows[0].segment, 3);
    EXPECT_EQ(rows[0].from_polygon, no_polygon);
    EXPECT_EQ(rows[0].line, 2u);
}

TEST(Tables, LinesMayEndInCrLf) {
    const test::TemporaryFolder folder;
    write_file(folder / "table.csv", "segment,visibility\r\n0,clear\r\n1,blocked\r\n");
    const auto rows = read_all<VisibilityRow>(folder / "table.csv");
    ASSERT_EQ(rows.size(), 2u);
    EXPECT_EQ(rows[1].visibility, Visibility::blocked);
}

TEST(Tables, NumbersAreWhatSection1Says) {
    const test::TemporaryFolder folder;
    write_file(folder / "boxes.csv", boxes_header +
                                         "0,-1,0.1,0x1.8p1,-0,2/4,36028797018963969/36028797018963968,1e-400,"
                                         "+1,1e22,.5,,,,3/9,0,0,0.1,2/8\n");
    const BoxRow row = read_all<BoxRow>(folder / "boxes.csv").at(0);
    const auto& points = row.question.corners.points;
    EXPECT_EQ(row.question.corners.count, 3);
    EXPECT_TRUE(points[0].is_binary64());
    EXPECT_EQ(points[0].nearest(), (Point{0.1, 3, 0}));
    EXPECT_FALSE(points[1].is_binary64());  // 1 + 2^-55
    EXPECT_EQ(points[1].rational(), (RationalPoint{Rational(1, 2), 1 + Rational(1, 36028797018963968), 0}));
    EXPECT_EQ(points[2].rational(), (RationalPoint{1, Rational(1e22), Rational(1, 2)}));
    EXPECT_EQ(row.question.u.rational().x, Rational(1, 3));
    EXPECT_EQ(row.question.margin, Rational(0.1));
    EXPECT_EQ(row.question.height, Rational(1, 4));
}

// The fast paths of exact_text.cpp against GMP: sums of three doubles at any distance and of any size.
TEST(ExactText, FastPathsAgreeWithFractions) {
    std::mt19937_64 engine(7);
    int pairs = 0, fractions = 0, plain = 0;
    for (int k = 0; k < 20000; ++k) {
        const int shift = static_cast<int>(engine() % 180), power = static_cast<int>(engine() % 300) - 220;
        const auto mantissa = static_cast<double>(static_cast<std::int64_t>(engine()) >> (engine() % 63));
        const auto tail = static_cast<double>(static_cast<std::int64_t>(engine()) >> (engine() % 63));
        const Rational value = Rational(std::ldexp(mantissa, power)) + Rational(std::ldexp(tail, power - shift)) +
                               (k % 3 == 0 ? Rational(std::ldexp(3.0, power - 2 * shift)) : Rational(0));
        const std::string expected = to_text(value);

        const auto parsed = parse_exact_number(expected);
        ASSERT_TRUE(parsed) << expected;
        const ExactPoint whole(RationalPoint{value, 0, 0});
        const ExactPoint point = to_point({*parsed, ExactNumber{}, ExactNumber{}});
        ASSERT_EQ(point.rational().x, value) << expected;
        ASSERT_EQ(point.has_fraction(), whole.has_fraction()) << expected;
        ASSERT_EQ(point.nearest().x, whole.nearest().x) << expected;
        ASSERT_EQ(point.rest().x, whole.rest().x) << expected;

        std::string written;
        append_point(written, point);
        ASSERT_EQ(written, expected + ",0,0");
        (point.has_fraction() ? fractions : point.is_binary64() ? plain : pairs)++;
    }
    EXPECT_GT(pairs, 1000);
    EXPECT_GT(fractions, 1000);
    EXPECT_GT(plain, 1000);
}

TEST(ExactText, NumbersAreAsParseBinary64) {
    std::mt19937_64 engine(8);
    for (int k = 0; k < 20000; ++k) {
        const std::uint64_t bits = engine();
        double value;
        std::memcpy(&value, &bits, sizeof value);
        if (!std::isfinite(value)) continue;
        std::string text;
        append_number(text, value);
        ASSERT_EQ(text, to_text(value));
        ASSERT_EQ(parse_number(text), value);
    }
    for (const char* text : {"", "nan", "inf", "-inf", "1e999", "1 ", " 1", "1,", "--1", "0x", "infinity"})
        EXPECT_EQ(parse_number(text), std::nullopt) << text;
}

// Each row: a broken table, the line that the message must name and a word of it.
TEST(Tables, BrokenTablesAreRefusedWithTheirLine) {
    struct Row {
        const char* text;
        std::size_t line;
        const char* words;
    };
    const Row rows[] = {
        {"", 1, "wrong header"},
        {"box,state,close,cover\n", 1, "wrong header"},
        {"box,state,close,cover,light", 1, "does not end"},
        {" box,state,close,cover,light\n", 1, "wrong header"},
        {"box,state,close,cover,light\n0,empty,,,\n1,emp", 3, "does not end"},
        {"box,state,close,cover,light\n0,empty,,\n", 2, "4 columns instead of 5"},
        {"box,state,close,cover,light\n0,empty,,,,\n", 2, "6 columns instead of 5"},
        {"box,state,close,cover,light\n\n", 2, "column box"},
        {"box,state,close,cover,light\n0,empty,,,\n0,empty,,,\n", 3, "doubled id '0'"},
        {"box,state,close,cover,light\n5,empty,,,\n3,empty,,,\n", 3, "ids do not ascend '3'"},
        {"box,state,close,cover,light\n-1,empty,,,\n", 2, "column box"},
        {"box,state,close,cover,light\n1.0,empty,,,\n", 2, "column box"},
        {"box,state,close,cover,light\n9223372036854775808,empty,,,\n", 2, "column box"},
        {"box,state,close,cover,light\n0,uninitialised,,,\n", 2, "column state"},
        {"box,state,close,cover,light\n0,Empty,,,\n", 2, "column state"},
        {"box,state,close,cover,light\n0,close,2 1,,\n", 2, "column close"},
        {"box,state,close,cover,light\n0,close,2 2,,\n", 2, "column close"},
        {"box,state,close,cover,light\n0,close,2  3,,\n", 2, "column close"},
        {"box,state,close,cover,light\n0,close,2 ,,\n", 2, "column close"},
        {"box,state,close,cover,light\n0,close,,-1,\n", 2, "column cover"},
        {"box,state,close,cover,light\n0,close,,,x\n", 2, "column light"},
    };
    for (const Row& row : rows) {
        const test::TemporaryFolder folder;
        write_file(folder / "states.csv", row.text);
        try {
            read_all<StateRow>(folder / "states.csv");
            ADD_FAILURE() << "accepted: " << row.text;
        } catch (const InputError& error) {
            EXPECT_EQ(error.where().line, row.line) << row.text << error.what();
            EXPECT_NE(std::string(error.what()).find(row.words), std::string::npos) << row.text << error.what();
            EXPECT_FALSE(error.where().remedy.empty()) << row.text;
        }
    }
}

TEST(Tables, TagsAreNamedByTheirQuestion) {
    const test::TemporaryFolder folder;
    write_file(folder / "tags.csv", "question,id,kind,band\nbox,5,seam,52\nbox,5,seam,52\n");
    try {
        read_all<TagRow>(folder / "tags.csv");
        ADD_FAILURE() << "accepted";
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("doubled id 'box 5'"), std::string::npos) << error.what();
    }
}

TEST(Tables, BrokenBoxesAreRefused) {
    for (const char* row : {
             "0,-2,0,0,0,1,0,0,0,1,0,,,,1,0,0,0.125,0.25\n",    // no such polygon id
             "0,-1,0,0,0,1,0,0,0,1,0,,,1,1,0,0,0.125,0.25\n",   // a part of a fourth corner
             "0,-1,0,0,0,1,0,0,0,1,0,1,,,1,0,0,0.125,0.25\n",   // a part of a fourth corner
             "0,-1,0,0,0,1,0,0,nan,1,0,,,,1,0,0,0.125,0.25\n",  // no number
             "0,-1,0,0,0,1,0,0,1/0,1,0,,,,1,0,0,0.125,0.25\n",  // no number
             "0,-1,0,0,0,1,0,0,0,1,0,,,,1,0,0,0.125,\n",        // nothing
             "0,-1,0,0,0,1,0,0,0,1,0,,,,1,0,0,0.125\n",         // a column less
             "0,-1,0,0,0,1,0,0,0,1,0,,,,1,0,0,0.125,0.25,1\n",  // a column more
         }) {
        const test::TemporaryFolder folder;
        write_file(folder / "boxes.csv", boxes_header + row);
        EXPECT_THROW(read_all<BoxRow>(folder / "boxes.csv"), InputError) << row;
    }
    EXPECT_THROW(TableReader<BoxRow>("/nonexistent/boxes.csv"), InputError);
    EXPECT_THROW(TableReader<BoxRow>("/tmp"), InputError);
}

TEST(Tables, AnswersUnderTestMayBeOutOfOrder) {
    const test::TemporaryFolder folder;
    write_file(folder / "visibility.csv", "segment,visibility\n4,clear\n2,clear\n2,blocked\n");
    TableReadOptions options;
    options.ordered = false;
    TableReader<VisibilityRow> reader(folder / "visibility.csv", options);
    VisibilityRow row;
    int count = 0;
    while (reader.next(row)) ++count;
    EXPECT_EQ(count, 3);
}

TEST(Tables, UndecidedIsAWordOfAnswersUnderTestOnly) {
    const test::TemporaryFolder folder;
    const std::string path = folder / "visibility.csv";
    TableWriter<VisibilityRow> writer(path);
    VisibilityRow row;
    row.decided = false;
    writer.write(row);
    writer.commit();
    EXPECT_EQ(read_file(path), "segment,visibility\n0,undecided\n");
    EXPECT_THROW(read_all<VisibilityRow>(path), InputError);
    TableReadOptions options;
    options.undecided = true;
    TableReader<VisibilityRow> reader(path, options);
    row.decided = true;
    ASSERT_TRUE(reader.next(row));
    EXPECT_FALSE(row.decided);
}

// Lines longer than a block, and many of them: the reader's buffer moves and grows.
TEST(Tables, LongListsAndManyRows) {
    const test::TemporaryFolder folder;
    std::vector<StateRow> rows(40);
    {
        TableWriter<StateRow> writer(folder / "states.csv");
        for (std::size_t k = 0; k < rows.size(); ++k) {
            rows[k].box = static_cast<RowId>(k);
            rows[k].state = BufferState::close;
            for (PolygonId id = 0; id < (k % 10 == 3 ? 300000 : 1000); ++id) rows[k].close.push_back(3 * id);
            writer.write(rows[k]);
        }
        EXPECT_FALSE(std::filesystem::exists(folder / "states.csv"));
        writer.commit();
        EXPECT_EQ(writer.rows(), rows.size());
    }
    const auto again = read_all<StateRow>(folder / "states.csv");
    ASSERT_EQ(again.size(), rows.size());
    for (std::size_t k = 0; k < rows.size(); ++k) EXPECT_EQ(again[k].close, rows[k].close);
}

TEST(Tables, ThreadsMayMakeTheLines) {
    const test::TemporaryFolder folder;
    std::string lines;
    append_row(lines, VisibilityRow{1, Visibility::grazing, true});
    append_row(lines, VisibilityRow{2, Visibility::blocked, true});
    TableWriter<VisibilityRow> writer(folder / "visibility.csv");
    writer.write({0, Visibility::clear, true});
    writer.write_lines(lines);
    writer.write({3, Visibility::clear, true});
    writer.commit();
    EXPECT_EQ(writer.rows(), 4u);
    EXPECT_EQ(read_file(folder / "visibility.csv"), "segment,visibility\n0,clear\n1,grazing\n2,blocked\n3,clear\n");
}

// Named cases of ExactText: what went wrong once.
TEST(ExactText, NamedCases) {
    std::string text;
    append_point(text, ExactPoint(RationalPoint{Rational(9007199254740993), -Rational(9007199254740993), 0}));
    EXPECT_EQ(text, "9007199254740993/1,-9007199254740993/1,0");
}

}  // namespace
}  // namespace cob
