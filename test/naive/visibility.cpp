#include "naive/visibility.hpp"

#include <algorithm>
#include <map>

namespace cob::naive {

const char* to_text(Visibility visibility) {
    static const char* const names[] = {"clear", "grazing", "blocked"};
    return names[static_cast<int>(visibility)];
}

namespace {

/// What is seen of a direction when looking along the segment: a vector of the plane.
struct Flat {
    Rational s, t;
};
Rational cross(const Flat& a, const Flat& b) {
    return a.s * b.t - a.t * b.s;
}
Rational dot(const Flat& a, const Flat& b) {
    return a.s * b.s + a.t * b.t;
}

/// A ray from the point of contact along which a sector ends.
struct Ray {
    RationalPoint in_space;
    Flat flat;
};

/// What a piece is near a point on its border: the open directions counter-clockwise from one ray to the other, a
/// half-plane at a side, a wedge at a corner; at most half a turn.
struct Sector {
    Ray from, to;
    bool contains(const Flat& direction) const {
        return cross(from.flat, direction) > 0 && cross(direction, to.flat) > 0;
    }
};

/// Projection along the segment onto the plane of two coordinate axes.
class Projection {
public:
    explicit Projection(const RationalPoint& along) : along_(along) {
        while (along_[axis_] == 0) ++axis_;
    }
    Ray operator()(const RationalPoint& direction) const {
        const RationalPoint flat = direction - Rational(direction[axis_] / along_[axis_]) * along_;
        return {direction, {flat[(axis_ + 1) % 3], flat[(axis_ + 2) % 3]}};
    }

private:
    RationalPoint along_;
    int axis_ = 0;
};

bool same_ray(const RationalPoint& a, const RationalPoint& b) {
    return cob::cross(a, b) == RationalPoint{} && cob::dot(a, b) > 0;
}

/// "The pieces close when the open sectors, together with the rays in space along which two of the sectors end on
/// opposite sides, cover the full turn." Between two neighbours of all rays nothing changes, so it is enough to look
/// at every ray and at one direction between each and the next.
bool close_around(const std::vector<Sector>& sectors) {
    const auto covered = [&](const Flat& direction) {
        return std::any_of(sectors.begin(), sectors.end(), [&](const Sector& s) { return s.contains(direction); });
    };
    const auto joined = [&](const Flat& direction) {
        for (const Sector& left : sectors)
            for (const Sector& right : sectors)
                if (same_ray(left.from.in_space, right.to.in_space) && cross(left.from.flat, direction) == 0 &&
                    dot(left.from.flat, direction) > 0)
                    return true;
        return false;
    };
    std::vector<Flat> rays;
    for (const Sector& sector : sectors) {
        rays.push_back(sector.from.flat);
        rays.push_back(sector.to.flat);
    }
    const auto lower_half = [](const Flat& a) { return a.t < 0 || (a.t == 0 && a.s < 0); };
    std::sort(rays.begin(), rays.end(), [&](const Flat& a, const Flat& b) {
        return lower_half(a) != lower_half(b) ? lower_half(b) : cross(a, b) > 0;
    });
    for (std::size_t k = 0; k < rays.size(); ++k) {
        const Flat &a = rays[k], &b = rays[(k + 1) % rays.size()];
        if (!covered(a) && !joined(a)) return false;
        if (cross(a, b) == 0 && dot(a, b) > 0) continue;              // the same direction
        if (cross(a, b) <= 0 && !covered({-a.t, a.s})) return false;  // half a turn or more: look right after a
        if (cross(a, b) > 0 && !covered({a.s + b.s, a.t + b.t})) return false;
    }
    return !rays.empty();
}

/// How a convex piece lies around a point of its plane.
struct Place {
    enum { outside, inside, border } where = outside;
    std::optional<Sector> sector;  ///< Where on the border.
};

/// Positive to the left of side k as seen from the piece's visible side, zero on its line.
Rational left_of(const RationalPoint& point, const Piece& piece, std::size_t k) {
    const RationalPoint &a = piece.corners[k], &b = piece.corners[(k + 1) % piece.corners.size()];
    return dot(piece.normal, cob::cross(b - a, point - a));
}

/// Where a point of the piece's plane lies.
Place place_of(const RationalPoint& point, const Piece& piece, const Projection& project) {
    const Loop& corners = piece.corners;
    const std::size_t count = corners.size();
    std::optional<std::size_t> corner, side;
    for (std::size_t k = 0; k < count; ++k) {
        const RationalPoint &a = corners[k], &b = corners[(k + 1) % count];
        const Rational left = left_of(point, piece, k);
        if (left < 0) return {};
        if (point == a) corner = k;
        if (left == 0 && dot(a - point, b - point) < 0) side = k;
    }
    Place place;
    if (!corner && !side) {
        place.where = Place::inside;
        return place;
    }
    place.where = Place::border;
    const std::size_t before = corner ? (*corner + count - 1) % count : *side;
    const std::size_t after = corner ? (*corner + 1) % count : (*side + 1) % count;
    Ray from = project(corners[before] - point), to = project(corners[after] - point);
    RationalPoint middle;
    for (const RationalPoint& vertex : corners) middle = middle + (vertex - point);
    if (cross(from.flat, project(middle).flat) < 0) std::swap(from, to);
    place.sector = Sector{from, to};
    return place;
}

/// The open segment in the piece's plane meets the closed piece: more than an end of it lies left of all sides.
bool meets_in_plane(const Piece& piece, const RationalPoint& x, const RationalPoint& y) {
    Rational low = 0, high = 1;  // the parameters that are
    for (std::size_t k = 0; k < piece.corners.size(); ++k) {
        const Rational at_x = left_of(x, piece, k), at_y = left_of(y, piece, k);
        if (at_x < 0 && at_y < 0) return false;
        if (at_x < 0) low = std::max<Rational>(low, at_x / (at_x - at_y));
        if (at_y < 0) high = std::min<Rational>(high, at_x / (at_x - at_y));
    }
    return low <= high && low < 1 && high > 0;
}

}  // namespace

bool lies_on(const RationalPoint& point, const Piece& piece) {
    if (dot(piece.normal, point - piece.corners.front()) != 0) return false;
    for (std::size_t k = 0; k < piece.corners.size(); ++k)
        if (left_of(point, piece, k) < 0) return false;
    return true;
}

Visibility visibility(const std::vector<const Polygon*>& scene, const RationalPoint& x, const RationalPoint& y) {
    const RationalPoint along = y - x;
    const Projection project(along);
    bool met = false;
    std::map<Rational, std::vector<Sector>> contacts;  // by the place along the segment
    for (const Polygon* polygon : scene) {
        for (const Piece& piece : polygon->pieces) {
            const RationalPoint& corner = piece.corners.front();
            const Rational at_x = dot(piece.normal, x - corner), at_y = dot(piece.normal, y - corner);
            if (at_x == 0 && at_y == 0) {
                met = met || meets_in_plane(piece, x, y);
            } else if (at_x.sign() * at_y.sign() < 0) {
                const Rational parameter = at_x / (at_x - at_y);
                const Place place = place_of(x + parameter * along, piece, project);
                if (place.where == Place::inside) return Visibility::blocked;
                if (place.where == Place::border) contacts[parameter].push_back(*place.sector);
            }
        }
    }
    for (const auto& [parameter, sectors] : contacts)
        if (close_around(sectors)) return Visibility::blocked;
    return met || !contacts.empty() ? Visibility::grazing : Visibility::clear;
}

}  // namespace cob::naive
