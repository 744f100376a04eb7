// The rows of `cob stress`, the quick subset: geometry is exact everywhere (SPEC 1), photometry within its bounds.
#include "cob/stress.hpp"

#include "report/stress_report.hpp"
#include "report/stress_scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace cob {
namespace {

StressOptions quick() {
    StressOptions options;
    options.quick = true;
    return options;
}

// SPEC 1: every geometric decision is the one of infinitely precise arithmetic, for any finite input. And the cases
// are hard: each plain arithmetic gets some answers wrong.
TEST(Stress, GeometryIsExactWherePlainArithmeticIsNot) {
    std::uint64_t binary32 = 0, binary64 = 0, epsilon = 0, asked = 0;
    for (const GeometryRow& row : stress_geometry(quick())) {
        EXPECT_EQ(row.row.verdict, Verdict::pass) << row.row.name << ": " << row.row.came_out;
        EXPECT_GT(row.relations, 0u) << row.row.name;
        EXPECT_GT(row.segments, 0u) << row.row.name;
        asked += row.relations + row.segments;
        binary32 += row.binary32.relations + row.binary32.visibility;
        binary64 += row.binary64.relations + row.binary64.visibility;
        epsilon += row.epsilon.relations + row.epsilon.visibility;
    }
    EXPECT_GT(asked, 5000u);
    EXPECT_GT(binary32, 0u);
    EXPECT_GT(binary64, 0u);
    EXPECT_GT(epsilon, 0u);
}

// The questions about the still life are worth asking: every relation and every visibility occurs.
TEST(Stress, EveryAnswerOccurs) {
    const Scene scene = scene_of(stress::still_life());
    const stress::Questions questions = stress::ask(scene, 1, Rational(1, 8), Rational(1, 4), 40, 160);
    const stress::Answers answers = answer(scene, questions, Arithmetic::exact, Source::tree);
    for (const Relation relation :
         {Relation::disjoint, Relation::base, Relation::coplanar, Relation::boundary, Relation::crossing})
        EXPECT_TRUE(std::any_of(answers.relations.begin(), answers.relations.end(), [&](const BoxAnswer& a) {
            return a.relation == relation;
        })) << to_text(relation);
    for (const Visibility visibility : {Visibility::clear, Visibility::grazing, Visibility::blocked})
        EXPECT_TRUE(std::count(answers.visibility.begin(), answers.visibility.end(), visibility))
            << to_text(visibility);
}

TEST(Stress, PhotometryAndStiffTransportStayWithinTheirBounds) {
    for (const auto& rows : {stress_photometry(quick()), stress_stiff(quick())}) {
        EXPECT_GE(rows.size(), 5u);
        for (const StressRow& row : rows) EXPECT_NE(row.verdict, Verdict::failed) << row.name << ": " << row.came_out;
    }
}

// Moving a scene by one ulp changes answers where polygons touch, and the report counts them.
TEST(Stress, OneUlpChangesAnswersWherePolygonsTouch) {
    const std::vector<StressRow> rows = stress_sensitivity(scene_of(stress::still_life()), "still life", quick());
    ASSERT_EQ(rows.size(), 1u);
    EXPECT_EQ(rows[0].verdict, Verdict::figure);
    EXPECT_EQ(rows[0].came_out.find(" 0 change, 0 of them"), std::string::npos) << rows[0].came_out;
}

TEST(StressReport, AFailedRowIsCountedAndShown) {
    report::StressResults results;
    results.others.push_back({"stiff", "fine", "1", "1", Verdict::pass});
    EXPECT_TRUE(results.pass());
    results.others.push_back({"stiff", "wrong, one", "1", "2", Verdict::failed});
    EXPECT_FALSE(results.pass());
    EXPECT_NE(stress_text(results).find("2 cases: 1 pass, 0 limits, 1 failed"), std::string::npos);
    EXPECT_NE(stress_csv(results).find("stiff,\"wrong, one\",1,2,FAILED\n"), std::string::npos);
    EXPECT_NE(stress_html(results).find("wrong, one"), std::string::npos);
}

}  // namespace
}  // namespace cob
