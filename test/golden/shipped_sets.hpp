/// \file
/// The golden sets in data/golden.
#pragma once

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

namespace cob::test {

/// Their folders, by name.
inline std::vector<std::string> shipped_sets() {
    std::vector<std::string> sets;
    for (const auto& entry : std::filesystem::directory_iterator(COB_DATA "/golden"))
        if (entry.is_directory()) sets.push_back(entry.path().string());
    std::sort(sets.begin(), sets.end());
    return sets;
}

}  // namespace cob::test
