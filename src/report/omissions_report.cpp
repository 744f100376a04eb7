#include "report/omissions_report.hpp"
#include "report/text.hpp"

#include <nlohmann/json.hpp>

namespace cob {
std::string left_out_rows(const Omissions& omissions, std::size_t column) {
    std::string text;
    for (const Omissions::Decision& d : omissions.decisions())
        if (d.possible)
            text +=
                titled_line(d.kept ? "kept" : "left out", column, std::string(to_text(d.omission)) + ": " + d.reason);
    return text;
}

std::string omission_rows(const Omissions& omissions) {
    std::string text;
    for (const bool possible : {true, false}) {
        text += possible ? "would be left out\n" : "would not be left out\n";
        for (const Omissions::Decision& d : omissions.decisions())
            if (d.possible == possible) text += "  " + titled_line(to_text(d.omission), 10, d.reason);
    }
    return text;
}

nlohmann::ordered_json omissions_json(const Omissions& omissions) {
    nlohmann::ordered_json json;
    for (const Omissions::Decision& d : omissions.decisions())
        json[to_text(d.omission)] = {
            {"left_out", d.left_out()}, {"possible", d.possible}, {"kept", d.kept}, {"reason", d.reason}};
    return json;
}

}  // namespace cob
