#include "radiosity/transport.hpp"

#include "radiosity/lambert_sum.hpp"
#include "radiosity/shaft.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace cob::radiosity {
namespace {

constexpr double pi = 3.14159265358979323846;
/// A third on a binary grid: sample points are exact dyadic combinations of corners (SPEC 1).
constexpr double third = 1365.0 / 4096.0;
/// Up to here which pieces lie behind which planes is kept as a matrix of bits.
constexpr std::size_t most_pieces_in_matrix = 4096;
constexpr std::int8_t uncertain = 2;

/// Centres of count = k^2 equal parts, k a power of two.
std::vector<Sample> stratified(bool triangle, int count) {
    int k = 1;
    while (k * k < count) k *= 2;
    std::vector<Sample> result;
    for (int j = 0; j < k; ++j)
        for (int i = 0; i < (triangle ? k - j : k); ++i) {
            const double a = triangle ? third : 0.5;
            result.push_back({(i + a) / k, (j + a) / k, {}, false});
            if (triangle && i + j + 1 < k) result.push_back({(i + 1 - a) / k, (j + 1 - a) / k, {}, false});
        }
    return result;
}

}  // namespace

Transport::Transport(const Scene& scene, const Mesh& mesh, const CandidateSource& candidates, const Sheets& sheets,
                     const RadiosityOptions& options)
    : scene_(scene),
      mesh_(mesh),
      candidates_(candidates),
      sheets_(sheets),
      keep_all_(options.keep_all),
      samples_(options.samples),
      mixed_samples_(options.mixed_samples),
      planes_(scene, mesh.exponent()),
      oracle_(scene, candidates),
      receiving_{stratified(true, options.receiving_points), stratified(false, options.receiving_points)} {
    const std::size_t count = scene.pieces().size();
    if (count > most_pieces_in_matrix) return;
    behind_words_ = (count + 63) / 64;
    behind_.resize(behind_words_ * count);
    tbb::parallel_for(std::size_t(0), count, [&](std::size_t plane) {
        for (std::size_t piece = 0; piece < count; ++piece)
            if (planes_.wholly_behind(static_cast<PieceId>(piece), static_cast<PieceId>(plane)))
                behind_[plane * behind_words_ + piece / 64] |= std::uint64_t(1) << (piece % 64);
    });
}

bool Transport::behind(PieceId piece, PieceId plane) const {
    if (behind_.empty()) return planes_.wholly_behind(piece, plane);
    const auto k = static_cast<std::size_t>(piece);
    return (behind_[static_cast<std::size_t>(plane) * behind_words_ + k / 64] >> (k % 64) & 1) != 0;
}

Point Transport::point(NodeId id, double s, double t) const {
    const Node& n = mesh_.node(id);
    const auto at = [&](std::size_t k) { return mesh_.vertices()[static_cast<std::size_t>(n.corners[k])].position; };
    if (n.corner_count() == 3) return (1 - s - t) * at(0) + (s * at(1) + t * at(2));
    return (1 - t) * ((1 - s) * at(0) + s * at(1)) + t * ((1 - s) * at(3) + s * at(2));
}

ExactPoint Transport::exact(NodeId element, const Sample& sample) const {
    const Element& e = mesh_.node(element).element;
    return point_in(scene_, mesh_.roots()[e.root], e, sample.s, sample.t);
}

bool Transport::in_front(PieceId plane, NodeId element, const Sample& sample) const {
    const std::optional<Sign> quick = planes_.side(plane, sample.position);
    return (quick ? *quick : planes_.exact_side(plane, exact(element, sample))) == Sign::positive;
}

// -------------------------------------------------------------------------------------------------- the shooter

std::vector<Sample> Transport::samples_of(NodeId patch, int count) const {
    const Node& n = mesh_.node(patch);
    const PolygonId polygon = mesh_.roots()[n.element.root].polygon;
    std::vector<Sample> samples = stratified(n.corner_count() == 3, count);
    for (Sample& sample : samples) {
        sample.position = point(patch, sample.s, sample.t);
        sample.hidden = !sheets_.above(polygon).empty() && sheets_.hides(polygon, exact(patch, sample));
    }
    return samples;
}

Shot Transport::make_shot(NodeId patch, const Rgb& exitance) const {
    const Node& n = mesh_.node(patch);
    const Root& root = mesh_.roots()[n.element.root];
    Shot shot;
    shot.patch = patch;
    shot.exitance = exitance;
    shot.piece = root.piece;
    shot.corner_count = n.corner_count();
    for (int k = 0; k < shot.corner_count; ++k) {
        const auto c = static_cast<std::size_t>(k);
        shot.corners[c] = mesh_.vertices()[static_cast<std::size_t>(n.corners[c])].position;
    }
    shot.bounds = bounds_of(shot.corners.data(), shot.corner_count);
    shot.samples = samples_of(patch, samples_);
    shot.mixed_samples = samples_of(patch, mixed_samples_);
    return shot;
}

bool Transport::apart(const Shot& shot, RootId receiver) const {
    const PieceId piece = mesh_.roots()[receiver].piece;
    return piece == shot.piece || behind(piece, shot.piece) || behind(shot.piece, piece);
}

// --------------------------------------------------------------------------------------------- the closed form

double Transport::form_factor(const Shot& shot, const Point& at, const Point& normal, TransportScratch& scratch) const {
    ++scratch.form_factors;
    std::array<Point, 4> r;
    std::array<Point, 8> clipped;
    for (std::size_t k = 0; k < static_cast<std::size_t>(shot.corner_count); ++k) r[k] = shot.corners[k] - at;
    const int count = clip_to_horizon(normal, r.data(), shot.corner_count, clipped.data());
    if (count == 0) return 0;
    const LambertSum<double> sum = lambert_sum(normal, clipped.data(), count);
    // What does not stand out of rounding is as good as nothing: in one plane, or seen edge on.
    return sum.value > lambert_error<double>() * sum.condition ? sum.value / (2 * pi) : 0;
}

double Transport::unobstructed(const Shot& shot, NodeId element, TransportScratch& scratch) const {
    const Node& n = mesh_.node(element);
    const double middle = n.corner_count() == 3 ? third : 0.5;
    const PieceId piece = mesh_.roots()[n.element.root].piece;
    return form_factor(shot, point(element, middle, middle), planes_.normal(piece), scratch);
}

// ------------------------------------------------------------------------------------------------ what is between

void Transport::find_between(const Shot& shot, NodeId patch, TransportScratch& scratch) const {
    scratch.between.clear();
    scratch.last_blocker = 0;
    if (keep_all_) return;
    const Node& n = mesh_.node(patch);
    std::array<Point, 4> corners;
    const int count = n.corner_count();
    for (std::size_t k = 0; k < static_cast<std::size_t>(count); ++k)
        corners[k] = mesh_.vertices()[static_cast<std::size_t>(n.corners[k])].position;
    const Shaft shaft(shot.bounds, bounds_of(corners.data(), count));
    const PieceId plane = mesh_.roots()[n.element.root].piece;

    if (!behind_.empty()) {
        const std::uint64_t* behind_shooter = &behind_[static_cast<std::size_t>(shot.piece) * behind_words_];
        const std::uint64_t* behind_receiver = &behind_[static_cast<std::size_t>(plane) * behind_words_];
        const std::size_t pieces = scene_.pieces().size();
        for (std::size_t word = 0; word < behind_words_; ++word) {
            std::uint64_t rest = ~(behind_shooter[word] | behind_receiver[word]);
            if (word + 1 == behind_words_ && pieces % 64 != 0) rest &= (std::uint64_t(1) << (pieces % 64)) - 1;
            for (; rest != 0; rest &= rest - 1) {
                const auto piece = static_cast<PieceId>(word * 64 + static_cast<std::size_t>(__builtin_ctzll(rest)));
                if (shaft.may_meet(planes_.bounds(piece), planes_.corners(piece))) scratch.between.push_back(piece);
            }
        }
        return;
    }
    struct Context {
        const Transport& transport;
        const Shaft& shaft;
        PieceId shooter, receiver;
        std::vector<PieceId>& out;
    } context{*this, shaft, shot.piece, plane, scratch.between};
    std::array<double, 6> bounds = shaft.bounds();
    for (double& b : bounds) b = std::scalbn(b, mesh_.exponent());
    candidates_.polygons_in(bounds, {&context, [](void* opaque, std::int32_t id) {
                                         const Context& c = *static_cast<Context*>(opaque);
                                         const Polygon& polygon = c.transport.scene_.polygon(id);
                                         for (std::uint32_t k = 0; k < polygon.piece_count; ++k) {
                                             const auto piece = static_cast<PieceId>(polygon.first_piece + k);
                                             const Planes& planes = c.transport.planes_;
                                             if (c.shaft.may_meet(planes.bounds(piece), planes.corners(piece)) &&
                                                 !planes.wholly_behind(piece, c.shooter) &&
                                                 !planes.wholly_behind(piece, c.receiver))
                                                 c.out.push_back(piece);
                                         }
                                         return true;
                                     }});
    std::sort(scratch.between.begin(), scratch.between.end());
}

// ------------------------------------------------------------------------------------------------ the segments

double Transport::passes(const Shot& shot, const Sample& to, NodeId element, const Sample& from,
                         TransportScratch& scratch) const {
    ++scratch.segments;
    if (!keep_all_) {
        // What is certain in binary64. The piece that blocked the last segment is likely to block this one.
        bool unknown = false;
        const std::size_t count = scratch.between.size();
        for (std::size_t n = 0; n < count; ++n) {
            const std::size_t k = n == 0 ? scratch.last_blocker : n <= scratch.last_blocker ? n - 1 : n;
            const PieceId piece = scratch.between[k];
            const std::int8_t known = scratch.side_from[k];
            const Crossing crossing = planes_.crossing(
                piece, from.position, known == uncertain ? std::nullopt : std::optional<Sign>(static_cast<Sign>(known)),
                to.position);
            if (crossing == Crossing::pierces) {
                scratch.last_blocker = k;
                return 0;
            }
            unknown = unknown || crossing == Crossing::unknown;
        }
        if (!unknown) return 1;
    }
    ++scratch.oracle_segments;
    const PieceId from_piece = mesh_.roots()[mesh_.node(element).element.root].piece;
    switch (oracle_({exact(element, from), exact(shot.patch, to), from_piece, shot.piece})) {
        case Visibility::clear:
            return 1;
        case Visibility::grazing:
            return 0.5;
        case Visibility::blocked:
            return 0;
    }
    return 0;
}

Transport::Fraction Transport::fraction(const Shot& shot, const std::vector<Sample>& samples, NodeId element,
                                        const Sample& at, TransportScratch& scratch) const {
    const PieceId plane = mesh_.roots()[mesh_.node(element).element.root].piece;
    const Point &normal = planes_.normal(plane), &shooter_normal = planes_.normal(shot.piece);
    Fraction result;
    for (const Sample& sample : samples) {
        if (!in_front(plane, shot.patch, sample)) continue;
        // Weighted as the closed form weights it: the fraction is of the form factor, not of the area.
        const Point d = sample.position - at.position;
        const double distance2 = dot(d, d);
        const double weight =
            std::max(dot(normal, d), 0.0) * std::max(-dot(shooter_normal, d), 0.0) / (distance2 * distance2);
        if (!(weight > 0)) continue;
        result.all += weight;
        ++result.tested;
        const double share = sample.hidden ? 0 : passes(shot, sample, element, at, scratch);
        result.visible += weight * share;
        result.clear += share == 1;
    }
    return result;
}

Reception Transport::receive(const Shot& shot, NodeId element, TransportScratch& scratch) const {
    const Node& n = mesh_.node(element);
    const PieceId plane = mesh_.roots()[n.element.root].piece;
    Reception result;
    double unobstructed_sum = 0;
    bool all_clear = true;
    const std::vector<Sample>& points = receiving_[n.corner_count() == 3 ? 0 : 1];
    for (Sample at : points) {
        at.position = point(element, at.s, at.t);
        const double closed_form = form_factor(shot, at.position, planes_.normal(plane), scratch);
        if (closed_form == 0 || !in_front(shot.piece, element, at)) continue;
        unobstructed_sum += closed_form;
        if (!keep_all_) {
            if (scratch.between.empty() &&
                sheets_.above(mesh_.roots()[mesh_.node(shot.patch).element.root].polygon).empty()) {
                scratch.segments_left_out += static_cast<std::int64_t>(shot.samples.size());
                result.form_factor += closed_form;
                continue;
            }
            find_sides(at.position, scratch);
        }
        Fraction seen = fraction(shot, shot.samples, element, at, scratch);
        const bool mixed = seen.tested == 0 || (seen.visible > 0 && seen.clear < seen.tested);
        if (mixed) seen = fraction(shot, shot.mixed_samples, element, at, scratch);
        // A sliver in front of the receiver's plane, and no sample on it: taken as it is, it is next to nothing.
        const double share = seen.all > 0 ? seen.visible / seen.all : 1;
        all_clear = all_clear && share == 1;
        result.form_factor += closed_form * share;
    }
    result.form_factor /= static_cast<double>(points.size());
    if (unobstructed_sum == 0) return result;
    result.sight = result.form_factor == 0 ? Sight::none : all_clear ? Sight::whole : Sight::partial;
    return result;
}

void Transport::find_sides(const Point& from, TransportScratch& scratch) const {
    scratch.side_from.clear();
    for (const PieceId piece : scratch.between) {
        const std::optional<Sign> side = planes_.side(piece, from);
        scratch.side_from.push_back(side ? static_cast<std::int8_t>(*side) : uncertain);
    }
}

double Transport::receive_at(const Shot& shot, NodeId element, double s, double t, int samples,
                             TransportScratch& scratch) const {
    const RootId root = mesh_.node(element).element.root;
    if (apart(shot, root)) return 0;
    const Sample at{s, t, point(element, s, t), false};
    const double closed_form = form_factor(shot, at.position, planes_.normal(mesh_.roots()[root].piece), scratch);
    if (closed_form == 0 || !in_front(shot.piece, element, at)) return 0;
    find_between(shot, mesh_.node(element).patch, scratch);
    find_sides(at.position, scratch);
    const Fraction seen = fraction(shot, samples_of(shot.patch, samples), element, at, scratch);
    return seen.all > 0 ? closed_form * seen.visible / seen.all : closed_form;
}

Reception Transport::receive_unobstructed(const Shot& shot, NodeId element, TransportScratch& scratch) const {
    const Node& n = mesh_.node(element);
    const PieceId plane = mesh_.roots()[n.element.root].piece;
    const std::vector<Sample>& points = receiving_[n.corner_count() == 3 ? 0 : 1];
    Reception result;
    for (const Sample& at : points)
        result.form_factor += form_factor(shot, point(element, at.s, at.t), planes_.normal(plane), scratch);
    result.form_factor /= static_cast<double>(points.size());
    if (result.form_factor > 0) result.sight = Sight::whole;
    return result;
}

}  // namespace cob::radiosity
