#include "cob/manifest.hpp"

#include "cob/error.hpp"
#include "cob/files.hpp"
#include "golden/sha256.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>

namespace cob {
namespace {

constexpr const char* remake = "make the set anew with `cob golden`";

[[noreturn]] void refuse(const std::string& path, const std::string& problem, const std::string& value) {
    throw InputError(problem, {path, 0, value, remake});
}

}  // namespace

std::string sha256(std::string_view bytes) {
    Sha256 hash;
    hash.update(bytes);
    return hash.finish();
}

ManifestFile describe_file(const std::string& path) {
    ManifestFile result;
    Sha256 hash;
    read_blocks(path, [&](std::string_view block) {
        hash.update(block);
        result.bytes += block.size();
    });
    result.sha256 = hash.finish();
    return result;
}

Manifest read_set_manifest(const std::string& folder) {
    const std::string path = (std::filesystem::path(folder) / "manifest.json").string();
    if (!exists(path))
        throw InputError("no golden set, manifest.json is missing",
                         {folder, 0, "", "name the folder of a set that `cob golden` has finished"});
    return read_manifest(path);
}

Manifest read_manifest(const std::string& path) {
    const std::string text = read_file(path);
    Manifest manifest;
    try {
        const auto json = nlohmann::json::parse(text);
        manifest.format = json.at("format").get<int>();
        if (manifest.format != Manifest::current_format)
            throw InputError("unknown format version",
                             {path, 0, std::to_string(manifest.format), "use a version of cob that knows it"});
        json.at("parameters").get_to(manifest.parameters);
        json.at("counts").get_to(manifest.counts);
        for (const auto& [name, file] : json.at("files").items()) {
            // Names come from outside and are joined to the set's folder: nothing may lead out of it.
            if (name.empty() || name.find('/') != std::string::npos || name == "." || name == "..")
                refuse(path, "file name that is not plain", name);
            manifest.files[name] = {file.at("bytes").get<std::uint64_t>(), file.at("sha256").get<std::string>()};
        }
    } catch (const nlohmann::json::exception& error) {
        refuse(path, "no manifest of a golden set", error.what());
    }
    return manifest;
}

void write_manifest(const std::string& path, const Manifest& manifest) {
    nlohmann::json files = nlohmann::json::object();
    for (const auto& [name, file] : manifest.files) files[name] = {{"bytes", file.bytes}, {"sha256", file.sha256}};
    const nlohmann::json json = {{"format", manifest.format},
                                 {"parameters", manifest.parameters},
                                 {"counts", manifest.counts},
                                 {"files", files}};
    write_file(path, json.dump(2) + "\n");
}

void check_files(const std::string& folder, const Manifest& manifest) {
    for (const auto& [name, expected] : manifest.files) {
        const std::string path = (std::filesystem::path(folder) / name).string();
        if (!exists(path)) refuse(path, "file of the set is missing", "");
        const ManifestFile found = describe_file(path);
        if (found.bytes != expected.bytes)
            refuse(path, "size differs from the manifest's " + std::to_string(expected.bytes),
                   std::to_string(found.bytes));
        if (found.sha256 != expected.sha256) refuse(path, "SHA-256 differs from the manifest", found.sha256);
    }
}

}  // namespace cob
