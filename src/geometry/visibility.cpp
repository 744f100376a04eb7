#include "cob/visibility.hpp"

#include "cob/candidates.hpp"
#include "cob/error.hpp"
#include "geometry/visibility_closing.hpp"
#include "geometry/visibility_oracle.hpp"

namespace cob {

const char* to_text(Visibility visibility) {
    switch (visibility) {
        case Visibility::clear:
            return "clear";
        case Visibility::grazing:
            return "grazing";
        case Visibility::blocked:
            return "blocked";
    }
    return "";
}

VisibilityOracle::VisibilityOracle(const Scene& scene, const CandidateSource& candidates)
    : implementation_(std::make_unique<Implementation>(scene, candidates)) {}
VisibilityOracle::~VisibilityOracle() = default;

Visibility VisibilityOracle::operator()(const Segment& segment, PredicateCounters* counters) const {
    refuse_a_point(segment);
    PredicateCounters own;
    const ExactSigns signs(implementation_->pieces, segment, {counters ? counters : &own});
    return visibility_along(signs, implementation_->candidates, segment);
}

Visibility VisibilityOracle::operator()(const Segment& segment, PieceId& blocker) const {
    refuse_a_point(segment);
    PredicateCounters counters;
    const ExactSigns signs(implementation_->pieces, segment, {&counters});
    if (blocker >= 0 && touch(signs, blocker).kind == Touch::Kind::inside) return Visibility::blocked;
    return visibility_along(signs, implementation_->candidates, segment, &blocker);
}

Visibility VisibilityOracle::against(PolygonId polygon, const Segment& segment) const {
    refuse_a_point(segment);
    PredicateCounters counters;
    const ExactSigns signs(implementation_->pieces, segment, {&counters});
    Gathering<ExactSigns> gathering(signs);
    const Polygon& p = implementation_->pieces.scene().polygon(polygon);
    for (std::uint32_t k = 0; k < p.piece_count; ++k)
        if (!gathering.add(static_cast<PieceId>(p.first_piece + k))) break;
    return gathering.answer();
}

std::size_t VisibilityOracle::memory() const {
    return sizeof(Implementation) + implementation_->pieces.memory();
}

void refuse_a_point(const Segment& segment) {
    if (segment.from == segment.to)
        throw InputError("a segment of no length", {"", 0, "", "give it two different ends"});
}

}  // namespace cob
