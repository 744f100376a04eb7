/// \file
/// Moving a scene to a binary grid, so that all questions about it are binary64 or binary32 numbers (SPEC 7,
/// "exactly consumable").
#pragma once

#include "cob/golden.hpp"
#include "cob/scene.hpp"
#include "golden/number_format.hpp"

namespace cob {

/// Sample points inside an element: multiples of 2^-sample_bits of its sides.
constexpr int sample_bits(NumberFormat format) {
    return format == NumberFormat::binary32 ? 2 : 4;
}

struct SnappedScene {
    Scene scene;
    std::optional<SnapReport> report;  ///< None where nothing was asked for.
};

/// Snaps where the parameters ask for it. Throws InputError where the grid is too fine for the numbers, where a
/// polygon becomes invalid and skip_invalid is not set, and where margin or height do not fit.
SnappedScene snap(Scene scene, const GoldenParameters& parameters);

}  // namespace cob
