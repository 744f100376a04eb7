#include "cob/form_factors.hpp"

#include "arithmetic/shared_progress.hpp"
#include "arithmetic/threads.hpp"
#include "cob/error.hpp"
#include "radiosity/flux_forecast.hpp"
#include "radiosity/photometric_range.hpp"
#include "radiosity/piece_pair.hpp"
#include "radiosity/plane_sheets.hpp"

#include <algorithm>
#include <cmath>

namespace cob {

using namespace radiosity;

namespace {

/// Added to every error: areas, sums and quotients are rounded, and so are the closed forms in binary64 that values
/// are compared with, whose terms cancel.
constexpr double rounding = 1e-12;

/// Two polygons, the smaller first, and the pairs of their pieces that may exchange light.
struct PolygonPair {
    PolygonId smaller = 0, larger = 0;
    std::vector<PiecePair> pieces;

    bool has(Passage passage) const {
        return std::any_of(pieces.begin(), pieces.end(), [&](const PiecePair& p) { return p.passage == passage; });
    }
};

struct PairFlux {
    Integral flux;
    std::uint64_t evaluations = 0;
};

}  // namespace

struct FormFactorMatrix::Implementation {
    Implementation(const Scene& s, const CandidateSource& c, const FormFactorOptions& o)
        : scene(s), candidates(c), options(o), pieces(s), context{scene, candidates, pieces, polygons} {
        for (PolygonId polygon = 0; polygon < scene.polygon_count(); ++polygon) polygons.push_back(parts_of(polygon));
    }

    PolygonParts parts_of(PolygonId polygon) const {
        PolygonParts parts;
        const Polygon& shape = scene.polygon(polygon);
        for (std::uint32_t k = 0; k < shape.piece_count; ++k) {
            parts.pieces.push_back(static_cast<PieceId>(shape.first_piece + k));
            ConvexPolygon scaled = polygon_of(scene, scene.piece(parts.pieces.back()));
            for (RationalPoint& corner : scaled) corner = Rational(pieces.scale()) * corner;
            parts.area += area(scaled);
        }
        for (PolygonId sheet : sheets_on_top(scene, polygon, candidates))
            for (std::uint32_t k = 0; k < scene.polygon(sheet).piece_count; ++k)
                parts.on_top.push_back(static_cast<PieceId>(scene.polygon(sheet).first_piece + k));
        return parts;
    }

    void check(PolygonId polygon) const {
        if (polygon < 0 || polygon >= scene.polygon_count() || !scene.polygon(polygon).valid)
            throw InputError("no such polygon", {scene.name(), 0, std::to_string(polygon),
                                                 "give numbers from 0 to " + std::to_string(scene.polygon_count() - 1) +
                                                     " of valid polygons"});
    }

    PolygonPair prepare(PolygonId i, PolygonId j) const {
        for (const PolygonId k : {i, j}) refuse_too_small(scene, k, polygons[static_cast<std::size_t>(k)].area);
        PolygonPair pair;
        const bool keep = polygons[i].area < polygons[j].area || (polygons[i].area == polygons[j].area && i <= j);
        pair.smaller = keep ? i : j, pair.larger = keep ? j : i;
        for (PieceId a : polygons[pair.smaller].pieces)
            for (PieceId b : polygons[pair.larger].pieces) {
                if (a == b || (i == j && a > b)) continue;
                PiecePair part = make_pair(context, a, b);
                if (part.passage != Passage::not_facing) pair.pieces.push_back(std::move(part));
            }
        return pair;
    }

    /// Of each of a pair's pairs of pieces.
    QuadratureOptions quadrature(const PolygonPair& pair, const std::function<void()>& pulse) const {
        const double parts = static_cast<double>(std::max<std::size_t>(1, pair.pieces.size()));
        return {0.5 * options.tolerance * polygons[pair.smaller].area / parts,
                options.certified ? options.max_subdivisions : options.max_evaluations, pulse};
    }
    /// A_i F_ij of a pair; receiving at the larger polygon instead where turned.
    PairFlux flux(const PolygonPair& pair, bool turned, const std::function<void()>& pulse) const;

    bool above_goal(const PolygonPair& pair, const Integral& flux) const {
        return flux.error / polygons[pair.smaller].area + rounding > options.tolerance;
    }
    /// Of the same flux from both sides: what both bounds leave, or the better estimate.
    PairFlux better(const PairFlux& a, const PairFlux& b) const;

    const Scene& scene;
    const CandidateSource& candidates;
    FormFactorOptions options;
    PreparedPieces pieces;
    std::vector<PolygonParts> polygons;
    PairContext context;
    std::vector<PolygonPair> pairs;
};

PairFlux FormFactorMatrix::Implementation::better(const PairFlux& a, const PairFlux& b) const {
    PairFlux result = a.flux.error <= b.flux.error ? a : b;
    result.evaluations = a.evaluations + b.evaluations;
    if (!options.certified) return result;
    const double low = std::max(a.flux.value - a.flux.error, b.flux.value - b.flux.error),
                 high = std::min(a.flux.value + a.flux.error, b.flux.value + b.flux.error);
    const double roundings = 0x1p-50 * (std::abs(a.flux.value) + a.flux.error + std::abs(b.flux.value) + b.flux.error);
    if (high - low + 2 * roundings < 2 * result.flux.error)
        result.flux = {(low + high) / 2, (high - low) / 2 + roundings};
    return result;
}

PairFlux FormFactorMatrix::Implementation::flux(const PolygonPair& pair, bool turned,
                                                const std::function<void()>& pulse) const {
    PairFlux sum;
    const QuadratureOptions each = quadrature(pair, pulse);
    const auto integrate = options.certified ? certified_flux : flux_between;
    for (const PiecePair& part : pair.pieces) {
        const QuadratureResult result = turned ? integrate(context, make_pair(context, part.light, part.receiver), each)
                                               : integrate(context, part, each);
        sum.flux += result.visible;
        sum.evaluations += result.evaluations;
    }
    if (pair.smaller == pair.larger) sum.flux.value *= 2, sum.flux.error *= 2;  // each pair of pieces, both ways
    return sum;
}

FormFactorMatrix::FormFactorMatrix(const Scene& scene, const CandidateSource& candidates,
                                   const FormFactorOptions& options)
    : implementation_(std::make_unique<Implementation>(scene, candidates, options)) {}
FormFactorMatrix::~FormFactorMatrix() = default;

FormFactorPlan FormFactorMatrix::plan(const std::vector<std::pair<PolygonId, PolygonId>>& asked,
                                      const Progress& progress) {
    Implementation& self = *implementation_;
    std::vector<std::pair<PolygonId, PolygonId>> pairs;
    for (const auto& [i, j] : asked) {
        self.check(i), self.check(j);
        pairs.emplace_back(std::min(i, j), std::max(i, j));
    }
    if (asked.empty())
        for (PolygonId i = 0; i < self.scene.polygon_count(); ++i)
            for (PolygonId j = i; j < self.scene.polygon_count(); ++j)
                if (self.scene.polygon(i).valid && self.scene.polygon(j).valid) pairs.emplace_back(i, j);
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());

    self.pairs.assign(pairs.size(), {});
    SharedProgress counter(progress, pairs.size());
    in_parallel(self.options.threads, pairs.size(), [&](std::size_t k) {
        self.pairs[k] = self.prepare(pairs[k].first, pairs[k].second);
        counter.step();
    });

    FormFactorPlan plan;
    plan.pairs = pairs.size();
    std::uint64_t obstructed_parts = 0;
    std::vector<std::pair<const PolygonPair*, const PiecePair*>> timed;
    for (const PolygonPair& pair : self.pairs) {
        const bool obstructed = pair.has(Passage::obstructed), free = pair.has(Passage::unobstructed);
        ++(pair.pieces.empty() ? plan.not_facing
           : obstructed        ? plan.obstructed
           : free              ? plan.unobstructed
                               : plan.hidden);
        for (const PiecePair& part : pair.pieces)
            if (part.passage == Passage::obstructed) {
                ++obstructed_parts;
                plan.occluders += static_cast<double>(part.occluders.size());
                timed.emplace_back(&pair, &part);
            }
    }
    if (obstructed_parts == 0) return plan;
    plan.occluders /= static_cast<double>(obstructed_parts);
    // A few, spread over all.
    const std::size_t samples = std::min<std::size_t>(timed.size(), 12);
    const double each = static_cast<double>(obstructed_parts) / static_cast<double>(samples);
    for (std::size_t k = 0; k < samples; ++k) {
        const auto& [pair, part] = timed[k * timed.size() / samples];
        const QuadratureOptions quadrature = self.quadrature(*pair, [&counter] { counter.pulse(); });
        const FluxForecast forecast =
            forecast_flux(self.context, *part, {quadrature, self.options.certified, self.options.both_sides, samples});
        plan.evaluations += each * forecast.evaluations;
        plan.seconds += each * forecast.seconds;
    }
    return plan;
}

FormFactorResult FormFactorMatrix::compute(const Progress& progress) const {
    const Implementation& self = *implementation_;
    std::vector<std::array<PairFlux, 2>> fluxes(self.pairs.size());
    SharedProgress counter(progress, self.pairs.size());
    in_parallel(self.options.threads, self.pairs.size(), [&](std::size_t k) {
        const auto pulse = [&counter] { counter.pulse(); };
        const PolygonPair& pair = self.pairs[k];
        fluxes[k][0] = self.flux(pair, false, pulse);
        if (self.options.both_sides && pair.smaller != pair.larger)
            fluxes[k][1] = self.flux(pair, true, pulse);
        else if (!self.options.both_sides && self.above_goal(pair, fluxes[k][0].flux))
            fluxes[k][0] = self.better(fluxes[k][0], self.flux(pair, true, pulse));
        counter.step();
    });

    FormFactorResult result;
    const auto add = [&](PolygonId from, PolygonId to, const Integral& flux) {
        const double value = flux.value / self.polygons[from].area;
        // It is from 0 to 1, whatever was lost to rounding.
        const double error = std::isfinite(value) ? std::min(1.0, flux.error / self.polygons[from].area + rounding) : 1;
        if (!(value > 0) && error <= self.options.tolerance) return;
        result.values.push_back({from, to, value > 0 ? std::min(value, 1.0) : 0, error});
        if (error > self.options.tolerance) ++result.above_goal;
    };
    for (std::size_t k = 0; k < fluxes.size(); ++k) {
        const PolygonPair& pair = self.pairs[k];
        const Integral &one = fluxes[k][0].flux, &two = self.options.both_sides ? fluxes[k][1].flux : one;
        result.evaluations += fluxes[k][0].evaluations + fluxes[k][1].evaluations;
        add(pair.smaller, pair.larger, one);
        if (pair.smaller == pair.larger) continue;
        add(pair.larger, pair.smaller, two);
        if (!self.options.both_sides || one.value + two.value == 0) continue;
        const double difference = std::abs(one.value - two.value);
        result.reciprocity = std::max(result.reciprocity, difference / self.polygons[pair.smaller].area);
        const double errors = one.error + two.error + rounding * self.polygons[pair.smaller].area;
        result.reciprocity_in_errors = std::max(result.reciprocity_in_errors, difference / errors);
    }
    std::sort(result.values.begin(), result.values.end(), [](const PolygonFormFactor& a, const PolygonFormFactor& b) {
        return std::pair(a.from, a.to) < std::pair(b.from, b.to);
    });
    return result;
}

}  // namespace cob
