/// \file
/// The parts of a golden set under way: FOLDER/shards/NUMBER, each a folder that appears under its name only when it
/// is whole (written beside it, then renamed), with a manifest of its own.
#pragma once

#include "cob/manifest.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <string>

namespace cob {

/// Rows of one shard, without headers: text by table name.
using ShardTables = std::map<std::string, std::string>;

class Shards {
public:
    /// The identity says what the shards belong to: parameters, scene, shard size. Creates the folder.
    Shards(std::string folder, std::map<std::string, std::string> identity);

    /// Whether the shard is there. Throws InputError where it was made otherwise, or is truncated.
    bool has(std::uint64_t shard) const;
    /// Appears at once and whole, or not at all. Throws InputError (disk full, ...).
    void put(std::uint64_t shard, const ShardTables& tables, const std::map<std::string, std::int64_t>& counts) const;
    /// Takes over what another folder has finished and this one has not.
    void take_from(const std::string& set_folder, std::uint64_t count) const;

    const std::string& folder() const { return folder_; }

    /// Checks every byte of a shard. Throws InputError.
    Manifest check(std::uint64_t shard) const;
    /// Joins one table of all shards that have it under its header; nothing where none has it.
    std::optional<ManifestFile> merge(const std::string& table, const std::string& header, std::uint64_t count,
                                      const std::string& to) const;

private:
    std::string path(std::uint64_t shard) const;

    std::string folder_;
    std::map<std::string, std::string> identity_;
};

}  // namespace cob
