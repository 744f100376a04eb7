#include "golden/parameters.hpp"

#include "cob/arithmetic.hpp"
#include "cob/error.hpp"

#include <charconv>
#include <sstream>

namespace cob {

namespace {

/// Reads parameters by name, strictly.
class Reader {
public:
    explicit Reader(const std::map<std::string, std::string>& text) : text_(text) {}

    bool has(const std::string& name) const { return text_.count(name) != 0; }
    const std::string& at(const std::string& name) const {
        const auto found = text_.find(name);
        if (found == text_.end())
            throw InputError("the manifest lacks a parameter", {"manifest.json", 0, name, remedy});
        return found->second;
    }
    template <class Integer>
    Integer integer(const std::string& name) const {
        const std::string& text = at(name);
        Integer value{};
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        if (error != std::errc() || end != text.data() + text.size()) refuse(text);
        return value;
    }
    double number(const std::string& name) const {
        const auto value = parse_binary64(at(name));
        if (!value) refuse(at(name));
        return *value;
    }
    bool flag(const std::string& name) const {
        if (at(name) != "true" && at(name) != "false") refuse(at(name));
        return at(name) == "true";
    }

private:
    static constexpr const char* remedy = "make the set anew";
    [[noreturn]] static void refuse(const std::string& text) {
        throw InputError("bad parameter in the manifest", {"manifest.json", 0, text, remedy});
    }
    const std::map<std::string, std::string>& text_;
};

}  // namespace

std::map<std::string, std::string> to_text(const GoldenParameters& p) {
    std::map<std::string, std::string> text{{"level", std::to_string(p.level)},
                                            {"boxes", p.boxes ? "true" : "false"},
                                            {"margin", to_text(p.margin)},
                                            {"height", to_text(p.height)},
                                            {"segments", std::to_string(p.segments)},
                                            {"hard", std::to_string(p.hard)},
                                            {"seed", std::to_string(p.seed)},
                                            {"float", p.binary32 ? "true" : "false"},
                                            {"skip_invalid", p.skip_invalid ? "true" : "false"}};
    if (p.edge) text["edge"] = to_text(*p.edge);
    if (p.grid) text["grid"] = std::to_string(*p.grid);
    for (const std::string& kind : p.kinds) text["kinds"] += (text["kinds"].empty() ? "" : ",") + kind;
    return text;
}

NumberFormat format_of(const GoldenParameters& parameters) {
    return parameters.binary32 ? NumberFormat::binary32 : parameters.grid ? NumberFormat::binary64 : NumberFormat::any;
}

GoldenParameters parameters_of(const Manifest& manifest) {
    const Reader read(manifest.parameters);
    GoldenParameters p;
    p.level = read.integer<int>("level");
    p.boxes = read.flag("boxes");
    p.margin = read.number("margin");
    p.height = read.number("height");
    p.segments = read.integer<std::uint64_t>("segments");
    p.hard = read.integer<std::uint64_t>("hard");
    p.seed = read.integer<std::uint64_t>("seed");
    p.binary32 = read.flag("float");
    p.skip_invalid = read.flag("skip_invalid");
    if (read.has("edge")) p.edge = read.number("edge");
    if (read.has("grid")) p.grid = read.integer<int>("grid");
    if (read.has("kinds")) {
        std::istringstream words(read.at("kinds"));
        for (std::string kind; std::getline(words, kind, ',');) p.kinds.push_back(kind);
    }
    return p;
}

}  // namespace cob
