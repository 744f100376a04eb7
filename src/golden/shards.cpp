#include "golden/shards.hpp"

#include "cob/error.hpp"
#include "cob/files.hpp"
#include "golden/sha256.hpp"

#include <tbb/parallel_for_each.h>
#include <unistd.h>
#include <cstdio>
#include <filesystem>

namespace cob {

namespace fs = std::filesystem;

namespace {

constexpr const char* manifest_name = "shard.json";

std::string name_of(std::uint64_t shard) {
    char name[32];
    std::snprintf(name, sizeof name, "%08llu", static_cast<unsigned long long>(shard));
    return name;
}

/// A folder that is removed unless it is renamed to its final name.
class TemporaryFolder {
public:
    explicit TemporaryFolder(std::string path)
        : path_(std::move(path)), temporary_(path_ + ".tmp" + std::to_string(::getpid())) {
        create_folder(temporary_);
    }
    ~TemporaryFolder() {
        std::error_code ignored;
        fs::remove_all(temporary_, ignored);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    std::string operator/(const std::string& name) const { return temporary_ + "/" + name; }
    void commit() {
        std::error_code error;
        fs::rename(temporary_, path_, error);
        // Another process may have finished the same shard meanwhile: with the same bytes.
        if (error && !exists(path_ + "/" + manifest_name))
            throw InputError("cannot write",
                             {path_, 0, error.message(), "choose a folder that is writable and has room"});
    }

private:
    std::string path_, temporary_;
};

/// A file that is described while it is written.
class DescribedFile {
public:
    explicit DescribedFile(const std::string& path) : file_(path) {}
    void write(std::string_view text) {
        file_.write(text);
        hash_.update(text);
        bytes_ += text.size();
    }
    ManifestFile commit() {
        file_.commit();
        return {bytes_, hash_.finish()};
    }

private:
    OutputFile file_;
    Sha256 hash_;
    std::uint64_t bytes_ = 0;
};

[[noreturn]] void refuse_damaged(const std::string& path, const std::string& why) {
    throw InputError("damaged shard", {path, 0, why, "remove this folder and run the same command again"});
}

}  // namespace

Shards::Shards(std::string folder, std::map<std::string, std::string> identity)
    : folder_(folder + "/shards"), identity_(std::move(identity)) {
    create_folder(folder_);
}

std::string Shards::path(std::uint64_t shard) const {
    return folder_ + "/" + name_of(shard);
}

bool Shards::has(std::uint64_t shard) const {
    const std::string folder = path(shard);
    if (!exists(folder)) return false;
    if (!exists(folder + "/" + manifest_name)) refuse_damaged(folder, "it has no manifest");
    const Manifest manifest = read_manifest(folder + "/" + manifest_name);
    if (manifest.parameters != identity_) {
        std::string differs;
        for (const auto& [name, value] : identity_) {
            const auto found = manifest.parameters.find(name);
            if (found == manifest.parameters.end() || found->second != value) differs = name;
        }
        throw InputError("shards of another set are here",
                         {folder, 0, differs.empty() ? "other parameters" : differs + " differs",
                          "repeat the command that began them, or choose another folder"});
    }
    for (const auto& [name, file] : manifest.files) {
        std::error_code error;
        const auto bytes = fs::file_size(folder + "/" + name, error);
        if (error) refuse_damaged(folder, name + " is missing");
        if (bytes != file.bytes) refuse_damaged(folder, name + " is truncated");
    }
    return true;
}

void Shards::put(std::uint64_t shard, const ShardTables& tables,
                 const std::map<std::string, std::int64_t>& counts) const {
    TemporaryFolder folder(path(shard));
    Manifest manifest;
    manifest.parameters = identity_;
    manifest.counts = counts;
    for (const auto& [name, text] : tables) manifest.files[name] = {};
    tbb::parallel_for_each(tables.begin(), tables.end(), [&](const auto& table) {
        const auto& [name, text] = table;
        write_file(folder / name, text);
        manifest.files.find(name)->second = {text.size(), sha256(text)};
    });
    write_manifest(folder / manifest_name, manifest);
    folder.commit();
}

void Shards::take_from(const std::string& set_folder, std::uint64_t count) const {
    Shards other = *this;
    other.folder_ = set_folder + "/shards";
    if (!is_folder(other.folder_))
        throw InputError("no shards to merge", {other.folder_, 0, "", "name the -o folder of a --shard run"});
    for (std::uint64_t shard = 0; shard < count; ++shard) {
        if (has(shard) || !other.has(shard)) continue;
        TemporaryFolder folder(path(shard));
        const Manifest manifest = other.check(shard);
        for (const auto& [name, file] : manifest.files)
            write_file(folder / name, read_file(other.path(shard) + "/" + name));
        write_manifest(folder / manifest_name, manifest);
        folder.commit();
    }
}

Manifest Shards::check(std::uint64_t shard) const {
    const std::string folder = path(shard);
    const Manifest manifest = read_manifest(folder + "/" + manifest_name);
    for (const auto& [name, file] : manifest.files)
        if (describe_file(folder + "/" + name).sha256 != file.sha256) refuse_damaged(folder, name + " was changed");
    return manifest;
}

std::optional<ManifestFile> Shards::merge(const std::string& table, const std::string& header, std::uint64_t count,
                                          const std::string& to) const {
    std::optional<DescribedFile> out;
    for (std::uint64_t shard = 0; shard < count; ++shard) {
        const std::string part = path(shard) + "/" + table;
        if (!exists(part)) continue;
        if (!out) out.emplace(to).write(header + "\n");
        read_blocks(part, [&](std::string_view block) { out->write(block); });
    }
    if (!out) return {};
    return out->commit();
}

}  // namespace cob
