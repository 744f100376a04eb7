/// \file
/// Embree as everybody uses it, to be measured against: not a source of candidates. Only where the library is built
/// with Embree.
#pragma once

#include "cob/visibility.hpp"

#include <memory>
#include <optional>

namespace cob {

/// All pieces as triangles in binary32, in robust mode; segments lose 1e-4 of their length at both ends, because
/// without that every segment would meet the surface that it leaves. Thread-safe once built.
class EmbreeTriangles {
public:
    /// Of a segment's parameter, at both ends.
    static constexpr float offset = 1e-4F;

    explicit EmbreeTriangles(const Scene& scene);
    ~EmbreeTriangles();

    /// Something is hit between the ends. Of a segment beyond Embree's range, 1.8e18, nothing.
    bool hidden(const Segment& segment) const;
    struct Hit {
        PieceId piece;
        double parameter;  ///< Along the segment.
    };
    /// What is hit first.
    std::optional<Hit> first_hit(const Segment& segment) const;
    std::size_t memory() const;

private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

}  // namespace cob
