/// \file
/// Adversarial questions, the same for every run and platform: the number of a case is its seed. Neither the twin's
/// nor the library's answers go into them.
#pragma once

#include "naive/box.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace cob::naive {

/// A face line to be.
struct Face {
    std::vector<Point> corners;
    bool emits = false;
};

/// Where the awkwardness comes from.
enum class Family {
    lattice,   ///< Small integers: ties everywhere.
    rotated,   ///< The same rotated by rational rotations.
    oblique,   ///< Slanted elements, the height irrational, polygons an ulp from the top.
    ulp,       ///< One-ulp perturbations of the lattice ones.
    scaled,    ///< Times 2^300 or 2^-300, near the ends of the range, subnormal.
    offset,    ///< 2^40 away from the origin.
    sliver,    ///< 10^6 times as long as wide.
    fraction,  ///< Corners and ends that are no binary64 numbers.
    mixed,     ///< Every coordinate of another magnitude.
};
constexpr int family_count = 9;
const char* to_text(Family family);
/// Families take turns.
Family family_of(std::uint64_t seed);

/// Polygons and boxes over the first of them (or over nothing).
struct BoxCase {
    std::vector<Face> faces;
    std::vector<BoxQuestion> boxes;
};
BoxCase box_case(std::uint64_t seed);

/// Polygons and segments between, on and through them.
struct SegmentCase {
    struct Segment {
        RationalPoint from, to;
    };
    std::vector<Face> faces;
    std::vector<Segment> segments;
};
SegmentCase segment_case(std::uint64_t seed);

/// One polygon: any shape, planar or not, in any family.
std::vector<Point> polygon_case(std::uint64_t seed);

}  // namespace cob::naive
