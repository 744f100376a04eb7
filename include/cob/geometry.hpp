/// \file
/// Elements, boxes and the exact predicates between a polygon and a box (SPEC sections 3 to 5).
#pragma once

#include "cob/arithmetic.hpp"
#include "cob/scene.hpp"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace cob {

// ---------------------------------------------------------------------------------------- elements (SPEC 3)

using RootId = std::int32_t;  ///< Index into Roots::all().

/// A root element: a whole piece of three or four corners, or a triangle of a piece with more.
struct Root {
    PolygonId polygon = no_polygon;
    PieceId piece = -1;
    std::array<VertexId, 4> corners{};  ///< Counter-clockwise as seen; the fourth -1 for a triangle.
    std::uint8_t longest_side = 0;      ///< Base-edge direction u runs from this corner to the next (choice 2).
    RootId id = -1;                     ///< Its own index in Roots::all().

    int corner_count() const { return corners[3] < 0 ? 3 : 4; }
};

/// All roots of a scene, ascending by polygon, then piece, then triangle.
class Roots {
public:
    explicit Roots(const Scene& scene);
    const std::vector<Root>& all() const { return roots_; }
    const Root& operator[](RootId id) const { return roots_[static_cast<std::size_t>(id)]; }
    RootId size() const { return static_cast<RootId>(roots_.size()); }
    /// The roots of one polygon: [first, last).
    std::pair<RootId, RootId> of(PolygonId polygon) const;

private:
    std::vector<Root> roots_;
    std::vector<RootId> first_of_polygon_;
};

/// An element by its exact address. Of a quadrilateral root: cell (i, j) of the bilinear grid of 2^level_i by
/// 2^level_j, i along corner 0 to 1, j along corner 0 to 3. Of a triangle root, level_i = level_j = level: the
/// triangle with lattice corners (i, j), (i+1, j), (i, j+1) of the side cut in 2^level, or, inverted,
/// (i+1, j+1), (i, j+1), (i+1, j); lattice point (i, j) is corner0 + i/2^level (corner1 - corner0) +
/// j/2^level (corner2 - corner0). Levels up to 31.
struct Element {
    RootId root = -1;
    std::uint32_t i = 0, j = 0;
    std::uint8_t level_i = 0, level_j = 0;
    bool inverted = false;

    friend bool operator==(const Element& a, const Element& b) {
        return a.root == b.root && a.i == b.i && a.j == b.j && a.level_i == b.level_i && a.level_j == b.level_j &&
               a.inverted == b.inverted;
    }
};

/// The element that is the whole root.
Element root_element(RootId root);
/// Halves every side: four children. Of a quadrilateral: (2i,2j), (2i+1,2j), (2i+1,2j+1), (2i,2j+1). Of a
/// triangle: at corners 0, 1, 2, then the middle. Throws InputError beyond level 31.
std::array<Element, 4> children(const Root& root, const Element& element);
/// The element of which this is a child; one of level 0 on either axis has none (std::logic_error).
Element parent(const Root& root, const Element& element);
/// Patches of a root: as few cuts as bring every side to at most edge (SPEC 3), exactly compared; edge <= 0 or
/// infinite: the root alone. Quadrilateral: ascending by j, then i; triangle: the same, upright before inverted.
/// Throws InputError for more than 2^31 patches.
std::vector<Element> patches(const Scene& scene, const Root& root, double edge);
/// Every element `levels` refinements below the given one, in depth-first order of children().
std::vector<Element> descendants(const Root& root, const Element& element, int levels);

/// The exact corners, in order; the fourth is absent for a triangle.
struct Corners {
    std::array<ExactPoint, 4> points;
    int count = 0;
};
Corners corners(const Scene& scene, const Root& root, const Element& element);
/// Exact dyadic combination of the element's corners. Quadrilateral: bilinear at (s, t) in [0, 1]^2; triangle:
/// corner0 + s (corner1 - corner0) + t (corner2 - corner0). s and t are taken exactly.
ExactPoint point_in(const Scene& scene, const Root& root, const Element& element, double s, double t);

// ------------------------------------------------------------------------------------------- boxes (SPEC 4)

/// A question about a box: a row of boxes.csv (SPEC 7), or made from an element.
struct BoxQuestion {
    PolygonId polygon = no_polygon;  ///< The element's own polygon; no_polygon: none is left out.
    Corners corners;
    ExactPoint u;                      ///< Base-edge direction, any length, exactly perpendicular to the normal.
    Rational margin = Rational(1, 8);  ///< Fraction of each extent, >= 0.
    Rational height = Rational(1, 4);  ///< Fraction of the shorter widened extent, > 0.
};

BoxQuestion box_question(const Scene& scene, const Root& root, const Element& element, const Rational& margin,
                         const Rational& height);

/// Numerically prepared box over an element; immutable after construction and safe to share between threads.
/// Throws InputError where SPEC 4 refuses it.
class Box {
public:
    explicit Box(const BoxQuestion& question);
    ~Box();
    Box(Box&&) noexcept;
    Box& operator=(Box&&) noexcept;

    PolygonId polygon() const;
    /// Axis-aligned bounds that contain the closed box, rounded outward: for candidates, never for decisions.
    const std::array<double, 6>& bounds() const;  ///< xmin, ymin, zmin, xmax, ymax, zmax.

    struct Prepared;
    const Prepared& prepared() const { return *prepared_; }

private:
    std::unique_ptr<Prepared> prepared_;
};

// ------------------------------------------------------------------------- polygon against box (SPEC 5)

enum class Relation : std::uint8_t { disjoint, base, coplanar, boundary, crossing };
enum class Shared : std::uint8_t { none, vertex, edge };

const char* to_text(Relation relation);
const char* to_text(Shared shared);
inline bool is_close(Relation relation) {
    return relation == Relation::crossing || relation == Relation::boundary;
}

/// The arithmetic in which a predicate is evaluated. `exact` is the product: filter first, exact where that is
/// undecided, right for every input. The others are the same formula for the study of error against time.
enum class Arithmetic : std::uint8_t { exact, binary32, binary64, epsilon, interval, rational };

/// How often the filter decided and the exact stages were needed; add them up per thread.
struct PredicateCounters {
    std::uint64_t filtered = 0;   ///< Decided in binary64 with certainty.
    std::uint64_t integer = 0;    ///< Decided in fixed-width integers.
    std::uint64_t rational = 0;   ///< Decided in fractions.
    std::uint64_t undecided = 0;  ///< Interval arithmetic alone: no answer.
    PredicateCounters& operator+=(const PredicateCounters& other);
};

struct BoxAnswer {
    Relation relation = Relation::disjoint;
    bool covers = false;  ///< Only where close.
    bool decided = true;  ///< False only in Arithmetic::interval.
};

/// Relation and covers of one polygon (SPEC 5); the own polygon is the caller's to leave out.
BoxAnswer relate(const Scene& scene, PolygonId polygon, const Box& box, PredicateCounters* counters = nullptr);
BoxAnswer relate(const Scene& scene, PolygonId polygon, const Box& box, Arithmetic arithmetic,
                 PredicateCounters* counters = nullptr);
/// How the sides of two polygons touch (SPEC 5).
Shared shared(const Scene& scene, PolygonId a, PolygonId b);
/// Some corner of the box's element lies strictly in front of the plane of one of the light's pieces (SPEC 5).
bool faces(const Scene& scene, PolygonId light, const Box& box, PredicateCounters* counters = nullptr);

}  // namespace cob
