#include "report/census_report.hpp"

#include "report/omissions_report.hpp"
#include "report/text.hpp"

#include <nlohmann/json.hpp>

namespace cob {
namespace {

std::string number(std::size_t value) {
    return std::to_string(value);
}

/// "1 polygon", "2 polygons".
std::string counted(std::size_t count, const std::string& noun) {
    return number(count) + " " + noun + (count == 1 ? "" : "s");
}

std::string point_text(const Point& point) {
    return "(" + to_text(point.x) + ", " + to_text(point.y) + ", " + to_text(point.z) + ")";
}

/// Ascending numbers, runs of three or more as first-last.
std::string ranges(const std::vector<PolygonId>& ids) {
    std::string text;
    for (std::size_t k = 0; k < ids.size();) {
        std::size_t end = k + 1;
        while (end < ids.size() && ids[end] == ids[end - 1] + 1) ++end;
        if (end - k < 3) end = k + 1;
        text += (k == 0 ? "" : " ") + std::to_string(ids[k]);
        if (end - k > 1) text += "-" + std::to_string(ids[end - 1]);
        k = end;
    }
    return text;
}

/// One line of the report: a title in a column, then what there is to say.
std::string row(const std::string& title, const std::string& text) {
    return titled_line(title, 28, text);
}

/// A count and the polygons that it counts.
std::string list_row(const std::string& title, const std::vector<PolygonId>& ids) {
    return row(title, number(ids.size()) + (ids.empty() ? "" : ": " + ranges(ids)));
}

std::string polygon_rows(const SceneInfo& info) {
    const Census& census = info.census;
    std::string text = row("polygons", number(info.scene.polygons().size()) + ", " + number(census.valid) + " valid, " +
                                           number(info.scene.invalid().size()) + " invalid");
    for (const InvalidPolygon& invalid : info.scene.invalid())
        text += "  invalid: polygon " + std::to_string(invalid.polygon) + ", line " + std::to_string(invalid.line) +
                ": " + invalid.reason + "\n";
    if (!info.scene.invalid().empty())
        text += "  other commands refuse this scene unless they run with --skip-invalid\n";
    text += row("pieces", number(info.scene.pieces().size()) + ": " + counted(census.pieces[0], "triangle") + ", " +
                              counted(census.pieces[1], "quadrilateral") + ", " + number(census.pieces[2]) +
                              " with more corners");
    text += row("most corners of a loop", number(census.most_corners));
    text += list_row("not planar", census.not_planar);
    text += list_row("  planar as decimal text", info.planar_as_decimal);
    text += list_row("planar, not convex", census.not_convex);
    text += list_row("with holes on bridges", census.with_bridges);
    text += list_row("with spikes", census.with_spikes);
    text += list_row("with straight angles", census.with_straight_angles);
    text += list_row("lights", census.lights);
    return text;
}

std::string contact_rows(const Census& census) {
    std::string text = row("exactly shared edges", number(census.shared_edges) + ", " + number(census.crowded_edges) +
                                                       " of them by three polygons or more");
    text += row("T-junctions", counted(census.t_junction_corners, "corner position") +
                                   " inside a side of another polygon, " + counted(census.t_junction_pairs, "pair"));
    text += row("coplanar overlapping pairs", number(census.overlap_pairs) + ", " +
                                                  number(census.same_facing_overlap_pairs) + " facing the same way");
    constexpr std::size_t most_shown = 20;
    for (std::size_t k = 0; k < census.overlaps.size() && k < most_shown; ++k) {
        const CoplanarOverlap& pair = census.overlaps[k];
        text += "  " + std::to_string(pair.first) + " and " + std::to_string(pair.second) +
                (pair.same_facing ? ", facing the same way" : ", facing opposite ways") +
                (pair.duplicate ? ", one loop\n" : "\n");
    }
    if (census.overlap_pairs > most_shown)
        text += "  and " + number(census.overlap_pairs - most_shown) + " more (--json lists them)\n";
    text += row("polygons repeating another", number(census.duplicates));
    return text;
}

std::string reader_rows(const SceneInfo& info) {
    std::string text;
    for (const auto& [statement, count] : info.read.skipped)
        text += row("skipped statement", statement + ", " + counted(count, "time"));
    for (const std::string& warning : info.read.warnings) text += row("warning", warning);
    return text;
}

/// Bits of the integers in which the orientation of four scene corners is exact: three differences of coordinates
/// multiplied, six products summed.
int orientation_bits(const Census& census) {
    return 3 * (census.bits + 1) + 4;
}

std::string arithmetic_needed(const Census& census) {
    const int bits = orientation_bits(census);
    const std::string grid = "coordinates are " + std::to_string(census.bits) + "-bit multiples of 2^" +
                             std::to_string(census.lowest_bit) + ": the orientation of four corners takes " +
                             std::to_string(bits) + " bits, ";
    if (bits <= 53) return grid + "exact in binary64";
    for (const int width : {128, 256, 512, 1024})
        if (bits <= width) return grid + "a filter and " + std::to_string(width) + "-bit integers behind it";
    return grid + "a filter and fractions behind it";
}

nlohmann::ordered_json json_polygons(const Scene& scene, const std::vector<PolygonId>& ids) {
    auto list = nlohmann::ordered_json::array();
    for (const PolygonId id : ids) list.push_back({{"polygon", id}, {"line", scene.polygon(id).line}});
    return list;
}

}  // namespace

std::vector<std::string> machinery(const SceneInfo& info) {
    const Census& census = info.census;
    std::vector<std::string> needs;
    const auto need_if = [&](std::size_t count, const std::string& sentence) {
        if (count > 0) needs.push_back(sentence);
    };
    need_if(info.scene.invalid().size(),
            "--skip-invalid: " + counted(info.scene.invalid().size(), "polygon") + " cannot be used");
    need_if(census.not_planar.size(), "cutting into triangles: " + counted(census.not_planar.size(), "polygon") +
                                          " not planar in binary64, " + number(info.planar_as_decimal.size()) +
                                          " of them planar as written");
    need_if(census.not_convex.size(),
            "unions of triangles: " + counted(census.not_convex.size(), "planar polygon") + " not convex");
    need_if(census.pieces[2],
            "roots inside a piece: " + counted(census.pieces[2], "piece") + " of more than 4 corners");
    need_if(census.valid, "exact arithmetic: " + arithmetic_needed(census));
    need_if(census.shared_edges + census.t_junction_pairs,
            "ties, as the ordinary case: " + counted(census.shared_edges, "shared edge") + " and " +
                counted(census.t_junction_pairs, "T-junction") + " touch boxes without crossing them");
    need_if(census.t_junction_pairs, "partial sides in 'shared': T-junctions share a part of a side, not an edge");
    need_if(census.overlap_pairs, "the open base of the box: " + counted(census.overlap_pairs, "pair") +
                                      " of polygons overlap in one plane and must cast nothing on each other");
    need_if(census.same_facing_overlap_pairs,
            "layers in transport (choice 9): " + counted(census.same_facing_overlap_pairs, "such pair") +
                " facing the same way");
    needs.push_back(census.lights.empty()
                        ? "no light: classification and visibility only; radiosity needs a material "
                          "with Ke"
                        : "facing tests for occluded buffers: " + counted(census.lights.size(), "light"));
    return needs;
}

std::string info_text(const SceneInfo& info) {
    std::string text = row("scene", info.scene.name());
    text += polygon_rows(info);
    if (info.census.valid > 0)
        text += row("bounding box", point_text(info.census.lowest) + " to " + point_text(info.census.highest));
    text += contact_rows(info.census);
    text += reader_rows(info);
    text += "this scene needs\n";
    for (const std::string& sentence : machinery(info)) text += "  " + sentence + "\n";
    text += omission_rows(info.omissions);
    return text;
}

nlohmann::ordered_json info_json(const SceneInfo& info) {
    const Scene& scene = info.scene;
    const Census& census = info.census;
    using Json = nlohmann::ordered_json;
    const auto triple = [](const Point& p) { return Json{p.x, p.y, p.z}; };

    Json json;
    json["scene"] = scene.name();
    json["polygons"] = scene.polygons().size();
    json["valid"] = census.valid;
    json["invalid"] = Json::array();
    for (const InvalidPolygon& invalid : scene.invalid())
        json["invalid"].push_back({{"polygon", invalid.polygon}, {"line", invalid.line}, {"reason", invalid.reason}});
    json["pieces"] = {
        {"triangles", census.pieces[0]}, {"quadrilaterals", census.pieces[1]}, {"more_corners", census.pieces[2]}};
    json["most_corners"] = census.most_corners;
    json["not_planar"] = json_polygons(scene, census.not_planar);
    json["planar_as_decimal_text"] = json_polygons(scene, info.planar_as_decimal);
    json["planar_not_convex"] = json_polygons(scene, census.not_convex);
    json["with_bridges"] = json_polygons(scene, census.with_bridges);
    json["with_spikes"] = json_polygons(scene, census.with_spikes);
    json["with_straight_angles"] = json_polygons(scene, census.with_straight_angles);
    json["lights"] = json_polygons(scene, census.lights);
    for (Json& light : json["lights"]) {
        const Material& material = scene.material(light["polygon"].get<PolygonId>());
        light["material"] = material.name;
        light["emitted_exitance"] = material.emitted_exitance;
    }
    if (census.valid > 0) json["bounding_box"] = {{"low", triple(census.lowest)}, {"high", triple(census.highest)}};
    json["shared_edges"] = census.shared_edges;
    json["edges_of_three_or_more"] = census.crowded_edges;
    json["t_junction_corners"] = census.t_junction_corners;
    json["t_junction_pairs"] = census.t_junction_pairs;
    json["t_junctions"] = Json::array();
    for (const TJunction& junction : census.t_junctions)
        json["t_junctions"].push_back({{"corner_of", junction.corner_of},
                                       {"position", triple(scene.position(junction.corner))},
                                       {"side_of", junction.side_of},
                                       {"side", junction.side}});
    json["coplanar_overlap_pairs"] = census.overlap_pairs;
    json["coplanar_overlap_pairs_same_facing"] = census.same_facing_overlap_pairs;
    json["coplanar_overlaps"] = Json::array();
    for (const CoplanarOverlap& pair : census.overlaps)
        json["coplanar_overlaps"].push_back({{"first", pair.first},
                                             {"second", pair.second},
                                             {"same_facing", pair.same_facing},
                                             {"duplicate", pair.duplicate}});
    json["polygons_repeating_another"] = census.duplicates;
    json["coordinate_bits"] = census.bits;
    json["coordinate_lowest_bit"] = census.lowest_bit;
    json["skipped_statements"] = info.read.skipped;
    json["warnings"] = info.read.warnings;
    json["needs"] = machinery(info);
    json["left_out"] = omissions_json(info.omissions);
    return json;
}

}  // namespace cob
