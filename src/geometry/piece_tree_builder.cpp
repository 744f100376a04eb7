#include "geometry/piece_tree_builder.hpp"

#include <algorithm>
#include <array>
#include <iterator>

namespace cob {
namespace {

constexpr std::size_t slice_count = 16;

/// Half of it; 0 of empty bounds.
double surface(const Bounds& bounds) {
    std::array<double, 3> side;
    for (std::size_t axis = 0; axis < 3; ++axis) side[axis] = std::max(0.0, bounds.high[axis] - bounds.low[axis]);
    return side[0] * side[1] + side[1] * side[2] + side[2] * side[0];
}

/// Equal slices between the first and the last middle along an axis.
struct Slices {
    std::size_t axis;
    double first, per_length;

    std::size_t operator()(const Bounds& bounds) const {
        const double slice = (bounds.middle(axis) - first) * per_length;
        return std::min(slice_count - 1, static_cast<std::size_t>(slice));
    }
};

/// What is in a slice, or in several.
struct Content {
    Bounds bounds;
    std::size_t count = 0;

    void add(const Bounds& other, std::size_t more) {
        bounds.add(other);
        count += more;
    }
    double cost() const { return surface(bounds) * static_cast<double>(count); }
};

}  // namespace

PieceTreeBuilder::PieceTreeBuilder(const Scene& scene, const Normalisation& normalise,
                                   LargeVector<PieceTreeNode>& nodes, LargeVector<PieceOutline>& outlines)
    : scene_(scene), normalise_(normalise), nodes_(nodes), outlines_(outlines) {
    // Nothing is asked beyond reach, so wider bounds need not be kept.
    const double margin = std::min(PieceTreeNode::margin + 5 * normalise.greatest_error(), 2 * Normalisation::reach);
    pieces_.reserve(scene.pieces().size());
    for (PieceId id = 0; id < static_cast<PieceId>(scene.pieces().size()); ++id) {
        Bounds bounds;
        for (const VertexId corner : scene.corners(scene.piece(id))) bounds.add(normalise(scene.position(corner)));
        for (std::size_t axis = 0; axis < 3; ++axis) {
            bounds.low[axis] -= margin;
            bounds.high[axis] += margin;
        }
        pieces_.push_back({id, bounds});
    }
}

void PieceTreeBuilder::build() {
    if (pieces_.empty()) return;
    outlines_.reserve(pieces_.size());
    nodes_.emplace_back();
    fill(0, part(0, pieces_.size()), 0);
    nodes_.shrink_to_fit();
}

PieceTreeBuilder::Part PieceTreeBuilder::part(std::size_t first, std::size_t beyond) const {
    Part result{first, beyond, {}};
    for (; first < beyond; ++first) result.bounds.add(pieces_[first].bounds);
    return result;
}

std::pair<PieceTreeBuilder::Part, PieceTreeBuilder::Part> PieceTreeBuilder::halves(const Part& whole) {
    const std::size_t middle = whole.first + whole.size() / 2;
    return {part(whole.first, middle), part(middle, whole.beyond)};
}

std::pair<PieceTreeBuilder::Part, PieceTreeBuilder::Part> PieceTreeBuilder::best_split(const Part& whole) {
    const auto begin = pieces_.begin() + static_cast<std::ptrdiff_t>(whole.first);
    const auto end = pieces_.begin() + static_cast<std::ptrdiff_t>(whole.beyond);
    // 1. Slices along each axis on which the middles differ by more than bounds are wider than what they hold.
    Bounds middles;
    std::for_each(begin, end, [&](const Entry& entry) {
        middles.add(Point{entry.bounds.middle(0), entry.bounds.middle(1), entry.bounds.middle(2)});
    });
    Slices best_slices{};
    std::size_t best_beyond = 0;
    double least = Bounds::infinity;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double length = middles.high[axis] - middles.low[axis];
        if (!(length > PieceTreeNode::margin)) continue;
        const Slices slices{axis, middles.low[axis], static_cast<double>(slice_count) / length};
        std::array<Content, slice_count> content;
        std::for_each(begin, end, [&](const Entry& entry) { content[slices(entry.bounds)].add(entry.bounds, 1); });
        // 2. What each plane between two slices costs.
        std::array<double, slice_count> above{};
        Content all;
        for (std::size_t k = slice_count - 1; k > 0; --k) {
            all.add(content[k].bounds, content[k].count);
            above[k] = all.cost();
        }
        all = {};
        for (std::size_t k = 1; k < slice_count; ++k) {
            all.add(content[k - 1].bounds, content[k - 1].count);
            if (all.cost() + above[k] >= least || all.count == 0 || all.count == whole.size()) continue;
            least = all.cost() + above[k];
            best_slices = slices;
            best_beyond = k;
        }
    }
    // 3. Parted there; where no middles differ so much, anyhow.
    if (best_beyond == 0) return halves(whole);
    const auto middle =
        std::partition(begin, end, [&](const Entry& entry) { return best_slices(entry.bounds) < best_beyond; });
    const auto at = static_cast<std::size_t>(std::distance(pieces_.begin(), middle));
    return {part(whole.first, at), part(at, whole.beyond)};
}

void PieceTreeBuilder::fill(std::size_t node, const Part& all, int level) {
    // 1. What has the largest surface is parted, until there are eight.
    std::vector<Part> parts{all};
    while (parts.size() < 8) {
        const auto of = [](const Part& part) { return part.size() > 1 ? surface(part.bounds) : -1; };
        const auto largest =
            std::max_element(parts.begin(), parts.end(), [&](const Part& a, const Part& b) { return of(a) < of(b); });
        if (largest->size() == 1) break;
        auto [first, second] = level < most_heuristic_levels ? best_split(*largest) : halves(*largest);
        *largest = first;
        parts.push_back(second);
    }
    // 2. Single pieces are outlines, side by side; the others nodes, once this one is known.
    std::vector<Bounds> bounds;
    for (const Part& part : parts) bounds.push_back(part.bounds);
    nodes_[node].set_bounds(bounds);
    for (std::size_t k = 0; k < parts.size(); ++k) {
        if (parts[k].size() > 1) continue;
        nodes_[node].children[k] = ~static_cast<PieceTreeNode::Child>(outlines_.size());
        outlines_.emplace_back(scene_, pieces_[parts[k].first].piece, normalise_);
    }
    // 3. What is below.
    for (std::size_t k = 0; k < parts.size(); ++k) {
        if (parts[k].size() == 1) continue;
        const std::size_t child = nodes_.size();
        nodes_[node].children[k] = static_cast<PieceTreeNode::Child>(child);
        nodes_.emplace_back();
        fill(child, parts[k], level + 1);
    }
}

}  // namespace cob
