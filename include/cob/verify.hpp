// Distributed under the Boost Software License, Version 1.0 (https://www.boost.org/LICENSE_1_0.txt).
/// \file
/// Checks code against a golden set (SPEC 7), in-process: hand over what decides a box and a polygon, and what decides
/// a segment, in plain doubles. Needs the standard library alone: neither the cob library nor CGAL.
///
///     const cob::verify::Set set = cob::verify::load_set("data/golden/cornell");
///     const auto report = cob::verify::check(set, my_relation, my_visibility);
///     std::cout << to_text(report);
///     return report.agree() ? 0 : 1;
///
/// my_relation(const Box&, const Polygon&) returns a Relation, or a bool: is it one of Options::hit?
/// my_visibility(const Segment&) returns a Visibility, or a bool: is it hidden? Either may be nullptr.
#pragma once

#include "cob/verify/compare.hpp"

#include <type_traits>

namespace cob::verify {

using Vector = std::array<double, 3>;

/// A row of boxes.csv: the box over an element (SPEC 4).
struct Box {
    std::int64_t id = 0;
    std::int64_t polygon = -1;  ///< The element's own polygon, which is not asked about; -1: none.
    int corner_count = 4;
    std::array<Vector, 4> corners{};  ///< Counter-clockwise about the normal.
    Vector u{};                       ///< Base-edge direction.
    double margin = 0, height = 0;    ///< Fractions: of each extent, of the shorter widened extent.
};

/// A row of segments.csv.
struct Segment {
    std::int64_t id = 0;
    Vector from{}, to{};
    std::int64_t from_polygon = -1, to_polygon = -1;  ///< That the ends lie on; -1: none, or not said.
};

/// A polygon of scene.obj and its pieces as triangles (none where the set has no triangles.csv).
struct Polygon {
    std::int64_t id = 0;
    std::vector<Vector> loop;
    std::vector<std::array<Vector, 3>> triangles;
};

/// The questions of a set are read when they are asked; the polygons are held here.
struct Set {
    std::string folder;
    std::vector<Polygon> polygons;  ///< By id.
};

/// Throws Error where the folder holds no set.
Set load_set(const std::string& folder);

namespace detail {

inline Vector vector_at(const Table& row, std::size_t column) {
    return {row.number(column), row.number(column + 1), row.number(column + 2)};
}

inline Box box_at(const Table& row) {
    Box box;
    box.id = row.integer(0), box.polygon = row.integer(1);
    const std::vector<std::size_t> columns = corner_columns(row);
    box.corner_count = static_cast<int>(columns.size());
    for (std::size_t k = 0; k < columns.size(); ++k) box.corners[k] = vector_at(row, columns[k]);
    box.u = vector_at(row, 14), box.margin = row.number(17), box.height = row.number(18);
    return box;
}

inline Segment segment_at(const Table& row) {
    Segment segment{row.integer(0), vector_at(row, 1), vector_at(row, 4), -1, -1};
    if (row.header() == 0) segment.from_polygon = row.integer(7), segment.to_polygon = row.integer(8);
    return segment;
}

struct Bounds {
    Vector low{HUGE_VAL, HUGE_VAL, HUGE_VAL}, high{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};

    void add(const Vector& point, double reach = 0) {
        for (std::size_t k = 0; k < 3; ++k)
            low[k] = std::min(low[k], point[k] - reach), high[k] = std::max(high[k], point[k] + reach);
    }
    bool meet(const Bounds& other) const {
        for (std::size_t k = 0; k < 3; ++k)
            if (low[k] > other.high[k] || other.low[k] > high[k]) return false;
        return true;
    }
};

/// Contains the box, generously: every point of it is within (1 + 2 margin)(1 + height) diagonals of a corner.
inline Bounds bounds_of(const Box& box) {
    Bounds element, bounds;
    for (int k = 0; k < box.corner_count; ++k) element.add(box.corners[static_cast<std::size_t>(k)]);
    double squares = 0;
    for (std::size_t k = 0; k < 3; ++k) squares += std::pow(element.high[k] - element.low[k], 2);
    for (int k = 0; k < box.corner_count; ++k)
        bounds.add(box.corners[static_cast<std::size_t>(k)],
                   std::sqrt(squares) * (1 + 2 * box.margin) * (1 + box.height));
    return bounds;
}

/// A callable's answer as a column of the confusion matrix.
inline std::size_t column_of(bool answer) {
    return answer ? 1 : 0;
}
inline std::size_t column_of(Relation answer) {
    return static_cast<std::size_t>(answer);
}
inline std::size_t column_of(Visibility answer) {
    return static_cast<std::size_t>(answer);
}

template <class Relate>
void check_boxes(const Set& set, Relate&& relate, const Options& options, Report& report) {
    constexpr bool yes_no = std::is_same_v<std::decay_t<decltype(relate(Box{}, Polygon{}))>, bool>;
    const std::vector<std::string>& columns = yes_no ? yes_no_names() : relation_names();
    report.tables.push_back({"relations", true, {}, {}, {}});
    Recorder recorder(report.tables.back(), report.first, options, relation_names(), columns);

    std::vector<Bounds> bounds(set.polygons.size());
    for (std::size_t k = 0; k < bounds.size(); ++k)
        for (const Vector& point : set.polygons[k].loop) bounds[k].add(point);

    Tags tags(set.folder, "box");
    Cursor exact(set.folder + "/relations.csv", {relations_header});
    std::map<std::int64_t, std::size_t> listed;
    for (Cursor row(set.folder + "/boxes.csv", {boxes_header}); row.at_row(); row.step()) {
        const Box box = box_at(row.row());
        const Question question{box.id, tags.of(box.id), &row.row()};
        listed.clear();
        for (; exact.at(box.id); exact.step()) listed[exact.row().integer(1)] = exact.row().word(2, relation_names());
        const Bounds reach = bounds_of(box);
        for (std::size_t k = 0; k < bounds.size(); ++k) {
            const Polygon& polygon = set.polygons[k];
            const auto found = listed.find(polygon.id);
            if (polygon.id == box.polygon || (found == listed.end() && !bounds[k].meet(reach))) continue;
            const std::size_t truth = found == listed.end() ? 0 : found->second;
            const std::size_t answer = column_of(relate(box, polygon));
            const std::size_t wanted = yes_no ? column_of(is_hit(options, truth)) : truth;
            recorder.compared(question, polygon.id, truth, answer,
                              answer == wanted ? ""
                              : yes_no         ? "close"
                                               : "relation",
                              relation_names()[truth], columns[answer]);
        }
    }
}

template <class See>
void check_segments(const Set& set, See&& see, const Options& options, Report& report) {
    constexpr bool yes_no = std::is_same_v<std::decay_t<decltype(see(Segment{}))>, bool>;
    const std::vector<std::string>& columns = yes_no ? yes_no_names() : visibility_names();
    report.tables.push_back({"visibility", true, {}, {}, {}});
    Recorder recorder(report.tables.back(), report.first, options, visibility_names(), columns);

    Tags tags(set.folder, "segment");
    Cursor exact(set.folder + "/visibility.csv", {visibility_header});
    for (Cursor row(set.folder + "/segments.csv", segments_headers); row.at_row(); row.step(), exact.step()) {
        const Segment segment = segment_at(row.row());
        if (!exact.at(segment.id))
            throw Error(exact.row().path() + ": no answer to segment " + std::to_string(segment.id));
        const std::size_t truth = exact.row().word(1, visibility_names());
        const std::size_t answer = column_of(see(segment));
        const bool free = truth == column_of(Visibility::grazing) && !options.strict;
        const std::size_t wanted = yes_no ? column_of(truth == column_of(Visibility::blocked)) : truth;
        recorder.compared({segment.id, tags.of(segment.id), &row.row()}, -1, truth, answer,
                          free || answer == wanted ? ""
                          : yes_no                 ? "hidden"
                                                   : "visibility",
                          visibility_names()[truth], columns[answer]);
    }
}

}  // namespace detail

/// Asks every question of the set: each box about every polygon near it, each segment once. Throws Error.
template <class Relate, class See>
Report check(const Set& set, Relate&& relate, See&& see, const Options& options = {}) {
    Report report;
    report.tables.reserve(2);
    if constexpr (!std::is_same_v<std::decay_t<Relate>, std::nullptr_t>)
        if (Table::exists(set.folder + "/boxes.csv")) detail::check_boxes(set, relate, options, report);
    if constexpr (!std::is_same_v<std::decay_t<See>, std::nullptr_t>)
        if (Table::exists(set.folder + "/segments.csv")) detail::check_segments(set, see, options, report);
    return report;
}

inline Set load_set(const std::string& folder) {
    Set set{folder, {}};
    std::ifstream file(folder + "/scene.obj");
    if (!file) throw Error(folder + "/scene.obj: cannot open file: is this a golden set?");
    std::vector<Vector> positions;
    std::size_t number = 0;
    for (std::string line; std::getline(file, line);) {
        ++number;
        const auto fail = [&](const char* problem) {
            throw Error(folder + "/scene.obj:" + std::to_string(number) + ": " + problem + " '" + line + "'");
        };
        // Words of the line: statement, then operands.
        std::vector<std::string_view> words;
        for (std::size_t begin = 0; (begin = line.find_first_not_of(" \t\r", begin)) != std::string::npos;) {
            const std::size_t end = std::min(line.find_first_of(" \t\r", begin), line.size());
            words.push_back(std::string_view(line).substr(begin, end - begin));
            begin = end;
        }
        if (words.empty()) continue;
        if (words[0] == "v") {
            Vector point{};
            for (std::size_t k = 0; k < 3; ++k) {
                const auto value = k + 1 < words.size() ? parse_number(words[k + 1]) : std::nullopt;
                if (!value) fail("bad vertex");
                point[k] = *value;
            }
            positions.push_back(point);
        } else if (words[0] == "f") {
            Polygon polygon{static_cast<std::int64_t>(set.polygons.size()), {}, {}};
            for (std::size_t k = 1; k < words.size(); ++k) {
                long long index = 0;
                std::from_chars(words[k].data(), words[k].data() + words[k].size(), index);
                if (index < 0) index += static_cast<long long>(positions.size()) + 1;
                if (index < 1 || index > static_cast<long long>(positions.size())) fail("bad index in face");
                polygon.loop.push_back(positions[static_cast<std::size_t>(index - 1)]);
            }
            set.polygons.push_back(std::move(polygon));
        }
    }
    if (!Table::exists(folder + "/triangles.csv")) return set;
    Cursor row(folder + "/triangles.csv", {"triangle,polygon,x0,y0,z0,x1,y1,z1,x2,y2,z2"});
    for (; row.at_row(); row.step()) {
        const std::int64_t polygon = row.row().integer(1);
        if (polygon < 0 || polygon >= static_cast<std::int64_t>(set.polygons.size()))
            row.row().fail("no such polygon", std::string(row.row().field(1)), "make the set anew");
        set.polygons[static_cast<std::size_t>(polygon)].triangles.push_back(
            {detail::vector_at(row.row(), 2), detail::vector_at(row.row(), 5), detail::vector_at(row.row(), 8)});
    }
    return set;
}

}  // namespace cob::verify
