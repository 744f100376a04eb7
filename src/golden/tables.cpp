#include "cob/tables.hpp"

#include "cob/error.hpp"
#include "cob/files.hpp"
#include "golden/line_reader.hpp"
#include "golden/row_codecs.hpp"

#include <algorithm>
#include <optional>

namespace cob {
namespace {

constexpr std::size_t flush_size = std::size_t{1} << 20;

template <class Row>
void remember_line(Row&, std::size_t) {}
void remember_line(BoxRow& row, std::size_t line) {
    row.line = line;
}
void remember_line(SegmentRow& row, std::size_t line) {
    row.line = line;
}
void remember_line(PointRow& row, std::size_t line) {
    row.line = line;
}

template <class Row>
std::string to_text(const RowKey& key, bool pair) {
    if constexpr (std::is_same_v<Row, TagRow>)
        return (static_cast<TagRow::Question>(key[0]) == TagRow::Question::box ? "box " : "segment ") +
               std::to_string(key[1]);
    return std::to_string(key[0]) + (pair ? "," + std::to_string(key[1]) : "");
}

}  // namespace

// --------------------------------------------------------------------------------------------------- reading

template <class Row>
struct TableReader<Row>::Implementation {
    LineReader lines;
    TableReadOptions options;
    RowCodec<Row> codec;
    std::string_view header;
    std::optional<RowKey> last;

    Implementation(const std::string& path, TableReadOptions read_options) : lines(path), options(read_options) {
        const auto& headers = RowCodec<Row>::headers;
        std::string_view line;
        const bool any = lines.next(line);
        const auto found = std::find(headers.begin(), headers.end(), line);
        if (!any || found == headers.end())
            lines.refuse("wrong header", any ? line : "(empty file)",
                         "write the header line " + std::string(headers.back()));
        header = *found;
    }

    bool next(Row& row) {
        std::string_view line;
        if (!lines.next(line)) return false;
        Fields fields(lines, header, line, options.undecided);
        codec.parse(fields, row);
        fields.expect_end();
        if (options.ordered) check_order(row);
        remember_line(row, lines.line_number());
        return true;
    }

    void check_order(const Row& row) {
        const RowKey key = RowCodec<Row>::key(row);
        if (last && key <= *last) {
            const bool pair = key[1] != 0 || (*last)[1] != 0;
            lines.refuse(key == *last ? "doubled id" : "ids do not ascend", to_text<Row>(key, pair),
                         key == *last ? "give every question one row" : "sort the rows by their ids");
        }
        last = key;
    }
};

template <class Row>
TableReader<Row>::TableReader(const std::string& path, TableReadOptions options)
    : implementation_(std::make_unique<Implementation>(path, options)) {}
template <class Row>
TableReader<Row>::~TableReader() = default;
template <class Row>
TableReader<Row>::TableReader(TableReader&&) noexcept = default;

template <class Row>
bool TableReader<Row>::next(Row& row) {
    return implementation_->next(row);
}

// --------------------------------------------------------------------------------------------------- writing

template <class Row>
struct TableWriter<Row>::Implementation {
    OutputFile file;
    std::string text;
    std::uint64_t rows = 0;

    explicit Implementation(const std::string& path) : file(path), text(RowCodec<Row>::headers.back()) { text += '\n'; }

    void flush(std::size_t least) {
        if (text.size() < least) return;
        file.write(text);
        text.clear();
    }
};

template <class Row>
TableWriter<Row>::TableWriter(const std::string& path) : implementation_(std::make_unique<Implementation>(path)) {}
template <class Row>
TableWriter<Row>::~TableWriter() = default;
template <class Row>
TableWriter<Row>::TableWriter(TableWriter&&) noexcept = default;

template <class Row>
void TableWriter<Row>::write(const Row& row) {
    append_row(implementation_->text, row);
    ++implementation_->rows;
    implementation_->flush(flush_size);
}

template <class Row>
void TableWriter<Row>::write_lines(std::string_view lines) {
    implementation_->flush(1);
    implementation_->file.write(lines);
    implementation_->rows += static_cast<std::uint64_t>(std::count(lines.begin(), lines.end(), '\n'));
}

template <class Row>
void TableWriter<Row>::commit() {
    implementation_->flush(1);
    implementation_->file.commit();
}

template <class Row>
std::uint64_t TableWriter<Row>::rows() const {
    return implementation_->rows;
}

template <class Row>
void append_row(std::string& text, const Row& row) {
    RowCodec<Row>::append(text, row);
    text += '\n';
}

template <class Row>
const char* table_name() {
    return RowCodec<Row>::name;
}

// One line for each kind of row.
#define COB_INSTANTIATE_TABLE(Row)                           \
    template class TableReader<Row>;                         \
    template class TableWriter<Row>;                         \
    template void append_row<Row>(std::string&, const Row&); \
    template const char* table_name<Row>();

COB_INSTANTIATE_TABLE(BoxRow)
COB_INSTANTIATE_TABLE(SegmentRow)
COB_INSTANTIATE_TABLE(TriangleRow)
COB_INSTANTIATE_TABLE(PointRow)
COB_INSTANTIATE_TABLE(TagRow)
COB_INSTANTIATE_TABLE(StateRow)
COB_INSTANTIATE_TABLE(RelationRow)
COB_INSTANTIATE_TABLE(VisibilityRow)
COB_INSTANTIATE_TABLE(IrradianceRow)
COB_INSTANTIATE_TABLE(FormFactorRow)

}  // namespace cob
