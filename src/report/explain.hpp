/// \file
/// One element in words (`cob explain`), for teaching and review.
#pragma once

#include "cob/candidates.hpp"
#include "cob/classify.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace cob {

struct ExplainedElement {
    Element element;
    std::optional<std::uint64_t> number;  ///< Of its box, where it is one of the meshing's.
    Rational margin, height;
};

/// Its box, exact and rounded; every polygon near it with relation, covers and shared, and the comparisons with exact
/// values that decide them; its state, and which sentence of the paper that follows from.
std::string explain(const Scene& scene, const Roots& roots, const CandidateSource& source,
                    const ExplainedElement& element);

}  // namespace cob
