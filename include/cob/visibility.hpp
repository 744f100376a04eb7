/// \file
/// Exact point-to-point visibility (SPEC section 6).
#pragma once

#include "cob/arithmetic.hpp"
#include "cob/geometry.hpp"
#include "cob/scene.hpp"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace cob {

enum class Visibility : std::uint8_t { clear, grazing, blocked };
const char* to_text(Visibility visibility);

/// An open segment between two different exact points. Carrying a piece that an end lies on spares arithmetic: the end
/// is known to be in its plane, and in those of the other pieces of the same planar polygon. A hint must be true as
/// far as the plane goes; -1: nothing is known. Hints never change an answer.
struct Segment {
    ExactPoint from, to;
    PieceId from_piece = -1, to_piece = -1;
};

/// An answer in some arithmetic.
struct VisibilityAnswer {
    Visibility visibility = Visibility::clear;
    bool decided = true;  ///< False only in Arithmetic::interval; then `visibility` means nothing.
};

/// Where an open segment meets a piece.
enum class ContactKind : std::uint8_t { inside, side, corner, in_plane };
struct Contact {
    PieceId piece = -1;
    ContactKind kind = ContactKind::inside;
    int index = -1;      ///< Of the side or corner of the piece.
    Rational parameter;  ///< Where along the segment, in (0, 1); of in_plane contact, where it begins.
};

/// What covers a ray at which a sector begins or ends (SPEC 6, closing).
enum class Covering : std::uint8_t {
    none,
    sector,  ///< Seen along the segment it lies in another piece's open sector.
    seam,    ///< Seen along the segment it has the direction of a ray in space along which two pieces meet.
};

/// A contact and what it contributes.
struct ExplainedContact {
    Contact contact;
    Rational last;                   ///< Of in_plane contact: the parameter where it ends; else that of the contact.
    bool from_visible_side = false;  ///< Where the plane is crossed: the segment comes from the visible side.
    bool blocks = false;             ///< Crossed inside, or one of the pieces that close around this point.
    /// At a side or corner: the rays from the point, each as a direction from one vertex towards another, between
    /// which, seen along the segment, the piece's local sector extends counter-clockwise.
    std::array<VertexId, 2> begin{-1, -1}, end{-1, -1};
    Covering begin_covering = Covering::none, end_covering = Covering::none;
};

/// Why the answer is what it is.
struct Explanation {
    Visibility visibility = Visibility::clear;
    std::vector<Contact> contacts;          ///< In order along the segment, then by piece.
    std::vector<ExplainedContact> details;  ///< Of the same contacts.
};

class CandidateSource;  // cob/candidates.hpp

/// Answers segments against one scene; thread-safe after construction. The scene and the source must outlive it.
class VisibilityOracle {
public:
    VisibilityOracle(const Scene& scene, const CandidateSource& candidates);
    ~VisibilityOracle();

    /// Throws InputError where both ends are one point.
    Visibility operator()(const Segment& segment, PredicateCounters* counters = nullptr) const;
    /// The same formula in other arithmetic, for the study of error against time: the segment's hints are not used.
    /// Candidates come from the same source, which is right for all of them.
    VisibilityAnswer operator()(const Segment& segment, Arithmetic arithmetic,
                                PredicateCounters* counters = nullptr) const;
    /// The same for one of several segments near each other, which one piece often blocks: it is tried first.
    /// blocker: in: that piece, -1 for none; out: a piece that this segment crosses inside, -1 where it found none.
    Visibility operator()(const Segment& segment, PieceId& blocker) const;
    /// As if the scene were this polygon alone.
    Visibility against(PolygonId polygon, const Segment& segment) const;
    /// The first polygon along the segment, from its beginning, that blocks it by itself; of several at one point the
    /// lowest; none: no_polygon.
    PolygonId nearest_blocker(const Segment& segment) const;
    /// Every contact in order along the segment.
    std::vector<Contact> contacts(const Segment& segment) const;
    /// The same with what each contact contributes.
    Explanation explain(const Segment& segment) const;

    /// Bytes held beside the scene and the source.
    std::size_t memory() const;

private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

}  // namespace cob
