#include "radiosity/cell_signs.hpp"

#include <algorithm>
#include <cmath>

namespace cob::radiosity {
namespace {

/// What is below it, against the largest, is a sliver beside a rounded cut: a share of 2^-23 or 2^-16 of the cell.
constexpr double negligible_if_linear = 0x1p-24, negligible_if_quadratic = 0x1p-34;
constexpr double most_beyond = 4;  ///< Between what a polynomial's values and its coefficients say.

bool zero_inside(const BoundedNumber& value) {
    return std::abs(value.value) <= value.error;
}

/// The sign of a polynomial on a triangle from its Bernstein coefficients, those at the corners first, all but a
/// sliver: where a corner's is p and none is below -q, the polynomial is negative only where l^degree p < q, l the
/// corner's barycentric coordinate.
template <std::size_t n>
std::optional<Sign> sign_of_coefficients(const std::array<BoundedNumber, n>& c, double& sliver) {
    for (const Sign sign : {Sign::positive, Sign::negative}) {
        double p = 0, q = 0;
        for (std::size_t k = 0; k < n; ++k) {
            const double low = (sign == Sign::positive ? c[k].value : -c[k].value) - c[k].error;
            if (k < 3) p = std::max(p, low);
            q = std::max(q, -low);
            if (!(low >= -HUGE_VAL)) return std::nullopt;
        }
        if (q > 0 && !(q <= (n == 3 ? negligible_if_linear : negligible_if_quadratic) * p)) continue;
        if (q == 0 && p == 0) return std::nullopt;
        // The strip 0 <= l < e has a share of at most 2 e.
        if (q > 0) sliver += 2.01 * (n == 3 ? q / p : std::sqrt(q / p));
        return sign;
    }
    return std::nullopt;
}

template <std::size_t n>
UndecidedSign undecided_of(const std::array<BoundedNumber, n>& c) {
    UndecidedSign result;
    result.linear = n == 3;
    for (std::size_t k = 0; k < n; ++k) result.coefficients[k] = c[k].value;
    return result;
}

}  // namespace

SignsOverCell::SignsOverCell(const PairShapes& shapes, const Triangle2D& cell) : shapes_(&shapes), cell_(cell) {
    const std::size_t pairs = shapes.side_count() * shapes.corner_count();
    if (pairs <= most_in_table) linear_.assign(pairs, Known::not_asked), normals_.resize(shapes.side_count());
    for (std::size_t k = 0; k < 3; ++k) {
        const Point2D &a = cell[k], &b = cell[(k + 1) % 3];
        const Vector3<double> middle{0.5 * (a.s + b.s), 0.5 * (a.t + b.t), 0};
        places_[k] = {{a.s, a.t, 0}, 0};
        places_[k + 3] = {middle, unit_roundoff * BoundedVector{middle, 0}.size() + underflow};
    }
}

SignsOverCell::SignsOverCell(const SignsOverCell& around, const Point2D& point)
    : SignsOverCell(*around.shapes_, Triangle2D{point, point, point}) {
    linear_ = around.linear_;
    is_point_ = true;
}

void SignsOverCell::note(const UndecidedSign& sign) {
    if (!undecided_ || (sign.linear && !undecided_->linear)) undecided_ = sign;
}

const SignsOverCell::Normals& SignsOverCell::normals(std::int32_t side, bool at_middles) {
    Normals& known = is_sparse() ? sparse_normals_[side] : normals_[static_cast<std::size_t>(side)];
    const auto& [a, b] = shapes_->side(side);
    const auto fill = [&, a = a, b = b](std::size_t from, std::size_t to) {
        for (std::size_t k = from; k < to; ++k)
            known.at[k] = cross(shapes_->bounded_corner(a) - places_[k], shapes_->bounded_corner(b) - places_[k]);
    };
    if (!known.at_corners) fill(0, is_point_ ? 1 : 3), known.at_corners = true;
    if (at_middles && !known.at_middles && !is_point_) fill(3, 6), known.at_middles = true;
    return known;
}

// ---------------------------------------------------------------------------------------- a side and a corner

SignsOverCell::Known& SignsOverCell::known(std::int32_t side, VertexId v) {
    const std::size_t key = static_cast<std::size_t>(side) * shapes_->corner_count() + static_cast<std::size_t>(v);
    return is_sparse() ? sparse_linear_[key] : linear_[key];
}

SignsOverCell::Known SignsOverCell::linear(std::int32_t side, VertexId v) {
    Known& known = this->known(side, v);
    if (is_point_ ? known == Known::zero || known == Known::negative || known == Known::positive
                  : known != Known::not_asked && known != Known::undecided)
        return known;
    const auto& [a, b] = shapes_->side(side);
    if (v == a || v == b) return known = Known::zero;
    const Normals& normal = normals(side, false);
    const auto value_at = [&](std::size_t k) { return dot(normal.at[k], shapes_->bounded_corner(v) - places_[k]); };
    if (is_point_) {
        if (const auto sign = value_at(0).sign())
            return known = *sign == Sign::positive   ? Known::positive
                           : *sign == Sign::negative ? Known::negative
                                                     : Known::zero;
        if (shapes_->always_in_plane(side, v)) return known = Known::zero;
        note({true, {}});
        return known = Known::undecided;
    }
    const std::array<BoundedNumber, 3> values{value_at(0), value_at(1), value_at(2)};
    if (known == Known::not_asked) {
        double sliver = 0;
        if (const auto sign = sign_of_coefficients(values, sliver)) {
            sliver_ += sliver;
            if (*sign == Sign::positive) return known = sliver > 0 ? Known::mostly_positive : Known::positive;
            return known = sliver > 0 ? Known::mostly_negative : Known::negative;
        }
        if (std::all_of(values.begin(), values.end(), zero_inside) && shapes_->always_in_plane(side, v))
            return known = Known::zero;
    }
    note(undecided_of(values));
    return known = Known::undecided;
}

std::optional<Sign> SignsOverCell::linear_sign(std::int32_t side, VertexId v) {
    switch (linear(side, v)) {
        case Known::zero:
            return Sign::zero;
        case Known::negative:
        case Known::mostly_negative:
            return Sign::negative;
        case Known::positive:
        case Known::mostly_positive:
            return Sign::positive;
        default:
            return std::nullopt;
    }
}

std::optional<Sign> SignsOverCell::side(PlaneRef plane, VertexId v) {
    const auto sign = linear_sign(plane.index, v);
    return sign && plane.flipped ? -*sign : sign;
}

std::optional<Sign> SignsOverCell::side_without_sliver(PlaneRef plane, VertexId v) {
    const Known known = linear(plane.index, v);
    if (known == Known::mostly_negative || known == Known::mostly_positive) return std::nullopt;
    return side(plane, v);
}

// -------------------------------------------------------------------------------------------------- three sides

std::optional<Sign> SignsOverCell::side(PlaneRef plane, const ContourRay& ray) {
    if (ray.vertex >= 0) return side(plane, ray.vertex);
    if (ray.first.index == plane.index || ray.second.index == plane.index) return Sign::zero;
    const auto sign = determinant_sign(plane.index, ray.first.index, ray.second.index);
    if (!sign) return std::nullopt;
    return (plane.flipped != ray.first.flipped) != ray.second.flipped ? -*sign : *sign;
}

/// The sign of [m, m', m''].
std::optional<Sign> SignsOverCell::determinant_sign(std::int32_t p, std::int32_t q, std::int32_t r) {
    // Sides that share a corner v: (u x v) x (v x w) = [u, v, w] v, and the determinant is a product of two linear
    // ones.
    for (const auto& [one, other, third] : {std::array{p, q, r}, std::array{q, r, p}, std::array{r, p, q}}) {
        const auto &e = shapes_->side(one), &f = shapes_->side(other);
        for (std::size_t i = 0; i < 2; ++i)
            for (std::size_t j = 0; j < 2; ++j) {
                if (e[i] != f[j]) continue;
                const auto between = linear_sign(one, f[1 - j]), along = linear_sign(third, e[i]);
                if ((between && *between == Sign::zero) || (along && *along == Sign::zero)) return Sign::zero;
                if (!between || !along) return std::nullopt;
                return j == 0 ? *between * *along : -(*between * *along);
            }
    }
    return quadratic_sign(p, q, r);
}

std::optional<Sign> SignsOverCell::quadratic_sign(std::int32_t p, std::int32_t q, std::int32_t r) {
    const Normals &m = normals(p, true), &n = normals(q, true), &o = normals(r, true);
    const auto value_at = [&](std::size_t k) { return dot(cross(m.at[k], n.at[k]), o.at[k]); };
    if (is_point_) {
        if (const auto sign = value_at(0).sign()) return sign;
        if (shapes_->always_in_line({p, q, r})) return Sign::zero;
        note({});
        return std::nullopt;
    }
    std::array<BoundedNumber, 6> c;
    for (std::size_t k = 0; k < 6; ++k) c[k] = value_at(k);
    for (std::size_t k = 0; k < 3; ++k) {
        const BoundedNumber &middle = c[k + 3], &a = c[k], &b = c[(k + 1) % 3];
        const double sizes = 4 * std::abs(middle.value) + std::abs(a.value) + std::abs(b.value);
        c[k + 3] = {2 * middle.value - 0.5 * (a.value + b.value),
                    (2 * middle.error + 0.5 * (a.error + b.error) + unit_roundoff * sizes) * (1 + 8 * unit_roundoff)};
    }
    if (const auto sign = sign_of_coefficients(c, sliver_)) return sign;
    if (std::all_of(c.begin(), c.end(), zero_inside) && shapes_->always_in_line({p, q, r})) return Sign::zero;
    const UndecidedSign undecided = undecided_of(c);
    if (doubt_ > 0) {
        std::array<std::int32_t, 3> sides{p, q, r};
        std::sort(sides.begin(), sides.end());
        if (const auto sign = sign_in_doubt(undecided, sides)) return sign;
    }
    note(undecided);
    return std::nullopt;
}

std::optional<Sign> SignsOverCell::sign_in_doubt(const UndecidedSign& undecided, std::array<std::int32_t, 3> sides) {
    std::array<double, 6> c = undecided.coefficients;
    const auto value_at = [&](const std::array<double, 3>& l) {
        return c[0] * l[0] * l[0] + c[1] * l[1] * l[1] + c[2] * l[2] * l[2] +
               2 * (c[3] * l[0] * l[1] + c[4] * l[1] * l[2] + c[5] * l[2] * l[0]);
    };
    const Sign sign = value_at({1.0 / 3, 1.0 / 3, 1.0 / 3}) > 0 ? Sign::positive : Sign::negative;
    if (sign == Sign::negative)
        for (double& value : c) value = -value;
    const double largest = std::max({c[0], c[1], c[2]}), least = *std::min_element(c.begin(), c.end());
    if (!(least < 0 && -least <= doubt_ * largest)) return std::nullopt;
    // Where on the sides it is least.
    std::array<double, 3> worst{1, 0, 0};
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t next = (k + 1) % 3;
        const double bend = c[k] - 2 * c[k + 3] + c[next];
        const double f = bend > 0 ? std::clamp((c[k] - c[k + 3]) / bend, 0.0, 1.0) : c[k] < c[next] ? 0 : 1;
        std::array<double, 3> place{};
        place[k] = 1 - f, place[next] = f;
        if (value_at(place) < value_at(worst)) worst = place;
    }
    // Not on the side itself, where the receiver may touch what it looks at.
    const double inwards = -0.125 * value_at(worst) / largest;
    for (double& l : worst) l += inwards * (1.0 / 3 - l);
    const double value = value_at(worst);
    if (!(value < 0 && least >= most_beyond * value)) return std::nullopt;

    DoubtfulSign doubtful{sides, undecided, {}, least / value, std::min(1.0, 2.01 * std::sqrt(-least / largest))};
    for (std::size_t k = 0; k < 3; ++k)
        doubtful.worst.s += worst[k] * cell_[k].s, doubtful.worst.t += worst[k] * cell_[k].t;
    if (std::none_of(doubtful_.begin(), doubtful_.end(), [&](const auto& known) { return known.sides == sides; }))
        doubtful_.push_back(doubtful);
    return sign;
}

}  // namespace cob::radiosity
