/// \file
/// The column `shared` (SPEC 5) for many boxes: it depends on two polygons only, and elements of one polygon ask for
/// the same pairs again and again.
#pragma once

#include "cob/geometry.hpp"

#include <vector>

namespace cob {

/// Remembers what shared() said of recent pairs, in a table of fixed size. One thread each.
class SharedCache {
public:
    explicit SharedCache(const Scene& scene) : scene_(scene), entries_(size) {}

    /// own may be no_polygon.
    Shared operator()(PolygonId own, PolygonId polygon) {
        if (own == no_polygon) return Shared::none;
        const auto hash = static_cast<std::uint32_t>(own) * 0x9e3779b1u + static_cast<std::uint32_t>(polygon);
        Entry& entry = entries_[hash % size];
        if (entry.own != own || entry.polygon != polygon) entry = {own, polygon, shared(scene_, own, polygon)};
        return entry.shared;
    }

private:
    static constexpr std::size_t size = 4096;
    struct Entry {
        PolygonId own = no_polygon, polygon = no_polygon;
        Shared shared = Shared::none;
    };

    const Scene& scene_;
    std::vector<Entry> entries_;
};

}  // namespace cob
