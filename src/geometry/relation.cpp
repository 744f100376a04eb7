#include "arithmetic/orientation.hpp"
#include "geometry/covers.hpp"
#include "geometry/exact_kernel.hpp"
#include "geometry/filter_kernel.hpp"
#include "geometry/prepared_box.hpp"
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

FilterKernel make_filter(const Box::Prepared& box, const FramePiece<double>& piece, std::uint8_t flat_axes) {
    double largest = box.size;
    for (int k = 0; k < 3; ++k) largest = std::max({largest, -piece.low[k], piece.high[k]});
    return {largest, box.error, std::max(1, piece.count - 2), box.base_exact, flat_axes};
}

/// One piece against one box: the stages share what they have found.
class PieceQuery {
public:
    PieceQuery(const Scene& scene, const Piece& piece, const Box::Prepared& box)
        : scene_(scene), vertices_(scene.corners(piece)), box_(box) {}

    Relation relation(PredicateCounters& counters) {
        Findings findings = filter();
        if (findings.decided()) {
            ++counters.filtered;
        } else {
            ++counters.rational;
            findings = in_fractions(findings);
        }
        return relation_of(findings);
    }

    bool covers(PredicateCounters& counters) {
        UncertainBool answer = UncertainBool::undecided;
        if (kernel_) answer = meets_all_box_edges(*kernel_, box_.frame, piece());
        if (answer != UncertainBool::undecided) {
            ++counters.filtered;
            return answer == UncertainBool::yes;
        }
        ++counters.rational;
        const Rational rise_squared = box_.exact().rise_squared();
        const auto corners = exact_corners();
        return meets_all_box_edges(RationalKernel(rise_squared), box_.exact().frame,
                                   FramePiece<Rational>(corners.data(), static_cast<int>(corners.size()))) ==
               UncertainBool::yes;
    }

private:
    Findings filter() {
        Findings findings;
        findings.undecided = everything();
        if (!to_frame(scene_, vertices_, box_, corners_)) return findings;
        const FramePiece<double> corners = piece();
        kernel_ = make_filter(box_, corners, flat_axes());
        findings.undecided = {};
        separate(*kernel_, box_.frame, corners, AllAxes{}, findings);
        return findings;
    }

    Findings in_fractions(Findings findings) const {
        const AxisSet open = findings.undecided;
        findings.undecided = {};
        const Rational rise_squared = box_.exact().rise_squared();
        const auto corners = exact_corners();
        separate(RationalKernel(rise_squared), box_.exact().frame,
                 FramePiece<Rational>(corners.data(), static_cast<int>(corners.size())), open, findings);
        return findings;
    }

    FramePiece<double> piece() const { return {corners_.data(), static_cast<int>(corners_.size())}; }

    std::vector<Vector3<Rational>> exact_corners() const {
        std::vector<Vector3<Rational>> corners;
        for (const VertexId vertex : vertices_)
            corners.push_back(box_.exact().to_frame(to_rational(scene_.position(vertex))));
        return corners;
    }

    /// Axes of the frame to which the piece is exactly perpendicular.
    std::uint8_t flat_axes() const {
        unsigned flat = 0;
        if (box_.axis_aligned)
            for (int axis = 0; axis < 3; ++axis) {
                const double first = scene_.position(vertices_[0])[axis];
                if (!std::all_of(vertices_.begin(), vertices_.end(),
                                 [&](VertexId vertex) { return scene_.position(vertex)[axis] == first; }))
                    continue;
                for (int k = 0; k < 3; ++k)
                    if (box_.directions[static_cast<std::size_t>(k)][axis] != 0) flat |= 1u << k;
            }
        return static_cast<std::uint8_t>(flat);
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
    std::optional<FilterKernel> kernel_;
    FilterCorners corners_;
};

/// Cover by several pieces: quickly refused where the polygon's extents leave some of the rectangle free.
bool many_cover(const Scene& scene, PolygonId polygon, const Box::Prepared& box, PredicateCounters& counters) {
    if (FilterCorners corners; to_frame(scene, scene.loop(polygon), box, corners)) {
        const FramePiece<double> extents(corners.data(), static_cast<int>(corners.size()));
        const FilterKernel kernel = make_filter(box, extents, 0);
        for (int k = 0; k < 2; ++k)
            if (kernel.face(extents.low[k] - box.frame.low[k], k) == UncertainSign::positive ||
                kernel.face(box.frame.high[k] - extents.high[k], k) == UncertainSign::positive) {
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

/// All pieces of the polygon lie exactly in the element's plane. Its loop may leave it, where SPEC 2 drops a spike.
bool in_base_plane(const Scene& scene, PolygonId polygon, const Box::Prepared& box) {
    for (const Piece& piece : scene.pieces_of(polygon)) {
        for (const VertexId vertex : scene.corners(piece)) {
            const Vector3<Rational> q = box.exact().to_frame(to_rational(scene.position(vertex)));
            if (q.z != box.exact().frame.low.z) return false;
        }
    }
    return true;
}

int strength(Relation relation) {
    return static_cast<int>(relation);
}

}  // namespace

BoxAnswer relate(const Scene& scene, PolygonId polygon, const Box& box, PredicateCounters* counters) {
    PredicateCounters ignored;
    PredicateCounters& count = counters != nullptr ? *counters : ignored;
    const Box::Prepared& prepared = box.prepared();
    const View<Piece> pieces = scene.pieces_of(polygon);

    BoxAnswer answer;
    if (pieces.size() == 1) {
        PieceQuery query(scene, pieces.front(), prepared);
        answer.relation = query.relation(count);
        if (is_close(answer.relation)) answer.covers = query.covers(count);
    } else {
        for (const Piece& piece : pieces) {
            const Relation relation = PieceQuery(scene, piece, prepared).relation(count);
            if (strength(relation) > strength(answer.relation)) answer.relation = relation;
            if (relation == Relation::crossing) break;
        }
        if (is_close(answer.relation)) answer.covers = many_cover(scene, polygon, prepared, count);
    }
    if (answer.relation == Relation::base && in_base_plane(scene, polygon, prepared))
        answer.relation = Relation::coplanar;
    return answer;
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
