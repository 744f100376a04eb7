#include "radiosity/visible_light.hpp"

#include "geometry/convex_polygon.hpp"
#include "radiosity/cone_algebra.hpp"

#include <boost/container/small_vector.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>

#include <cmath>
#include <type_traits>

namespace cob::radiosity {
namespace {

using boost::multiprecision::cpp_bin_float;
template <unsigned digits>
using Decimal = boost::multiprecision::number<cpp_bin_float<digits>, boost::multiprecision::et_off>;

/// Is the piece certainly on the outside of one of the cone's planes? May say no.
bool misses(const PlanesThroughPoint& planes, const Cone& cone, const View<VertexId>& corners) {
    boost::container::small_vector<BoundedVector, 8> towards;
    for (VertexId corner : corners) towards.push_back(planes.viewpoint().towards(corner));
    for (const PlaneRef& plane : cone.planes) {
        const BoundedVector normal = planes.normal(plane);
        bool outside = true;
        for (std::size_t k = 0; k < towards.size() && outside; ++k) {
            const BoundedNumber height = dot(normal, towards[k]);
            outside = height.value < -height.error || planes.contains(plane, corners[k]);
        }
        if (outside) return true;
    }
    return false;
}

/// The directions in which the piece lies strictly between the viewpoint and the plane of a piece of the light.
std::optional<Cone> shadow_of(PlanesThroughPoint& planes, PieceId occluder, PieceId light) {
    const Viewpoint& viewpoint = planes.viewpoint();
    bool in_front = false, behind = false;
    for (VertexId corner : viewpoint.pieces().corners(occluder)) {
        const Sign side = viewpoint.side_of(light, corner);
        in_front = in_front || side == Sign::positive;
        behind = behind || side == Sign::negative;
    }
    if (!in_front) return std::nullopt;
    std::optional<Cone> shadow = planes.over(occluder);
    if (!shadow || !behind) return shadow;
    return split(planes, *shadow, planes.before(occluder, light)).positive;
}

/// Large shadows first: they leave less to cut. Any order gives the same region.
double apparent_size(const Viewpoint& viewpoint, PieceId piece) {
    const Vector3<double> to = viewpoint.towards(viewpoint.pieces().corners(piece)[0]).value;
    const double distance = length(to);
    const double size = std::abs(viewpoint.height_over(piece).value) / (distance * distance * distance);
    return size > 0 ? size : 0;  // NaN, of what underflows, would not sort
}

/// Appends what is seen of the cone over one piece of the light.
void append_visible(PlanesThroughPoint& planes, const Cone& cone, PieceId light, const std::vector<PieceId>& on_top,
                    const std::vector<PieceId>& occluders, std::vector<Cone>& visible) {
    const Viewpoint& viewpoint = planes.viewpoint();
    struct Shadow {
        double size;
        PieceId piece;
        Cone cone;
    };
    std::vector<Shadow> shadows;
    for (PieceId sheet : on_top)
        if (!misses(planes, cone, viewpoint.pieces().corners(sheet)))
            if (auto hidden = planes.over(sheet))
                shadows.push_back({apparent_size(viewpoint, sheet), sheet, std::move(*hidden)});
    for (PieceId occluder : occluders)
        if (occluder != light && !misses(planes, cone, viewpoint.pieces().corners(occluder)))
            if (auto shadow = shadow_of(planes, occluder, light))
                shadows.push_back({apparent_size(viewpoint, occluder), occluder, std::move(*shadow)});
    std::vector<const Cone*> largest_first;
    std::sort(shadows.begin(), shadows.end(),
              [](const Shadow& a, const Shadow& b) { return a.size != b.size ? a.size > b.size : a.piece < b.piece; });
    for (const Shadow& shadow : shadows) largest_first.push_back(&shadow.cone);
    subtract(planes, cone, std::move(largest_first), visible);
}

ConeInNumbers<double> in_binary64(const PlanesThroughPoint& planes, const Cone& cone) {
    ConeInNumbers<double> result;
    for (const PlaneRef& plane : cone.planes) result.inward.push_back(planes.normal(plane).value);
    for (const Ray& ray : cone.rays) result.rays.push_back(ray.direction.value);
    return result;
}

/// Error of lambert<double>() of the cone, from the errors of its planes and rays.
double error_in_binary64(const PlanesThroughPoint& planes, const ReceiverNormal& normal, const Cone& cone) {
    const auto relative = [](const BoundedVector& v) { return 1.8 * v.error / length(v.value) + 4 * unit_roundoff; };
    double sum = 0;
    const std::size_t n = cone.rays.size();
    for (std::size_t k = 0; k < n; ++k) {
        const BoundedVector &from = cone.rays[(k + n - 1) % n].direction, &to = cone.rays[k].direction;
        const BoundedVector inward = planes.normal(cone.planes[k]);
        const double theta = angle(from.value, to.value);
        const double cosine =
            std::abs(dot(normal.bounded.value, inward.value)) / (length(normal.bounded.value) * length(inward.value));
        sum += theta * (2 * relative(inward) + 2 * relative(normal.bounded)) +
               cosine * (relative(from) + relative(to) + theta * 4 * unit_roundoff);
    }
    return 1.01 * sum / (2 * boost::math::constants::pi<double>());
}

BoundedNumber sum_in_binary64(const PlanesThroughPoint& planes, const ReceiverNormal& normal,
                              const std::vector<Cone>& cones, bool with_error) {
    BoundedNumber sum;
    for (const Cone& cone : cones) {
        sum.value += lambert(normal.bounded.value, in_binary64(planes, cone));
        if (with_error) sum.error += error_in_binary64(planes, normal, cone) + 2 * unit_roundoff * std::abs(sum.value);
    }
    return sum;
}

/// With all digits of T.
template <class T>
T number_of(const Rational& value) {
    if constexpr (std::is_floating_point_v<T>) {
        const double nearest = to_nearest(value);
        return T(nearest) + T(to_nearest(Rational(value - Rational(nearest))));
    } else {
        return T(numerator(value)) / T(denominator(value));
    }
}

/// To a largest component between 1/2 and 2, with all digits of T.
template <class T>
Vector3<T> scaled(const RationalPoint& v) {
    const Rational size = largest_component(v);
    Vector3<T> result;
    for (int axis = 0; axis < 3; ++axis) {
        result[axis] = number_of<T>(v[axis] / size);
    }
    return result;
}

template <class T>
T sum_in(const PlanesThroughPoint& planes, const ReceiverNormal& normal, const std::vector<Cone>& cones) {
    T sum = 0;
    for (const Cone& cone : cones) {
        ConeInNumbers<T> numbers;
        for (const PlaneRef& plane : cone.planes) numbers.inward.push_back(scaled<T>(planes.exact_normal(plane)));
        for (const Ray& ray : cone.rays) numbers.rays.push_back(scaled<T>(planes.exact_direction(ray)));
        sum += lambert(scaled<T>(normal.exact), numbers);
    }
    return sum;
}

double sides(const std::vector<Cone>& cones) {
    double count = 0;
    for (const Cone& cone : cones) count += static_cast<double>(cone.planes.size());
    return count;
}

/// Both sums with that many digits, where these suffice for 1e-14 of the unobstructed one. With exact rays and normals,
/// rounded once, a side's angle is off by at most 20 units of rounding and its cosine by 15, times an angle of at most
/// pi, over 2 pi: with the additions below 16 units, 8 epsilons.
template <class T>
bool evaluate_in(const PlanesThroughPoint& planes, const ReceiverNormal& normal, const std::vector<Cone>& all,
                 const std::vector<Cone>& visible, LightView& view) {
    const T unobstructed = sum_in<T>(planes, normal, all);
    const T error = T(8 * (sides(all) + sides(visible))) * std::numeric_limits<T>::epsilon();
    if (!(error <= unobstructed * T(1e-14))) return false;
    view.unobstructed = static_cast<double>(unobstructed);
    view.visible = static_cast<double>(sum_in<T>(planes, normal, visible));
    return true;
}

void evaluate(const PlanesThroughPoint& planes, const ReceiverNormal& normal, const std::vector<Cone>& all,
              const std::vector<Cone>& visible, Precision precision, LightView& view) {
    const bool certain = precision == Precision::certain;
    const BoundedNumber a = sum_in_binary64(planes, normal, all, certain);
    const BoundedNumber v = sum_in_binary64(planes, normal, visible, certain);
    view.unobstructed = a.value, view.visible = v.value;
    const bool is_number = std::isfinite(a.value) && std::isfinite(v.value);
    if (is_number && (!certain || (a.error <= 1e-14 * a.value && v.error <= 1e-14 * a.value))) return;
    // The 64 bits of the x87 suffice for most; where long double is binary64, they do not.
    if (evaluate_in<long double>(planes, normal, all, visible, view)) return;
    // Long angles of a light that is small or seen at a graze cancel: more digits. What 1200 do not tell from nothing
    // is below 1e-1100, and nothing in binary64.
    if (evaluate_in<Decimal<50>>(planes, normal, all, visible, view)) return;
    if (evaluate_in<Decimal<200>>(planes, normal, all, visible, view)) return;
    if (evaluate_in<Decimal<450>>(planes, normal, all, visible, view)) return;
    if (evaluate_in<Decimal<1200>>(planes, normal, all, visible, view)) return;
    view.unobstructed = view.visible = 0;
}

}  // namespace

ReceiverNormal::ReceiverNormal(const RationalPoint& normal) : exact(normal) {
    const Rational size = largest_component(normal);
    for (int axis = 0; axis < 3; ++axis) bounded.value[axis] = to_nearest(Rational(normal[axis] / size));
    bounded.error = unit_roundoff;
}

LightView view_light(const Viewpoint& viewpoint, const ReceiverNormal& normal, const LightPieces& light,
                     const std::vector<PieceId>& occluders, Precision precision) {
    PlanesThroughPoint planes(viewpoint);
    std::vector<Cone> all, visible;
    const PlaneRef horizon = planes.perpendicular_to(normal.exact, normal.bounded);
    bool untouched = true;
    for (PieceId piece : light.pieces) {
        if (viewpoint.side_of(piece) != Sign::positive) continue;
        std::optional<Cone> cone = split(planes, *planes.over(piece), horizon).positive;
        if (!cone) continue;
        const std::size_t before = visible.size();
        append_visible(planes, *cone, piece, light.on_top, occluders, visible);
        untouched = untouched && visible.size() == before + 1 && visible.back().planes == cone->planes;
        all.push_back(std::move(*cone));
    }
    LightView view;
    view.parts = static_cast<int>(visible.size());
    evaluate(planes, normal, all, visible, precision, view);
    // Sums of parts may be off by their last digits; what is known is not.
    if (untouched) view.visible = view.unobstructed;
    if (visible.empty()) view.visible = 0;
    view.unobstructed = std::clamp(view.unobstructed, 0.0, 1.0);
    view.visible = std::clamp(view.visible, 0.0, view.unobstructed);
    if (precision == Precision::binary64) return view;
    for (const Cone& cone : visible) view.solid_angle += solid_angle(in_binary64(planes, cone));
    return view;
}

}  // namespace cob::radiosity
