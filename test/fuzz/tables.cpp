// Tables: any bytes as any table of SPEC 7 and 8, by the library's reader and by that of cob/verify.hpp. The first line
// names the table; what it accepts, it writes and reads again alike.
#include "cob/tables.hpp"
#include "cob/error.hpp"
#include "cob/verify/table.hpp"
#include "fuzz/target.hpp"
#include "temporary_folder.hpp"

#include <array>

namespace cob::fuzz {
namespace {

template <class Row>
std::string rows_of(const std::string& path) {
    TableReader<Row> reader(path);
    std::string text;
    for (Row row; reader.next(row);) append_row(text, row);
    return text;
}

template <class Row>
std::string read_as(std::string_view text) {
    static const test::TemporaryFolder folder;
    const std::string path = folder / "table.csv", header(text.substr(0, text.find('\n')));
    write_anew(path, text);
    try {
        verify::Table table(path, {header});
        while (table.next()) table.number(0);
    } catch (const verify::Error&) {
    }
    const std::string rows = rows_of<Row>(path);
    // Segments are written with the columns from and to.
    const bool short_segments = header.find(",z1\r") != header.npos || header.substr(header.size() - 3) == ",z1";
    write_anew(path, (short_segments ? header.substr(0, header.find(",z1") + 3) + ",from,to" : header) + "\n" + rows);
    require(rows_of<Row>(path) == rows, "what was written is read again");
    return rows.empty() ? "empty tables" : "tables";
}

using Reader = std::string (*)(std::string_view);
struct Kind {
    const char* name;
    Reader read;
};
template <class Row>
Kind kind() {
    return {table_name<Row>(), read_as<Row>};
}

std::string read(std::string_view text) {
    static const std::array<Kind, 10> kinds{
        kind<BoxRow>(),   kind<SegmentRow>(),  kind<TriangleRow>(),   kind<PointRow>(),      kind<TagRow>(),
        kind<StateRow>(), kind<RelationRow>(), kind<VisibilityRow>(), kind<IrradianceRow>(), kind<FormFactorRow>()};
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view name = text.substr(0, end);
    for (const Kind& kind : kinds)
        if (name == kind.name) return kind.read(text.substr(std::min(end + 1, text.size())));
    return "no table";
}

}  // namespace

Target target() {
    return {{"boxes.csv\nbox,polygon,x0,y0,z0,x1,y1,z1,x2,y2,z2,x3,y3,z3,ux,uy,uz,margin,height\n"
             "0,0,0,0,0,1,0,0,1,1,0,0,1,0,1,0,0,0.125,0.25\n3,-1,0,1/3,0,1,0,0,1,1e-300,0,,,,1,0,0,1/3,2\n",
             "segments.csv\nsegment,x0,y0,z0,x1,y1,z1\n0,0,0,0,1,1,1\n7,1/3,-2/3,1e300,0x1p-3,1,-0\n",
             "segments.csv\nsegment,x0,y0,z0,x1,y1,z1,from,to\n0,0,0,0,1,1,1,0,-1\n1,1,2,3,4,5,6,-1,4\n",
             "triangles.csv\ntriangle,polygon,x0,y0,z0,x1,y1,z1,x2,y2,z2\n0,0,0,0,0,1,0,0,0,1,0\n",
             "points.csv\npoint,x,y,z,nx,ny,nz\n0,0,0,0,0,0,1\n1,1/7,0.5,-3,1,2,3\n",
             "tags.csv\nquestion,id,kind,band\nbox,0,element,8\nbox,4,top-ulp,52\nsegment,0,light,11\n",
             "states.csv\r\nbox,state,close,cover,light\r\n0,close,3 4 5,,4\r\n1,occluded,,2,\r\n2,empty,,,\r\n",
             "states.csv\nbox,state,close,cover,light\n0,close,3 4 5,,4\n1,occluded,,2,\n2,empty,,,\n",
             "relations.csv\nbox,polygon,relation,covers,shared\n0,3,crossing,1,edge\n0,4,base,0,none\n",
             "visibility.csv\nsegment,visibility\n0,clear\n1,blocked\n5,grazing\n",
             "irradiance.csv\npoint,light,unobstructed,visible,r,g,b\n0,2,0.5,0.25,1,2,3\n0,4,0,0,0,0,0\n",
             "formfactors.csv\nfrom,to,form_factor,error\n0,1,0.5,1e-9\n1,0,0.25,0\n"},
            {",",
             "\n",
             "\r\n",
             "-1",
             "1/3",
             "1/0",
             "0/1",
             "-",
             "1e999",
             "1e-999",
             "nan",
             "inf",
             "0x1p-1074",
             " ",
             "close",
             "9223372036854775808",
             "undecided",
             "grazing",
             "0,0,0\n",
             std::string(1, '\0'),
             "99999999999/7"},
            {"tables", "refused"},
            6000,
            read};
}

}  // namespace cob::fuzz
