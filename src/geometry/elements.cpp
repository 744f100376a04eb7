// Elements by address (SPEC 3): roots, refinement and exact corners.
#include "arithmetic/lengths.hpp"
#include "cob/error.hpp"
#include "cob/geometry.hpp"
#include "geometry/lattice.hpp"

#include <cmath>
#include <stdexcept>

namespace cob {
namespace {

constexpr int most_levels = 31;

/// Choice 2: the longest side, the first among equals.
std::uint8_t longest_side(const Scene& scene, const Root& root) {
    const auto count = static_cast<std::size_t>(root.corner_count());
    const auto corner = [&](std::size_t k) -> const Point& { return scene.position(root.corners[k % count]); };
    std::size_t longest = 0;
    for (std::size_t side = 1; side < count; ++side)
        if (compare_lengths(corner(side), corner(side + 1), corner(longest), corner(longest + 1)) == Sign::positive)
            longest = side;
    return static_cast<std::uint8_t>(longest);
}

Root make_root(const Scene& scene, RootId id, PieceId piece, const std::array<VertexId, 4>& corners) {
    Root root{scene.piece(piece).polygon, piece, corners, 0, id};
    root.longest_side = longest_side(scene, root);
    return root;
}

/// An element of the lattice one level finer than `element`.
Element finer(const Element& element, std::uint32_t i, std::uint32_t j, bool inverted) {
    return {element.root,
            i,
            j,
            static_cast<std::uint8_t>(element.level_i + 1),
            static_cast<std::uint8_t>(element.level_j + 1),
            inverted};
}

void append_descendants(const Root& root, const Element& element, int levels, std::vector<Element>& out) {
    if (levels == 0) {
        out.push_back(element);
        return;
    }
    for (const Element& child : children(root, element)) append_descendants(root, child, levels - 1, out);
}

/// Lattice corners of an element, in order.
struct Cell {
    std::array<std::array<std::uint32_t, 2>, 4> corners;
    int count;
};

Cell cell(const Root& root, const Element& element) {
    const std::uint32_t i = element.i, j = element.j;
    if (root.corner_count() == 4) return {{{{i, j}, {i + 1, j}, {i + 1, j + 1}, {i, j + 1}}}, 4};
    if (element.inverted) return {{{{i + 1, j + 1}, {i, j + 1}, {i + 1, j}, {0, 0}}}, 3};
    return {{{{i, j}, {i + 1, j}, {i, j + 1}, {0, 0}}}, 3};
}

/// b - a without rounding, as the rounded difference and what it leaves out (Knuth's two-sum).
struct Difference {
    double rounded, rest;
};
Difference exact_difference(double b, double a) {
    const double rounded = b - a, a_part = b - rounded, b_part = rounded + a_part;
    return {rounded, (a_part - a) + (b - b_part)};
}

/// Direction u (choice 2), at a quarter of its length where the whole would overflow.
ExactPoint base_edge(const Scene& scene, const Root& root) {
    const std::size_t from = root.longest_side, to = (from + 1) % static_cast<std::size_t>(root.corner_count());
    const Point &a = scene.position(root.corners[from]), &b = scene.position(root.corners[to]);
    Point nearest, rest;
    for (int axis = 0; axis < 3; ++axis) {
        const Difference difference = exact_difference(b[axis], a[axis]);
        if (!std::isfinite(difference.rest)) return ExactPoint(Rational(1, 4) * (to_rational(b) - to_rational(a)));
        nearest[axis] = difference.rounded;
        rest[axis] = difference.rest;
    }
    return ExactPoint::from_pair(nearest, rest);
}

}  // namespace

Roots::Roots(const Scene& scene) {
    first_of_polygon_.reserve(scene.polygons().size() + 1);
    roots_.reserve(scene.pieces().size());
    for (PolygonId polygon = 0; polygon < scene.polygon_count(); ++polygon) {
        first_of_polygon_.push_back(size());
        const auto first = static_cast<PieceId>(scene.polygon(polygon).first_piece);
        const auto count = static_cast<PieceId>(scene.polygon(polygon).piece_count);
        for (PieceId piece = first; piece < first + count; ++piece) {
            const auto corners = scene.corners(scene.piece(piece));
            if (corners.size() == 3) {
                roots_.push_back(make_root(scene, size(), piece, {corners[0], corners[1], corners[2], -1}));
            } else if (corners.size() == 4) {
                roots_.push_back(make_root(scene, size(), piece, {corners[0], corners[1], corners[2], corners[3]}));
            } else {
                for (const auto& [a, b, c] : cut_into_triangles(scene, scene.piece(piece)))
                    roots_.push_back(make_root(scene, size(), piece, {corners[a], corners[b], corners[c], -1}));
            }
        }
    }
    first_of_polygon_.push_back(size());
}

std::pair<RootId, RootId> Roots::of(PolygonId polygon) const {
    const auto k = static_cast<std::size_t>(polygon);
    return {first_of_polygon_[k], first_of_polygon_[k + 1]};
}

Element root_element(RootId root) {
    Element element;
    element.root = root;
    return element;
}

std::array<Element, 4> children(const Root& root, const Element& element) {
    if (element.level_i >= most_levels || element.level_j >= most_levels)
        throw InputError("an element cannot be refined beyond level 31",
                         {"", 0, "", "ask for fewer levels or a longer edge"});
    const std::uint32_t i = 2 * element.i, j = 2 * element.j;
    if (root.corner_count() == 4)
        return {finer(element, i, j, false), finer(element, i + 1, j, false), finer(element, i + 1, j + 1, false),
                finer(element, i, j + 1, false)};
    if (element.inverted)
        return {finer(element, i + 1, j + 1, true), finer(element, i, j + 1, true), finer(element, i + 1, j, true),
                finer(element, i + 1, j + 1, false)};
    return {finer(element, i, j, false), finer(element, i + 1, j, false), finer(element, i, j + 1, false),
            finer(element, i, j, true)};
}

Element parent(const Root& root, const Element& element) {
    if (element.level_i == 0 || element.level_j == 0) throw std::logic_error("a patch has no parent");
    Element result{element.root,
                   element.i / 2,
                   element.j / 2,
                   static_cast<std::uint8_t>(element.level_i - 1),
                   static_cast<std::uint8_t>(element.level_j - 1),
                   false};
    // Only the middle child of a triangle stands the other way up than its parent.
    const bool is_odd_i = element.i % 2 == 1, is_odd_j = element.j % 2 == 1;
    if (root.corner_count() == 3) result.inverted = element.inverted ? (is_odd_i || is_odd_j) : (is_odd_i && is_odd_j);
    return result;
}

std::vector<Element> descendants(const Root& root, const Element& element, int levels) {
    std::vector<Element> elements;
    append_descendants(root, element, levels, elements);
    return elements;
}

Corners corners(const Scene& scene, const Root& root, const Element& element) {
    const Cell lattice = cell(root, element);
    Corners result;
    result.count = lattice.count;
    for (std::size_t k = 0; k < static_cast<std::size_t>(lattice.count); ++k)
        result.points[k] = lattice_point(scene, root, Dyadic{lattice.corners[k][0], element.level_i},
                                         Dyadic{lattice.corners[k][1], element.level_j});
    return result;
}

ExactPoint point_in(const Scene& scene, const Root& root, const Element& element, double s, double t) {
    // Inverted triangles run backwards from their first corner (i + 1, j + 1).
    const std::uint32_t shift = element.inverted ? 1 : 0;
    const int step = element.inverted ? -1 : 1;
    const auto u = dyadic_sum(element.i + shift, element.level_i, step, s);
    const auto v = dyadic_sum(element.j + shift, element.level_j, step, t);
    if (u && v) return lattice_point(scene, root, *u, *v);
    const auto exact = [&](std::uint32_t base, int level, double part) {
        return Rational((Rational(base + shift) + step * Rational(part)) / Rational(Integer(1) << level));
    };
    return lattice_point(scene, root, exact(element.i, element.level_i, s), exact(element.j, element.level_j, t));
}

BoxQuestion box_question(const Scene& scene, const Root& root, const Element& element, const Rational& margin,
                         const Rational& height) {
    BoxQuestion question;
    question.polygon = root.polygon;
    question.corners = corners(scene, root, element);
    question.u = base_edge(scene, root);
    question.margin = margin;
    question.height = height;
    return question;
}

}  // namespace cob
