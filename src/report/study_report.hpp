/// \file
/// The runs of a study as table, plots and page.
#pragma once

#include "cob/bench.hpp"
#include "cob/study.hpp"
#include "report/camera.hpp"

#include <string>
#include <vector>

namespace cob::report {

struct StudyPicture {
    std::string path, caption;  ///< A PNG file.
};
/// Draws the scene solved on the coarse patches alone and with both refinements, and the mesh of these, into the
/// folder; at most so many shots each.
std::vector<StudyPicture> draw_study(const Scene& scene, const Camera& camera, const StudySettings& settings, int shots,
                                     int threads, const std::string& folder, const Progress& alive);

struct StudyResults {
    std::string scene;  ///< As it is to be named.
    BenchMachine machine;
    int threads = 0;
    std::vector<StudyPicture> pictures;
    StudyReference reference;
    std::vector<StudyRun> runs;
};

/// study.csv: one line for each run.
std::string study_csv(const StudyResults& results);
/// Error by series and refinement, for a terminal.
std::string study_text(const StudyResults& results);
/// Draws the plots into the folder and writes study.html, self-contained, study.csv and bar.csv.
void write_study(const StudyResults& results, const std::string& folder);

}  // namespace cob::report
