#include "golden/snap.hpp"

#include "cob/error.hpp"
#include "cob/geometry.hpp"
#include "golden/parameters.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cob {

namespace {

/// Nearest multiple of 2^-grid, ties to even; what is a multiple already stays.
double snapped(double value, int grid) {
    constexpr double all_integers = 9007199254740992.0;  // 2^53: every binary64 number beyond it is an integer.
    const double scaled = std::ldexp(value, grid);
    if (!(std::abs(scaled) < all_integers)) return value;
    return std::ldexp(std::nearbyint(scaled), -grid) + 0.0;
}

/// Bits below the grid that corners and sample points need: every halving of a side adds one to a triangle, and to a
/// quadrilateral, whose bilinear products take one of each side, two.
int bits_below_grid(const Scene& scene, const GoldenParameters& parameters) {
    const int sample = parameters.segments > 0 || parameters.hard > 0 ? sample_bits(format_of(parameters)) : 0;
    int most = 0;
    const Roots roots(scene);
    for (const Root& root : roots.all()) {
        const Element patch = patches(scene, root, parameters.edge.value_or(0)).front();
        const int cuts = root.corner_count() == 4 ? patch.level_i + patch.level_j + 2 * parameters.level + 2 * sample
                                                  : patch.level_i + parameters.level + sample;
        most = std::max(most, cuts);
    }
    return most;
}

/// Bits above the grid's unit: of coordinates, and of differences of two.
int bits_above_one(const Scene& scene) {
    double largest = 0;
    for (const Point& p : scene.positions())
        for (int axis = 0; axis < 3; ++axis) largest = std::max(largest, std::abs(p[axis]));
    int exponent = 0;
    std::frexp(largest, &exponent);  // largest < 2^exponent; rounding up to it needs one bit more
    return exponent + 1;
}

Scene::Input moved(const Scene& scene, int grid) {
    Scene::Input input{scene.name(), scene.positions(), {}, scene.materials()};
    for (Point& p : input.positions)
        for (int axis = 0; axis < 3; ++axis) p[axis] = snapped(p[axis], grid);
    for (PolygonId id = 0; id < scene.polygon_count(); ++id) {
        const auto loop = scene.loop(id);
        input.faces.push_back({{loop.begin(), loop.end()}, scene.polygon(id).material, scene.polygon(id).line});
    }
    return input;
}

SnapReport compare(const Scene& before, const Scene& after, int grid) {
    SnapReport report;
    report.grid = grid;
    for (std::size_t k = 0; k < before.positions().size(); ++k) {
        const Point move = after.positions()[k] - before.positions()[k];
        if (move == Point{}) continue;
        ++report.moved;
        report.largest_move = std::max(report.largest_move, std::hypot(move.x, move.y, move.z));
    }
    for (PolygonId id = 0; id < before.polygon_count(); ++id) {
        if (!before.polygon(id).valid) continue;
        if (!after.polygon(id).valid)
            report.now_invalid.push_back(id);
        else if (before.polygon(id).planar && !after.polygon(id).planar)
            report.not_planar.push_back(id);
    }
    return report;
}

/// Numbers of the set run from 2^-(grid + below) to 2^above; binary32 and binary64 end where they end.
void refuse_beyond_format(const Scene& scene, NumberFormat format, int finest_bit) {
    const bool is_binary32 = format == NumberFormat::binary32;
    const int most = is_binary32 ? std::numeric_limits<float>::max_exponent : std::numeric_limits<double>::max_exponent;
    const int least = is_binary32 ? 149 : 1074;  // of the smallest subnormal number
    if (bits_above_one(scene) <= most && finest_bit <= least) return;
    throw InputError(std::string("the scene is too ") + (finest_bit > least ? "small" : "large") + " for exact " +
                         (is_binary32 ? "binary32" : "binary64") + " numbers",
                     {scene.name(), 0, "", "choose another unit of length, or a coarser --grid"});
}

void refuse_new_invalid(const SnapReport& report, const Scene& after) {
    const PolygonId first = report.now_invalid.front();
    std::string reason;
    for (const InvalidPolygon& invalid : after.invalid())
        if (invalid.polygon == first) reason = invalid.reason;
    throw InputError("snapping to multiples of 2^" + std::to_string(-report.grid) + " makes " +
                         std::to_string(report.now_invalid.size()) + " polygons invalid, polygon " +
                         std::to_string(first) + " by " + reason,
                     {after.name(), after.polygon(first).line, "", "choose a finer --grid or give --skip-invalid"});
}

}  // namespace

SnappedScene snap(Scene scene, const GoldenParameters& parameters) {
    const NumberFormat format = format_of(parameters);
    if (!parameters.grid && !parameters.binary32) return {std::move(scene), {}};
    for (const double value : {parameters.margin, parameters.height})
        if (!fits(value, format))
            throw InputError("margin and height must be binary32 numbers, too",
                             {"", 0, to_text(value), "choose a multiple of a power of two"});

    // The finest grid that leaves room for corners and sample points; snapping may lengthen a side and so refine the
    // patches, hence the loop.
    const auto finest = [&](const Scene& of) {
        return digits(format) - bits_above_one(of) - std::max(1, bits_below_grid(of, parameters));
    };
    const int wanted = parameters.grid.value_or(finest(scene));
    for (int grid = wanted;; --grid) {
        Scene after = Scene::build(moved(scene, grid), {true});
        const int possible = finest(after);
        if (grid > possible) {
            if (!parameters.grid) continue;
            throw InputError("grid is too fine for all corners and sample points to be exact",
                             {"", 0, std::to_string(grid), "choose --grid " + std::to_string(possible) + " or less"});
        }
        refuse_beyond_format(after, format, grid + bits_below_grid(after, parameters));
        SnapReport report = compare(scene, after, grid);
        if (!report.now_invalid.empty() && !parameters.skip_invalid) refuse_new_invalid(report, after);
        return {std::move(after), std::move(report)};
    }
}

}  // namespace cob
