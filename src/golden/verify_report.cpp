#include "cob/golden.hpp"

#include "scene/json_text.hpp"

namespace cob {

namespace {

using Json = nlohmann::ordered_json;

Json to_json(const verify::Confusion& confusion) {
    Json matrix = Json::object();
    for (std::size_t row = 0; row < confusion.rows.size(); ++row)
        for (std::size_t column = 0; column < confusion.columns.size(); ++column)
            matrix[confusion.rows[row]][confusion.columns[column]] = confusion.at(row, column);
    return matrix;
}

Json to_json(const verify::KindReport& part) {
    Json json;
    for (const verify::NamedCount& named : verify::named_counts) json[named.name] = part.counts.*named.count;
    json["confusion"] = to_json(part.confusion);
    return json;
}

Json to_json(const verify::Disagreement& d) {
    Json json{{"table", d.table}, {"id", d.id}};
    if (d.polygon >= 0) json["polygon"] = d.polygon;
    json["kind"] = d.kind;
    if (d.band) json["band"] = *d.band, json["switch_ulps"] = d.switch_ulps;
    json["column"] = d.column;
    json["exact"] = d.exact;
    json["given"] = d.given;
    json["question"] = d.question;
    return json;
}

std::string escaped(const std::string& text) {
    std::string out;
    for (const char c : text) switch (c) {
            case '&':
                out += "&amp;";
                break;
            case '<':
                out += "&lt;";
                break;
            case '>':
                out += "&gt;";
                break;
            case '"':
                out += "&quot;";
                break;
            default:
                out += static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t' ? '?' : c;
        }
    return out;
}

std::string failure_text(const verify::Report& report, const std::string& table, const std::string& kind) {
    std::string text;
    for (const verify::Disagreement& d : report.first)
        if (d.table == table && d.kind == kind) text += verify::to_text(d) + "\n";
    return text;
}

}  // namespace

std::string to_json(const verify::Report& report) {
    Json json{{"agree", report.agree()}};
    json["tables"] = Json::object();
    for (const verify::TableReport& table : report.tables) {
        Json& entry = json["tables"][table.table];
        entry["answered"] = table.answered;
        if (!table.answered) continue;
        entry.update(to_json(table.total));
        entry["kinds"] = Json::object();
        for (const auto& [kind, part] : table.kinds) entry["kinds"][kind] = to_json(part);
        entry["columns"] = table.columns;
    }
    json["first"] = Json::array();
    for (const verify::Disagreement& d : report.first) json["first"].push_back(to_json(d));
    return json_text(json);
}

std::string to_junit(const verify::Report& report) {
    std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"cob verify\">\n";
    for (const verify::TableReport& table : report.tables) {
        std::size_t failures = 0;
        std::string cases;
        for (const auto& [kind, part] : table.kinds) {
            const verify::Counts& c = part.counts;
            cases += "    <testcase classname=\"cob." + table.table + "\" name=\"" + escaped(kind) + "\"";
            if (c.agree()) {
                cases += "/>\n";
                continue;
            }
            ++failures;
            std::string summary;
            for (const verify::NamedCount& named : verify::named_counts)
                if (named.count != &verify::Counts::compared)
                    summary += (summary.empty() ? "" : ", ") + std::to_string(c.*named.count) + " " + named.name;
            cases += ">\n      <failure message=\"" + summary + " of " + std::to_string(c.compared) + "\">" +
                     escaped(failure_text(report, table.table, kind)) + "</failure>\n    </testcase>\n";
        }
        if (!table.answered)
            cases = "    <testcase classname=\"cob." + table.table + "\" name=\"not answered\"><skipped/></testcase>\n";
        text += "  <testsuite name=\"" + table.table + "\" tests=\"" +
                std::to_string(table.answered ? table.kinds.size() : 1) + "\" failures=\"" + std::to_string(failures) +
                "\" skipped=\"" + std::to_string(table.answered ? 0 : 1) + "\">\n" + cases + "  </testsuite>\n";
    }
    return text + "</testsuites>\n";
}

}  // namespace cob
