/// \file
/// The Close Object Buffer (SPEC section 5).
#pragma once

#include <cstdint>

namespace cob {

/// State of the buffer of one element.
enum class BufferState : std::uint8_t { uninitialised, empty, close, occluded };
const char* to_text(BufferState state);

}  // namespace cob
