#include "cob/irradiance_table.hpp"

#include "cob/error.hpp"
#include "cob/irradiance.hpp"
#include "cob/tables.hpp"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <chrono>

namespace cob {
namespace {

constexpr std::size_t batch = 1024;  ///< Points read, answered and written together.

std::vector<IrradianceRow> answer(const Scene& scene, const IrradianceOracle& oracle, const PointRow& point) {
    std::vector<IrradianceRow> rows;
    for (PolygonId light : oracle.lights()) {
        const LightAtPoint seen = oracle(point.position, point.normal.rational(), light);
        IrradianceRow row{point.point, light, seen.unobstructed, seen.visible, {}};
        for (std::size_t channel = 0; channel < 3; ++channel)
            row.irradiance[channel] = seen.visible * scene.material(light).emitted_exitance[channel];
        rows.push_back(row);
    }
    return rows;
}

void check(const PointRow& point, const std::string& path) {
    if (point.normal.rational() == RationalPoint{})
        throw InputError("the normal is zero", {path, point.line, "0,0,0", "give a direction, of any length"});
}

/// Counts and checks all rows, and times a few, spread over the first ones.
IrradianceCost estimate(const Scene& scene, const IrradianceOracle& oracle, const std::string& path) {
    IrradianceCost cost;
    cost.lights = oracle.lights().size();
    std::vector<PointRow> samples;
    TableReader<PointRow> reader(path);
    for (PointRow point; reader.next(point); ++cost.points) {
        check(point, path);
        if (samples.size() < 16 && cost.points % 7 == 0) samples.push_back(point);
    }
    if (samples.empty()) return cost;
    const auto start = std::chrono::steady_clock::now();
    for (const PointRow& point : samples) answer(scene, oracle, point);
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
    cost.seconds = spent.count() / static_cast<double>(samples.size()) * static_cast<double>(cost.points);
    return cost;
}

}  // namespace

IrradianceTableResult write_irradiance(const Scene& scene, const CandidateSource& candidates, const std::string& points,
                                       const std::string& out, const IrradianceTableOptions& options) {
    const IrradianceOracle oracle(scene, candidates);
    const IrradianceCost cost = estimate(scene, oracle, points);
    if (options.tell_cost) options.tell_cost(cost);

    IrradianceTableResult result;
    TableReader<PointRow> reader(points);
    TableWriter<IrradianceRow> writer(out);
    std::uint64_t done = 0;
    for (bool more = true; more;) {
        std::vector<PointRow> asked;
        for (PointRow point; asked.size() < batch && (more = reader.next(point));) asked.push_back(point);
        std::vector<std::vector<IrradianceRow>> answers(asked.size());
        const auto work = [&] {
            tbb::parallel_for(std::size_t{0}, asked.size(),
                              [&](std::size_t k) { answers[k] = answer(scene, oracle, asked[k]); });
        };
        if (options.threads == 0)
            work();
        else
            tbb::task_arena(options.threads).execute(work);
        for (const auto& rows : answers)
            for (const IrradianceRow& row : rows) {
                writer.write(row);
                ++result.rows;
                if (row.visible < row.unobstructed) ++(row.visible > 0 ? result.partly : result.wholly);
            }
        done += asked.size();
        if (options.progress) options.progress(done, cost.points);
    }
    writer.commit();
    return result;
}

}  // namespace cob
