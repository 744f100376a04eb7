/// Point to polygon against closed forms to 1e-12.
#include "cob/form_factor.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace {

using cob::FormFactor;
using cob::Point;

cob::View<Point> view(const std::vector<Point>& points) {
    return {points.data(), points.data() + points.size()};
}

FormFactor precise(const Point& x, const Point& n, const std::vector<Point>& polygon) {
    return cob::precise_form_factor(x, n, view(polygon));
}

constexpr double pi = 3.14159265358979323846;

/// Rectangle [0,a]x[0,b] at height c over the receiver at the origin, facing down (Howell, B-3).
double parallel_rectangle(double a, double b, double c) {
    const double x = a / c, y = b / c;
    const double p = std::sqrt(1 + x * x), q = std::sqrt(1 + y * y);
    return (x / p * std::atan(y / p) + y / q * std::atan(x / q)) / (2 * pi);
}

void expect_relative(double value, double expected, double tolerance) {
    EXPECT_LE(std::fabs(value - expected), tolerance * std::fabs(expected)) << value << " instead of " << expected;
}

std::vector<Point> ceiling(double a, double b, double c) {
    return {{0, 0, c}, {0, b, c}, {a, b, c}, {a, 0, c}};  // counter-clockwise from below
}

TEST(FormFactor, ParallelRectangleAgreesWithTheClosedForm) {
    for (const double a : {0.125, 1.0, 7.5})
        for (const double b : {0.25, 1.0, 100.0})
            for (const double c : {0.0625, 1.0, 30.0})
                expect_relative(precise({0, 0, 0}, {0, 0, 1}, ceiling(a, b, c)).value, parallel_rectangle(a, b, c),
                                1e-12);
}

TEST(FormFactor, PerpendicularRectangleAgreesWithTheClosedForm) {
    // Howell B-4: wall x in [0, a], z in [0, b] at y = c, receiver at the origin facing up.
    for (const double a : {0.5, 1.0, 20.0})
        for (const double b : {0.5, 1.0, 20.0})
            for (const double c : {0.25, 1.0, 3.0}) {
                const double h = std::sqrt(b * b + c * c);
                const double expected = (std::atan(a / c) - c / h * std::atan(a / h)) / (2 * pi);
                const std::vector<Point> wall{{0, c, 0}, {0, c, b}, {a, c, b}, {a, c, 0}};
                const std::vector<Point> reversed(wall.rbegin(), wall.rend());
                const double forward = precise({0, 0, 0}, {0, 0, 1}, wall).value;
                const double backward = precise({0, 0, 0}, {0, 0, 1}, reversed).value;
                EXPECT_EQ(std::min(forward, backward), 0.0);  // seen from one side only
                expect_relative(std::max(forward, backward), expected, 2e-12);
            }
}

TEST(FormFactor, FarAndGrazingKeepTwelveDigits) {
    // A unit square at distance d over the receiver: cos cos / (pi d^2) up to 1/d^2.
    for (const double d : {1e4, 1e6, 1e9, 1e12}) {
        const std::vector<Point> square{{-0.5, -0.5, d}, {-0.5, 0.5, d}, {0.5, 0.5, d}, {0.5, -0.5, d}};
        const FormFactor result = precise({0, 0, 0}, {0, 0, 1}, square);
        expect_relative(result.value, 1 / (pi * d * d), 1e-12 + 1 / (d * d));
        EXPECT_LE(result.error, 1e-12 * result.value);
    }
    // The receiver's plane nearly contains the square: the cosine at the receiver is 2^-30 over distance.
    const double h = 0x1p-30;
    const std::vector<Point> wall{{1, -0.5, 0}, {1, 0.5, 0}, {1, 0.5, h}, {1, -0.5, h}};
    const std::vector<Point> facing(wall.rbegin(), wall.rend());
    const double seen =
        std::max(precise({0, 0, 0}, {0, 0, 1}, wall).value, precise({0, 0, 0}, {0, 0, 1}, facing).value);
    // Integral of z / (pi (1 + y^2)^2): h^2/(2 pi) (y/(1+y^2) + atan y) from y = 0 to 1/2, relative error h^2.
    expect_relative(seen, h * h / (2 * pi) * (0.4 + std::atan(0.5)), 1e-12);
}

TEST(FormFactor, WhatLiesBehindTheReceiverDoesNotCount) {
    // A wall that stands half below the receiver's plane counts as its upper half.
    const std::vector<Point> whole{{-1, 1, -5}, {1, 1, -5}, {1, 1, 1}, {-1, 1, 1}};
    const std::vector<Point> upper{{-1, 1, 0}, {1, 1, 0}, {1, 1, 1}, {-1, 1, 1}};
    const double expected = precise({0, 0, 0}, {0, 0, 1}, upper).value;
    ASSERT_GT(expected, 0.01);
    expect_relative(precise({0, 0, 0}, {0, 0, 1}, whole).value, expected, 1e-12);
    EXPECT_EQ(precise({0, 0, 0}, {0, 0, -1}, upper).value, 0.0);
    // In its plane: nothing.
    EXPECT_EQ(precise({3, 3, 1}, {0, 0, 1}, ceiling(1, 1, 1)).value, 0.0);
}

TEST(FormFactor, AClosedBoxFillsTheHemisphere) {
    const auto quad = [](Point a, Point b, Point c, Point d) { return std::vector<Point>{a, b, c, d}; };
    const std::vector<std::vector<Point>> box{
        quad({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}), quad({0, 0, 1}, {0, 1, 1}, {1, 1, 1}, {1, 0, 1}),
        quad({0, 0, 0}, {0, 0, 1}, {1, 0, 1}, {1, 0, 0}), quad({0, 1, 0}, {1, 1, 0}, {1, 1, 1}, {0, 1, 1}),
        quad({0, 0, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1}), quad({1, 0, 0}, {1, 0, 1}, {1, 1, 1}, {1, 1, 0})};
    std::mt19937_64 random(7);
    for (int round = 0; round < 50; ++round) {
        const auto number = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
        const Point x{number(), number(), number()}, n{number() - 0.5, number() - 0.5, number() - 0.5};
        double sum = 0, precise_sum = 0;
        for (const auto& wall : box) {
            sum += cob::form_factor(x, n, view(wall)).value;
            precise_sum += precise(x, n, wall).value;
        }
        EXPECT_NEAR(sum, 1.0, 1e-13);
        EXPECT_NEAR(precise_sum, 1.0, 4e-12);
    }
}

TEST(FormFactor, TheStatedErrorOfBinary64Holds) {
    std::mt19937_64 random(11);
    const auto number = [&] { return static_cast<double>(random() >> 11) * 0x1p-52 - 1; };
    int seen = 0;
    for (int round = 0; round < 300; ++round) {
        const double size = std::ldexp(1.0, -static_cast<int>(random() % 24));
        const Point o{number(), number(), number() + 1};
        std::vector<Point> triangle;
        for (int k = 0; k < 3; ++k)
            triangle.push_back({o.x + size * number(), o.y + size * number(), o.z + size * number()});
        const Point x{0.1 * number(), 0.1 * number(), 0}, n{number(), number(), number()};
        const FormFactor fast = cob::form_factor(x, n, view(triangle)), exact = precise(x, n, triangle);
        EXPECT_LE(std::fabs(fast.value - exact.value), fast.error + exact.error);
        seen += exact.value > 0;
    }
    EXPECT_GT(seen, 50);
}

TEST(FormFactor, ScalesByPowersOfTwoExactly) {
    const std::vector<Point> square{{0, 0, 1}, {0, 0.7, 1}, {0.9, 0.7, 1}, {0.9, 0, 1}};
    const double unit = precise({0.1, 0.2, 0}, {0, 0.3, 1}, square).value;
    for (const int k : {-900, -300, 300, 900}) {
        std::vector<Point> scaled = square;
        for (Point& p : scaled) p = std::ldexp(1.0, k) * p;
        const Point x{std::ldexp(0.1, k), std::ldexp(0.2, k), 0};
        EXPECT_EQ(precise(x, {0, 0.3, 1}, scaled).value, unit);
        EXPECT_EQ(precise(x, {0, std::ldexp(0.3, k), std::ldexp(1, k)}, scaled).value, unit);
    }
}

}  // namespace
