// Embree as a yes-or-no variant of visibility, and the segments on which it is wrong.
#include "golden/bench_set.hpp"

#ifdef COB_HAS_EMBREE

#include "geometry/embree_triangles.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cob {
namespace {

bool right(const BenchSegment& question, bool hidden) {
    return question.visibility == Visibility::grazing || hidden == (question.visibility == Visibility::blocked);
}

double length(const Point& v) {
    return std::hypot(v.x, v.y, v.z);
}

/// Puts the contact of a piece into the description where it is the clearest so far.
void consider(const Scene& scene, PieceId piece, double parameter, bool seam, EmbreeDisagreement& result) {
    const Point from = result.segment.from.nearest(), d = result.segment.to.nearest() - from;
    const View<VertexId> corners = scene.corners(scene.piece(piece));
    double nearest = std::numeric_limits<double>::infinity();
    Point across;
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const Point a = scene.position(corners[static_cast<std::ptrdiff_t>(k)]);
        const Point b = scene.position(corners[static_cast<std::ptrdiff_t>((k + 1) % corners.size())]);
        const Point normal = cross(d, b - a);
        const double distance = std::abs(dot(normal, a - from)) / length(normal);
        if (distance < nearest) nearest = distance, across = (1 / length(normal)) * normal;
    }
    const double to_end = std::min(parameter, 1 - parameter) * length(d);
    const double clearance = seam || !std::isfinite(nearest) ? 0 : std::min(nearest, to_end);
    if (result.piece >= 0 && clearance <= result.clearance) return;
    result.piece = piece;
    result.parameter = parameter;
    result.clearance = clearance;
    result.across = across;
}

/// What the exact answer rests on, or what Embree hits.
EmbreeDisagreement described(const BenchSet& set, const VisibilityOracle& oracle, const EmbreeTriangles& embree,
                             const BenchSegment& question) {
    EmbreeDisagreement result;
    result.segment = question.segment;
    result.blocked = question.visibility == Visibility::blocked;
    if (result.blocked) {
        for (const ExplainedContact& contact : oracle.explain(question.segment).details)
            if (contact.blocks)
                consider(set.scene, contact.contact.piece, to_nearest(contact.contact.parameter),
                         contact.contact.kind != ContactKind::inside, result);
    } else if (const auto hit = embree.first_hit(question.segment)) {
        consider(set.scene, hit->piece, hit->parameter, false, result);
    }
    constexpr double offset = EmbreeTriangles::offset;
    result.at_end = result.parameter <= offset || result.parameter >= 1 - offset;
    return result;
}

}  // namespace

void bench_embree(const BenchSet& set, const BenchOptions& options, std::vector<BenchRow>& rows) {
    if (set.segments.empty()) return;
    const EmbreeTriangles embree(set.scene);
    std::vector<BenchRow> kinds;
    for (const auto& [kind, segments] : set.segments) {
        std::vector<char> answers(segments.size());
        const auto ask = [&, &questions = segments](std::size_t k) {
            answers[k] = embree.hidden(questions[k].segment);
        };
        BenchRow row = measure(segments.size(), options, ask, [&, &questions = segments](std::size_t k) {
            return right(questions[k], answers[k] != 0) ? Outcome::right : Outcome::wrong;
        });
        row.question = "segment", row.variant = "embree", row.kind = kind;
        row.bytes = embree.memory();
        kinds.push_back(std::move(row));
    }
    add_rows(rows, std::move(kinds));
}

std::vector<EmbreeDisagreement> embree_disagreements(const std::string& folder, const BenchOptions& options) {
    const BenchSet set = read_bench_set(folder, options);
    const VisibilityOracle oracle(set.scene, *set.candidates);
    const EmbreeTriangles embree(set.scene);
    std::vector<EmbreeDisagreement> found;
    for (const auto& [kind, segments] : set.segments)
        for (const BenchSegment& question : segments) {
            if (right(question, embree.hidden(question.segment))) continue;
            found.push_back(described(set, oracle, embree, question));
            found.back().kind = kind;
        }
    std::stable_sort(found.begin(), found.end(), [](const EmbreeDisagreement& a, const EmbreeDisagreement& b) {
        return a.clearance > b.clearance;
    });
    return found;
}

}  // namespace cob

#else

namespace cob {

void bench_embree(const BenchSet&, const BenchOptions&, std::vector<BenchRow>&) {}

std::vector<EmbreeDisagreement> embree_disagreements(const std::string&, const BenchOptions&) {
    return {};
}

}  // namespace cob

#endif
