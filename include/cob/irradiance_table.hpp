/// \file
/// points.csv in, irradiance.csv out (SPEC sections 7 and 8).
#pragma once

#include "cob/candidates.hpp"
#include "cob/progress.hpp"
#include "cob/scene.hpp"

#include <cstdint>
#include <functional>
#include <string>

namespace cob {

/// What answering will cost, known before the first answer.
struct IrradianceCost {
    std::uint64_t points = 0, lights = 0;
    double seconds = 0;  ///< On one core; from a few timed answers.
};

struct IrradianceTableOptions {
    int threads = 0;  ///< 0: all cores. The table does not depend on it.
    Progress progress;
    std::function<void(const IrradianceCost&)> tell_cost;  ///< Called once, before the work.
};

struct IrradianceTableResult {
    std::uint64_t rows = 0;    ///< One for each point and light.
    std::uint64_t partly = 0;  ///< Of these, some of what is in front is hidden;
    std::uint64_t wholly = 0;  ///< all of it is.
};

/// Answers every point of the table `points` and writes the table `out`, in bounded memory. Irradiance is the
/// visible form factor times the light's emitted exitance. Throws InputError with file and line for unreadable
/// rows and zero normals.
IrradianceTableResult write_irradiance(const Scene& scene, const CandidateSource& candidates, const std::string& points,
                                       const std::string& out, const IrradianceTableOptions& options = {});

}  // namespace cob
