/// \file
/// What the paper claims, each claim measured: the rows behind `cob study --claims`.
///
/// A claim is a sentence with a figure and a threshold. It is measured on several cases (a scene, a setting); it is
/// confirmed where every case meets the threshold, refuted where none does, and else holds only if.
#pragma once

#include "cob/progress.hpp"
#include "cob/scene.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace cob {

enum class ClaimVerdict : std::uint8_t { confirmed, refuted, only_if };
const char* to_text(ClaimVerdict verdict);

/// A claim on one case.
struct ClaimCase {
    std::string scene;     ///< Of the data folder, or what was made in code; with the setting.
    double value = 0;      ///< The figure that the threshold is about.
    std::string measured;  ///< The figures in words.
    bool holds = false;
};

/// A curve that goes with a claim.
struct ClaimCurve {
    std::string title;
    std::vector<std::array<double, 2>> points;
};
struct ClaimPlot {
    std::string title, x_label, y_label;
    bool logarithmic_x = false, logarithmic_y = false;
    std::vector<ClaimCurve> curves;
};

struct ClaimResult {
    std::string id;         ///< One word or two with hyphens.
    std::string text;       ///< What is claimed.
    std::string where;      ///< In the paper.
    std::string criterion;  ///< When a case holds: what is measured and the threshold.
    std::string condition;  ///< What the cases that hold have in common; shown where the claim holds only if.
    std::vector<ClaimCase> cases;
    std::optional<ClaimPlot> plot;

    ClaimVerdict verdict() const;
    /// The scenes where it fails, separated by commas.
    std::string fails_on() const;
};

struct ClaimOptions {
    std::string data;    ///< Folder with the shipped scenes.
    std::string folder;  ///< For what a claim writes besides (the truth beside the buffer).
    bool quick = false;  ///< The smallest scenes and meshes alone: seconds. Times mean little then.
    int threads = 0;     ///< 0: all.
    Progress progress;   ///< Counts cases; how many there are is not known.
};

/// The ids in the order of the table.
std::vector<std::string> claim_ids();
/// Measures claims, all where no id is given. Throws InputError for an id that is none, or where a scene cannot be
/// read.
std::vector<ClaimResult> measure_claims(const std::vector<std::string>& ids, const ClaimOptions& options);

}  // namespace cob
