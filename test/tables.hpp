/// \file
/// Whole tables in memory.
#pragma once

#include "cob/tables.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace cob::test {

/// All rows of a table, or of the one of that kind in a folder.
template <class Row>
std::vector<Row> read_all(const std::string& path) {
    TableReader<Row> reader(std::filesystem::is_directory(path) ? path + "/" + table_name<Row>() : path);
    std::vector<Row> rows;
    for (Row row; reader.next(row);) rows.push_back(row);
    return rows;
}

}  // namespace cob::test
