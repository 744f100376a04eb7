#include "report/stress_report.hpp"

#include "report/page.hpp"
#include "report/text.hpp"

#include <algorithm>
#include <array>

namespace cob::report {
namespace {

std::vector<StressRow> all_rows(const StressResults& results) {
    std::vector<StressRow> rows;
    for (const GeometryRow& row : results.geometry) rows.push_back(row.row);
    rows.insert(rows.end(), results.others.begin(), results.others.end());
    return rows;
}

Table table_of(const std::vector<StressRow>& rows) {
    Table table{{"group", "case", "expected", "came out", "verdict"}, {}};
    for (const StressRow& row : rows)
        table.rows.push_back({row.group, row.name, row.expected, row.came_out, to_text(row.verdict)});
    return table;
}

Table geometry_table(const StressResults& results) {
    Table table{{"case", "relations", "wrong in fractions", "binary32", "binary64", "epsilon", "segments",
                 "wrong in fractions", "binary32", "binary64", "epsilon", "filter decides %"},
                {}};
    for (const GeometryRow& row : results.geometry) {
        std::vector<std::string> cells{row.row.name};
        for (const auto of : {&GeometryRow::relations, &GeometryRow::segments}) {
            cells.push_back(std::to_string(row.*of));
            const auto errors =
                of == &GeometryRow::relations ? &ArithmeticErrors::relations : &ArithmeticErrors::visibility;
            for (const ArithmeticErrors* arithmetic : {&row.exact, &row.binary32, &row.binary64, &row.epsilon})
                cells.push_back(std::to_string(arithmetic->*errors));
        }
        cells.push_back(printed("%.1f", 100 * static_cast<double>(row.filtered) /
                                            static_cast<double>(std::max<std::uint64_t>(1, row.decided))));
        table.rows.push_back(std::move(cells));
    }
    return table;
}

std::string verdicts(const std::vector<StressRow>& rows) {
    std::array<std::size_t, 4> counts{};
    for (const StressRow& row : rows) ++counts[static_cast<std::size_t>(row.verdict)];
    return std::to_string(rows.size()) + " cases: " + std::to_string(counts[0]) + " pass, " +
           std::to_string(counts[1]) + " limits, " + std::to_string(counts[2]) + " failed, " +
           std::to_string(counts[3]) + " figures";
}

}  // namespace

bool StressResults::pass() const {
    const std::vector<StressRow> rows = all_rows(*this);
    return std::none_of(rows.begin(), rows.end(), [](const StressRow& row) { return row.verdict == Verdict::failed; });
}

std::string stress_csv(const StressResults& results) {
    return table_of(all_rows(results)).csv();
}

std::string stress_geometry_csv(const StressResults& results) {
    Table table = geometry_table(results);
    table.heads = {"case",
                   "relations",
                   "relations_exact",
                   "relations_binary32",
                   "relations_binary64",
                   "relations_epsilon",
                   "segments",
                   "segments_exact",
                   "segments_binary32",
                   "segments_binary64",
                   "segments_epsilon",
                   "filter_percent"};
    return table.csv();
}

std::string stress_text(const StressResults& results) {
    const std::vector<StressRow> rows = all_rows(results);
    std::string text = verdicts(rows) + "; " + printed("%.1f s", results.seconds) + "\n";
    for (const StressRow& row : rows)
        if (row.verdict != Verdict::pass)
            text += std::string(to_text(row.verdict)) + "  " + row.name + "\n    expected: " + row.expected +
                    "\n    came out: " + row.came_out + "\n";
    return text;
}

std::string stress_html(const StressResults& results) {
    Page page("Stiff and extreme cases");
    page.paragraph(verdicts(all_rows(results)) + "; " + printed("%.1f s", results.seconds) + "; compiler " +
                   __VERSION__ + ".");
    page.paragraph(
        "pass: as expected. limit: not as expected, for the reason told; a limit of the method or the number type. "
        "figure: measured, nothing is expected.");
    page.heading("Geometry: answers in other arithmetic");
    page.paragraph(
        "The same questions in every arithmetic. The product (filter first, exact where that is undecided) is compared "
        "with fractions and must not differ; the columns binary32, binary64 and epsilon count the answers that plain "
        "floating point, and floating point with a tolerance, get wrong on the same input.");
    page.table(geometry_table(results));
    page.heading("Every case");
    page.table(table_of(all_rows(results)));
    return page.html();
}

}  // namespace cob::report
