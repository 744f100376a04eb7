/// \file
/// The rows of `cob stress` as table, text and page.
#pragma once

#include "cob/stress.hpp"

#include <string>
#include <vector>

namespace cob::report {

struct StressResults {
    std::vector<GeometryRow> geometry;
    std::vector<StressRow> others;
    double seconds = 0;

    /// None failed.
    bool pass() const;
};

/// stress.csv: group, case, expected, came out, verdict.
std::string stress_csv(const StressResults& results);
/// geometry.csv: the cases of geometry with wrong answers by arithmetic.
std::string stress_geometry_csv(const StressResults& results);
/// The counts of verdicts and every row that did not pass, for a terminal.
std::string stress_text(const StressResults& results);
/// One self-contained page.
std::string stress_html(const StressResults& results);

}  // namespace cob::report
