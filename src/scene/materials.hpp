/// \file
/// Material libraries (MTL) beside an OBJ file.
#pragma once

#include "cob/scene.hpp"

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace cob {

/// The materials that the libraries of one OBJ file define, by name.
class MaterialLibrary {
public:
    /// The folder of `scene_file` is where libraries are sought.
    MaterialLibrary(std::string scene_file, const ReadOptions& options, ReadReport& report);

    /// What follows `mtllib`: one or more file names, which may contain blanks. Sought as they stand and by their
    /// last part beside the OBJ file; a file that does not exist is a warning.
    void read_libraries(std::string_view names);

    /// The text of one library; `path` is for messages.
    void read_text(std::string_view text, const std::string& path);

    /// Index into take(); grey and a warning, once, for a name that no library defines.
    std::int32_t find(std::string_view name);

    /// The first is grey and stands for faces without one.
    std::vector<Material> take() { return std::move(materials_); }

private:
    std::string existing_file(std::string_view name) const;

    std::string scene_file_;
    const ReadOptions& options_;
    ReadReport& report_;
    std::vector<Material> materials_{Material{}};
    std::map<std::string, std::int32_t, std::less<>> by_name_, by_name_without_comment_;
    std::set<std::string, std::less<>> files_, unknown_;
};

/// Counts a statement that is skipped; the number of different ones is kept small whatever the file is.
void count_skipped(ReadReport& report, std::string_view keyword);

}  // namespace cob
