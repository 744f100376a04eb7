/// \file
/// Output files that are written whole or not at all, and whole text files as input.
#pragma once

#include <cstdio>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace cob {

/// A file that appears under its name only when commit() succeeds: written beside it under a temporary name, then
/// renamed. Destroyed without commit(): the temporary is removed; of a process that was killed, by the next that writes
/// the same file. Of a link, the file that it leads to is replaced. Throws InputError (disk full, read-only, a folder,
/// a device or a pipe of that name, ...).
class OutputFile {
public:
    explicit OutputFile(const std::string& path);
    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    void write(std::string_view text);
    void commit();

private:
    void fail(const char* what);
    std::string path_, temporary_;
    std::FILE* file_ = nullptr;
};

/// A folder for results, created with its parents where it is missing. What it created and nothing was put into, it
/// removes when it ends: work that fails leaves no trace. Throws InputError where it cannot be created or written into.
class OutputFolder {
public:
    explicit OutputFolder(const std::string& path);
    ~OutputFolder();
    OutputFolder(const OutputFolder&) = delete;
    OutputFolder& operator=(const OutputFolder&) = delete;

private:
    void remove_created();
    std::vector<std::string> created_;  ///< Innermost first.
};

/// Writes one whole file at once.
void write_file(const std::string& path, std::string_view text);
/// Creates a folder and its parents; an existing one is fine.
void create_folder(const std::string& path);
/// False also where that cannot be told: of a name that is too long, or behind links in a circle.
bool exists(const std::string& path);
bool is_folder(const std::string& path);
/// Gives the bytes of a file to the sink, block by block. Throws InputError where it cannot be read.
void read_blocks(const std::string& path, const std::function<void(std::string_view)>& sink);
/// The bytes of a file; throws as read_blocks().
std::string read_file(const std::string& path);

}  // namespace cob
