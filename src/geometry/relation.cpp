#include "arithmetic/orientation.hpp"
#include "geometry/covers.hpp"
#include "geometry/exact_kernel.hpp"
#include "geometry/filter_kernel.hpp"
#include "geometry/integer_stage.hpp"
#include "geometry/prepared_box.hpp"
#include "geometry/relation_alone.hpp"
#include "geometry/separating_axes.hpp"
#include "geometry/study.hpp"

#include <boost/container/small_vector.hpp>

namespace cob {
namespace {

using FilterCorners = boost::container::small_vector<Vector3<double>, 8>;

/// Corners in the frame; false where the filter cannot be used: the box is out of its range, or one of them is.
bool to_frame(const Scene& scene, const View<VertexId>& vertices, const Box::Prepared& box, FilterCorners& corners) {
    if (!box.usable) return false;
    corners.clear();
    double sum = 0;  // NaN and infinity stay in it
    for (const VertexId vertex : vertices) {
        const Vector3<double> q = box.to_frame(scene.position(vertex));
        sum += std::abs(q.x) + std::abs(q.y) + std::abs(q.z);
        corners.push_back(q);
    }
    return sum < 1e90;
}

/// M of filter_kernel.hpp.
double largest_coordinate(const Box::Prepared& box, const FramePiece<double>& piece) {
    double largest = box.size;
    for (int k = 0; k < 3; ++k) largest = std::max({largest, -piece.low[k], piece.high[k]});
    return largest;
}

FilterKernel make_filter(const Box::Prepared& box, const FramePiece<double>& piece) {
    return {largest_coordinate(box, piece), box.error, std::max(1, piece.count - 2), box.base_exact};
}

/// Certainly: what has these extents does not hide all of the base rectangle.
bool leaves_some_free(const FilterKernel& filter, const Box::Prepared& box, const FramePiece<double>& extents) {
    for (int k = 0; k < 2; ++k)
        if (filter.face(extents.low[k] - box.frame.low[k], k) == UncertainSign::positive ||
            filter.face(box.frame.high[k] - extents.high[k], k) == UncertainSign::positive)
            return true;
    return false;
}

/// One piece against one box: the stages share what they have found.
class PieceQuery {
public:
    PieceQuery(const Scene& scene, const Piece& piece, const Box::Prepared& box)
        : scene_(scene),
          vertices_(scene.corners(piece)),
          box_(box),
          in_range_(to_frame(scene, vertices_, box, frame_)) {
        if (!in_range_ || static_cast<int>(vertices_.size()) > GridKernel::most_corners) return;
        const double step = grid_step(largest_coordinate(box, frame_piece()));
        if (!box.grid.contain(step)) return;
        for (const VertexId vertex : vertices_)
            if (!on_grid(scene.position(vertex), step)) return;
        grid_ = GridKernel(step);
    }

    Relation relation(PredicateCounters& counters) {
        Findings findings;
        // 1. Without rounding, else the filter.
        if (grid_) {
            ++counters.filtered;
            separate(*grid_, box_.frame, frame_piece(), AllAxes{}, findings);
            return relation_of(findings);
        }
        if (in_range_) {
            const FramePiece<double> piece = frame_piece();
            separate(make_filter(box_, piece), box_.frame, piece, AllAxes{}, findings);
            if (findings.decided()) {
                ++counters.filtered;
                return relation_of(findings);
            }
            // Ties in the ordinary case, boxes and walls parallel to the axes, need only comparisons.
            const Points points = vertex_points();
            if (box_.aligned) {
                drop_empty_groups(points, findings.undecided);
                if (box_.aligned->sides) compare_with_faces(points, findings);
                if (findings.decided()) {
                    ++counters.filtered;
                    return relation_of(findings);
                }
            }

            // 2. Integers.
            if (separate_in_integers({box_, view(points), piece}, findings.undecided, findings) && findings.decided()) {
                ++counters.integer;
                return relation_of(findings);
            }
        }

        // 3. Fractions.
        ++counters.rational;
        const AxisSet open = in_range_ ? findings.undecided : everything();
        findings.undecided = {};
        const Rational rise_squared = box_.exact().rise_squared();
        const FrameCorners<Rational> corners = exact_corners();
        separate(RationalKernel(rise_squared), box_.exact().frame, frame_piece(corners), open, findings);
        return relation_of(findings);
    }

    bool covers(PredicateCounters& counters) const {
        UncertainBool answer = UncertainBool::undecided;
        if (grid_) {
            ++counters.filtered;
            return meets_all_box_edges(*grid_, box_.frame, frame_piece()) == UncertainBool::yes;
        }
        if (in_range_) {
            const FramePiece<double> piece = frame_piece();
            const FilterKernel filter = make_filter(box_, piece);
            // Before its direction is asked for, which the filter cannot tell where it stands upright.
            answer = leaves_some_free(filter, box_, piece) ? UncertainBool::no
                                                           : meets_all_box_edges(filter, box_.frame, piece);
            if (answer != UncertainBool::undecided) {
                ++counters.filtered;
                return answer == UncertainBool::yes;
            }
            const Points points = vertex_points();
            answer = covers_in_integers({box_, view(points), piece});
            if (answer != UncertainBool::undecided) {
                ++counters.integer;
                return answer == UncertainBool::yes;
            }
        }
        ++counters.rational;
        const Rational rise_squared = box_.exact().rise_squared();
        const FrameCorners<Rational> corners = exact_corners();
        return meets_all_box_edges(RationalKernel(rise_squared), box_.exact().frame, frame_piece(corners)) ==
               UncertainBool::yes;
    }

private:
    using Points = boost::container::small_vector<Point, 8>;

    FramePiece<double> frame_piece() const { return {frame_.data(), static_cast<int>(frame_.size())}; }
    static FramePiece<Rational> frame_piece(const FrameCorners<Rational>& corners) {
        return {corners.data(), static_cast<int>(corners.size())};
    }

    Points vertex_points() const {
        Points points;
        for (const VertexId vertex : vertices_) points.push_back(scene_.position(vertex));
        return points;
    }
    static View<Point> view(const Points& points) { return {points.data(), points.data() + points.size()}; }

    FrameCorners<Rational> exact_corners() const {
        FrameCorners<Rational> corners;
        for (const VertexId vertex : vertices_)
            corners.push_back(box_.exact().to_frame(to_rational(scene_.position(vertex))));
        return corners;
    }

    /// Where all corners agree exactly in a coordinate to which the frame is parallel, N is along that axis.
    void drop_empty_groups(const Points& points, AxisSet& open) const {
        if (open.groups == 0) return;
        for (int k = 0; k < 3; ++k) {
            const int axis = box_.aligned->axis[static_cast<std::size_t>(k)];
            bool flat = true;
            for (const Point& p : points) flat = flat && p[axis] == points[0][axis];
            if (!flat) continue;
            open.groups = static_cast<std::uint8_t>(open.groups & 1u << k);
            // Along N the gaps are those of the box's faces, which are looked at anyway.
            open.normals = 0;
        }
    }

    /// The box's own axes, exactly.
    void compare_with_faces(const Points& points, Findings& findings) const {
        const AxisSet open = findings.undecided;
        if (open.faces == 0) return;
        findings.undecided.faces = 0;
        const AlignedBox& aligned = *box_.aligned;
        for (int k = 0; k < 3; ++k)
            for (int end = 0; end < 2; ++end) {
                if (!open.face(2 * k + end)) continue;
                double nearest = aligned.coordinate(points[0], k);  // to the inside of this face
                for (const Point& p : points) {
                    const double value = aligned.coordinate(p, k);
                    nearest = end == 0 ? std::max(nearest, value) : std::min(nearest, value);
                }
                const Sign beyond = end == 0 ? -aligned.compare(nearest, k, 0) : aligned.compare(nearest, k, 1);
                findings.apart = findings.apart || beyond == Sign::positive;
                findings.touches = findings.touches || beyond == Sign::zero;
                findings.only_base = findings.only_base || (beyond == Sign::zero && k == 2 && end == 0);
            }
    }

    static AxisSet everything() {
        AxisSet all;
        all.faces = 63;
        all.normals = 3;
        all.groups = 7;
        return all;
    }

    const Scene& scene_;
    View<VertexId> vertices_;
    const Box::Prepared& box_;
    FilterCorners frame_;
    bool in_range_;
    std::optional<GridKernel> grid_;
};

/// Cover by several pieces: quickly refused where the polygon's extents leave some of the rectangle free.
bool many_cover(const Scene& scene, PolygonId polygon, const Box::Prepared& box, PredicateCounters& counters) {
    if (FilterCorners corners; to_frame(scene, scene.loop(polygon), box, corners)) {
        const FramePiece<double> extents(corners.data(), static_cast<int>(corners.size()));
        if (leaves_some_free(make_filter(box, extents), box, extents)) {
            ++counters.filtered;
            return false;
        }
    }
    ++counters.rational;
    std::vector<FrameCorners<Rational>> pieces;
    for (const Piece& piece : scene.pieces_of(polygon)) {
        pieces.emplace_back();
        for (const VertexId vertex : scene.corners(piece))
            pieces.back().push_back(box.exact().to_frame(to_rational(scene.position(vertex))));
    }
    const Rational rise_squared = box.exact().rise_squared();
    return pieces_cover(RationalKernel(rise_squared), box.exact().frame, pieces);
}

bool in_base_plane(const Point& p, const Box::Prepared& box) {
    const auto& c = box.question.corners.points;
    if (!box.aligned) {
        // Of a quadrilateral's halves one may be straight and tell nothing, but not both.
        const ExactPoint point(p);
        return orientation(c[0], c[1], c[2], point) == Sign::zero &&
               (box.question.corners.count == 3 || orientation(c[0], c[2], c[3], point) == Sign::zero);
    }
    const int axis = box.aligned->axis[2];
    return c[0].rest()[axis] == 0 && c[0].nearest()[axis] == p[axis];
}

/// All of the polygon, that is all of its pieces (a loop may have spikes besides), lies in the element's plane.
bool in_base_plane(const Scene& scene, PolygonId polygon, const Box::Prepared& box) {
    for (const Piece& piece : scene.pieces_of(polygon))
        for (const VertexId vertex : scene.corners(piece))
            if (!in_base_plane(scene.position(vertex), box)) return false;
    return true;
}

int strength(Relation relation) {
    return static_cast<int>(relation);
}

BoxAnswer relate(const Scene& scene, PolygonId polygon, const Box::Prepared& prepared, bool asks_cover,
                 PredicateCounters& count) {
    const View<Piece> pieces = scene.pieces_of(polygon);

    BoxAnswer answer;
    if (pieces.size() == 1) {
        PieceQuery query(scene, pieces.front(), prepared);
        answer.relation = query.relation(count);
        if (asks_cover && is_close(answer.relation)) answer.covers = query.covers(count);
    } else {
        for (const Piece& piece : pieces) {
            const Relation relation = PieceQuery(scene, piece, prepared).relation(count);
            if (strength(relation) > strength(answer.relation)) answer.relation = relation;
            if (relation == Relation::crossing) break;
        }
        if (asks_cover && is_close(answer.relation)) answer.covers = many_cover(scene, polygon, prepared, count);
    }
    if (answer.relation == Relation::base && in_base_plane(scene, polygon, prepared))
        answer.relation = Relation::coplanar;
    return answer;
}

}  // namespace

BoxAnswer relate(const Scene& scene, PolygonId polygon, const Box& box, PredicateCounters* counters) {
    PredicateCounters ignored;
    return relate(scene, polygon, box.prepared(), true, counters != nullptr ? *counters : ignored);
}

Relation relation_alone(const Scene& scene, PolygonId polygon, const Box& box) {
    PredicateCounters ignored;
    return relate(scene, polygon, box.prepared(), false, ignored).relation;
}

const char* to_text(Relation relation) {
    switch (relation) {
        case Relation::disjoint:
            return "disjoint";
        case Relation::base:
            return "base";
        case Relation::coplanar:
            return "coplanar";
        case Relation::boundary:
            return "boundary";
        case Relation::crossing:
            return "crossing";
    }
    return "";
}

const char* to_text(Shared shared) {
    switch (shared) {
        case Shared::none:
            return "none";
        case Shared::vertex:
            return "vertex";
        case Shared::edge:
            return "edge";
    }
    return "";
}

PredicateCounters& PredicateCounters::operator+=(const PredicateCounters& other) {
    filtered += other.filtered;
    integer += other.integer;
    rational += other.rational;
    undecided += other.undecided;
    return *this;
}

}  // namespace cob
