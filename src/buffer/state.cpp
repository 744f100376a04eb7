#include "cob/buffer.hpp"

namespace cob {

const char* to_text(BufferState state) {
    switch (state) {
        case BufferState::uninitialised:
            return "uninitialised";
        case BufferState::empty:
            return "empty";
        case BufferState::close:
            return "close";
        case BufferState::occluded:
            return "occluded";
    }
    return "";
}

}  // namespace cob
