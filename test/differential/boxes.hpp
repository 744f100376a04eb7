/// \file
/// The same question about a box for the library and for the naive twin.
#pragma once

#include "naive/box.hpp"

#include "cob/error.hpp"
#include "cob/geometry.hpp"

#include <optional>

namespace cob::test {

/// Nothing where SPEC 4 refuses the question.
inline std::optional<Box> library_box(const naive::BoxQuestion& question) {
    BoxQuestion result;
    result.polygon = question.polygon;
    result.corners.count = static_cast<int>(question.corners.size());
    for (std::size_t k = 0; k < question.corners.size(); ++k)
        result.corners.points[k] = ExactPoint(question.corners[k]);
    result.u = ExactPoint(question.u);
    result.margin = question.margin;
    result.height = question.height;
    try {
        return Box(result);
    } catch (const InputError&) {
        return std::nullopt;
    }
}

}  // namespace cob::test
