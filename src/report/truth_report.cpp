#include "report/truth_report.hpp"

#include "arithmetic/shared_progress.hpp"
#include "arithmetic/threads.hpp"
#include "cob/files.hpp"
#include "cob/irradiance.hpp"
#include "cob/patch_visibility.hpp"
#include "geometry/convex_polygon.hpp"
#include "report/text.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>

namespace cob {
namespace {

constexpr int grid = 5;  ///< Samples along a side.
/// Pairs of sub-patches looked at for a segment to a light that no sample sees.
constexpr std::uint64_t pairs_between_samples = 3000;

/// Place of a sample along a side. Neighbours are just within a quarter, and the outermost near the ends: the sharp
/// shadow of what stands or hovers at an element's side is near that side.
constexpr double place_of(int k) {
    return (3 + 62 * k) / 256.0;
}

/// A sample point and its place in the grid.
struct Sample {
    int i, j;
    ExactPoint point;
};

std::vector<Sample> samples_of(const Scene& scene, const Root& root, const Element& element) {
    std::vector<Sample> samples;
    for (int i = 0; i < grid; ++i)
        for (int j = 0; j < grid; ++j) {
            const double s = place_of(i), t = place_of(j);
            if (root.corner_count() == 4 || s + t < 1) samples.push_back({i, j, point_in(scene, root, element, s, t)});
        }
    return samples;
}

/// What one light does to one element.
struct LightOnElement {
    bool faces = false, boundary = false, sharp = false;
    bool hidden_by_one = false;      ///< By one polygon, from every piece of the light that faces it.
    std::vector<double> hemisphere;  ///< At each sample: seen solid angle as a share of the hemisphere's.
};

/// What is true of one element.
struct ElementTruth {
    std::uint64_t element = 0;
    BufferState state = BufferState::empty;
    int lights = 0, boundaries = 0, sharp = 0;
    double hemisphere = 0;  ///< Largest share of the hemisphere from which a sample is lit.
    bool together = false;  ///< Faces lights, all out of sight, one of them by no one polygon.

    bool vain() const { return state == BufferState::close && boundaries == 0; }
    bool missed() const { return state != BufferState::close && sharp > 0; }
    bool lit_though_occluded() const { return state == BufferState::occluded && (hemisphere > 0 || boundaries > 0); }
    bool shut_out_together() const { return state != BufferState::occluded && together; }
};

class Judge {
public:
    Judge(const ElementList& elements, const CandidateSource& source)
        : elements_(elements), visibility_(elements.scene(), source), irradiance_(elements.scene(), source) {}

    std::size_t lights() const { return irradiance_.lights().size(); }
    /// An element at the ends of binary64 may take minutes: the pulse is called now and then and may throw.
    ElementTruth operator()(std::uint64_t number, BufferState state, const std::function<void()>& pulse) const;

private:
    LightOnElement relate(const Element& element, const ConvexPatch& patch, PolygonId light,
                          const std::function<void()>& pulse) const;
    bool is_lit_between(const ConvexPatch& patch, const std::vector<ConvexPatch>& parts,
                        const std::function<void()>& pulse) const;

    const ElementList& elements_;
    PatchVisibility visibility_;
    IrradianceOracle irradiance_;
};

LightOnElement Judge::relate(const Element& element, const ConvexPatch& patch, PolygonId light,
                             const std::function<void()>& pulse) const {
    const Scene& scene = elements_.scene();
    const Root& root = elements_.root_of(element);
    LightOnElement result;

    // The exact relations to the light's pieces.
    std::vector<ConvexPatch> neither;
    int visible = 0, facing = 0;
    for (const Piece& piece : scene.pieces_of(light)) {
        const ConvexPatch part = patch_of(scene, piece);
        const PatchAnswer answer = visibility_(patch, part, {1, 0, 0, pulse});
        if (!answer.facing) continue;
        ++facing;
        visible += answer.relation == PatchRelation::visible;
        if (answer.relation != PatchRelation::visible && answer.relation != PatchRelation::hidden)
            neither.push_back(part);
    }
    result.faces = facing > 0;
    result.hidden_by_one = facing > 0 && visible == 0 && neither.empty();
    if (!result.faces || result.hidden_by_one) return result;

    // The light as samples see it.
    const RationalPoint normal = area_vector(polygon_of(corners(scene, root, element)));
    const std::vector<Sample> samples = samples_of(scene, root, element);
    std::vector<std::optional<double>> shares;
    const double hemisphere = 2 * std::acos(-1.0);
    for (const Sample& sample : samples) {
        pulse();
        const LightAtPoint seen = irradiance_(sample.point, normal, light);
        result.hemisphere.push_back(seen.solid_angle / hemisphere);
        shares.push_back(seen.unobstructed > 0 ? std::optional(seen.visible / seen.unobstructed) : std::nullopt);
    }
    if (visible == facing) return result;
    result.boundary = std::any_of(result.hemisphere.begin(), result.hemisphere.end(), [](double s) { return s > 0; });
    if (!result.boundary) result.boundary = is_lit_between(patch, neither, pulse);
    for (std::size_t p = 0; p < samples.size(); ++p)
        for (std::size_t q = 0; q < p; ++q)
            if (std::abs(samples[p].i - samples[q].i) + std::abs(samples[p].j - samples[q].j) == 1 && shares[p] &&
                shares[q] && std::abs(*shares[p] - *shares[q]) >= 0.5)
                result.sharp = true;
    return result;
}

/// No sample sees these parts of a light: whether a segment elsewhere does.
bool Judge::is_lit_between(const ConvexPatch& patch, const std::vector<ConvexPatch>& parts,
                           const std::function<void()>& pulse) const {
    return std::any_of(parts.begin(), parts.end(), [&](const ConvexPatch& part) {
        return visibility_(patch, part, {0, 0, pairs_between_samples, pulse}).clear.has_value();
    });
}

ElementTruth Judge::operator()(std::uint64_t number, BufferState state, const std::function<void()>& pulse) const {
    const Element element = elements_[number];
    ElementTruth truth;
    truth.element = number;
    truth.state = state;
    const ConvexPatch patch = patch_of(corners(elements_.scene(), elements_.root_of(element), element));
    bool several = false;
    std::vector<double> hemisphere;
    for (PolygonId light : irradiance_.lights()) {
        if (light == elements_.root_of(element).polygon) continue;
        const LightOnElement seen = relate(element, patch, light, pulse);
        truth.lights += seen.faces;
        truth.boundaries += seen.boundary;
        truth.sharp += seen.sharp;
        several = several || (seen.faces && !seen.hidden_by_one);
        hemisphere.resize(std::max(hemisphere.size(), seen.hemisphere.size()));
        for (std::size_t k = 0; k < seen.hemisphere.size(); ++k) hemisphere[k] += seen.hemisphere[k];
    }
    for (double share : hemisphere) truth.hemisphere = std::max(truth.hemisphere, share);
    truth.together = several && truth.hemisphere == 0 && truth.boundaries == 0;
    return truth;
}

TruthSummary summarise(const std::vector<ElementTruth>& truths) {
    TruthSummary summary;
    summary.sampled = truths.size();
    for (const ElementTruth& truth : truths) {
        summary.empty += truth.state == BufferState::empty;
        summary.close += truth.state == BufferState::close;
        summary.occluded += truth.state == BufferState::occluded;
        summary.boundary += truth.boundaries > 0;
        summary.sharp += truth.sharp > 0;
        summary.refined_in_vain += truth.vain();
        summary.sharp_missed += truth.missed();
        summary.shut_out_together += truth.shut_out_together();
        if (!truth.lit_though_occluded()) continue;
        ++summary.occluded_lit;
        summary.occluded_lit_hemisphere = std::max(summary.occluded_lit_hemisphere, truth.hemisphere);
    }
    return summary;
}

std::string rows_of(const std::vector<ElementTruth>& truths) {
    std::string text = "box,state,lights,boundaries,sharp,hemisphere,verdict\n";
    for (const ElementTruth& truth : truths) {
        const char* verdict = truth.missed()                ? "sharp missed"
                              : truth.vain()                ? "refined in vain"
                              : truth.lit_though_occluded() ? "occluded but lit"
                              : truth.shut_out_together()   ? "shut out together"
                                                            : "";
        text += std::to_string(truth.element) + ',' + to_text(truth.state) + ',' + std::to_string(truth.lights) + ',' +
                std::to_string(truth.boundaries) + ',' + std::to_string(truth.sharp) + ',' + to_text(truth.hemisphere) +
                ',' + verdict + '\n';
    }
    return text;
}

std::string row_of(const std::string& scene, const TruthSummary& s) {
    std::string text =
        "scene,elements,sampled,lights,empty,close,occluded,boundary,sharp,refined_in_vain,sharp_missed,occluded_lit,"
        "occluded_lit_hemisphere,shut_out_together\n" +
        csv_cell(scene);
    for (std::uint64_t value : {s.elements, s.sampled, s.lights, s.empty, s.close, s.occluded, s.boundary, s.sharp,
                                s.refined_in_vain, s.sharp_missed, s.occluded_lit})
        text += ',' + std::to_string(value);
    return text + ',' + to_text(s.occluded_lit_hemisphere) + ',' + std::to_string(s.shut_out_together) + '\n';
}

std::string name_of(const std::string& path) {
    const std::size_t slash = path.find_last_of('/');
    return slash == std::string::npos ? path : path.substr(slash + 1);
}

}  // namespace

TruthSummary write_truth(const ElementList& elements, const CandidateSource& source, const std::string& folder,
                         const TruthOptions& options) {
    const auto start = std::chrono::steady_clock::now();
    const auto seconds = [&start] {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    };
    const Judge judge(elements, source);

    // Which elements.
    const std::uint64_t lights = std::max<std::uint64_t>(1, judge.lights());
    const std::uint64_t most = std::max<std::uint64_t>(1, options.max_pairs / lights);
    const std::uint64_t stride = elements.size() <= most ? 1 : (elements.size() + most - 1) / most;
    const std::uint64_t count = (elements.size() + stride - 1) / stride;

    // What it will cost, from the first few spread over all. An element may take seconds: each is told.
    SharedProgress progress(options.progress, count);
    const auto judge_block = [&](std::uint64_t begin, std::uint64_t end, std::uint64_t step, ElementTruth* out) {
        ElementClassifier classifier(elements, source, options.classify);
        ClassifiedElement classified;
        const auto pulse = [&progress] { progress.pulse(); };
        for (std::uint64_t k = begin; k < end; k += step) {
            pulse();
            classifier(k * stride, classified);
            *out++ = judge(k * stride, classified.inherited ? *classified.inherited : classified.found.state, pulse);
        }
    };
    if (options.say && count > 0) {
        const std::uint64_t step = (count + 7) / 8;
        std::vector<ElementTruth> first((count + step - 1) / step);
        judge_block(0, count, step, first.data());
        options.say(printed("truth: %llu of %llu elements, %llu lights: about %.1f s of one core",
                            static_cast<unsigned long long>(count), static_cast<unsigned long long>(elements.size()),
                            static_cast<unsigned long long>(judge.lights()),
                            seconds() / static_cast<double>(first.size()) * static_cast<double>(count)));
    }

    // All of them.
    std::vector<ElementTruth> truths(count);
    in_parallel(options.threads, (count + 15) / 16, [&](std::size_t block) {
        const std::uint64_t begin = 16 * block, end = std::min<std::uint64_t>(begin + 16, count);
        judge_block(begin, end, 1, truths.data() + begin);
        progress.step(end - begin);
    });

    TruthSummary summary = summarise(truths);
    summary.elements = elements.size();
    summary.lights = judge.lights();
    summary.seconds = seconds();
    create_folder(folder);
    write_file(folder + "/truth.csv", rows_of(truths));
    write_file(folder + "/truth_summary.csv", row_of(name_of(elements.scene().name()), summary));
    return summary;
}

std::string to_text(const TruthSummary& s) {
    const auto n = [](std::uint64_t value) { return static_cast<unsigned long long>(value); };
    return printed(
        "truth (%llu of %llu elements, %llu lights, %.1f s)\n"
        "  states                        %llu empty, %llu close, %llu occluded\n"
        "  with a shadow boundary        %llu\n"
        "  with a sharp one              %llu\n"
        "  refined in vain               %llu  (close, no boundary)\n"
        "  sharp shadows missed          %llu  (sharp boundary, not close)\n"
        "  occluded, yet lit             %llu  (at most %.3g of the hemisphere)\n"
        "  shut out by several together  %llu  (not occluded, no light reaches it)\n",
        n(s.sampled), n(s.elements), n(s.lights), s.seconds, n(s.empty), n(s.close), n(s.occluded), n(s.boundary),
        n(s.sharp), n(s.refined_in_vain), n(s.sharp_missed), n(s.occluded_lit), s.occluded_lit_hemisphere,
        n(s.shut_out_together));
}

}  // namespace cob
