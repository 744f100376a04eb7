#include "radiosity/transport.hpp"

#include "radiosity/lambert_sum.hpp"

#include <algorithm>
#include <cmath>

namespace cob::radiosity {
namespace {

constexpr double pi = 3.14159265358979323846;
/// A third on a binary grid: sample points are exact dyadic combinations of corners (SPEC 1).
constexpr double third = 1365.0 / 4096.0;

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

/// Brings the longest component near 1.
double power_of_two_over(const Point& v) {
    const double longest = std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
    return longest > 0 ? std::ldexp(1.0, std::min(-std::ilogb(longest), 1000)) : 1;
}

}  // namespace

Transport::Transport(const Scene& scene, const Mesh& mesh, const CandidateSource& candidates, const Sheets& sheets,
                     const RadiosityOptions& options, const Omissions& omissions)
    : scene_(scene),
      mesh_(mesh),
      sheets_(sheets),
      convex_(omissions(Omission::convex)),
      shaft_(omissions(Omission::shaft)),
      filter_(omissions(Omission::filter)),
      samples_(options.samples),
      mixed_samples_(options.mixed_samples),
      planes_(scene, mesh.exponent()),
      between_(scene, planes_),
      oracle_(scene, candidates),
      receiving_{stratified(true, options.receiving_points), stratified(false, options.receiving_points)} {}

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
    const std::optional<Sign> quick = filter_ ? planes_.side(plane, sample.position) : std::nullopt;
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

PatchShape Transport::shape_of(NodeId patch) const {
    const Node& n = mesh_.node(patch);
    PatchShape shape;
    shape.piece = mesh_.roots()[n.element.root].piece;
    shape.corner_count = n.corner_count();
    for (std::size_t k = 0; k < static_cast<std::size_t>(shape.corner_count); ++k)
        shape.corners[k] = mesh_.vertices()[static_cast<std::size_t>(n.corners[k])].position;
    shape.bounds = bounds_of(shape.corners.data(), shape.corner_count);
    return shape;
}

Shot Transport::make_shot(NodeId patch, const Rgb& exitance) const {
    return {patch, exitance, shape_of(patch), samples_of(patch, samples_), samples_of(patch, mixed_samples_)};
}

bool Transport::apart(const Shot& shot, RootId receiver) const {
    return between_.apart(mesh_.roots()[receiver].piece, shot.shape.piece);
}

// --------------------------------------------------------------------------------------------- the closed form

double Transport::form_factor(const Shot& shot, const Point& at, const Point& normal, TransportScratch& scratch) const {
    ++scratch.form_factors;
    std::array<Point, 4> r;
    std::array<Point, 8> clipped;
    for (std::size_t k = 0; k < static_cast<std::size_t>(shot.shape.corner_count); ++k)
        r[k] = shot.shape.corners[k] - at;
    const int count = clip_to_horizon(normal, r.data(), shot.shape.corner_count, clipped.data());
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
    if (shaft_ && !convex_) between_.find(shot.shape, shape_of(patch), scratch.between);
}

bool Transport::is_clear(const Shot& shot, const TransportScratch& scratch) const {
    return (convex_ || (shaft_ && scratch.between.empty())) &&
           sheets_.above(mesh_.roots()[mesh_.node(shot.patch).element.root].polygon).empty();
}

// ------------------------------------------------------------------------------------------------ the segments

double Transport::passes(const Shot& shot, const Sample& to, NodeId element, const Sample& from,
                         TransportScratch& scratch) const {
    ++scratch.segments;
    if (convex_) return 1;
    if (shaft_ && filter_) {
        // What is certain in binary64. The piece that blocked the last segment is likely to block this one.
        bool unknown = false;
        const std::size_t count = scratch.between.size();
        for (std::size_t n = 0; n < count; ++n) {
            const std::size_t k = n == 0 ? scratch.last_blocker : n <= scratch.last_blocker ? n - 1 : n;
            const Obstacle& obstacle = scratch.between[k];
            const std::optional<Sign> side_to =
                obstacle.shooter ? obstacle.shooter : planes_.side(obstacle.piece, to.position);
            const Crossing crossing =
                planes_.crossing(obstacle.piece, from.position, scratch.side_from[k], to.position, side_to);
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
    const Segment segment{exact(element, from), exact(shot.patch, to), from_piece, shot.shape.piece};
    switch (filter_ ? oracle_(segment) : oracle_(segment, Arithmetic::rational).visibility) {
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
    const Point &normal = planes_.normal(plane), &shooter_normal = planes_.normal(shot.shape.piece);
    Fraction result;
    // Lengths by the first sample's power of two: at 1e-80 units the fourth power of a distance underflows.
    double scale = 0;
    for (const Sample& sample : samples) {
        if (!in_front(plane, shot.patch, sample)) continue;
        // Weighted as the closed form weights it: the fraction is of the form factor, not of the area.
        const Point off = sample.position - at.position;
        if (scale == 0) scale = power_of_two_over(off);
        const Point d = scale * off;
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

Reception Transport::receive(const Shot& shot, NodeId element, TransportScratch& scratch,
                             std::optional<double> unobstructed) const {
    const Node& n = mesh_.node(element);
    const PieceId plane = mesh_.roots()[n.element.root].piece;
    Reception result;
    double unobstructed_sum = 0;
    bool all_clear = true;
    const std::vector<Sample>& points = receiving_[n.corner_count() == 3 ? 0 : 1];
    for (Sample at : points) {
        at.position = point(element, at.s, at.t);
        // Of one receiving point, the centroid, it is the form factor that the strength was taken from.
        const double closed_form = unobstructed && points.size() == 1
                                       ? *unobstructed
                                       : form_factor(shot, at.position, planes_.normal(plane), scratch);
        if (closed_form == 0 || !in_front(shot.shape.piece, element, at)) continue;
        unobstructed_sum += closed_form;
        if (is_clear(shot, scratch)) {
            scratch.segments_left_out += static_cast<std::int64_t>(shot.samples.size());
            result.form_factor += closed_form;
            continue;
        }
        find_sides(at.position, scratch);
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
    for (const Obstacle& obstacle : scratch.between)
        scratch.side_from.push_back(obstacle.receiver ? obstacle.receiver : planes_.side(obstacle.piece, from));
}

double Transport::receive_at(const Shot& shot, NodeId element, double s, double t, int samples,
                             TransportScratch& scratch) const {
    const RootId root = mesh_.node(element).element.root;
    if (apart(shot, root)) return 0;
    const Sample at{s, t, point(element, s, t), false};
    const double closed_form = form_factor(shot, at.position, planes_.normal(mesh_.roots()[root].piece), scratch);
    if (closed_form == 0 || !in_front(shot.shape.piece, element, at)) return 0;
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
