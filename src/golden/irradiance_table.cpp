#include "cob/irradiance_table.hpp"

#include "buffer/ordered_pipeline.hpp"
#include "cob/irradiance.hpp"
#include "golden/answer.hpp"

#include <chrono>

namespace cob {
namespace {

constexpr std::size_t block_size = 16;  ///< Points; each asks for all lights.

struct Block {
    std::vector<PointRow> points;
    std::string lines;
    IrradianceTableResult result;
};

void answer(const Scene& scene, const IrradianceOracle& oracle, const PointRow& point, Block& block) {
    for (PolygonId light : oracle.lights()) {
        const LightAtPoint seen = oracle(point.position, point.normal.rational(), light);
        IrradianceRow row{point.point, light, seen.unobstructed, seen.visible, {}};
        for (std::size_t channel = 0; channel < 3; ++channel)
            row.irradiance[channel] = seen.visible * scene.material(light).emitted_exitance[channel];
        append_row(block.lines, row);
        ++block.result.rows;
        if (row.visible < row.unobstructed) ++(row.visible > 0 ? block.result.partly : block.result.wholly);
    }
}

void check(const PointRow& point, const std::string& path) {
    if (point.normal.rational() == RationalPoint{})
        throw InputError("the normal is zero", {path, point.line, "0,0,0", "give a direction, of any length"});
}

/// Counts and checks all rows and, where somebody wants to know, times a few, spread over the first ones.
IrradianceCost estimate(const Scene& scene, const IrradianceOracle& oracle, const std::string& path, bool timed) {
    IrradianceCost cost;
    cost.lights = oracle.lights().size();
    std::vector<PointRow> samples;
    TableReader<PointRow> reader(path);
    for (PointRow point; reader.next(point); ++cost.points) {
        check(point, path);
        if (timed && samples.size() < 16 && cost.points % 7 == 0) samples.push_back(point);
    }
    if (samples.empty()) return cost;
    const auto start = std::chrono::steady_clock::now();
    Block block;
    for (const PointRow& point : samples) answer(scene, oracle, point, block);
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
    cost.seconds = spent.count() / static_cast<double>(samples.size()) * static_cast<double>(cost.points);
    return cost;
}

}  // namespace

IrradianceTableResult write_irradiance(const Scene& scene, const CandidateSource& candidates, const std::string& points,
                                       const std::string& out, const IrradianceTableOptions& options) {
    const IrradianceOracle oracle(scene, candidates);
    const IrradianceCost cost = estimate(scene, oracle, points, static_cast<bool>(options.tell_cost));
    if (options.tell_cost) options.tell_cost(cost);

    IrradianceTableResult result;
    TableReader<PointRow> reader(points);
    TableWriter<IrradianceRow> writer(out);
    std::uint64_t done = 0;
    ordered_pipeline<Block>(
        thread_count(options.threads),
        [&](Block& block) {
            block.points = read_rows(reader, block_size);
            return !block.points.empty();
        },
        [&](Block& block) {
            for (const PointRow& point : block.points) answer(scene, oracle, point, block);
        },
        [&](const Block& block) {
            writer.write_lines(block.lines);
            result.rows += block.result.rows;
            result.partly += block.result.partly;
            result.wholly += block.result.wholly;
            done += block.points.size();
            if (options.progress) options.progress(done, cost.points);
        });
    writer.commit();
    return result;
}

}  // namespace cob
