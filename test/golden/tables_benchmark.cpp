// A million rows each way: nanoseconds a row for writing and reading the tables of a set. Correctness first: what is
// read is what was written, or the benchmark ends.
#include "cob/files.hpp"
#include "cob/tables.hpp"
#include "temporary_folder.hpp"

#include <benchmark/benchmark.h>

#include <random>
#include <stdexcept>

namespace cob {
namespace {

constexpr std::int64_t rows = 1000000;

double coordinate(std::mt19937_64& engine) {
    return static_cast<double>(engine() >> 11) / 9007199254740992.0;
}

/// Boxes as classify makes them: corners in binary64, or halves of such that are fractions.
BoxRow box_row(std::mt19937_64& engine, RowId id, bool fractions) {
    BoxRow row;
    row.box = id;
    row.question.polygon = static_cast<PolygonId>(id / 64);
    row.question.corners.count = 4;
    for (ExactPoint& point : row.question.corners.points) {
        const Point nearest{1 + coordinate(engine), 1 + coordinate(engine), 1 + coordinate(engine)};
        point = fractions ? ExactPoint::from_pair(nearest, {0x1p-54, -0x1p-55, 0x1p-56}) : ExactPoint(nearest);
    }
    row.question.u = ExactPoint(Point{0.1, 0.2, 0.3});
    return row;
}

SegmentRow segment_row(std::mt19937_64& engine, RowId id, bool fractions) {
    const BoxRow row = box_row(engine, id, fractions);
    return {id, row.question.corners.points[0], row.question.corners.points[1], 1, 2, 0};
}

RelationRow relation_row(std::mt19937_64& engine, RowId id, bool) {
    return {id, static_cast<PolygonId>(engine() >> 40), Relation::crossing, false, Shared::edge, true};
}

template <class Row>
using Make = Row (*)(std::mt19937_64&, RowId, bool);

template <class Row>
void write_table(const std::string& path, Make<Row> make, bool fractions) {
    std::mt19937_64 engine(1);
    TableWriter<Row> writer(path);
    for (RowId id = 0; id < rows; ++id) writer.write(make(engine, id, fractions));
    writer.commit();
}

template <class Row>
void write(benchmark::State& state, Make<Row> make, bool fractions) {
    const test::TemporaryFolder folder;
    for (auto _ : state) write_table<Row>(folder / "table", make, fractions);
    state.SetItemsProcessed(rows * state.iterations());
    state.SetBytesProcessed(static_cast<std::int64_t>(read_file(folder / "table").size()) * state.iterations());
}

template <class Row>
void read(benchmark::State& state, Make<Row> make, bool fractions) {
    const test::TemporaryFolder folder;
    write_table<Row>(folder / "table", make, fractions);
    for (auto _ : state) {
        TableReader<Row> reader(folder / "table");
        Row row;
        RowId count = 0;
        while (reader.next(row)) ++count;
        if (count != rows) throw std::logic_error("rows are missing");
    }
    // Written again: the same bytes.
    TableReader<Row> reader(folder / "table");
    TableWriter<Row> writer(folder / "again");
    for (Row row; reader.next(row);) writer.write(row);
    writer.commit();
    if (read_file(folder / "table") != read_file(folder / "again")) throw std::logic_error("bytes differ");
    state.SetItemsProcessed(rows * state.iterations());
}

template <class Row>
void add(const char* name, Make<Row> make, bool fractions) {
    const std::string title = name;
    benchmark::RegisterBenchmark(("write/" + title).c_str(), write<Row>, make, fractions)
        ->Unit(benchmark::kMillisecond);
    benchmark::RegisterBenchmark(("read/" + title).c_str(), read<Row>, make, fractions)->Unit(benchmark::kMillisecond);
}

}  // namespace
}  // namespace cob

int main(int argc, char** argv) {
    cob::add<cob::BoxRow>("boxes", cob::box_row, false);
    cob::add<cob::BoxRow>("boxes_of_fractions", cob::box_row, true);
    cob::add<cob::SegmentRow>("segments", cob::segment_row, false);
    cob::add<cob::SegmentRow>("segments_of_fractions", cob::segment_row, true);
    cob::add<cob::RelationRow>("relations", cob::relation_row, false);
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
}
