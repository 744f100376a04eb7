/// \file
/// A tree of bounding boxes over the sides of a loop as seen; sides may change and vanish.
#pragma once

#include "arithmetic/orientation.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace cob {

/// Closed axis-aligned rectangle; empty where xmin > xmax.
struct Bounds2 {
    double xmin = std::numeric_limits<double>::infinity(), ymin = xmin, xmax = -xmin, ymax = -xmin;

    static Bounds2 of(const Point2& a, const Point2& b) {
        return {std::min(a.x, b.x), std::min(a.y, b.y), std::max(a.x, b.x), std::max(a.y, b.y)};
    }
    friend Bounds2 operator|(const Bounds2& a, const Bounds2& b) {
        return {std::min(a.xmin, b.xmin), std::min(a.ymin, b.ymin), std::max(a.xmax, b.xmax), std::max(a.ymax, b.ymax)};
    }
};

/// A closed rectangle meets the open one of another; flat sides may lie inside, the other may not be flat.
inline bool meets_open(const Bounds2& closed, const Bounds2& open) {
    return closed.xmin < open.xmax && closed.xmax > open.xmin && closed.ymin < open.ymax && closed.ymax > open.ymin;
}
inline bool meets_closed(const Bounds2& a, const Bounds2& b) {
    return a.xmin <= b.xmax && a.xmax >= b.xmin && a.ymin <= b.ymax && a.ymax >= b.ymin;
}

/// Leaves in the loop's own order, which keeps near what is near; every node bounds its two children.
class SideTree {
public:
    /// `count` empty leaves.
    explicit SideTree(std::size_t count) {
        while (leaves_ < count) leaves_ *= 2;
        nodes_.resize(2 * leaves_);
    }

    /// Fills all leaves at once: bounds_of(k) for k < count.
    template <class BoundsOf>
    void fill(std::size_t count, BoundsOf&& bounds_of) {
        for (std::size_t k = 0; k < count; ++k) nodes_[leaves_ + k] = bounds_of(k);
        for (std::size_t node = leaves_; node-- > 1;) nodes_[node] = nodes_[2 * node] | nodes_[2 * node + 1];
    }

    void set(std::size_t leaf, const Bounds2& bounds) {
        std::size_t node = leaves_ + leaf;
        for (nodes_[node] = bounds; node > 1; node /= 2) nodes_[node / 2] = nodes_[node] | nodes_[node ^ 1];
    }

    /// Calls found(leaf), ascending, for the leaves at or after `first` whose box satisfies meets(box), until it
    /// returns true; returns whether it did.
    template <class Meets, class Found>
    bool find(std::size_t first, Meets&& meets, Found&& found) const {
        return find(1, 0, leaves_, first, meets, found);
    }

private:
    template <class Meets, class Found>
    bool find(std::size_t node, std::size_t begin, std::size_t size, std::size_t first, Meets& meets,
              Found& found) const {
        if (begin + size <= first || !meets(nodes_[node])) return false;
        if (size == 1) return found(begin);
        return find(2 * node, begin, size / 2, first, meets, found) ||
               find(2 * node + 1, begin + size / 2, size / 2, first, meets, found);
    }

    std::size_t leaves_ = 1;
    std::vector<Bounds2> nodes_;  ///< Node k has the children 2k and 2k + 1; the root is 1.
};

}  // namespace cob
