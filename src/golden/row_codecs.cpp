#include "golden/row_codecs.hpp"

#include <algorithm>
#include <charconv>

namespace cob {
namespace {

constexpr std::array<const char*, 4> state_names = {"uninitialised", "empty", "close", "occluded"};
constexpr std::array<const char*, 5> relation_names = {"disjoint", "base", "coplanar", "boundary", "crossing"};
constexpr std::array<const char*, 3> shared_names = {"none", "vertex", "edge"};
constexpr std::array<const char*, 3> visibility_names = {"clear", "grazing", "blocked"};
constexpr std::array<const char*, 2> question_names = {"box", "segment"};

template <class Enum, std::size_t N>
void append_name(std::string& text, const std::array<const char*, N>& names, Enum value, bool decided = true) {
    text += decided ? names[static_cast<std::size_t>(value)] : "undecided";
}

/// One of the names from the first-th on.
template <class Enum, std::size_t N>
Enum parse_name(Fields& fields, const std::array<const char*, N>& names, std::size_t first = 0) {
    const std::string_view field = fields.text();
    for (std::size_t k = first; k < N; ++k)
        if (field == names[k]) return static_cast<Enum>(k);
    std::string all;
    for (std::size_t k = first; k < N; ++k) all += (k > first ? ", " : "") + std::string(names[k]);
    fields.refuse("unknown word", field, "write one of " + all);
}

void append_integer(std::string& text, std::int64_t value) {
    char digits[24];
    text.append(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
}

void append_list(std::string& text, const std::vector<PolygonId>& ids) {
    for (std::size_t k = 0; k < ids.size(); ++k) {
        if (k > 0) text += ' ';
        append_integer(text, ids[k]);
    }
}

}  // namespace

// ------------------------------------------------------------------------------------------------ questions

void RowCodec<BoxRow>::parse(Fields& fields, BoxRow& row) {
    row.box = fields.id();
    row.question.polygon = fields.polygon_or_none();
    Corners& corners = row.question.corners;
    for (std::size_t k = 0; k < 3; ++k) corners.points[k] = fields.exact_point();
    corners.count = fields.next_is_empty() ? 3 : 4;
    if (corners.count == 4) {
        corners.points[3] = fields.exact_point();
    } else {
        corners.points[3] = ExactPoint();
        for (int k = 0; k < 3; ++k)
            if (const auto field = fields.text(); !field.empty())
                fields.refuse("triangle with a part of a fourth corner", field, "give x3, y3 and z3 all or none");
    }
    // All elements of a root share u, and usually all boxes share margin and height: fractions are slow to make.
    const std::string_view frame = fields.rest();
    if (last_frame_.empty() || frame != last_frame_) {
        const std::string text(frame);
        last_frame_.clear();
        last_.u = fields.exact_point();
        last_.margin = fields.exact_rational();
        last_.height = fields.exact_rational();
        fields.expect_end();
        last_frame_ = text;
    } else {
        for (int k = 0; k < 5; ++k) fields.text();
    }
    row.question.u = last_.u;
    row.question.margin = last_.margin;
    row.question.height = last_.height;
}

void RowCodec<BoxRow>::append(std::string& text, const BoxRow& row) {
    append_integer(text, row.box);
    text += ',';
    append_integer(text, row.question.polygon);
    const Corners& corners = row.question.corners;
    for (int k = 0; k < corners.count; ++k) {
        text += ',';
        append_point(text, corners.points[static_cast<std::size_t>(k)]);
    }
    if (corners.count == 3) text += ",,,";
    text += ',';
    append_point(text, row.question.u);
    text += ',' + to_text(row.question.margin) + ',' + to_text(row.question.height);
}

void RowCodec<SegmentRow>::parse(Fields& fields, SegmentRow& row) {
    row.segment = fields.id();
    row.from = fields.exact_point();
    row.to = fields.exact_point();
    const bool hints = !fields.ended();
    row.from_polygon = hints ? fields.polygon_or_none() : no_polygon;
    row.to_polygon = hints ? fields.polygon_or_none() : no_polygon;
}

void RowCodec<SegmentRow>::append(std::string& text, const SegmentRow& row) {
    append_integer(text, row.segment);
    for (const ExactPoint* end : {&row.from, &row.to}) {
        text += ',';
        append_point(text, *end);
    }
    for (const PolygonId polygon : {row.from_polygon, row.to_polygon}) {
        text += ',';
        append_integer(text, polygon);
    }
}

void RowCodec<TriangleRow>::parse(Fields& fields, TriangleRow& row) {
    row.triangle = fields.id();
    row.polygon = fields.polygon();
    for (Point& corner : row.corners) corner = fields.point();
}

void RowCodec<TriangleRow>::append(std::string& text, const TriangleRow& row) {
    append_integer(text, row.triangle);
    text += ',';
    append_integer(text, row.polygon);
    for (const Point& corner : row.corners) {
        text += ',';
        append_point(text, corner);
    }
}

void RowCodec<PointRow>::parse(Fields& fields, PointRow& row) {
    row.point = fields.id();
    row.position = fields.exact_point();
    row.normal = fields.exact_point();
}

void RowCodec<PointRow>::append(std::string& text, const PointRow& row) {
    append_integer(text, row.point);
    for (const ExactPoint* point : {&row.position, &row.normal}) {
        text += ',';
        append_point(text, *point);
    }
}

void RowCodec<TagRow>::parse(Fields& fields, TagRow& row) {
    row.question = parse_name<TagRow::Question>(fields, question_names);
    row.id = fields.id();
    row.kind = fields.text();
    const auto plain = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_' ||
               c == '.';
    };
    if (row.kind.empty() || !std::all_of(row.kind.begin(), row.kind.end(), plain))
        fields.refuse("not one word", row.kind, "use letters, digits, '-', '_' and '.'");
    row.band = static_cast<int>(fields.integer(0, 52));
}

void RowCodec<TagRow>::append(std::string& text, const TagRow& row) {
    append_name(text, question_names, row.question);
    text += ',';
    append_integer(text, row.id);
    text += ',' + row.kind + ',';
    append_integer(text, row.band);
}

// -------------------------------------------------------------------------------------------------- answers

void RowCodec<StateRow>::parse(Fields& fields, StateRow& row) {
    row.box = fields.id();
    row.decided = !fields.take_undecided();
    row.state = row.decided ? parse_name<BufferState>(fields, state_names, 1) : BufferState::empty;
    fields.polygons(row.close);
    fields.polygons(row.cover);
    fields.polygons(row.light);
}

void RowCodec<StateRow>::append(std::string& text, const StateRow& row) {
    append_integer(text, row.box);
    text += ',';
    append_name(text, state_names, row.state, row.decided);
    for (const auto* list : {&row.close, &row.cover, &row.light}) {
        text += ',';
        append_list(text, *list);
    }
}

void RowCodec<RelationRow>::parse(Fields& fields, RelationRow& row) {
    row.box = fields.id();
    row.polygon = fields.polygon();
    row.decided = !fields.take_undecided();
    row.relation = row.decided ? parse_name<Relation>(fields, relation_names) : Relation::disjoint;
    row.covers = fields.flag();
    row.shared = parse_name<Shared>(fields, shared_names);
}

void RowCodec<RelationRow>::append(std::string& text, const RelationRow& row) {
    append_integer(text, row.box);
    text += ',';
    append_integer(text, row.polygon);
    text += ',';
    append_name(text, relation_names, row.relation, row.decided);
    text += row.covers ? ",1," : ",0,";
    append_name(text, shared_names, row.shared);
}

void RowCodec<VisibilityRow>::parse(Fields& fields, VisibilityRow& row) {
    row.segment = fields.id();
    row.decided = !fields.take_undecided();
    row.visibility = row.decided ? parse_name<Visibility>(fields, visibility_names) : Visibility::clear;
}

void RowCodec<VisibilityRow>::append(std::string& text, const VisibilityRow& row) {
    append_integer(text, row.segment);
    text += ',';
    append_name(text, visibility_names, row.visibility, row.decided);
}

void RowCodec<IrradianceRow>::parse(Fields& fields, IrradianceRow& row) {
    row.point = fields.id();
    row.light = fields.polygon();
    for (double* value : {&row.unobstructed, &row.visible, &row.irradiance[0], &row.irradiance[1], &row.irradiance[2]})
        *value = fields.number();
}

void RowCodec<IrradianceRow>::append(std::string& text, const IrradianceRow& row) {
    append_integer(text, row.point);
    text += ',';
    append_integer(text, row.light);
    for (const double value :
         {row.unobstructed, row.visible, row.irradiance[0], row.irradiance[1], row.irradiance[2]}) {
        text += ',';
        append_number(text, value);
    }
}

void RowCodec<FormFactorRow>::parse(Fields& fields, FormFactorRow& row) {
    row.from = fields.polygon();
    row.to = fields.polygon();
    row.form_factor = fields.number();
    row.error = fields.number();
}

void RowCodec<FormFactorRow>::append(std::string& text, const FormFactorRow& row) {
    append_integer(text, row.from);
    text += ',';
    append_integer(text, row.to);
    for (const double value : {row.form_factor, row.error}) {
        text += ',';
        append_number(text, value);
    }
}

}  // namespace cob
