/// \file
/// The paper's claims as table and page.
#pragma once

#include "cob/bench.hpp"
#include "cob/claims.hpp"

#include <string>
#include <vector>

namespace cob::report {

/// What they were measured on.
struct ClaimsSetting {
    BenchMachine machine;
    int threads = 0;
    bool quick = false;
};

/// A line for each claim, for a terminal.
std::string claims_text(const std::vector<ClaimResult>& results);
/// claims.csv: a row for each claim on each case.
std::string claims_csv(const std::vector<ClaimResult>& results);
/// Draws the plots into the folder and writes claims.html, self-contained, and claims.csv.
void write_claims(const std::vector<ClaimResult>& results, const ClaimsSetting& setting, const std::string& folder);

}  // namespace cob::report
