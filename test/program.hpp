/// \file
/// Runs the built program, as a user would, and looks at what it wrote.
#pragma once

#include "cob/files.hpp"
#include "temporary_folder.hpp"

#include <sys/wait.h>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <set>
#include <string>

namespace cob::test {

struct ProgramResult {
    int code = -1;  ///< Exit code.
    std::string out, error;
};

/// A command as one would type it in a shell.
inline ProgramResult run_shell(const std::string& command) {
    const TemporaryFolder folder;
    const std::string out = folder / "out", error = folder / "error";
    const int status = std::system(("(" + command + ") >" + out + " 2>" + error).c_str());
    ProgramResult result;
    result.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    result.out = read_file(out);
    result.error = read_file(error);
    return result;
}

/// The program with these arguments, again as in a shell.
inline ProgramResult run_program(const std::string& arguments) {
    return run_shell(COB_PROGRAM " " + arguments);
}

/// Bytes of all files in a folder and in those inside it, by their paths from there.
inline std::map<std::string, std::string> bytes_of(const std::string& folder) {
    std::map<std::string, std::string> bytes;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
        if (entry.is_regular_file())
            bytes[std::filesystem::relative(entry.path(), folder).string()] = read_file(entry.path().string());
    return bytes;
}

/// Names in a folder; none where there is no folder.
inline std::set<std::string> files_in(const std::string& folder) {
    std::set<std::string> names;
    if (std::filesystem::exists(folder))
        for (const auto& entry : std::filesystem::directory_iterator(folder)) names.insert(entry.path().filename());
    return names;
}

}  // namespace cob::test
