/// \file
/// Reading and writing the tables of golden sets (SPEC sections 7 and 8), row by row, in bounded memory.
///
/// Reading is strict: the header is exactly one of SPEC's, every row has as many fields as it, every number is
/// wholly a number and finite, ids ascend, and every line, the last one too, ends (in LF or CRLF). Anything else
/// throws InputError with file, line, value and remedy. Writing ends lines in LF; numbers are shortest round-trip
/// decimals or, where one is no binary64 number, fractions p/q in lowest terms, so reading gives back the row.
#pragma once

#include "cob/arithmetic.hpp"
#include "cob/buffer.hpp"
#include "cob/geometry.hpp"
#include "cob/visibility.hpp"

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace cob {

using RowId = std::int64_t;  ///< Id of a question: a box, segment, triangle or point; >= 0.

// ------------------------------------------------------------------------------------------------ questions

/// boxes.csv: `box,polygon,x0,y0,z0,x1,y1,z1,x2,y2,z2,x3,y3,z3,ux,uy,uz,margin,height`.
struct BoxRow {
    RowId box = 0;
    BoxQuestion question;  ///< As it stands there: whether SPEC 4 refuses it is Box's to say.
    std::size_t line = 0;  ///< Where it was read, from 1; not written.
};

/// segments.csv: `segment,x0,y0,z0,x1,y1,z1`, then optionally `from,to`.
struct SegmentRow {
    RowId segment = 0;
    ExactPoint from, to;
    PolygonId from_polygon = no_polygon;  ///< Said to hold the end; no_polygon: none, or no such column.
    PolygonId to_polygon = no_polygon;
    std::size_t line = 0;  ///< Where it was read, from 1; not written.
};

/// triangles.csv: `triangle,polygon,x0,...,z2`.
struct TriangleRow {
    RowId triangle = 0;
    PolygonId polygon = no_polygon;
    std::array<Point, 3> corners;
};

/// points.csv: `point,x,y,z,nx,ny,nz`.
struct PointRow {
    RowId point = 0;
    ExactPoint position;
    ExactPoint normal;     ///< Any length.
    std::size_t line = 0;  ///< Where it was read, from 1; not written.
};

/// tags.csv: `question,id,kind,band`; box questions first, then ascending by id.
struct TagRow {
    enum class Question : std::uint8_t { box, segment };
    Question question = Question::box;
    RowId id = 0;
    std::string kind;  ///< One word of letters, digits, '-', '_' and '.'.
    int band = 0;      ///< 0 to 52.
};

// -------------------------------------------------------------------------------------------------- answers

/// states.csv: `box,state,close,cover,light`; the lists ascend and are separated by spaces.
struct StateRow {
    RowId box = 0;
    BufferState state = BufferState::empty;  ///< Never uninitialised.
    std::vector<PolygonId> close;            ///< None where occluded.
    std::vector<PolygonId> cover;            ///< Those that cover the element.
    std::vector<PolygonId> light;            ///< Close lights that face it.
    bool decided = true;                     ///< False: `undecided` stands for the state (interval arithmetic).
};

/// relations.csv: `box,polygon,relation,covers,shared`; ascending by box, then polygon.
struct RelationRow {
    RowId box = 0;
    PolygonId polygon = 0;
    Relation relation = Relation::crossing;
    bool covers = false;
    Shared shared = Shared::none;
    bool decided = true;  ///< False: `undecided` stands for the relation (interval arithmetic).
};

/// visibility.csv: `segment,visibility`.
struct VisibilityRow {
    RowId segment = 0;
    Visibility visibility = Visibility::clear;
    bool decided = true;  ///< False: `undecided` stands for the visibility (interval arithmetic).
};

/// irradiance.csv: `point,light,unobstructed,visible,r,g,b`; ascending by point, then light.
struct IrradianceRow {
    RowId point = 0;
    PolygonId light = 0;
    double unobstructed = 0, visible = 0;       ///< Form factors from the point, in [0, 1].
    std::array<double, 3> irradiance{0, 0, 0};  ///< W/m2.
};

/// formfactors.csv: `from,to,form_factor,error`; ascending by from, then to.
struct FormFactorRow {
    PolygonId from = 0, to = 0;
    double form_factor = 0, error = 0;
};

// ---------------------------------------------------------------------------------------- readers and writers

/// How strict to be; a set's own tables are read with the defaults, the answers of a variant under test may be less.
struct TableReadOptions {
    bool ordered = true;     ///< Refuse rows out of order and doubled ids; false: the caller looks after both.
    bool undecided = false;  ///< Accept the word `undecided` for a state, relation or visibility.
};

/// Reads one table. Row is one of the structs above.
template <class Row>
class TableReader {
public:
    /// Opens the table and checks its header.
    explicit TableReader(const std::string& path, TableReadOptions options = {});
    ~TableReader();
    TableReader(TableReader&&) noexcept;

    /// The next row; false at the end of the table. Reuses the row's storage.
    bool next(Row& row);

private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

/// Writes one table, which appears under its name only on commit(). The caller gives the rows in order.
template <class Row>
class TableWriter {
public:
    /// Creates the (temporary) file and writes the header; segments get the columns from and to.
    explicit TableWriter(const std::string& path);
    ~TableWriter();
    TableWriter(TableWriter&&) noexcept;

    void write(const Row& row);
    /// Lines made by append_row(): what several threads made is written in the order of the calls.
    void write_lines(std::string_view lines);
    void commit();
    /// Rows given to write() so far, and lines given to write_lines().
    std::uint64_t rows() const;

private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

/// Appends the row as one line, LF included. Threads may do so at the same time.
template <class Row>
void append_row(std::string& text, const Row& row);

/// Name of the table in a set: "boxes.csv", ...
template <class Row>
const char* table_name();

}  // namespace cob
