/// \file
/// Stiff and extreme cases, each with what is expected and what came out: the rows behind `cob stress`.
///
/// Everything is made in code, so that the rows need no files; only the sensitivity takes scenes from outside.
#pragma once

#include "cob/progress.hpp"
#include "cob/scene.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace cob {

enum class Verdict : std::uint8_t {
    pass,    ///< Came out as expected.
    limit,   ///< Did not, for the reason that is told: a limit of the method or of the number type.
    failed,  ///< Did not, and should have.
    figure,  ///< Nothing is expected: a measured figure.
};
const char* to_text(Verdict verdict);

struct StressRow {
    std::string group;     ///< "geometry", "photometry", "stiff", "sensitivity".
    std::string name;      ///< The case.
    std::string expected;  ///< In words.
    std::string came_out;  ///< In words and numbers.
    Verdict verdict = Verdict::pass;
};

/// Wrong answers of one arithmetic, for the rows of geometry.
struct ArithmeticErrors {
    std::uint64_t relations = 0;   ///< Relation or covers differs from the exact one.
    std::uint64_t visibility = 0;  ///< Clear, grazing or blocked differs.
};

/// One extreme case of geometry. Answers by the product (filter first, tree of candidates) are compared with the same
/// formula in fractions without a tree.
struct GeometryRow {
    StressRow row;
    std::uint64_t relations = 0, segments = 0;  ///< Answers asked.
    std::uint64_t filtered = 0, decided = 0;    ///< Predicates decided in binary64, and by all stages.
    ArithmeticErrors exact;                     ///< Of the product against fractions: must be 0.
    ArithmeticErrors binary32, binary64, epsilon;
};

struct StressOptions {
    bool quick = false;  ///< A subset of every group, for tests: seconds.
    Progress progress;   ///< Counts cases; how many there are is not known.
};

/// Scale, offset, aspect ratio, sheets one ulp apart, deep refinement, margin and height at their limits, touching and
/// coplanar polygons.
std::vector<GeometryRow> stress_geometry(const StressOptions& options);

/// Form factors from point to polygon, far, near, thin, grazing, tiny and huge, beside an independent evaluation with
/// 100 decimal digits.
std::vector<StressRow> stress_photometry(const StressOptions& options);

/// Closed boxes of high reflectance against E / (1 - rho), single precision, a bright tiny light beside a large dim
/// one, light through a slit.
std::vector<StressRow> stress_stiff(const StressOptions& options);

/// How many answers change when every coordinate of a scene moves by one ulp, up or down by a fixed pattern, and the
/// questions (boxes over elements, segments between points of polygons) move with their polygons.
std::vector<StressRow> stress_sensitivity(const Scene& scene, const std::string& name, const StressOptions& options);

}  // namespace cob
