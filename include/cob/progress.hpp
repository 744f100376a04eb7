/// \file
/// How long work tells what it has done, and how it is ended early.
#pragma once

#include <cstdint>
#include <functional>

namespace cob {

/// Called now and then, from one thread at a time, with the units done and in total (0: not known); an exception that
/// it throws ends the work and reaches its caller, and no output file appears. Empty: nobody is told.
using Progress = std::function<void(std::uint64_t done, std::uint64_t total)>;

}  // namespace cob
