/// \file
/// The narrow interface between trees and predicates: a source names pieces or polygons that may matter; it may
/// name too many, never too few. Answers do not depend on the source.
#pragma once

#include "cob/scene.hpp"

#include <array>
#include <memory>

namespace cob {

/// A source of candidates over one scene; thread-safe after construction.
class CandidateSource {
public:
    virtual ~CandidateSource() = default;

    /// Type-erased callback without allocation: a function and its context.
    struct Callback {
        void* context;
        bool (*call)(void* context, std::int32_t id);  ///< True: go on; false: stop.
    };

    /// The same for pieces. `crossed`: whatever the exact segment is, it crosses the piece's interior from one side to
    /// the other; a source need not know.
    struct PieceCallback {
        void* context;
        bool (*call)(void* context, PieceId piece, bool crossed);
    };

    /// Polygons (valid ones) whose bounds meet the closed bounds, each once.
    virtual void polygons_in(const std::array<double, 6>& bounds, Callback callback) const = 0;
    /// Pieces that may meet a segment whose exact ends lie within half an ulp of these points, each once.
    virtual void pieces_along(const Point& from, const Point& to, PieceCallback callback) const = 0;
    /// Bytes held beside the scene.
    virtual std::size_t memory() const = 0;
};

/// Where candidates come from.
enum class Source : std::uint8_t {
    all,     ///< Everything, without a tree.
    tree,    ///< CGAL's AABB tree for boxes, a flat tree built by the surface area heuristic for segments.
    embree,  ///< Embree's for segments; boxes ask CGAL's.
    octree,  ///< A loose octree: a baseline to measure the others against.
};

const char* to_text(Source source);

/// False only for Source::embree where it was built without.
bool is_available(Source source);
/// Throws InputError for Source::embree where it was built without.
std::unique_ptr<CandidateSource> make_candidates(const Scene& scene, Source source);

}  // namespace cob
