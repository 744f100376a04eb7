// Manifests: any bytes as manifest.json. What it accepts names only files of the set's own folder.
#include "cob/manifest.hpp"
#include "fuzz/target.hpp"
#include "temporary_folder.hpp"

namespace cob::fuzz {
namespace {

std::string read(std::string_view text) {
    static const test::TemporaryFolder folder;
    const std::string path = folder / "manifest.json";
    write_anew(path, text);
    const Manifest manifest = read_manifest(path);
    require(manifest.format == Manifest::current_format, "other formats are refused");
    for (const auto& [name, file] : manifest.files)
        require(!name.empty() && name != ".." && name.find('/') == name.npos, "names stay in the folder");
    return "manifests";
}

}  // namespace

Target target() {
    return {{R"({"format": 1, "parameters": {"level": "3", "seed": "1"}, "counts": {"boxes": 108, "state empty": 30},
 "files": {"boxes.csv": {"bytes": 10369, "sha256": "05edfe37"}, "scene.obj": {"bytes": 747, "sha256": "71df07d6"}}})",
             R"({"format":1,"parameters":{},"counts":{},"files":{}})"},
            {"{", "}", "[", "\"", ":", ",", "null", "-1", "1e400", "18446744073709551616", "\"..\"", "a/b", "../",
             "\\u0000", "\"format\": 1,", "\"files\": {}", " ", "\xff"},
            {"manifests", "refused"},
            6000,
            read};
}

}  // namespace cob::fuzz
