#include "golden/line_reader.hpp"

#include "cob/error.hpp"
#include "cob/files.hpp"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <limits>

namespace cob {
namespace {

constexpr std::size_t block_size = std::size_t{1} << 20;
constexpr std::size_t longest_line = std::size_t{1} << 26;  // a guard against files that are no tables

}  // namespace

LineReader::LineReader(std::string path) : path_(std::move(path)), block_(block_size) {
    const bool folder = is_folder(path_);
    if (!folder) file_.reset(std::fopen(path_.c_str(), "rb"));
    if (!file_)
        throw InputError("cannot open table",
                         {path_, 0, folder ? "is a folder" : std::strerror(errno), "check the path"});
}

bool LineReader::fill() {
    if (finished_) return false;
    if (begin_ > 0) {
        std::memmove(block_.data(), block_.data() + begin_, end_ - begin_);
        end_ -= begin_;
        begin_ = 0;
    }
    if (end_ == block_.size()) {
        if (end_ >= longest_line) refuse("line too long", "", "give a table of SPEC 7");
        block_.resize(2 * block_.size());
    }
    const std::size_t count = std::fread(block_.data() + end_, 1, block_.size() - end_, file_.get());
    if (count == 0 && std::ferror(file_.get()) != 0)
        throw InputError("cannot read table", {path_, 0, "", "check the disk"});
    end_ += count;
    finished_ = count == 0;
    return count > 0;
}

bool LineReader::next(std::string_view& line) {
    ++line_number_;
    std::size_t searched = 0;
    for (;;) {
        const char* begin = block_.data() + begin_;
        const std::size_t length = end_ - begin_;
        const void* found = length > searched ? std::memchr(begin + searched, '\n', length - searched) : nullptr;
        if (found != nullptr) {
            std::size_t count = static_cast<std::size_t>(static_cast<const char*>(found) - begin);
            begin_ += count + 1;
            if (count > 0 && begin[count - 1] == '\r') --count;
            line = std::string_view(begin, count);
            if (line_number_ == 1 && line.substr(0, 3) == "\xef\xbb\xbf") line.remove_prefix(3);  // spreadsheets' mark
            return true;
        }
        searched = length;
        if (fill()) continue;
        if (length == 0) return false;
        refuse("the last line does not end",
               std::string_view(block_.data() + begin_, std::min(length, std::size_t{60})),
               "the table may be cut off; write it anew, with a final newline");
    }
}

void LineReader::refuse(const std::string& problem, std::string_view value, const std::string& remedy) const {
    throw InputError(problem, {path_, line_number_, std::string(value.substr(0, 80)), remedy});
}

std::string_view Fields::text() {
    if (ended_) refuse_count();
    ++taken_;
    const std::size_t comma = rest_.find(',');
    const std::string_view field = rest_.substr(0, comma);
    ended_ = comma == std::string_view::npos;
    rest_ = ended_ ? std::string_view() : rest_.substr(comma + 1);
    return field;
}

bool Fields::take_undecided() {
    if (!undecided_ || rest_.substr(0, rest_.find(',')) != "undecided") return false;
    text();
    return true;
}

std::int64_t Fields::integer(std::int64_t least, std::int64_t most) {
    const std::string_view field = text();
    std::int64_t value = 0;
    const auto [stop, error] = std::from_chars(field.data(), field.data() + field.size(), value);
    if (error != std::errc{} || stop != field.data() + field.size() || value < least || value > most)
        refuse("no whole number in range", field,
               "write a whole number from " + std::to_string(least) + " to " + std::to_string(most));
    return value;
}

std::int64_t Fields::id() {
    return integer(0, std::numeric_limits<std::int64_t>::max());
}

PolygonId Fields::polygon() {
    return static_cast<PolygonId>(integer(0, std::numeric_limits<PolygonId>::max()));
}

PolygonId Fields::polygon_or_none() {
    return static_cast<PolygonId>(integer(no_polygon, std::numeric_limits<PolygonId>::max()));
}

void Fields::polygons(std::vector<PolygonId>& list) {
    const std::string_view field = text();
    list.clear();
    const char* at = field.data();
    const char* const end = at + field.size();
    while (at != end) {
        PolygonId id = 0;
        const auto [stop, error] = std::from_chars(at, end, id);
        const bool number = error == std::errc{} && id >= 0 && (stop == end || (*stop == ' ' && stop + 1 != end));
        if (!number || (!list.empty() && id <= list.back()))
            refuse("no ascending list of polygon ids", field, "separate ascending ids by single spaces");
        list.push_back(id);
        at = stop == end ? end : stop + 1;
    }
}

bool Fields::flag() {
    const std::string_view field = text();
    if (field != "0" && field != "1") refuse("neither 0 nor 1", field, "write 0 for no, 1 for yes");
    return field == "1";
}

double Fields::number() {
    const std::string_view field = text();
    const auto value = parse_number(field);
    if (!value) refuse("not a finite number", field, "write a finite decimal or C hex-float");
    return *value;
}

ExactNumber Fields::exact() {
    const std::string_view field = text();
    auto value = parse_exact_number(field);
    if (!value) refuse("not a finite number", field, "write a finite decimal, C hex-float or fraction p/q");
    return *std::move(value);
}

Rational Fields::exact_rational() {
    const ExactNumber number = exact();
    return number.fraction ? *number.fraction : Rational(Rational(number.nearest) + Rational(number.rest));
}

Point Fields::point() {
    const double x = number(), y = number(), z = number();
    return {x, y, z};
}

ExactPoint Fields::exact_point() {
    std::array<ExactNumber, 3> coordinates;
    for (ExactNumber& coordinate : coordinates) coordinate = exact();
    return to_point(coordinates);
}

void Fields::expect_end() const {
    if (!ended_) refuse_count();
}

std::string Fields::column_name() const {
    std::string_view names = header_;
    for (int k = 1; k < taken_; ++k) names.remove_prefix(std::min(names.find(','), names.size() - 1) + 1);
    return std::string(names.substr(0, names.find(',')));
}

void Fields::refuse(const std::string& problem, std::string_view value, const std::string& remedy) const {
    reader_.refuse("column " + column_name() + ": " + problem, value.empty() ? "(nothing)" : value, remedy);
}

void Fields::refuse_count() const {
    const auto columns = [](std::string_view line) { return 1 + std::count(line.begin(), line.end(), ','); };
    reader_.refuse(
        "row of " + std::to_string(columns(line_)) + " columns instead of " + std::to_string(columns(header_)), line_,
        "write the columns " + std::string(header_));
}

}  // namespace cob
