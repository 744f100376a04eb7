#include "arithmetic/process.hpp"
#include "arithmetic/text.hpp"
#include "radiosity/mesh.hpp"
#include "report/omissions_report.hpp"
#include "report/solution_files.hpp"
#include "report/text.hpp"
#include "scene/json_text.hpp"

#include <cmath>

namespace cob::report {
namespace {

using Json = nlohmann::ordered_json;

Json options_json(const RadiosityOptions& o) {
    return {
        {"refine", to_text(o.refinement)},
        {"patch_edge", o.patch_edge},
        {"light_edge", o.light_edge},
        {"buffer",
         {{"margin", to_text(o.buffer.margin)},
          {"height", to_text(o.buffer.height)},
          {"minimum_edge", o.buffer.minimum_edge},
          {"strength", to_text(o.buffer.strength)},
          {"threshold", o.buffer.threshold},
          {"levels", to_text(o.buffer.levels)},
          {"mode", to_text(o.buffer.mode)}}},
        {"gradient",
         {{"threshold", o.gradient.threshold}, {"minimum_edge", o.gradient.minimum_edge}, {"floor", o.gradient.floor}}},
        {"samples", o.samples},
        {"mixed_samples", o.mixed_samples},
        {"receiving_points", o.receiving_points},
        {"overshoot", o.overshoot},
        {"keep", o.keep.to_text()}};
}

/// In W: numbers, or text where binary64 does not hold them.
Json flux_json(const Rgb& flux, int exponent) {
    Json json = Json::array();
    for (const double f : flux) {
        const double watt = std::scalbn(f, exponent);
        if (f == 0 || std::isnormal(watt))
            json.push_back(watt);
        else
            json.push_back(scaled_text(f, exponent));
    }
    return json;
}

Json buffers_json(const RadiositySolver& solver) {
    const auto& built = solver.counters().buffers;
    const auto of = [&](BufferState state) { return built[static_cast<std::size_t>(state)]; };
    return {
        {"built", of(BufferState::empty) + of(BufferState::close) + of(BufferState::occluded)},
        {"empty", of(BufferState::empty)},
        {"close", of(BufferState::close)},
        {"occluded", of(BufferState::occluded)},
        {"bytes", solver.buffer_bytes()},
        {"bytes_per_buffer", static_cast<double>(solver.buffer_bytes()) / static_cast<double>(solver.buffer_count())},
        {"bytes_per_element",
         static_cast<double>(solver.buffer_bytes()) / static_cast<double>(solver.element_count())}};
}

Json figures_of(const RadiositySolver& solver, const RunFigures& figures) {
    const RadiosityCounters& c = solver.counters();
    const RadiosityTimes& t = solver.times();
    const EnergyBooks books = solver.books();
    const double interactions = static_cast<double>(c.interactions);
    Json json;
    json["scene"] = figures.scene;
    json["polygons"] = solver.mesh().scene().polygon_count();
    json["patches"] = solver.patch_count();
    json["elements"] = solver.element_count();
    json["elements_by_level"] = solver.elements_by_level();
    json["options"] = options_json(solver.options());
    json["ended_by"] = figures.ended_by;
    json["unshot_share"] = solver.unshot_share();
    json["counters"] = {{"shots", c.shots},
                        {"interactions", c.interactions},
                        {"form_factors", c.form_factors},
                        {"segments", c.segments},
                        {"segments_by_exact_oracle", c.oracle_segments},
                        {"segments_left_out", c.segments_left_out},
                        {"light_tests", c.light_tests},
                        {"buffers_left_out", c.buffers_left_out},
                        {"skipped_as_occluded", c.skipped_occluded},
                        {"refined_by_buffer", c.put_aside},
                        {"refined_by_gradient", c.refined_by_gradient},
                        {"refined_for_balance", c.refined_for_balance},
                        {"sampled_anew", c.resampled}};
    json["buffers"] = buffers_json(solver);
    json["left_out"] = omissions_json(solver.omissions());
    json["bookkeeping"] = {{"exitance_flux_by_elements", flux_json(books.by_elements, books.exponent)},
                           {"exitance_flux_by_patches", flux_json(books.by_patches, books.exponent)},
                           {"relative_difference", books.difference()},
                           {"moved_by_subdivision", books.moved}};
    const auto shooter = [&](std::int32_t patch) -> Json {
        if (patch < 0) return nullptr;
        return {{"patch", patch},
                {"polygon", solver.roots()[solver.mesh().node(patch).element.root].polygon},
                {"longest_side", std::scalbn(solver.mesh().longest_side(patch), solver.mesh().exponent())}};
    };
    json["closure"] = {{"flux", books.closure_flux},
                       {"error", books.closure_error},
                       {"mean", books.closure_mean},
                       {"least", books.closure_least},
                       {"most", books.closure_most},
                       {"least_of", shooter(books.closure_least_patch)},
                       {"most_of", shooter(books.closure_most_patch)}};
    json["seconds"] = {{"meshing", t.meshing},   {"interaction", t.interaction},       {"buffer", t.buffer},
                       {"shooting", t.shooting}, {"refinement", t.refinement},         {"gradient", t.gradient},
                       {"solution", t.total()},  {"picture", figures.picture_seconds}, {"all", figures.seconds}};
    json["buffer_share_of_solution"] = t.total() > 0 ? t.buffer / t.total() : 0;
    // What an interaction costs on average is what one that is skipped as occluded saves.
    json["seconds_saved_by_occluded_elements"] =
        interactions > 0 ? static_cast<double>(c.skipped_occluded) * (t.interaction + t.shooting) / interactions : 0;
    json["exposure"] = figures.exposure ? Json(*figures.exposure) : Json();
    json["peak_memory_bytes"] = peak_memory();
    return json;
}

/// The same in words.
std::string in_words(const Json& j, const RadiositySolver& solver, const RunFigures& figures) {
    const auto number = [](const Json& value) { return value.get<double>(); };
    std::string levels;
    for (const auto& count : j["elements_by_level"]) levels += (levels.empty() ? "" : " ") + count.dump();
    const auto line = [](const std::string& name, const std::string& value) { return titled_line(name, 26, value); };
    const Json &c = j["counters"], &b = j["buffers"], &s = j["seconds"];
    std::string text = line("scene", figures.scene);
    text += line("polygons", j["polygons"].dump()) + line("patches", j["patches"].dump());
    text += line("elements", j["elements"].dump() + " (by level: " + levels + ")");
    text += line("shots", c["shots"].dump() + ", ended by " + figures.ended_by);
    if (!figures.exposure) text += line("pictures", "not written: interrupted");
    text += line("unshot flux", printed("%.4g %%", 100 * number(j["unshot_share"])));
    text += line("segments tested", c["segments"].dump() + " (" + c["segments_by_exact_oracle"].dump() +
                                        " by the exact oracle), left out " + c["segments_left_out"].dump());
    text += line("refined", "by buffer " + c["refined_by_buffer"].dump() + ", by gradient " +
                                c["refined_by_gradient"].dump() + ", for balance " + c["refined_for_balance"].dump());
    text += line("buffers built", b["built"].dump() + ": empty " + b["empty"].dump() + ", close " + b["close"].dump() +
                                      ", occluded " + b["occluded"].dump());
    text += line("buffer memory", printed("%.2f bytes a buffer, %.2f an element", number(b["bytes_per_buffer"]),
                                          number(b["bytes_per_element"])));
    text += line("skipped as occluded",
                 c["skipped_as_occluded"].dump() +
                     printed(" shots, about %.3g s saved", number(j["seconds_saved_by_occluded_elements"])));
    text += left_out_rows(solver.omissions(), 26);
    text += line("bookkeeping", printed("differs by %.2g; subdivision moved %.3g %% of the flux",
                                        number(j["bookkeeping"]["relative_difference"]),
                                        100 * number(j["bookkeeping"]["moved_by_subdivision"])));
    text +=
        line("closure", printed("%.6f of the flux arrived, each shot %.4f off; mean %.6f", number(j["closure"]["flux"]),
                                number(j["closure"]["error"]), number(j["closure"]["mean"])) +
                            printed(", least %.6f, most %.6f (1 in a closed scene)", number(j["closure"]["least"]),
                                    number(j["closure"]["most"])));
    for (const char* which : {"least", "most"}) {
        const Json& of = j["closure"][std::string(which) + "_of"];
        if (!of.is_null())
            text +=
                line(std::string("  ") + which, "patch " + of["patch"].dump() + " of polygon " + of["polygon"].dump() +
                                                    printed(", longest side %.4g", number(of["longest_side"])));
    }
    text += line("seconds", printed("%.3f solution, %.3f picture, %.3f in all", number(s["solution"]),
                                    number(s["picture"]), number(s["all"])));
    text += line("  interaction, shooting", printed("%.3f, %.3f", number(s["interaction"]), number(s["shooting"])));
    text += line("  buffer", printed("%.4f: %.3f %% of the solution", number(s["buffer"]),
                                     100 * number(j["buffer_share_of_solution"])));
    text += line("  refinement, gradient", printed("%.3f, %.3f", number(s["refinement"]), number(s["gradient"])));
    text += line("  meshing", printed("%.3f", number(s["meshing"])));
    text += line("peak memory", printed("%.1f MB", number(j["peak_memory_bytes"]) / 1e6));
    return text;
}

}  // namespace

RunSummary summarise(const RadiositySolver& solver, const RunFigures& figures) {
    const Json json = figures_of(solver, figures);
    return {json_text(json), in_words(json, solver, figures)};
}

}  // namespace cob::report
