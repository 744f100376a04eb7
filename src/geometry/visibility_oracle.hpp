/// \file
/// The visibility of one segment, gathered piece by piece (SPEC section 6), in any arithmetic.
#pragma once

#include "cob/candidates.hpp"
#include "cob/visibility.hpp"
#include "geometry/visibility_closing.hpp"

#include <mutex>

namespace cob {

struct VisibilityOracle::Implementation {
    Implementation(const Scene& scene, const CandidateSource& source) : pieces(scene), candidates(source) {}

    VisibilityAnswer in_intervals(const Segment& segment) const;

    PieceTable pieces;
    const CandidateSource& candidates;
    std::once_flag extent_known;
    double extent = 0;  ///< Of the scene; only for Arithmetic::epsilon.
};

/// Throws InputError where both ends of the segment are one point.
void refuse_a_point(const Segment& segment);

/// The candidates of a segment, ascending.
std::vector<PieceId> candidates_along(const CandidateSource& source, const Segment& segment);

/// What a segment has met so far. Pieces may come in any order, each once.
template <class Signs>
class Gathering {
public:
    explicit Gathering(const Signs& signs) : signs_(signs) {}

    /// False: blocked already, nothing that follows matters. `crossed`: for certain, says the source of the piece.
    bool add(PieceId piece, bool crossed = false) {
        if (crossed && Signs::exact) {
            blocker_ = piece;
            return false;
        }
        const Touch met = touch(signs_, piece);
        switch (met.kind) {
            case Touch::Kind::none:
                return true;
            case Touch::Kind::inside:
                blocker_ = piece;
                return false;
            case Touch::Kind::in_plane:
                grazes_ = true;
                return true;
            case Touch::Kind::side:
            case Touch::Kind::corner:
                sectors_.push_back(sector_of(signs_, piece, met));
                return true;
        }
        return true;
    }
    Visibility answer() {
        if (blocker_ >= 0 || mark_closing(signs_, sectors_, false)) return Visibility::blocked;
        return grazes_ || !sectors_.empty() ? Visibility::grazing : Visibility::clear;
    }
    /// The piece that the segment crosses inside; -1: none so far.
    PieceId blocker() const { return blocker_; }

private:
    const Signs& signs_;
    Sectors sectors_;
    PieceId blocker_ = -1;
    bool grazes_ = false;
};

/// The whole answer, over all candidates; blocker: the piece that the segment crosses inside, -1 where it found none.
template <class Signs>
Visibility visibility_along(const Signs& signs, const CandidateSource& candidates, const Segment& segment,
                            PieceId* blocker = nullptr) {
    Gathering<Signs> gathering(signs);
    candidates.pieces_along(segment.from.nearest(), segment.to.nearest(),
                            {&gathering, [](void* context, PieceId piece, bool crossed) {
                                 return static_cast<Gathering<Signs>*>(context)->add(piece, crossed);
                             }});
    if (blocker != nullptr) *blocker = gathering.blocker();
    return gathering.answer();
}

}  // namespace cob
