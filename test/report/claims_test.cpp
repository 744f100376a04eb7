// The paper's claims: the registry, verdicts, and measurements that must come out as geometry says.
#include "cob/claims.hpp"

#include "cob/error.hpp"
#include "report/claims_report.hpp"
#include "temporary_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace cob {
namespace {

ClaimResult measure(const std::string& id, const std::string& folder) {
    ClaimOptions options;
    options.data = COB_DATA;
    options.folder = folder;
    options.quick = true;
    options.threads = 1;
    return measure_claims({id}, options).front();
}

const ClaimCase& of_scene(const ClaimResult& result, const std::string& scene) {
    const auto found = std::find_if(result.cases.begin(), result.cases.end(),
                                    [&](const ClaimCase& c) { return c.scene.find(scene) != std::string::npos; });
    if (found == result.cases.end()) throw std::runtime_error("no case on " + scene);
    return *found;
}

// Twenty claims, from detail shadows to occluded elements.
TEST(Claims, TheRegistryNamesEachOnce) {
    const std::vector<std::string> ids = claim_ids();
    EXPECT_EQ(ids.size(), 20u);
    EXPECT_EQ(std::set<std::string>(ids.begin(), ids.end()).size(), ids.size());
    EXPECT_THROW(measure_claims({"no-such-claim"}, {}), InputError);
}

TEST(Claims, VerdictsFollowFromTheCases) {
    ClaimResult result;
    result.cases = {{"a", 1, "", true}, {"b", 1, "", true}};
    EXPECT_EQ(result.verdict(), ClaimVerdict::confirmed);
    EXPECT_EQ(result.fails_on(), "");
    result.cases[1].holds = false;
    EXPECT_EQ(result.verdict(), ClaimVerdict::only_if);
    EXPECT_EQ(result.fails_on(), "b");
    result.cases[0].holds = false;
    EXPECT_EQ(result.verdict(), ClaimVerdict::refuted);
    EXPECT_EQ(result.fails_on(), "a, b");
}

// w = h L / (H - h) for a light parallel to the receiver, by similar triangles; another one has no such width.
TEST(Claims, PenumbraHoldsUnderAParallelLightOnly) {
    const test::TemporaryFolder folder;
    const ClaimResult result = measure("penumbra", folder.path());
    EXPECT_LT(of_scene(result, "parallel").value, 1e-8);
    EXPECT_GT(of_scene(result, "45 degrees").value, 0.01);
    EXPECT_EQ(result.verdict(), ClaimVerdict::only_if);
}

// Figure 3: what shares an edge with the table casts no shadow on it; figure 4: the sheet's edge does.
TEST(Claims, InVainAtTheSharedEdgeNotUnderTheSheet) {
    const test::TemporaryFolder folder;
    const ClaimResult result = measure("in-vain", folder.path());
    EXPECT_EQ(of_scene(result, "figure3").value, 1);
    EXPECT_EQ(of_scene(result, "figure4").value, 0);
}

// Figure 4 has elements that step 1 skips; figure 5's lie under light that reaches them from the side.
TEST(Claims, Step1SavesUnderTheSheet) {
    const test::TemporaryFolder folder;
    EXPECT_TRUE(of_scene(measure("step-1", folder.path()), "figure4").holds);
    const ClaimResult tangential = measure("tangential", folder.path());
    EXPECT_EQ(of_scene(tangential, "figure4").value, 0);
    EXPECT_GT(of_scene(tangential, "figure5").value, 0);
}

// A sheet exactly on the table hides it without a buffer; above it each patch is tried once.
TEST(Claims, SheetsAreTriedOnce) {
    const test::TemporaryFolder folder;
    const ClaimResult result = measure("sheets", folder.path());
    EXPECT_EQ(of_scene(result, "sheet 0 above").value, 0);
    EXPECT_EQ(of_scene(result, "sheet 0.001 above").value, 1);
}

TEST(Claims, TheTableHasARowForEachCase) {
    const test::TemporaryFolder folder;
    const ClaimResult result = measure("on-demand", folder.path());
    const std::string csv = report::claims_csv({result});
    EXPECT_EQ(static_cast<std::size_t>(std::count(csv.begin(), csv.end(), '\n')), 1 + result.cases.size());
    EXPECT_NE(report::claims_text({result}).find("1 claims: "), std::string::npos);
}

}  // namespace
}  // namespace cob
