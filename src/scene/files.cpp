#include "cob/files.hpp"

#include "cob/error.hpp"

#include <signal.h>
#include <unistd.h>
#include <cerrno>
#include <charconv>
#include <climits>
#include <cstring>
#include <filesystem>
#include <functional>
#include <limits>
#include <memory>
#include <system_error>

namespace cob {
namespace {

const std::string temporary_ending = ".tmp";  // then the number of the process that writes it

/// The name that a file is written under, but for the process's number. It has the hash of a name that leaves no room
/// for ending and number.
std::filesystem::path temporary_stem(const std::filesystem::path& path) {
    constexpr std::size_t most = NAME_MAX - std::numeric_limits<pid_t>::digits10 - 1;
    std::string name = path.filename().string();
    if (name.size() + temporary_ending.size() > most) name = "cob-" + std::to_string(std::hash<std::string>()(name));
    return path.parent_path() / (name + temporary_ending);
}

/// What processes that were killed have left of this file.
void remove_leftovers(const std::filesystem::path& path) {
    const std::string prefix = temporary_stem(path).filename().string();
    const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
    std::error_code ignored;
    for (std::filesystem::directory_iterator entry(folder, ignored), end; entry != end; entry.increment(ignored)) {
        const std::string name = entry->path().filename().string();
        pid_t process = 0;
        if (name.size() <= prefix.size() || name.compare(0, prefix.size(), prefix) != 0) continue;
        const char *const first = name.data() + prefix.size(), *const last = name.data() + name.size();
        const auto [stop, error] = std::from_chars(first, last, process);
        if (error != std::errc{} || stop != last || process <= 0) continue;
        if (::kill(process, 0) != 0 && errno == ESRCH) std::filesystem::remove(entry->path(), ignored);
    }
}

/// The file that a name stands for, links followed: a link stays a link. A device or a pipe would be replaced.
std::string ordinary_file(const std::string& path) {
    std::error_code unknown;
    const std::filesystem::file_status status = std::filesystem::status(path, unknown);
    if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
        throw InputError("cannot create", {path, 0, is_folder(path) ? "is a folder" : "is no ordinary file",
                                           "name a file that is new or may be replaced"});
    const std::filesystem::path target = std::filesystem::canonical(path, unknown);
    return unknown ? path : target.string();
}

}  // namespace

OutputFile::OutputFile(const std::string& path)
    : path_(ordinary_file(path)), temporary_(temporary_stem(path_).string() + std::to_string(::getpid())) {
    remove_leftovers(path_);
    file_ = std::fopen(temporary_.c_str(), "wb");
    if (!file_) fail("cannot create");
}

OutputFile::~OutputFile() {
    if (!file_) return;
    std::fclose(file_);
    std::remove(temporary_.c_str());
}

void OutputFile::write(std::string_view text) {
    if (std::fwrite(text.data(), 1, text.size(), file_) != text.size()) fail("cannot write");
}

void OutputFile::commit() {
    // A full disk may show only when the buffers are flushed, so all of these are checked before the rename.
    if (std::fflush(file_) != 0 || ::fsync(::fileno(file_)) != 0) fail("cannot write");
    std::FILE* file = file_;
    file_ = nullptr;
    if (std::fclose(file) != 0 || std::rename(temporary_.c_str(), path_.c_str()) != 0) fail("cannot write");
}

void OutputFile::fail(const char* what) {
    const std::string reason = std::strerror(errno);
    if (file_) std::fclose(file_);
    file_ = nullptr;
    std::remove(temporary_.c_str());
    throw InputError(what, {path_, 0, reason, "choose a folder that exists, is writable and has room"});
}

OutputFolder::OutputFolder(const std::string& path) {
    const std::filesystem::path whole = std::filesystem::path(path).lexically_normal();
    for (std::filesystem::path p = whole; !p.empty() && !exists(p.string()); p = p.parent_path())
        created_.push_back(p.string());
    try {
        create_folder(path);
        // Told now, not after the work.
        if (::access(path.c_str(), W_OK | X_OK) != 0)
            throw InputError("cannot write into folder", {path, 0, std::strerror(errno), "choose another"});
    } catch (...) {
        remove_created();
        throw;
    }
}

OutputFolder::~OutputFolder() {
    remove_created();
}

void OutputFolder::remove_created() {
    std::error_code not_empty;
    for (const std::string& path : created_) std::filesystem::remove(path, not_empty);
}

void write_file(const std::string& path, std::string_view text) {
    OutputFile file(path);
    file.write(text);
    file.commit();
}

void create_folder(const std::string& path) {
    std::error_code error;
    std::filesystem::create_directories(path, error);
    if (error) throw InputError("cannot create folder", {path, 0, error.message(), "choose another"});
    if (!is_folder(path)) throw InputError("cannot create folder", {path, 0, "is a file", "choose another"});
}

bool exists(const std::string& path) {
    std::error_code unknown;
    return std::filesystem::exists(path, unknown);
}

bool is_folder(const std::string& path) {
    std::error_code unknown;
    return std::filesystem::is_directory(path, unknown);
}

void read_blocks(const std::string& path, const std::function<void(std::string_view)>& sink) {
    struct Close {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };
    const bool folder = is_folder(path);
    const std::unique_ptr<std::FILE, Close> file(folder ? nullptr : std::fopen(path.c_str(), "rb"));
    if (!file)
        throw InputError("cannot open file",
                         {path, 0, folder ? "is a folder" : std::strerror(errno), "check the path"});
    std::vector<char> block(std::size_t{1} << 18);
    for (std::size_t n; (n = std::fread(block.data(), 1, block.size(), file.get())) > 0;) sink({block.data(), n});
    if (std::ferror(file.get()) != 0) throw InputError("cannot read file", {path, 0, "", "check the disk"});
}

std::string read_file(const std::string& path) {
    std::string text;
    read_blocks(path, [&](std::string_view block) { text += block; });
    return text;
}

}  // namespace cob
