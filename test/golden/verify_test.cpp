// Comparing a variant's answers with a golden set: each way to disagree is made by hand and must be counted where it
// belongs, and only there.
#include "cob/verify.hpp"

#include "cob/error.hpp"
#include "cob/files.hpp"
#include "cob/golden.hpp"
#include "cob/manifest.hpp"
#include "program.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <cstdlib>

namespace cob {
namespace {

const char* const obj =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
    "v 0 0 .125\nv 1 0 .125\nv 1 1 .125\nv 0 1 .125\n"
    "f 1 2 3 4\nf 5 6 7 8\nf 1 2 6 5\n";
const char* const relations =
    "box,polygon,relation,covers,shared\n0,1,crossing,1,none\n0,2,boundary,0,edge\n1,1,coplanar,0,none\n";
const char* const states = "box,state,close,cover,light\n0,occluded,,1,\n1,empty,,,\n";
const char* const visibility = "segment,visibility\n0,clear\n1,blocked\n2,grazing\n";

/// A small set of two boxes and three segments, and a folder of answers, at first the right ones.
class Verify : public ::testing::Test {
protected:
    Verify() {
        create_folder(set());
        create_folder(answers());
        put("scene.obj", obj);
        put("boxes.csv",
            "box,polygon,x0,y0,z0,x1,y1,z1,x2,y2,z2,x3,y3,z3,ux,uy,uz,margin,height\n"
            "0,0,0,0,0,1,0,0,1,1,0,0,1,0,1,0,0,0,0.25\n"
            "1,-1,0,0,0.125,1,0,0.125,1,1/3,0.125,,,,1,0,0,0,0.25\n");
        put("segments.csv",
            "segment,x0,y0,z0,x1,y1,z1,from,to\n0,0,0,1,1,1,2,-1,-1\n1,0.5,0.5,-1,0.5,0.5,1,-1,-1\n2,-1,0,0,2,0,0,-1,-"
            "1\n");
        put("tags.csv",
            "question,id,kind,band\nbox,0,element,4\nbox,1,side,52\nsegment,0,light,3\nsegment,1,light,3\nsegment,2,"
            "edge,52\n");
        put("relations.csv", relations);
        put("states.csv", states);
        put("visibility.csv", visibility);
        Manifest manifest;
        for (const char* name :
             {"scene.obj", "boxes.csv", "segments.csv", "tags.csv", "relations.csv", "states.csv", "visibility.csv"})
            manifest.files[name] = describe_file(set() + "/" + name);
        write_manifest(set() + "/manifest.json", manifest);
        answer("relations.csv", relations);
        answer("states.csv", states);
        answer("visibility.csv", visibility);
    }

    std::string set() const { return folder_ / "set"; }
    std::string answers() const { return folder_ / "answers"; }
    void put(const std::string& name, const std::string& text) { write_file(set() + "/" + name, text); }
    void answer(const std::string& name, const std::string& text) { write_file(answers() + "/" + name, text); }
    void drop(const std::string& name) { std::filesystem::remove(answers() + "/" + name); }
    verify::Report report(const verify::Options& options = {}) { return verify_answers(set(), answers(), options); }
    int exit_code(const std::string& more = "") {
        return test::run_program("verify " + set() + " " + answers() + " " + more).code;
    }
    test::TemporaryFolder folder_;
};

const verify::Counts& counts(const verify::Report& report, const std::string& table) {
    for (const verify::TableReport& entry : report.tables)
        if (entry.table == table) return entry.total.counts;
    throw std::logic_error("no table " + table);
}

TEST_F(Verify, RightAnswersAgree) {
    const verify::Report found = report();
    EXPECT_TRUE(found.agree());
    EXPECT_EQ(counts(found, "relations").compared, 3u);
    EXPECT_EQ(counts(found, "states").compared, 2u);
    EXPECT_EQ(counts(found, "visibility").compared, 3u);
    EXPECT_EQ(exit_code(), 0);
}

TEST_F(Verify, EachWayToDisagreeIsCountedApart) {
    struct Row {
        const char *table, *text;
        std::uint64_t wrong, missing, doubled, unknown, undecided;
    };
    const std::string head = "box,polygon,relation,covers,shared\n";
    const Row rows[] = {
        {"relations", "0,1,boundary,1,none\n0,2,boundary,0,edge\n1,1,coplanar,0,none\n", 1, 0, 0, 0, 0},
        {"relations", "0,1,crossing,0,none\n0,2,boundary,0,none\n1,1,coplanar,0,none\n", 2, 0, 0, 0, 0},
        {"relations", "0,2,boundary,0,edge\n1,1,coplanar,0,none\n", 1, 0, 0, 0, 0},  // a row left out
        {"relations", "0,1,crossing,1,none\n0,2,boundary,0,edge\n1,1,coplanar,0,none\n1,2,base,0,none\n", 1, 0, 0, 0,
         0},
        {"relations", "0,1,crossing,1,none\n0,1,base,0,none\n0,2,boundary,0,edge\n1,1,coplanar,0,none\n", 0, 0, 1, 0,
         0},
        {"relations", "0,1,crossing,1,none\n0,2,boundary,0,edge\n0,3,base,0,none\n1,1,coplanar,0,none\n", 0, 0, 0, 1,
         0},
        {"relations", "0,1,crossing,1,none\n0,2,boundary,0,edge\n1,1,coplanar,0,none\n2,1,base,0,none\n", 0, 0, 0, 1,
         0},
        {"relations", "0,1,crossing,1,none\n0,2,undecided,0,edge\n1,1,coplanar,0,none\n", 0, 0, 0, 0, 1},
        {"states", "0,occluded,,1,\n", 0, 1, 0, 0, 0},
        {"states", "0,close,1 2,,\n1,empty,,,\n", 1, 0, 0, 0, 0},
        {"states", "0,occluded,,,\n1,empty,,,\n", 1, 0, 0, 0, 0},
        {"states", "0,occluded,,1,\n0,occluded,,1,\n1,empty,,,\n5,empty,,,\n", 0, 0, 1, 1, 0},
        {"visibility", "0,blocked\n1,blocked\n2,clear\n", 1, 0, 0, 0, 0},
        {"visibility", "0,clear\n1,grazing\n2,blocked\n", 1, 0, 0, 0, 0},  // grazing is free only where it is right
        {"visibility", "1,blocked\n1,blocked\n2,grazing\n7,clear\n", 0, 1, 1, 1, 0},
        {"visibility", "0,clear\n1,blocked\n2,grazing\n9223372036854775807,clear\n", 0, 0, 0, 1, 0},  // the last id
        {"visibility", "0,undecided\n1,blocked\n2,undecided\n", 0, 0, 0, 0, 2},
    };
    for (const Row& row : rows) {
        answer("relations.csv", relations), answer("states.csv", states), answer("visibility.csv", visibility);
        const std::string header = row.table == std::string("relations") ? head
                                   : row.table == std::string("states")  ? "box,state,close,cover,light\n"
                                                                         : "segment,visibility\n";
        answer(std::string(row.table) + ".csv", header + row.text);
        const verify::Report found = report();
        EXPECT_FALSE(found.agree());
        for (const char* table : {"relations", "states", "visibility"}) {
            const verify::Counts c = counts(found, table);
            const bool here = table == std::string(row.table);
            EXPECT_EQ(c.wrong, here ? row.wrong : 0) << table << "\n" << row.text;
            EXPECT_EQ(c.missing, here ? row.missing : 0) << row.text;
            EXPECT_EQ(c.doubled, here ? row.doubled : 0) << row.text;
            EXPECT_EQ(c.unknown, here ? row.unknown : 0) << row.text;
            EXPECT_EQ(c.undecided, here ? row.undecided : 0) << row.text;
        }
        EXPECT_FALSE(found.first.empty());
        EXPECT_EQ(exit_code(), 1) << row.text;
    }
}

// SPEC 6: "A faster variant may answer a grazing segment either way."
TEST_F(Verify, GrazingIsAcceptedEitherWayUnlessStrict) {
    verify::Options strict;
    strict.strict = true;
    for (const char* answered : {"clear", "blocked"}) {
        answer("visibility.csv", std::string("segment,visibility\n0,clear\n1,blocked\n2,") + answered + "\n");
        EXPECT_TRUE(report().agree());
        EXPECT_EQ(counts(report(strict), "visibility").wrong, 1u);
        EXPECT_EQ(exit_code("--strict"), 1);
    }
}

TEST_F(Verify, AVariantMayAnswerYesOrNo) {
    drop("states.csv");
    answer("relations.csv", "box,polygon,close\n0,1,1\n0,2,1\n1,0,0\n");
    answer("visibility.csv", "segment,hidden\n0,0\n1,1\n2,1\n");
    EXPECT_TRUE(report().agree());
    EXPECT_EQ(exit_code(), 0);
    EXPECT_EQ(exit_code("--hit crossing,boundary,coplanar"), 1);
    EXPECT_EQ(exit_code("--strict"), 1) << "grazing is not hidden where it must be right";
    answer("relations.csv", "box,polygon,close\n0,1,1\n0,2,1\n1,1,1\n");
    EXPECT_EQ(exit_code(), 1);
    EXPECT_EQ(exit_code("--hit crossing,boundary,coplanar"), 0);
    answer("relations.csv", "box,polygon,close\n0,1,1\n");
    EXPECT_EQ(exit_code("--hit crossing"), 0);
    answer("visibility.csv", "segment,hidden\n0,1\n1,1\n2,1\n");
    EXPECT_EQ(exit_code("--hit crossing"), 1);
}

TEST_F(Verify, NearDisagreementsAreCountedApartByKindAndDescribed) {
    answer("relations.csv",
           "box,polygon,relation,covers,shared\n0,1,crossing,1,none\n0,2,boundary,0,edge\n1,1,base,0,none\n");
    verify::Options options;
    options.near_band = 20;
    const verify::Report found = report(options);
    EXPECT_EQ(counts(found, "relations").wrong, 0u);
    EXPECT_EQ(counts(found, "relations").near, 1u);
    EXPECT_EQ(found.tables[0].kinds.at("side").counts.near, 1u);
    EXPECT_EQ(found.tables[0].kinds.at("element").counts.near, 0u);
    EXPECT_EQ(found.tables[0].total.confusion.at(2, 1), 1u) << "coplanar answered as base";
    EXPECT_FALSE(found.agree()) << "near is still no agreement";
    ASSERT_EQ(found.first.size(), 1u);
    const verify::Disagreement& d = found.first[0];
    EXPECT_EQ(d.id, 1);
    EXPECT_EQ(d.polygon, 1);
    EXPECT_EQ(d.exact, "1,1,coplanar,0,none");
    EXPECT_NE(d.question.find("0x1p-3"), std::string::npos) << d.question;
    EXPECT_NE(d.question.find("1/3"), std::string::npos) << "what is no binary64 number stands as it is";
    EXPECT_LT(d.switch_ulps, 8) << "band 52 of a question of size 1 is within some ulps";
    options.near_band = 53;
    EXPECT_EQ(counts(report(options), "relations").wrong, 1u);
}

TEST_F(Verify, ReportsForScriptsAndContinuousIntegrationSayTheSame) {
    answer("visibility.csv", "segment,visibility\n0,blocked\n1,blocked\n2,clear\n");
    const std::string json = folder_ / "report.json", junit = folder_ / "report.xml";
    EXPECT_EQ(exit_code("--json " + json + " --junit " + junit), 1);
    const auto parsed = nlohmann::json::parse(read_file(json));
    EXPECT_FALSE(parsed["agree"].get<bool>());
    EXPECT_EQ(parsed["tables"]["visibility"]["wrong"], 1);
    EXPECT_EQ(parsed["tables"]["visibility"]["kinds"]["light"]["confusion"]["clear"]["blocked"], 1);
    EXPECT_EQ(parsed["tables"]["relations"]["wrong"], 0);
    EXPECT_EQ(parsed["first"][0]["id"], 0);
    const std::string xml = read_file(junit);
    EXPECT_NE(xml.find("name=\"light\">\n      <failure message=\"1 wrong"), std::string::npos) << xml;
    EXPECT_NE(xml.find("name=\"edge\"/>"), std::string::npos) << xml;
}

TEST_F(Verify, BadInputIsNamedAndIsNoDisagreement) {
    struct Row {
        const char *table, *text, *expected;
    };
    const Row rows[] = {
        {"relations.csv", "box,polygon,relation\n0,1,crossing\n", "relations.csv:1: wrong header"},
        {"relations.csv", "", "relations.csv: empty table"},
        {"relations.csv", "box,polygon,relation,covers,shared\n0,1,crossing,1,none\n0,2,bounda",
         "relations.csv:3: line without its end"},
        {"relations.csv", "box,polygon,relation,covers,shared\n0,1,crossing\n", "relations.csv:2: row of 3 fields"},
        {"relations.csv", "box,polygon,relation,covers,shared\n0,1,touching,0,none\n",
         "relations.csv:2: unknown word 'touching'"},
        {"relations.csv", "box,polygon,relation,covers,shared\n0,x,crossing,0,none\n",
         "relations.csv:2: not an integer 'x'"},
        {"relations.csv", "box,polygon,relation,covers,shared\n1,1,base,0,none\n0,1,base,0,none\n",
         "relations.csv:3: ids do not ascend"},
        {"relations.csv", "box,polygon,relation,covers,shared\n0,2,base,0,none\n0,1,base,0,none\n",
         "relations.csv:3: polygons do not ascend"},
        {"visibility.csv", "segment,visibility\n1,clear\n0,clear\n", "visibility.csv:3: ids do not ascend"},
        {"visibility.csv", "segment,hidden\n0,2\n", "visibility.csv:2: unknown word '2'"},
    };
    for (const Row& row : rows) {
        answer("relations.csv", relations), answer("visibility.csv", visibility);
        answer(row.table, row.text);
        try {
            report();
            ADD_FAILURE() << "accepted: " << row.text;
        } catch (const InputError& error) {
            EXPECT_NE(std::string(error.what()).find(row.expected), std::string::npos) << error.what();
        }
        EXPECT_EQ(exit_code(), 2);
    }
}

TEST_F(Verify, ADamagedOrMissingSetIsBadInput) {
    drop("states.csv"), drop("relations.csv"), drop("visibility.csv");
    EXPECT_EQ(exit_code(), 2) << "nothing was answered";
    answer("visibility.csv", visibility);
    EXPECT_EQ(exit_code(), 0);
    put("visibility.csv", std::string("segment,visibility\n0,clear\n1,clear\n2,grazing\n"));
    EXPECT_THROW(report(), InputError) << "the checksum does not fit";
    EXPECT_EQ(exit_code(), 2);
    std::filesystem::remove(set() + "/manifest.json");
    EXPECT_EQ(exit_code(), 2);
    std::filesystem::remove_all(answers());
    EXPECT_EQ(exit_code(), 2);
}

TEST_F(Verify, CallablesAreAskedEveryQuestionInPlainDoubles) {
    const verify::Set loaded = verify::load_set(set());
    ASSERT_EQ(loaded.polygons.size(), 3u);
    EXPECT_EQ(loaded.polygons[1].loop[2], (verify::Vector{1, 1, 0.125}));

    int asked = 0;
    const auto relation = [&](const verify::Box& box, const verify::Polygon& polygon) {
        ++asked;
        if (box.id == 1) {
            EXPECT_EQ(box.corners[2][1], 1.0 / 3);
        }
        return box.id == 0       ? polygon.id == 1 ? verify::Relation::crossing : verify::Relation::boundary
               : polygon.id == 1 ? verify::Relation::coplanar
                                 : verify::Relation::disjoint;
    };
    const auto sight = [](const verify::Segment& segment) { return segment.id == 1; };
    EXPECT_TRUE(verify::check(loaded, relation, sight).agree());
    EXPECT_EQ(asked, 5) << "the own polygon is left out";

    const auto nothing = [](const verify::Box&, const verify::Polygon&) { return false; };
    const verify::Report found = verify::check(loaded, nothing, nullptr);
    EXPECT_EQ(counts(found, "relations").wrong, 2u);
    EXPECT_EQ(found.tables.size(), 1u);
}

// Fractions in plain doubles: within two units in the last place, far beyond the range of p and q alone.
TEST(VerifyNumbers, FractionsRoundClosely) {
    struct Row {
        const char* text;
        double value;
    };
    const std::string zeros(400, '0');
    const std::string huge = "1" + zeros + "/3" + zeros;
    const Row rows[] = {
        {"1/3", 1.0 / 3}, {"-2/7", -2.0 / 7}, {huge.c_str(), 1.0 / 3}, {"0.1", 0.1}, {"-1e-320", -1e-320}};
    for (const Row& row : rows) {
        const auto value = verify::parse_number(row.text);
        ASSERT_TRUE(value) << row.text;
        EXPECT_NEAR(*value / row.value, 1, 1e-15) << row.text;
    }
    for (const char* text : {"", "/", "1/0", "1/-2", "x", "1/2/3", "1.5/2", "1 "})
        EXPECT_FALSE(verify::parse_number(text)) << text;
}

}  // namespace
}  // namespace cob
