/// \file
/// Runs the built program, as a user would.
#pragma once

#include "cob/files.hpp"
#include "temporary_folder.hpp"

#include <sys/wait.h>
#include <cstdlib>
#include <string>

namespace cob::test {

struct ProgramResult {
    int code = -1;  ///< Exit code.
    std::string out, error;
};

/// arguments as one would type them in a shell.
inline ProgramResult run_program(const std::string& arguments) {
    const TemporaryFolder folder;
    const std::string out = folder / "out", error = folder / "error";
    const int status = std::system((COB_PROGRAM " " + arguments + " >" + out + " 2>" + error).c_str());
    ProgramResult result;
    result.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    result.out = read_file(out);
    result.error = read_file(error);
    return result;
}

}  // namespace cob::test
