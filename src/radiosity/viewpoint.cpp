#include "radiosity/viewpoint.hpp"

#include "geometry/bounds.hpp"
#include "scene/edges.hpp"

namespace cob::radiosity {
namespace {

/// Exact: the corner b lies on the line through a and c.
bool is_straight(const Point& a, const Point& b, const Point& c) {
    const BoundedVector turn =
        cross(BoundedVector{b, 0} - BoundedVector{a, 0}, BoundedVector{c, 0} - BoundedVector{b, 0});
    if (turn.size() > turn.error) return false;
    const RationalPoint p = to_rational(a), q = to_rational(b), r = to_rational(c);
    return cob::cross(q - p, r - q) == RationalPoint{};
}

double scale_of(const Bounds& bounds) {
    const double size = longest_extent(bounds);
    return size > 0 ? std::ldexp(1.0, -std::clamp(std::ilogb(size), -1000, 1020)) : 1;
}

}  // namespace

PreparedPieces::PreparedPieces(const Scene& scene) : scene_(&scene), scale_(scale_of(bounds_of(scene))) {
    const std::vector<VertexId> canonical = first_at_position(scene);
    first_corner_.push_back(0);
    for (const Piece& piece : scene.pieces()) {
        const View<VertexId> loop = scene.corners(piece);
        const auto n = loop.size();
        for (std::size_t k = 0; k < n; ++k) {
            const VertexId corner = canonical[loop[k]];
            if (!is_straight(scene.position(loop[(k + n - 1) % n]), scene.position(corner),
                             scene.position(loop[(k + 1) % n])))
                corners_.push_back(corner);
        }
        first_corner_.push_back(static_cast<std::uint32_t>(corners_.size()));
    }
}

View<VertexId> PreparedPieces::corners(PieceId piece) const {
    const auto k = static_cast<std::size_t>(piece);
    return {corners_.data() + first_corner_[k], corners_.data() + first_corner_[k + 1]};
}

BoundedVector Viewpoint::towards(VertexId vertex) const {
    const double scale = pieces_->scale();
    const Vector3<double> coarse = scale * pieces_->scene().position(vertex) - scale * position_.nearest();
    const Vector3<double> rest = scale * position_.rest();
    BoundedVector result{coarse - rest, 0};
    const double off = BoundedVector{coarse, 0}.size() + BoundedVector{rest, 0}.size();
    // Differences that are exact are common (grids, dyadic points) but not told apart here.
    result.error = 2.5 * unit_roundoff * off + underflow;
    return result;
}

const RationalPoint& Viewpoint::exact_position() const {
    if (!exact_position_) exact_position_ = position_.rational();
    return *exact_position_;
}

RationalPoint Viewpoint::exact_towards(VertexId vertex) const {
    return to_rational(pieces_->scene().position(vertex)) - exact_position();
}

BoundedVector Viewpoint::normal(PieceId piece) const {
    const View<VertexId> loop = pieces_->corners(piece);
    const double scale = pieces_->scale();
    const auto at = [&](int k) { return BoundedVector{scale * pieces_->scene().position(loop[k]), 0}; };
    return cross(at(1) - at(0), at(2) - at(0));
}

RationalPoint Viewpoint::exact_normal(PieceId piece) const {
    const View<VertexId> loop = pieces_->corners(piece);
    const auto at = [&](int k) { return to_rational(pieces_->scene().position(loop[k])); };
    return cob::cross(at(1) - at(0), at(2) - at(0));
}

BoundedNumber Viewpoint::height_over(PieceId piece) const {
    return dot(normal(piece), -towards(pieces_->corners(piece)[0]));
}

Rational Viewpoint::exact_height_over(PieceId piece) const {
    return -cob::dot(exact_normal(piece), exact_towards(pieces_->corners(piece)[0]));
}

Sign Viewpoint::side_of(PieceId piece) const {
    if (const auto certain = height_over(piece).sign()) return *certain;
    return sign_of(exact_height_over(piece));
}

Sign Viewpoint::side_of(PieceId piece, VertexId vertex) const {
    const VertexId base = pieces_->corners(piece)[0];
    for (VertexId corner : pieces_->corners(piece))
        if (corner == vertex) return Sign::zero;
    const double scale = pieces_->scale();
    const Point &p = pieces_->scene().position(vertex), &q = pieces_->scene().position(base);
    const BoundedVector offset = BoundedVector{scale * p, 0} - BoundedVector{scale * q, 0};
    if (const auto certain = dot(normal(piece), offset).sign()) return *certain;
    return sign_of(cob::dot(exact_normal(piece), to_rational(p) - to_rational(q)));
}

}  // namespace cob::radiosity
