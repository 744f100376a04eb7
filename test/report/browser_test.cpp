// The pages as a browser shows them.
#include "cob/files.hpp"
#include "report/claims_report.hpp"
#include "report/gnuplot.hpp"
#include "report/study_report.hpp"
#include "temporary_folder.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

namespace cob {
namespace {

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t found = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) ++found;
    return found;
}

bool runs(const std::string& command) {
    return std::system((command + " >/dev/null 2>&1").c_str()) == 0;
}

/// The page after loading, and what the browser had to say.
struct Rendered {
    std::string document, messages;
};

/// A script at the page's end tells how many of its pictures were decoded: the page itself has none.
Rendered render(const std::string& folder, const std::string& page) {
    std::string html = read_file(folder + "/" + page);
    const std::string script =
        "<script>addEventListener('load', () => {"
        "const all = [...document.images];"
        "document.body.dataset.decoded = all.filter(i => i.complete && i.naturalWidth > 0).length;"
        "document.body.dataset.loaded = performance.getEntriesByType('resource').filter(e => "
        "!e.name.startsWith('data:')).length;});</script>";
    html.insert(html.find("</body>"), script);
    write_file(folder + "/seen.html", html);
    const std::string command =
        "timeout 120 chromium --headless --no-sandbox --disable-gpu --disable-quic --no-first-run "
        "--disable-background-networking --disable-component-update --disable-sync --enable-logging=stderr "
        "--user-data-dir='" +
        folder + "/profile' --dump-dom 'file://" + folder + "/seen.html' >'" + folder + "/dom.html' 2>'" + folder +
        "/messages.txt'";
    EXPECT_EQ(std::system(command.c_str()), 0);
    return {read_file(folder + "/dom.html"), read_file(folder + "/messages.txt")};
}

void expect_whole(const Rendered& rendered, std::size_t pictures) {
    EXPECT_EQ(count(rendered.document, "<img "), pictures);
    EXPECT_NE(rendered.document.find("data-decoded=\"" + std::to_string(pictures) + "\""), std::string::npos);
    EXPECT_NE(rendered.document.find("data-loaded=\"0\""), std::string::npos) << "something comes from elsewhere";
    EXPECT_EQ(rendered.messages.find("CONSOLE"), std::string::npos) << rendered.messages;
}

class Browser : public ::testing::Test {
protected:
    void SetUp() override {
        if (!runs("command -v chromium")) GTEST_SKIP() << "chromium is not installed";
        has_plots_ = runs("command -v gnuplot");
    }
    bool has_plots_ = false;
};

ClaimResult made_up_claim() {
    ClaimResult claim{"made-up",
                      "Shadows are <dark> & \"sharp\".",
                      "figure 0",
                      "As dark as can be.",
                      "it is night",
                      {{"here", 2, "twice as dark", true}, {"there", 0.5, "half as dark", false}},
                      {}};
    claim.plot = ClaimPlot{"Darkness", "x", "y", false, false, {{"measured", {{1, 1}, {2, 4}}}}};
    return claim;
}

// One self-contained page with the pictures and tables, checked in a headless browser.
TEST_F(Browser, ShowsEveryClaimWithItsPlot) {
    test::TemporaryFolder folder;
    report::write_claims({made_up_claim()}, {bench_machine(), 1, false}, folder.path());
    const Rendered rendered = render(folder.path(), "claims.html");
    expect_whole(rendered, has_plots_ ? 1 : 0);
    EXPECT_EQ(count(rendered.document, "<tr>"), 2u + 3u);  // heads, one claim; heads, two cases
    EXPECT_NE(rendered.document.find("only if it is night"), std::string::npos);
    EXPECT_NE(rendered.document.find("Shadows are &lt;dark&gt; &amp;"), std::string::npos);
}

TEST_F(Browser, ShowsAStudyWithItsPlots) {
    test::TemporaryFolder folder;
    report::StudyResults results;
    results.scene = "made up";
    results.machine = bench_machine();
    results.reference.points.resize(4);
    for (const Refinement refinement : {Refinement::none, Refinement::both}) {
        StudyRun run;
        run.settings.series = "budget";
        run.settings.refinement = refinement;
        run.elements = refinement == Refinement::none ? 1000 : 50;
        run.seconds_least = run.seconds_median = refinement == Refinement::none ? 1 : 0.1;
        run.all = {0.1, 0.1, 0.2};
        results.runs.push_back(run);
    }
    report::write_study(results, folder.path());
    const Rendered rendered = render(folder.path(), "study.html");
    expect_whole(rendered, has_plots_ ? 2 : 0);            // no point in the band: no plots of it
    EXPECT_EQ(count(rendered.document, "<tr>"), 2u + 3u);  // the bar; two runs
    EXPECT_NE(rendered.document.find("<td>met</td>"), std::string::npos);
    EXPECT_NE(rendered.document.find(bench_machine().commit), std::string::npos);
}

}  // namespace
}  // namespace cob
