/// \file
/// Candidates as a list.
#pragma once

#include "cob/candidates.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace cob {

/// The polygons whose bounds meet these (CandidateSource::polygons_in), ascending.
inline std::vector<PolygonId> polygons_in(const CandidateSource& source, const std::array<double, 6>& bounds) {
    std::vector<PolygonId> found;
    source.polygons_in(bounds, {&found, [](void* context, std::int32_t id) {
                                    static_cast<std::vector<PolygonId>*>(context)->push_back(id);
                                    return true;
                                }});
    std::sort(found.begin(), found.end());
    return found;
}

}  // namespace cob
