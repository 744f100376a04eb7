/// \file
/// What is certain about a segment and a piece without exact arithmetic.
#pragma once

#include <cstdint>

namespace cob {

enum class Certain : std::uint8_t {
    unknown,
    missed,         ///< The closed piece and the open segment have no point in common.
    crossed_inside  ///< The segment crosses the interior from one side to the other.
};

}  // namespace cob
