// "Error below 1e-13 of the unobstructed value": exact irradiance against polygons that are clipped and summed with 50
// digits, with nothing in common but the definition (SPEC 8).
#include "cob/irradiance.hpp"

#include "truth/rooms.hpp"

#include <gtest/gtest.h>
#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>

#include <algorithm>
#include <random>

namespace cob {
namespace {

using boost::multiprecision::cpp_bin_float_50;
using Digits = cpp_bin_float_50;
using Vector = Vector3<Digits>;
using Loop = std::vector<Vector>;

// What of a planar loop lies on the side of a plane through the origin (Sutherland and Hodgman).
Loop clipped(const Loop& loop, const Vector& normal) {
    Loop result;
    for (std::size_t k = 0; k < loop.size(); ++k) {
        const Vector &a = loop[k], &b = loop[(k + 1) % loop.size()];
        const Digits ha = dot(normal, a), hb = dot(normal, b);
        if (ha >= 0) result.push_back(a);
        if ((ha > 0 && hb < 0) || (ha < 0 && hb > 0)) result.push_back(a + Digits(ha / (ha - hb)) * (b - a));
    }
    return result.size() < 3 ? Loop{} : result;
}

// Form factor as the sum of the projected sector of each side (Arvo 1995): angles by arc cosines.
Digits form_factor(const Loop& loop, const Vector& normal) {
    using boost::multiprecision::acos;
    using boost::multiprecision::sqrt;
    Digits sum = 0;
    for (std::size_t k = 0; k < loop.size(); ++k) {
        const Vector &a = loop[k], &b = loop[(k + 1) % loop.size()];
        const Vector c = cross(a, b);
        const Digits length = sqrt(dot(c, c));
        if (length < Digits("1e-40")) continue;
        const Digits cosine = dot(a, b) / sqrt(dot(a, a) * dot(b, b));
        sum += acos(std::clamp<Digits>(cosine, -1, 1)) * dot(normal, c) / length;
    }
    return abs(sum) / (2 * boost::math::constants::pi<Digits>());
}

struct Reference {
    Digits unobstructed, visible;
};

// The light at height 1, corners relative to the viewpoint at height 0; occluders between, the last one first.
Reference look(const Loop& light, const std::vector<Loop>& occluders, const Vector& normal) {
    const Loop all = clipped(light, normal);
    std::vector<Loop> rest;
    if (!all.empty()) rest.push_back(all);
    for (auto occluder = occluders.rbegin(); occluder != occluders.rend(); ++occluder) {
        const std::size_t n = occluder->size();
        Vector middle{};
        for (const Vector& corner : *occluder) middle = middle + corner;
        std::vector<Loop> next;
        for (Loop inside : rest) {
            for (std::size_t k = 0; k < n; ++k) {
                Vector side = cross((*occluder)[k], (*occluder)[(k + 1) % n]);
                if (dot(side, middle) < 0) side = -side;
                if (const Loop outside = clipped(inside, -side); !outside.empty()) next.push_back(outside);
                inside = clipped(inside, side);
            }
        }
        rest = std::move(next);
    }
    Reference result{all.empty() ? Digits(0) : form_factor(all, normal), 0};
    for (const Loop& part : rest) result.visible += form_factor(part, normal);
    return result;
}

TEST(IrradianceReference, FiftyDigitsAgreeTo1e13) {
    std::mt19937_64 random(11);
    const auto number = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
    };
    int partly = 0, hidden = 0;
    for (int k = 0; k < 150; ++k) {
        const Point viewpoint{number(-1, 2), number(-1, 2), 0};
        const Point normal = k % 3 == 0 ? Point{0, 0, 1} : Point{number(-1, 1), number(-1, 1), number(0.01, 1)};
        const double height = k % 5 == 0 ? 0.001 : 1;  // grazing: the light just above the horizon
        test::RoomBuilder room = test::RoomBuilder().sheet(0, 0, 1, 1, height, false);
        const auto relative = [&](const std::vector<Point>& corners) {
            Loop loop;
            for (const Point& c : corners)
                loop.push_back({Digits(c.x) - viewpoint.x, Digits(c.y) - viewpoint.y, Digits(c.z) - viewpoint.z});
            return loop;
        };
        const Loop light = relative({{0, 0, height}, {1, 0, height}, {1, 1, height}, {0, 1, height}});
        std::vector<Loop> occluders;
        for (int count = 1 + k % 5; count > 0; --count) {
            std::vector<Point> corners;
            const double size = k % 10 == 9 ? 8 : number(0.05, 1);
            const Point at{number(-0.5, 1.5), number(-0.5, 1.5), 0};
            for (int corner = 0; corner < 3; ++corner)
                corners.push_back({at.x + number(-size, size), at.y + number(-size, size), height * number(0.1, 0.9)});
            room.polygon(corners);
            occluders.push_back(relative(corners));
        }
        const Scene scene = room.build();
        const test::EveryPolygon everything(scene);
        const LightAtPoint seen = IrradianceOracle(scene, everything)(viewpoint, to_rational(normal), 0);
        using boost::multiprecision::sqrt;
        Vector n{normal.x, normal.y, normal.z};
        n = Digits(1 / sqrt(dot(n, n))) * n;
        const Reference truth = look(light, occluders, n);
        const Digits allowed = truth.unobstructed * Digits(1e-13);
        EXPECT_LE(abs(truth.unobstructed - seen.unobstructed), allowed) << k;
        EXPECT_LE(abs(truth.visible - seen.visible), allowed) << k;
        partly += truth.visible > 0 && truth.visible < truth.unobstructed * Digits(0.999);
        hidden += truth.visible == 0 && truth.unobstructed > 0;
    }
    EXPECT_GT(partly, 40);
    EXPECT_GT(hidden, 0);
}

}  // namespace
}  // namespace cob
