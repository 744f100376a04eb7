#include "golden/hard_segments.hpp"

#include "cob/error.hpp"

#include <array>
#include <cmath>

namespace cob {

namespace {

constexpr int attempts = 32;

PolygonId any_polygon(const Questions& questions, Dice& dice) {
    return dice.of(questions.valid_polygons());
}

struct Side {
    RationalPoint a, b;
    PolygonId polygon = no_polygon;
};

Side any_side(const Questions& questions, Dice& dice) {
    const PolygonId polygon = any_polygon(questions, dice);
    const auto loop = questions.scene().loop(polygon);
    const std::size_t k = dice.below(loop.size());
    const auto at = [&](std::size_t corner) {
        return to_rational(questions.scene().position(loop[corner % loop.size()]));
    };
    return {at(k), at(k + 1), polygon};
}

/// A vertex, or a point a quarter, half or three quarters along a side.
RationalPoint target(const Questions& questions, Dice& dice, bool corner) {
    const Side side = any_side(questions, dice);
    const Rational along = corner ? Rational(0) : Rational(1 + static_cast<int>(dice.below(3)), 4);
    return side.a + along * (side.b - side.a);
}

SegmentTask from_to(const RationalPoint& from, const RationalPoint& to) {
    return {{ExactPoint(from), ExactPoint(to)}, no_polygon, no_polygon, ""};
}

// ------------------------------------------------------------------------------------------------ the kinds

SegmentTask through(const Questions& questions, Dice& dice, bool corner) {
    const Sample sample = questions.sample_element(dice);
    const RationalPoint start = sample.point.rational();
    SegmentTask task = from_to(start, Rational(2) * target(questions, dice, corner) - start);
    task.from = sample.polygon;
    task.segment.from_piece = sample.piece;
    return task;
}

SegmentTask beside(const Questions& questions, Dice& dice, bool corner) {
    const SegmentTask exact = through(questions, dice, corner);
    const NumberFormat format = questions.format();
    std::array<Point, 2> ends{exact.segment.from.nearest(), exact.segment.to.nearest()};
    for (Point& end : ends)
        for (int axis = 0; axis < 3; ++axis) end[axis] = rounded(end[axis], format);
    double& moved = ends[dice.below(2)][static_cast<int>(dice.below(3))];
    moved = neighbour(moved, dice.coin() ? HUGE_VAL : -HUGE_VAL, format);
    return {{ends[0], ends[1]}, no_polygon, no_polygon, ""};
}

SegmentTask seam(const Questions& questions, Dice& dice) {
    const Side side = any_side(questions, dice);
    SegmentTask task =
        dice.coin() ? from_to(side.a, side.b) : from_to(Rational(2) * side.a - side.b, Rational(2) * side.b - side.a);
    return task;
}

SegmentTask plane(const Questions& questions, Dice& dice) {
    const Root& root = dice.of(questions.roots().all());
    const RationalPoint p = questions.sample(root, root_element(root.id), dice).point.rational();
    const RationalPoint q = questions.sample(root, root_element(root.id), dice).point.rational();
    const Rational beyond(static_cast<int>(dice.below(4)));
    return from_to(p + beyond * (p - q), q + beyond * (q - p));
}

SegmentTask vertices(const Questions& questions, Dice& dice) {
    const Side from = any_side(questions, dice), to = any_side(questions, dice);
    SegmentTask task = from_to(from.a, to.a);
    task.from = from.polygon, task.to = to.polygon;
    return task;
}

SegmentTask stretched(const Questions& questions, Dice& dice, int power) {
    const RationalPoint middle = target(questions, dice, dice.coin());
    const RationalPoint reach = questions.sample_element(dice).point.rational() - middle;
    for (;; power /= 2) {
        const RationalPoint step = Rational(std::ldexp(1.0, power)) * reach;
        SegmentTask task = from_to(middle + step, middle - step);
        const NumberFormat format = questions.format();
        if (power == 0 || (fits(task.segment.from, format) && fits(task.segment.to, format))) return task;
    }
}

struct Kind {
    const char* name;
    SegmentTask (*make)(const Questions&, Dice&);
};

constexpr Kind always_possible{"vertices", vertices};
constexpr std::array<Kind, 9> kinds{{
    {"edge", [](const Questions& q, Dice& d) { return through(q, d, false); }},
    {"corner", [](const Questions& q, Dice& d) { return through(q, d, true); }},
    {"edge-ulp", [](const Questions& q, Dice& d) { return beside(q, d, false); }},
    {"corner-ulp", [](const Questions& q, Dice& d) { return beside(q, d, true); }},
    {"seam", seam},
    {"plane", plane},
    always_possible,
    {"far", [](const Questions& q, Dice& d) { return stretched(q, d, 1 + static_cast<int>(d.below(40))); }},
    {"small", [](const Questions& q, Dice& d) { return stretched(q, d, -1 - static_cast<int>(d.below(40))); }},
}};

}  // namespace

std::vector<std::string> hard_segment_kinds() {
    std::vector<std::string> names;
    for (const Kind& kind : kinds) names.emplace_back(kind.name);
    return names;
}

SegmentTask hard_segment(const Questions& questions, std::size_t wanted, Dice dice) {
    for (int attempt = 0; attempt < 2 * attempts; ++attempt) {
        const Kind& kind = attempt < attempts ? kinds[wanted] : always_possible;
        SegmentTask task = kind.make(questions, dice);
        const Segment& segment = task.segment;
        if (segment.from == segment.to || !fits(segment.from, questions.format()) ||
            !fits(segment.to, questions.format()))
            continue;
        task.kind = kind.name;
        return task;
    }
    throw InputError("too few vertices for hard segments", {questions.scene().name(), 0, "", "choose another scene"});
}

}  // namespace cob
