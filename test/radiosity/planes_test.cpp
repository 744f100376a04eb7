/// Planes in binary64 with error bounds: what they call certain is what exact arithmetic says, at any size of a piece.
#include "radiosity/planes.hpp"

#include "cob/candidates.hpp"
#include "cob/visibility.hpp"
#include "scenes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace {

using cob::ExactPoint;
using cob::Point;
using cob::Visibility;
using cob::radiosity::Crossing;
using cob::radiosity::Planes;

TEST(Planes, WhatIsCertainIsExactAlsoWhereProductsUnderflow) {
    std::mt19937_64 engine(1);
    const auto point = [&](int exponent) {
        const auto coordinate = [&] { return std::scalbn(static_cast<double>(engine() % 257) - 128, exponent - 7); };
        return Point{coordinate(), coordinate(), coordinate()};
    };
    std::size_t sides = 0, pierced = 0, missed = 0;
    for (const int size : {0, -20, -530, -533, -536, -539})
        for (int repeat = 0; repeat < 50; ++repeat) {
            scenes::Builder b;
            b.add({point(size), point(size), point(size)}, {0, 0, 0});
            const cob::Scene scene = b.scene();
            const Planes planes(scene, 0);
            const auto candidates = cob::make_candidates(scene, cob::Source::all);
            const cob::VisibilityOracle oracle(scene, *candidates);
            for (int k = 0; k < 40; ++k) {
                const Point from = point(k % 2 ? size : 0), to = point(size);
                const auto side_from = planes.side(0, from), side_to = planes.side(0, to);
                const auto exact_from = planes.exact_side(0, ExactPoint(from)),
                           exact_to = planes.exact_side(0, ExactPoint(to));
                sides += side_from.has_value();
                EXPECT_EQ(side_from.value_or(exact_from), exact_from) << size;
                EXPECT_EQ(side_to.value_or(exact_to), exact_to) << size;
                if (from == to) continue;
                const Crossing crossing = planes.crossing(0, from, exact_from, to, exact_to);
                if (crossing == Crossing::unknown) continue;
                ++(crossing == Crossing::pierces ? pierced : missed);
                EXPECT_EQ(oracle({ExactPoint(from), ExactPoint(to), -1, -1}),
                          crossing == Crossing::pierces ? Visibility::blocked : Visibility::clear)
                    << size;
            }
        }
    EXPECT_GT(sides, 1000u);
    EXPECT_GT(pierced, 100u);
    EXPECT_GT(missed, 1000u);
}

}  // namespace
