#include "golden/row_codecs.hpp"

#include <algorithm>
#include <charconv>

namespace cob {
namespace {

const char* to_text(TagRow::Question question) {
    return question == TagRow::Question::box ? "box" : "segment";
}

constexpr const char* undecided = "undecided";

/// One of the words of an enumeration, from `first` to `last`.
template <class Enum>
Enum parse_word(Fields& fields, Enum first, Enum last) {
    const std::string_view field = fields.text();
    std::string all;
    for (int k = static_cast<int>(first); k <= static_cast<int>(last); ++k) {
        const Enum value = static_cast<Enum>(k);
        if (field == to_text(value)) return value;
        all += (all.empty() ? "" : ", ") + std::string(to_text(value));
    }
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
    text += ',' + cob::to_text(row.question.margin) + ',' + cob::to_text(row.question.height);
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
    row.question = parse_word(fields, TagRow::Question::box, TagRow::Question::segment);
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
    text += to_text(row.question);
    text += ',';
    append_integer(text, row.id);
    text += ',' + row.kind + ',';
    append_integer(text, row.band);
}

// -------------------------------------------------------------------------------------------------- answers

void RowCodec<StateRow>::parse(Fields& fields, StateRow& row) {
    row.box = fields.id();
    row.decided = !fields.take_undecided();
    row.state = row.decided ? parse_word(fields, BufferState::empty, BufferState::occluded) : BufferState::empty;
    fields.polygons(row.close);
    fields.polygons(row.cover);
    fields.polygons(row.light);
}

void RowCodec<StateRow>::append(std::string& text, const StateRow& row) {
    append_integer(text, row.box);
    text += ',';
    text += row.decided ? to_text(row.state) : undecided;
    for (const auto* list : {&row.close, &row.cover, &row.light}) {
        text += ',';
        append_list(text, *list);
    }
}

void RowCodec<RelationRow>::parse(Fields& fields, RelationRow& row) {
    row.box = fields.id();
    row.polygon = fields.polygon();
    row.decided = !fields.take_undecided();
    row.relation = row.decided ? parse_word(fields, Relation::disjoint, Relation::crossing) : Relation::disjoint;
    row.covers = fields.flag();
    row.shared = parse_word(fields, Shared::none, Shared::edge);
}

void RowCodec<RelationRow>::append(std::string& text, const RelationRow& row) {
    append_integer(text, row.box);
    text += ',';
    append_integer(text, row.polygon);
    text += ',';
    text += row.decided ? to_text(row.relation) : undecided;
    text += row.covers ? ",1," : ",0,";
    text += to_text(row.shared);
}

void RowCodec<VisibilityRow>::parse(Fields& fields, VisibilityRow& row) {
    row.segment = fields.id();
    row.decided = !fields.take_undecided();
    row.visibility = row.decided ? parse_word(fields, Visibility::clear, Visibility::blocked) : Visibility::clear;
}

void RowCodec<VisibilityRow>::append(std::string& text, const VisibilityRow& row) {
    append_integer(text, row.segment);
    text += ',';
    text += row.decided ? to_text(row.visibility) : undecided;
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
