/// \file
/// How each kind of row stands in its table (SPEC 7 and 8): names, columns, order, text.
#pragma once

#include "cob/tables.hpp"
#include "golden/line_reader.hpp"

#include <array>
#include <string>
#include <string_view>

namespace cob {

/// Rows ascend by this; the second is 0 where one id is enough.
using RowKey = std::array<std::int64_t, 2>;

/// For each Row: `name`, `headers` (the one that is written last), parse(), append() and key(). A codec belongs to
/// one reader: it may keep what often repeats from row to row.
template <class Row>
struct RowCodec;

template <>
struct RowCodec<BoxRow> {
    static constexpr const char* name = "boxes.csv";
    static constexpr std::array<std::string_view, 1> headers = {
        "box,polygon,x0,y0,z0,x1,y1,z1,x2,y2,z2,x3,y3,z3,ux,uy,uz,margin,height"};
    void parse(Fields& fields, BoxRow& row);
    static void append(std::string& text, const BoxRow& row);
    static RowKey key(const BoxRow& row) { return {row.box, 0}; }

private:
    std::string last_frame_;  ///< Text of u, margin and height of the last row, and their values.
    BoxQuestion last_;
};

template <>
struct RowCodec<SegmentRow> {
    static constexpr const char* name = "segments.csv";
    static constexpr std::array<std::string_view, 2> headers = {"segment,x0,y0,z0,x1,y1,z1",
                                                                "segment,x0,y0,z0,x1,y1,z1,from,to"};
    static void parse(Fields& fields, SegmentRow& row);
    static void append(std::string& text, const SegmentRow& row);
    static RowKey key(const SegmentRow& row) { return {row.segment, 0}; }
};

template <>
struct RowCodec<TriangleRow> {
    static constexpr const char* name = "triangles.csv";
    static constexpr std::array<std::string_view, 1> headers = {"triangle,polygon,x0,y0,z0,x1,y1,z1,x2,y2,z2"};
    static void parse(Fields& fields, TriangleRow& row);
    static void append(std::string& text, const TriangleRow& row);
    static RowKey key(const TriangleRow& row) { return {row.triangle, 0}; }
};

template <>
struct RowCodec<PointRow> {
    static constexpr const char* name = "points.csv";
    static constexpr std::array<std::string_view, 1> headers = {"point,x,y,z,nx,ny,nz"};
    static void parse(Fields& fields, PointRow& row);
    static void append(std::string& text, const PointRow& row);
    static RowKey key(const PointRow& row) { return {row.point, 0}; }
};

template <>
struct RowCodec<TagRow> {
    static constexpr const char* name = "tags.csv";
    static constexpr std::array<std::string_view, 1> headers = {"question,id,kind,band"};
    static void parse(Fields& fields, TagRow& row);
    static void append(std::string& text, const TagRow& row);
    static RowKey key(const TagRow& row) { return {static_cast<std::int64_t>(row.question), row.id}; }
};

template <>
struct RowCodec<StateRow> {
    static constexpr const char* name = "states.csv";
    static constexpr std::array<std::string_view, 1> headers = {"box,state,close,cover,light"};
    static void parse(Fields& fields, StateRow& row);
    static void append(std::string& text, const StateRow& row);
    static RowKey key(const StateRow& row) { return {row.box, 0}; }
};

template <>
struct RowCodec<RelationRow> {
    static constexpr const char* name = "relations.csv";
    static constexpr std::array<std::string_view, 1> headers = {"box,polygon,relation,covers,shared"};
    static void parse(Fields& fields, RelationRow& row);
    static void append(std::string& text, const RelationRow& row);
    static RowKey key(const RelationRow& row) { return {row.box, row.polygon}; }
};

template <>
struct RowCodec<VisibilityRow> {
    static constexpr const char* name = "visibility.csv";
    static constexpr std::array<std::string_view, 1> headers = {"segment,visibility"};
    static void parse(Fields& fields, VisibilityRow& row);
    static void append(std::string& text, const VisibilityRow& row);
    static RowKey key(const VisibilityRow& row) { return {row.segment, 0}; }
};

template <>
struct RowCodec<IrradianceRow> {
    static constexpr const char* name = "irradiance.csv";
    static constexpr std::array<std::string_view, 1> headers = {"point,light,unobstructed,visible,r,g,b"};
    static void parse(Fields& fields, IrradianceRow& row);
    static void append(std::string& text, const IrradianceRow& row);
    static RowKey key(const IrradianceRow& row) { return {row.point, row.light}; }
};

template <>
struct RowCodec<FormFactorRow> {
    static constexpr const char* name = "formfactors.csv";
    static constexpr std::array<std::string_view, 1> headers = {"from,to,form_factor,error"};
    static void parse(Fields& fields, FormFactorRow& row);
    static void append(std::string& text, const FormFactorRow& row);
    static RowKey key(const FormFactorRow& row) { return {row.from, row.to}; }
};

}  // namespace cob
