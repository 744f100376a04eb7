/// \file
/// Exact point-to-point visibility (SPEC section 6).
#pragma once

#include "cob/arithmetic.hpp"
#include "cob/geometry.hpp"
#include "cob/scene.hpp"

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

/// Where an open segment meets a piece.
enum class ContactKind : std::uint8_t { inside, side, corner, in_plane };
struct Contact {
    PieceId piece = -1;
    ContactKind kind = ContactKind::inside;
    int index = -1;      ///< Of the side or corner of the piece.
    Rational parameter;  ///< Where along the segment, in (0, 1); of in_plane contact, where it begins.
};

class CandidateSource;  // cob/candidates.hpp

/// Answers segments against one scene; thread-safe after construction. The scene and the source must outlive it.
class VisibilityOracle {
public:
    VisibilityOracle(const Scene& scene, const CandidateSource& candidates);
    ~VisibilityOracle();

    /// Throws InputError where both ends are one point.
    Visibility operator()(const Segment& segment, PredicateCounters* counters = nullptr) const;
    Visibility against(PolygonId polygon, const Segment& segment) const;
    /// The first polygon along the segment, from its beginning, that blocks it by itself; none: no_polygon.
    PolygonId nearest_blocker(const Segment& segment) const;
    /// Every contact in order along the segment.
    std::vector<Contact> contacts(const Segment& segment) const;

    /// Bytes held beside the scene and the source.
    std::size_t memory() const;

private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

}  // namespace cob
