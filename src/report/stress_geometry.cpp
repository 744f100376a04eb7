// Extreme geometry: the product against fractions, and what other arithmetics get wrong there.
#include "cob/stress.hpp"
#include "report/stress_scene.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace cob {
namespace {

using stress::Answers;
using stress::Questions;
using stress::Shapes;

/// What must not have changed against the untransformed scene.
enum class Unchanged { nothing, visibility, everything };

struct GeometryCase {
    std::string name;
    Shapes shapes;
    Unchanged unchanged = Unchanged::nothing;
    Rational margin = Rational(1, 8), height = Rational(1, 4);
    int level = 1;
    /// Further sentences that must hold of the exact answers; each gives "" or what is wrong.
    std::string law{};
    std::function<std::string(const Scene&, const Questions&, const Answers&)> broken{};
};

ArithmeticErrors difference(const Answers& a, const Answers& b) {
    ArithmeticErrors errors;
    for (std::size_t i = 0; i < a.relations.size(); ++i)
        if (a.relations[i].relation != b.relations[i].relation || a.relations[i].covers != b.relations[i].covers)
            ++errors.relations;
    for (std::size_t i = 0; i < a.visibility.size(); ++i)
        if (a.visibility[i] != b.visibility[i]) ++errors.visibility;
    return errors;
}

std::string power_of_ten(double value) {
    return std::fabs(value) >= 1e5 || std::fabs(value) < 1e-4
               ? "1e" + std::to_string(static_cast<int>(std::lround(std::log10(value))))
               : to_text(value);
}

// ------------------------------------------------------------------------------------------------ the cases

/// Multiplied by powers of two, which changes no answer, and by powers of ten, which rounds every coordinate.
void add_scales(std::vector<GeometryCase>& cases, bool quick) {
    const auto scaled = [](double factor) { return [factor](const Point& p) { return factor * p; }; };
    for (const int exponent : {-1000, -498, -160, -30, 30, 160, 498, 1000}) {
        if (quick && std::abs(exponent) != 498) continue;
        cases.push_back({"scale 2^" + std::to_string(exponent),
                         mapped(stress::still_life(), scaled(std::ldexp(1.0, exponent))), Unchanged::everything});
    }
    for (const double factor : {1e-150, 1e-100, 1e-50, 1e-10, 0.1, 1e10, 1e50, 1e100, 1e150}) {
        if (quick && factor != 1e-150 && factor != 1e150) continue;
        cases.push_back({"scale " + power_of_ten(factor), mapped(stress::still_life(), scaled(factor))});
    }
}

void add_offsets(std::vector<GeometryCase>& cases, bool quick) {
    for (const int exponent : {10, 20, 30, 40, 50}) {
        if (quick && exponent != 50) continue;
        const double far = std::ldexp(1.0, exponent);
        cases.push_back({"offset 2^" + std::to_string(exponent),
                         mapped(stress::still_life(),
                                [far](const Point& p) {
                                    return p + Point{far, -far, far / 2};
                                }),
                         Unchanged::everything});
    }
}

/// Stretched along x: affine, so that no visibility changes; boxes do.
void add_aspects(std::vector<GeometryCase>& cases, bool quick) {
    for (const int exponent : {10, 20, 27}) {
        if (quick && exponent != 27) continue;
        const double stretch = std::ldexp(1.0, exponent);
        cases.push_back({"aspect ratio 2^" + std::to_string(exponent),
                         mapped(stress::still_life(),
                                [stretch](const Point& p) {
                                    return Point{stretch * p.x, p.y, p.z};
                                }),
                         Unchanged::visibility});
    }
}

/// Two sheets, the upper one an ulp above, below, or at the lower one's height.
void add_ulp_sheets(std::vector<GeometryCase>& cases) {
    const auto two = [](double z) {
        Shapes shapes;
        shapes.loops = {{{0, 0, 1}, {4, 0, 1}, {4, 4, 1}, {0, 4, 1}}, {{-1, -1, z}, {5, -1, z}, {5, 5, z}, {-1, 5, z}}};
        return shapes;
    };
    const auto all_of_the_lower = [](Relation wanted, bool covers) {
        return [wanted, covers](const Scene&, const Questions& questions, const Answers& answers) {
            for (std::size_t b = 0; b < questions.boxes.size(); ++b)
                if (questions.boxes[b].polygon == 0 &&
                    (answers.relations[b].relation != wanted || answers.relations[b].covers != covers))
                    return std::string("a box over the lower sheet has relation ") +
                           to_text(answers.relations[b].relation);
            return std::string();
        };
    };
    const auto add = [&](const char* name, double z, const char* law, Relation wanted, bool covers) {
        GeometryCase row;
        row.name = name;
        row.shapes = two(z);
        row.law = law;
        row.broken = all_of_the_lower(wanted, covers);
        cases.push_back(std::move(row));
    };
    add("two sheets, 1 ulp above", std::nextafter(1.0, 2.0), "every element of the lower sheet is covered",
        Relation::crossing, true);
    add("two sheets, 1 ulp below", std::nextafter(1.0, 0.0), "nothing is over the elements of the first sheet",
        Relation::disjoint, false);
    add("two sheets at one height", 1.0, "every element of the first sheet is coplanar with the second",
        Relation::coplanar, false);
}

/// All sheets in one plane: nothing is close, and nothing blocks.
void add_coplanar(std::vector<GeometryCase>& cases) {
    GeometryCase row;
    row.name = "all sheets coplanar";
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 3; ++j) {
            const double x = 3 * i, y = 4 * j;
            row.shapes.loops.push_back({{x, y, 0}, {x + 4, y, 0}, {x + 4, y + 4, 0}, {x, y + 4, 0}});
        }
    row.law = "nothing close, no segment blocked";
    row.broken = [](const Scene&, const Questions&, const Answers& answers) {
        for (const BoxAnswer& relation : answers.relations)
            if (is_close(relation.relation)) return std::string("a polygon is close");
        for (const Visibility visibility : answers.visibility)
            if (visibility == Visibility::blocked) return std::string("a segment is blocked");
        return std::string();
    };
    cases.push_back(std::move(row));
}

/// Patch and receiver with a common side, and a light that stands on the receiver.
void add_touching(std::vector<GeometryCase>& cases) {
    GeometryCase shared_edge;
    shared_edge.name = "patch and receiver share an edge";
    shared_edge.shapes.loops = {{{0, 0, 0}, {8, 0, 0}, {8, 8, 0}, {0, 8, 0}},
                                {{0, 0, 0}, {0, 0, 8}, {8, 0, 8}, {8, 0, 0}}};
    shared_edge.law = "they share an edge, and see each other everywhere";
    shared_edge.broken = [](const Scene& scene, const Questions&, const Answers& answers) {
        if (shared(scene, 0, 1) != Shared::edge) return std::string("no edge is shared");
        for (const Visibility visibility : answers.visibility)
            if (visibility == Visibility::blocked) return std::string("a segment is blocked");
        return std::string();
    };
    cases.push_back(shared_edge);

    GeometryCase light;
    light.name = "light touches the receiver";
    light.shapes.loops = {{{0, 0, 0}, {8, 0, 0}, {8, 8, 0}, {0, 8, 0}}, {{3, 5, 0}, {5, 3, 0}, {5, 3, 2}, {3, 5, 2}}};
    light.shapes.lights = {1};
    light.law = "the light is close to some of the receiver's elements, and at its edge faces them";
    light.broken = [](const Scene& scene, const Questions& questions, const Answers& answers) {
        std::size_t close = 0, facing = 0;
        for (std::size_t b = 0; b < questions.boxes.size(); ++b)
            if (questions.boxes[b].polygon == 0 && is_close(answers.relations[b].relation)) {
                ++close;
                if (faces(scene, 1, Box(questions.boxes[b]))) ++facing;
            }
        return close == 0 ? std::string("it is close to none") : facing == 0 ? std::string("it faces none") : "";
    };
    cases.push_back(light);
}

void add_boxes(std::vector<GeometryCase>& cases, bool quick) {
    const Rational tiny = Rational(1) / pow(Integer(10), 300);
    const auto add = [&](const std::string& name, const Rational& margin, const Rational& height) {
        GeometryCase row;
        row.name = name;
        row.shapes = stress::still_life();
        row.margin = margin;
        row.height = height;
        row.unchanged = Unchanged::visibility;
        cases.push_back(std::move(row));
    };
    add("margin 0", 0, Rational(1, 4));
    add("height 1e-300", Rational(1, 8), tiny);
    add("margin and height 1e3", 1000, 1000);
    if (quick) return;
    add("margin 1e-300", tiny, Rational(1, 4));
    add("margin 0, height 1e-300", 0, tiny);
    add("margin 1e3", 1000, Rational(1, 4));
    add("height 1e3", Rational(1, 8), 1000);
    add("height 1e3, margin 0", 0, 1000);
    add("margin and height 1/3", Rational(1, 3), Rational(1, 3));
}

std::vector<GeometryCase> all_cases(bool quick) {
    std::vector<GeometryCase> cases;
    cases.push_back({"untransformed", stress::still_life(), Unchanged::everything});
    add_scales(cases, quick);
    add_offsets(cases, quick);
    add_aspects(cases, quick);
    add_ulp_sheets(cases);
    add_boxes(cases, quick);
    add_touching(cases);
    add_coplanar(cases);
    return cases;
}

// ---------------------------------------------------------------------------------------------------- rows

std::string counted(std::uint64_t count, const char* what) {
    return std::to_string(count) + " " + what;
}

/// The product against fractions and the other arithmetics, on the same questions.
GeometryRow compared(const std::string& name, const Scene& scene, const Questions& questions, const Answers& exact) {
    GeometryRow row;
    row.row.group = "geometry";
    row.row.name = name;
    row.relations = exact.relations.size();
    row.segments = exact.visibility.size();
    row.filtered = exact.predicates.filtered;
    row.decided = exact.predicates.filtered + exact.predicates.integer + exact.predicates.rational;
    row.exact = difference(exact, answer(scene, questions, Arithmetic::rational, Source::all));
    row.binary32 = difference(exact, answer(scene, questions, Arithmetic::binary32, Source::all));
    row.binary64 = difference(exact, answer(scene, questions, Arithmetic::binary64, Source::all));
    row.epsilon = difference(exact, answer(scene, questions, Arithmetic::epsilon, Source::all));
    row.row.expected = "no difference to fractions";
    row.row.came_out = counted(row.exact.relations + row.exact.visibility, "differences");
    row.row.verdict = row.exact.relations + row.exact.visibility == 0 ? Verdict::pass : Verdict::failed;
    return row;
}

void add_to(StressRow& row, const std::string& expected, const std::string& came_out, bool holds) {
    row.expected += "; " + expected;
    row.came_out += "; " + came_out;
    if (!holds) row.verdict = Verdict::failed;
}

constexpr std::size_t most_boxes = 40, most_segments = 160;

GeometryRow row_of(const GeometryCase& c, const Answers& untransformed) {
    const Scene scene = scene_of(c.shapes);
    const Questions questions = stress::ask(scene, c.level, c.margin, c.height, most_boxes, most_segments);
    const Answers exact = answer(scene, questions, Arithmetic::exact, Source::tree);
    GeometryRow row = compared(c.name, scene, questions, exact);
    if (c.unchanged != Unchanged::nothing) {
        const ArithmeticErrors changed = difference(exact, untransformed);
        const std::uint64_t count = changed.visibility + (c.unchanged == Unchanged::everything ? changed.relations : 0);
        add_to(row.row,
               c.unchanged == Unchanged::everything ? "answers as untransformed" : "visibility as untransformed",
               counted(count, "changed"), count == 0);
    }
    if (c.broken) {
        const std::string wrong = c.broken(scene, questions, exact);
        add_to(row.row, c.law, wrong.empty() ? "so it is" : wrong, wrong.empty());
    }
    return row;
}

/// A chain of children 30 levels deep, each box against everything: exact, and nested as SPEC 4 says. The sheet's
/// corner stands where the smallest elements are.
GeometryRow deep_refinement() {
    const double third = std::ldexp(std::floor(std::ldexp(1.0, 30) / 3), -30), low = std::ldexp(1.0, -33);
    Shapes shapes;
    shapes.loops = {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
                    {{third, third, low}, {1, third, low}, {1, 1, low}, {third, 1, low}},
                    {{third, third, 0}, {third, third, 1}, {third, 1, 1}, {third, 1, 0}}};
    const Scene scene = scene_of(shapes);
    const Roots roots(scene);

    Questions questions;
    Element element = root_element(0);
    std::vector<ExactPoint> points;
    for (int level = 1; level <= 30; ++level) {
        for (const Element& child : children(roots[0], element)) {  // down to the child that begins at the corner
            const double size = std::ldexp(1.0, -level);
            if (child.i * size <= third && third < (child.i + 1) * size && child.j * size <= third &&
                third < (child.j + 1) * size) {
                element = child;
                break;
            }
        }
        questions.boxes.push_back(box_question(scene, roots[0], element, Rational(1, 8), Rational(1, 4)));
        points.push_back(corners(scene, roots[0], element).points[0]);
        points.push_back(point_in(scene, roots[0], element, 0.5, 0.5));
    }
    const ExactPoint above(Point{third, third, 0.5}), aside(Point{0.75, 0.25, 0.5});
    for (const ExactPoint& p : points)
        for (const ExactPoint& q : {above, aside}) questions.segments.push_back({p, q, -1, -1});

    const Answers exact = answer(scene, questions, Arithmetic::exact, Source::tree);
    GeometryRow row = compared("refinement 30 levels deep", scene, questions, exact);
    std::size_t unnested = 0;
    for (std::size_t i = 2; i < exact.relations.size(); ++i)  // two other polygons a box
        if (is_close(exact.relations[i].relation) && !is_close(exact.relations[i - 2].relation)) ++unnested;
    add_to(row.row, "what is close to a child is close to its parent", counted(unnested, "exceptions"), unnested == 0);
    return row;
}

}  // namespace

const char* to_text(Verdict verdict) {
    switch (verdict) {
        case Verdict::pass:
            return "pass";
        case Verdict::limit:
            return "limit";
        case Verdict::failed:
            return "FAILED";
        case Verdict::figure:
            return "figure";
    }
    return "";
}

std::vector<GeometryRow> stress_geometry(const StressOptions& options) {
    const Scene scene = scene_of(stress::still_life());
    const GeometryCase defaults;
    const Questions questions =
        stress::ask(scene, defaults.level, defaults.margin, defaults.height, most_boxes, most_segments);
    const Answers untransformed = answer(scene, questions, Arithmetic::exact, Source::tree);
    std::vector<GeometryRow> rows;
    for (const GeometryCase& c : all_cases(options.quick)) {
        if (options.progress) options.progress(rows.size(), 0);
        rows.push_back(row_of(c, untransformed));
    }
    rows.push_back(deep_refinement());
    return rows;
}

}  // namespace cob
