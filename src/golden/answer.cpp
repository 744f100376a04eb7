#include "golden/answer.hpp"

#include "cob/files.hpp"
#include "cob/irradiance_table.hpp"
#include "cob/manifest.hpp"
#include "scene/remarks.hpp"

namespace cob {

void refuse_unknown_polygon(const Scene& scene, PolygonId polygon) {
    if (polygon >= scene.polygon_count())
        throw InputError("no such polygon", {"", 0, std::to_string(polygon),
                                             "give -1 or 0 to " + std::to_string(scene.polygon_count() - 1)});
    if (polygon != no_polygon && !scene.polygon(polygon).valid)
        throw InputError("polygon is not valid", {"", 0, std::to_string(polygon), "give -1 or another polygon"});
}

namespace {

/// A set made with --skip-invalid says so: its polygons that SPEC 2 refuses keep their numbers.
bool made_with_invalid(const std::string& set) {
    const std::string path = set + "/manifest.json";
    if (!exists(path)) return false;
    const Manifest manifest = read_manifest(path);
    const auto found = manifest.parameters.find("skip_invalid");
    return found != manifest.parameters.end() && found->second == "true";
}

}  // namespace

AnswerSummary answer_set(const std::string& set, const std::string& folder, const AnswerOptions& options) {
    ReadOptions read;
    read.skip_invalid = options.skip_invalid || made_with_invalid(set);
    const std::string path = set + "/scene.obj";
    ReadReport report;
    const Scene scene = read_obj(path, read, &report);
    if (options.say)
        for (const std::string& remark : remarks_on(scene, report, path)) options.say(remark);

    AnswerSummary summary;
    const auto has = [&](const char* table) { return exists(set + "/" + table); };
    summary.has_boxes = has(table_name<BoxRow>());
    summary.has_segments = has(table_name<SegmentRow>());
    summary.has_points = has(table_name<PointRow>());
    if (!summary.has_boxes && !summary.has_segments && !summary.has_points)
        throw InputError("set without questions", {set, 0, "", "add boxes.csv, segments.csv or points.csv"});

    const auto source = make_candidates(scene, options.source);
    const OutputFolder created(folder);
    const AnswerJob job{scene, *source, set, folder, options};
    AnswerFiles files;
    if (options.peer != Peer::none) {
        answer_by_peer(job, files, summary);
        files.commit();
        return summary;
    }
    if (summary.has_boxes) answer_boxes(job, files, summary);
    if (summary.has_segments) answer_segments(job, files, summary);
    if (summary.has_points) {
        IrradianceTableOptions irradiance;
        irradiance.threads = options.threads;
        irradiance.progress = options.progress;
        summary.irradiances = write_irradiance(scene, *source, set + "/" + table_name<PointRow>(),
                                               folder + "/" + table_name<IrradianceRow>(), irradiance)
                                  .rows;
    }
    files.commit();
    return summary;
}

}  // namespace cob
