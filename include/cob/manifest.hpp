/// \file
/// manifest.json of a golden set: what it was made from, how, and a checksum for each file (SPEC section 7).
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

namespace cob {

/// One file of a set.
struct ManifestFile {
    std::uint64_t bytes = 0;
    std::string sha256;  ///< 64 lower-case hexadecimal digits.
};

/// The contents of manifest.json; everything sorted by name, so that the same contents give the same bytes.
struct Manifest {
    static constexpr int current_format = 1;

    int format = current_format;                    ///< Version of the set's format.
    std::map<std::string, std::string> parameters;  ///< Options of the command that made the set, as text.
    std::map<std::string, std::int64_t> counts;     ///< "boxes", "segments", ...
    std::map<std::string, ManifestFile> files;      ///< By name within the set; never manifest.json itself.
};

/// SHA-256 (FIPS 180-4) as 64 lower-case hexadecimal digits.
std::string sha256(std::string_view bytes);
/// Size and SHA-256 of a file, read in blocks. Throws InputError where it cannot be read.
ManifestFile describe_file(const std::string& path);

/// Throws InputError where the file cannot be read, is no manifest or is of another format.
Manifest read_manifest(const std::string& path);
/// That of a whole set; a folder without one holds none. Throws InputError.
Manifest read_set_manifest(const std::string& folder);
void write_manifest(const std::string& path, const Manifest& manifest);
/// Throws InputError at the first file of the manifest that is missing in the folder or differs from it.
void check_files(const std::string& folder, const Manifest& manifest);

}  // namespace cob
