/// \file
/// CGAL's own do_intersect(Triangle_3, Iso_cuboid_3) as a yes-or-no variant of relations.
#pragma once

#include "cob/answer.hpp"
#include "cob/geometry.hpp"
#include "cob/scene.hpp"

#include <array>
#include <memory>
#include <optional>

namespace cob {

/// Least and greatest coordinates of a box that is axis-aligned and whose corners are all binary64 numbers.
std::optional<std::array<double, 6>> cuboid_of(const BoxQuestion& question);

class CgalVariant {
public:
    virtual ~CgalVariant() = default;
    /// Does the polygon meet the closed box?
    virtual bool meets(PolygonId polygon, const std::array<double, 6>& cuboid) const = 0;
};

/// kernel: cgal_epick or cgal_epeck.
std::unique_ptr<const CgalVariant> make_cgal_variant(const Scene& scene, Peer kernel);

}  // namespace cob
