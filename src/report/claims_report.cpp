#include "report/claims_report.hpp"

#include "cob/files.hpp"
#include "report/gnuplot.hpp"
#include "report/page.hpp"
#include "report/text.hpp"

#include <algorithm>
#include <array>

namespace cob::report {
namespace {

/// "only if ...", with the condition.
std::string verdict_of(const ClaimResult& result) {
    std::string verdict = to_text(result.verdict());
    if (result.verdict() == ClaimVerdict::only_if) verdict += " " + result.condition;
    return verdict;
}

/// The case that says most: of those that fail the first, else the first.
const ClaimCase& telling(const ClaimResult& result) {
    const auto failing =
        std::find_if(result.cases.begin(), result.cases.end(), [](const ClaimCase& c) { return !c.holds; });
    return failing != result.cases.end() ? *failing : result.cases.front();
}

std::string counts(const std::vector<ClaimResult>& results) {
    std::array<std::size_t, 3> number{};
    for (const ClaimResult& result : results) ++number[static_cast<std::size_t>(result.verdict())];
    return std::to_string(results.size()) + " claims: " + std::to_string(number[0]) + " confirmed, " +
           std::to_string(number[1]) + " refuted, " + std::to_string(number[2]) + " only if";
}

std::string number(double value) {
    return printed("%.4g", value);
}

Table summary_table(const std::vector<ClaimResult>& results) {
    Table table{{"claim", "in the paper", "measured", "verdict", "fails on"}, {}};
    for (const ClaimResult& result : results) {
        const ClaimCase& c = telling(result);
        table.rows.push_back(
            {result.text, result.where, c.scene + ": " + c.measured, verdict_of(result), result.fails_on()});
    }
    return table;
}

Table case_table(const ClaimResult& result) {
    Table table{{"scene", "measured", "figure", "holds"}, {}};
    for (const ClaimCase& c : result.cases)
        table.rows.push_back({c.scene, c.measured, number(c.value), c.holds ? "yes" : "no"});
    return table;
}

/// False where there is no plot.
bool draw_plot(const ClaimResult& result, const std::string& base) {
    if (!result.plot) return false;
    Plot plot;
    plot.title = result.plot->title;
    plot.x_label = result.plot->x_label;
    plot.y_label = result.plot->y_label;
    plot.logarithmic_x = result.plot->logarithmic_x;
    plot.logarithmic_y = result.plot->logarithmic_y;
    for (const ClaimCurve& curve : result.plot->curves) {
        Curve drawn;
        drawn.title = curve.title;
        drawn.points = curve.points;
        plot.curves.push_back(std::move(drawn));
    }
    draw(plot, base);
    return true;
}

}  // namespace

std::string claims_text(const std::vector<ClaimResult>& results) {
    std::string text = counts(results) + "\n";
    for (const ClaimResult& result : results) {
        text += "\n" + result.id + ": " + result.text + " (" + result.where + ")\n    " + verdict_of(result) + "\n";
        for (const ClaimCase& c : result.cases)
            text += std::string(c.holds ? "    + " : "    - ") + c.scene + ": " + c.measured + "\n";
    }
    return text;
}

std::string claims_csv(const std::vector<ClaimResult>& results) {
    Table table{
        {"id", "claim", "in_the_paper", "criterion", "verdict", "condition", "scene", "measured", "figure", "holds"},
        {}};
    for (const ClaimResult& result : results)
        for (const ClaimCase& c : result.cases)
            table.rows.push_back({result.id, result.text, result.where, result.criterion, to_text(result.verdict()),
                                  result.verdict() == ClaimVerdict::only_if ? result.condition : "", c.scene,
                                  c.measured, number(c.value), c.holds ? "1" : "0"});
    return table.csv();
}

void write_claims(const std::vector<ClaimResult>& results, const ClaimsSetting& setting, const std::string& folder) {
    write_file(folder + "/claims.csv", claims_csv(results));
    Page page("The paper's claims, measured");
    page.paragraph(
        "A. C. Telea and C. W. A. M. van Overveld, The Close Objects Buffer: A Sharp Shadow Detection Technique for "
        "Radiosity Methods, Journal of Graphics Tools 2(2), 1997. A claim is confirmed where every case meets the "
        "threshold that is stated with it, refuted where none does, and else holds only if.");
    page.paragraph(setting.machine.processor + ", " + std::to_string(setting.threads) + " threads; " +
                   setting.machine.compiler + "; commit " + setting.machine.commit + "." +
                   (setting.quick ? " Quick: the smallest scenes and meshes alone." : ""));
    page.paragraph(counts(results) + ".");
    page.table(summary_table(results));
    for (const ClaimResult& result : results) {
        page.heading(result.text);
        page.paragraph("In the paper: " + result.where + ". " + result.criterion + " Verdict: " + verdict_of(result) +
                       ".");
        page.table(case_table(result));
        const std::string base = folder + "/" + result.id;
        if (draw_plot(result, base)) page.picture(base + ".svg", result.plot->title);
    }
    write_file(folder + "/claims.html", page.html());
}

}  // namespace cob::report
