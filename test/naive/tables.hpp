/// \file
/// Just enough of SPEC 7 to answer a golden set with the twin: written apart from the library's readers, trusting
/// that the set is well formed.
#pragma once

#include "naive/box.hpp"
#include "naive/cases.hpp"

#include <string>
#include <utility>
#include <vector>

namespace cob::naive {

/// The faces of scene.obj with what its material library says of them. Throws std::runtime_error.
std::vector<Face> read_faces(const std::string& path);

/// A row of a table that asks.
struct BoxRow {
    std::string id;
    BoxQuestion question;
};
struct SegmentRow {
    std::string id;
    RationalPoint from, to;
};
/// Nothing where there is no such file.
std::vector<BoxRow> read_boxes(const std::string& path);
std::vector<SegmentRow> read_segments(const std::string& path);

}  // namespace cob::naive
