/// \file
/// A whole golden set judged by the naive twin, from the set's files alone.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace cob::test {

struct TwinCheck {
    std::uint64_t pairs = 0, boxes = 0, segments = 0;  ///< Compared.
    std::vector<std::string> differences;              ///< The first ones, in words.
};

/// Every state, every pair of box and polygon, every visibility.
TwinCheck check_with_twin(const std::string& set);

}  // namespace cob::test
