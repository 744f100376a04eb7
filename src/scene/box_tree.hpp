/// \file
/// Bounding boxes of polygons, and a tree that finds those that meet a box.
#pragma once

#include "cob/scene.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

namespace cob {

/// Closed; empty as it is made.
struct Bounds3 {
    Point low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
              std::numeric_limits<double>::infinity()};
    Point high = -low;

    void add(const Point& point) {
        for (int axis = 0; axis < 3; ++axis) {
            low[axis] = std::min(low[axis], point[axis]);
            high[axis] = std::max(high[axis], point[axis]);
        }
    }
    void add(const Bounds3& other) {
        add(other.low);
        add(other.high);
    }
    bool meets(const Bounds3& other) const {
        for (int axis = 0; axis < 3; ++axis)
            if (low[axis] > other.high[axis] || high[axis] < other.low[axis]) return false;
        return true;
    }
};

/// A balanced tree over boxes, split at the median of the longest axis.
class BoxTree {
public:
    explicit BoxTree(std::vector<Bounds3> boxes) : boxes_(std::move(boxes)), order_(boxes_.size()) {
        std::iota(order_.begin(), order_.end(), 0u);
        while (leaves_ * leaf_size < boxes_.size()) leaves_ *= 2;
        nodes_.resize(2 * leaves_);
        split(1, 0, boxes_.size());
    }

    const Bounds3& box(std::uint32_t id) const { return boxes_[id]; }

    /// Calls found(id) for every box that meets the given one, each once, in no particular order.
    template <class Found>
    void find(const Bounds3& box, Found&& found) const {
        find_where([&](const Bounds3& other) { return other.meets(box); }, found);
    }
    /// Calls found(id) for every box of which meets(box) is true. It must be true of every box around such a one.
    template <class Meets, class Found>
    void find_where(const Meets& meets, Found&& found) const {
        find(1, 0, boxes_.size(), meets, found);
    }

private:
    static constexpr std::size_t leaf_size = 4;

    void split(std::size_t node, std::size_t begin, std::size_t end) {
        Bounds3& bounds = nodes_[node];
        for (std::size_t k = begin; k < end; ++k) bounds.add(boxes_[order_[k]]);
        if (node >= leaves_) return;
        int longest = 0;
        for (int axis = 1; axis < 3; ++axis)
            if (bounds.high[axis] - bounds.low[axis] > bounds.high[longest] - bounds.low[longest]) longest = axis;
        const std::size_t middle = begin + (end - begin) / 2;
        const auto centre = [&](std::uint32_t id) {
            return boxes_[id].low[longest] / 2 + boxes_[id].high[longest] / 2;
        };
        std::nth_element(order_.begin() + static_cast<std::ptrdiff_t>(begin),
                         order_.begin() + static_cast<std::ptrdiff_t>(middle),
                         order_.begin() + static_cast<std::ptrdiff_t>(end),
                         [&](std::uint32_t a, std::uint32_t b) { return centre(a) < centre(b); });
        split(2 * node, begin, middle);
        split(2 * node + 1, middle, end);
    }

    template <class Meets, class Found>
    void find(std::size_t node, std::size_t begin, std::size_t end, const Meets& meets, Found& found) const {
        if (begin == end || !meets(nodes_[node])) return;
        if (node >= leaves_) {
            for (std::size_t k = begin; k < end; ++k)
                if (meets(boxes_[order_[k]])) found(order_[k]);
            return;
        }
        const std::size_t middle = begin + (end - begin) / 2;
        find(2 * node, begin, middle, meets, found);
        find(2 * node + 1, middle, end, meets, found);
    }

    std::vector<Bounds3> boxes_;
    std::vector<std::uint32_t> order_;
    std::vector<Bounds3> nodes_;  ///< Node k has the children 2k and 2k + 1; the root is 1.
    std::size_t leaves_ = 1;
};

}  // namespace cob
