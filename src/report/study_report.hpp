/// \file
/// The runs of a study as table, plots and page.
#pragma once

#include "cob/study.hpp"

#include <string>
#include <vector>

namespace cob::report {

struct StudyResults {
    std::string scene, machine, commit;  ///< As they are to be named.
    StudyReference reference;
    std::vector<StudyRun> runs;
};

/// study.csv: one line for each run.
std::string study_csv(const StudyResults& results);
/// Error by series and refinement, for a terminal.
std::string study_text(const StudyResults& results);
/// Draws the plots into the folder and writes study.html, self-contained, and study.csv.
void write_study(const StudyResults& results, const std::string& folder);

}  // namespace cob::report
