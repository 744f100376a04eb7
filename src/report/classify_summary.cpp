#include "report/classify_summary.hpp"

#include "report/omissions_report.hpp"
#include "report/text.hpp"
#include "scene/json_text.hpp"

namespace cob {
namespace {

double ratio(double part, double whole) {
    return whole > 0 ? part / whole : 0;
}

double ratio(std::uint64_t part, std::uint64_t whole) {
    return ratio(static_cast<double>(part), static_cast<double>(whole));
}

std::uint64_t count(const ClassifyStatistics& statistics, BufferState state) {
    return statistics.elements[static_cast<std::size_t>(state)];
}

std::uint64_t total(const ClassifyStatistics& statistics) {
    std::uint64_t sum = 0;
    for (const std::uint64_t n : statistics.elements) sum += n;
    return sum;
}

}  // namespace

std::string to_text(const ClassifySummary& summary) {
    const ClassifyStatistics& s = summary.result.statistics;
    const std::uint64_t elements = total(s);
    const double n = static_cast<double>(elements);
    const PredicateCounters& p = s.predicates;
    const auto percent = [&](std::uint64_t part) { return 100 * ratio(part, elements); };
    const auto whole = [](std::uint64_t value) { return static_cast<unsigned long long>(value); };

    std::string text;
    text += printed("polygons            %llu, skipped %llu\n", whole(summary.polygons), whole(summary.skipped));
    text += printed("elements            %llu\n", whole(elements));
    for (const BufferState state : {BufferState::empty, BufferState::close, BufferState::occluded})
        text += printed("  %-17s %llu (%.2f %%)\n", to_text(state), whole(count(s, state)), percent(count(s, state)));
    if (summary.parameters.at("mode") == "inherit")
        text += printed("  inherited         %llu, of which %llu are not occluded: inherited.csv\n", whole(s.inherited),
                        whole(s.inherited_otherwise));
    text += printed("buffers around      %llu\n", whole(s.around));
    text += printed("candidates tested   %llu, %.3f an element\n", whole(s.tested), ratio(s.tested, elements));
    if (s.compared > 0)
        text += printed("  to compare        %llu, %.3f an element\n", whole(s.compared), ratio(s.compared, elements));
    const std::uint64_t decisions = p.filtered + p.integer + p.rational;
    text += printed("predicates          %llu filtered (%.2f %%), %llu integer, %llu rational\n", whole(p.filtered),
                    100 * ratio(p.filtered, decisions), whole(p.integer), whole(p.rational));
    text += printed("facing tests        %llu of lights\n", whole(s.light_tests));
    if (summary.omissions) text += left_out_rows(*summary.omissions, 20);
    text += printed("time                read %.3f s, mesh %.3f s, tree %.3f s, classify %.3f s\n",
                    summary.read_seconds, summary.mesh_seconds, summary.tree_seconds, summary.classify_seconds);
    text += printed("  an element        %.3f us, %.3f us of processor time\n",
                    1e6 * ratio(summary.classify_seconds, n), 1e6 * ratio(summary.processor_seconds, n));
    text += printed("buffers             %.2f bytes each, lists %.2f bytes an element\n",
                    ratio(summary.result.buffer_bytes, elements), ratio(summary.result.list_bytes, elements));
    text += printed("memory              %.1f MB at most, %.1f MB of it the tree\n",
                    static_cast<double>(summary.peak_bytes) / 1e6, static_cast<double>(summary.tree_bytes) / 1e6);
    return text;
}

std::string to_json(const ClassifySummary& summary) {
    const ClassifyStatistics& s = summary.result.statistics;
    const std::uint64_t elements = total(s);
    nlohmann::ordered_json json;
    json["parameters"] = summary.parameters;
    json["polygons"] = {{"total", summary.polygons}, {"skipped", summary.skipped}};
    json["elements"] = {{"total", elements},
                        {"empty", count(s, BufferState::empty)},
                        {"close", count(s, BufferState::close)},
                        {"occluded", count(s, BufferState::occluded)}};
    json["inherited"] = {{"occluded", s.inherited}, {"otherwise_from_the_scene", s.inherited_otherwise}};
    json["buffers_around"] = s.around;
    json["relations"] = summary.result.relations;
    json["candidates"] = {
        {"tested", s.tested}, {"per_element", ratio(s.tested, elements)}, {"tested_to_compare", s.compared}};
    json["predicates"] = {
        {"filtered", s.predicates.filtered}, {"integer", s.predicates.integer}, {"rational", s.predicates.rational}};
    json["light_tests"] = s.light_tests;
    if (summary.omissions) json["left_out"] = omissions_json(*summary.omissions);
    json["seconds"] = {{"read", summary.read_seconds},
                       {"mesh", summary.mesh_seconds},
                       {"tree", summary.tree_seconds},
                       {"classify", summary.classify_seconds},
                       {"classify_processor", summary.processor_seconds}};
    json["bytes"] = {{"per_buffer", ratio(summary.result.buffer_bytes, elements)},
                     {"lists", summary.result.list_bytes},
                     {"tree", summary.tree_bytes},
                     {"peak", summary.peak_bytes}};
    return json_text(json);
}

}  // namespace cob
