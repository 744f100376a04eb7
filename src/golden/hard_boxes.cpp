#include "golden/hard_boxes.hpp"

#include "geometry/candidate_list.hpp"
#include "geometry/convex_polygon.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace cob {

namespace {

constexpr int attempts = 32;

/// Exact geometry of an element's box before margin and height are chosen. Letters as in SPEC 4.
struct Frame {
    RationalPoint u, n, w;
    RationalPoint corner;                   ///< One corner of the element.
    Rational low_u, high_u, low_w, high_w;  ///< Extents of the corners along u and w, unnormalised.

    explicit Frame(const BoxQuestion& question) : u(question.u.rational()) {
        const ConvexPolygon corners = polygon_of(question.corners);
        n = area_vector(corners);
        w = cross(n, u);
        corner = corners[0];
        low_u = high_u = dot(corner, u), low_w = high_w = dot(corner, w);
        for (const RationalPoint& p : corners) {
            const Rational along_u = dot(p, u), along_w = dot(p, w);
            low_u = std::min(low_u, along_u), high_u = std::max(high_u, along_u);
            low_w = std::min(low_w, along_w), high_w = std::max(high_w, along_w);
        }
    }
};

struct Aim {
    PolygonId polygon = no_polygon;
    Point vertex;
};

/// A vertex of some polygon near the element, not its own.
std::optional<Aim> aim(const Questions& questions, const BoxQuestion& question, Dice& dice) {
    BoxQuestion wide = question;
    wide.margin = 1, wide.height = 1;
    std::vector<PolygonId> near = polygons_in(questions.candidates(), Box(wide).bounds());
    near.erase(std::remove(near.begin(), near.end(), question.polygon), near.end());
    if (near.empty()) return {};
    const PolygonId polygon = dice.of(near);
    const auto loop = questions.scene().loop(polygon);
    return Aim{polygon, questions.scene().position(loop[dice.below(loop.size())])};
}

BoxQuestion element_question(const Questions& questions, Dice& dice) {
    const Element element = questions.elements()[dice.below(questions.elements().size())];
    return box_question(questions.scene(), questions.roots()[element.root], element, questions.margin(),
                        questions.height());
}

BoxQuestion root_question(const Questions& questions, const Root& root) {
    return box_question(questions.scene(), root, root_element(root.id), questions.margin(), questions.height());
}

/// Number of the format next below or above the square root of an exact value, never the root itself.
std::optional<double> beside_root(const Rational& square, bool above, NumberFormat format) {
    double value = rounded(std::sqrt(to_nearest(square)), format);
    if (!(value > 0) || !std::isfinite(value)) return {};
    const auto beside = [&] {
        const Rational exact(value);
        return above ? exact * exact > square : exact * exact < square;
    };
    // At most some units in the last place away: of the square root, and of rounding its argument.
    for (int step = 0; step < 8 && !beside(); ++step) value = neighbour(value, above ? HUGE_VAL : 0, format);
    while (value > 0) {
        const double closer = neighbour(value, above ? 0 : HUGE_VAL, format);
        const Rational exact(closer);
        if (above ? exact * exact <= square : exact * exact >= square) break;
        value = closer;
    }
    return value > 0 && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

/// Square root of a fraction where that is a fraction.
std::optional<Rational> exact_root(const Rational& square) {
    const Integer p = numerator(square), q = denominator(square);
    const Integer root_p = sqrt(p), root_q = sqrt(q);
    if (root_p * root_p != p || root_q * root_q != q) return {};
    return Rational(root_p) / Rational(root_q);
}

/// How the polygon's relation answers, for keeping only questions at which something happens.
Relation relation_to(const Questions& questions, const Aim& target, const BoxQuestion& question) {
    return relate(questions.scene(), target.polygon, Box(question)).relation;
}

// ------------------------------------------------------------------------------------------------ the kinds

std::optional<BoxQuestion> seam(const Questions& questions, Dice& dice) {
    BoxQuestion question = root_question(questions, dice.of(questions.roots().all()));
    question.margin = 0;
    return question;
}

std::optional<BoxQuestion> plane(const Questions& questions, Dice& dice) {
    BoxQuestion question = root_question(questions, dice.of(questions.roots().all()));
    question.polygon = no_polygon;
    if (dice.coin())
        std::reverse(question.corners.points.begin(), question.corners.points.begin() + question.corners.count);
    return question;
}

/// Margin at which a side of the box passes through the vertex; none where it lies between the sides.
std::optional<Rational> margin_through(const Frame& frame, const Point& vertex, bool along_w) {
    const Rational& low = along_w ? frame.low_w : frame.low_u;
    const Rational& high = along_w ? frame.high_w : frame.high_u;
    const Rational at = dot(to_rational(vertex), along_w ? frame.w : frame.u);
    const Rational margin = (at > high ? at - high : low - at) / (high - low);
    return margin > 0 ? std::optional(margin) : std::nullopt;
}

std::optional<BoxQuestion> side(const Questions& questions, Dice& dice, bool exact) {
    BoxQuestion question = element_question(questions, dice);
    const std::optional<Aim> target = aim(questions, question, dice);
    if (!target) return {};
    const std::optional<Rational> margin = margin_through(Frame(question), target->vertex, dice.coin());
    if (!margin) return {};

    // The vertex must decide: just below the margin the answer differs from just above it.
    const Rational nudge = *margin / Rational(Integer(1) << 60);
    question.margin = *margin - nudge;
    const Relation inside = relation_to(questions, *target, question);
    question.margin = *margin + nudge;
    if (relation_to(questions, *target, question) == inside) return {};

    question.margin = *margin;
    if (exact) return question;
    const auto beside = beside_root(*margin * *margin, dice.coin(), questions.format());
    if (!beside) return {};
    question.margin = *beside;
    return question;
}

/// Square of the height (as a fraction of the shorter widened extent) at which the top passes through the vertex.
std::optional<Rational> height_through(const Frame& frame, const Rational& margin, const Point& vertex) {
    const Rational level = dot(to_rational(vertex) - frame.corner, frame.n);  // |n| times the distance
    if (level <= 0) return {};
    const Rational uu = dot(frame.u, frame.u), nn = dot(frame.n, frame.n);
    const Rational along_u = (frame.high_u - frame.low_u) * (1 + 2 * margin);  // |u| times the extent
    const Rational along_w = (frame.high_w - frame.low_w) * (1 + 2 * margin);  // |u||n| times the extent
    const Rational shorter = std::min(Rational(along_u * along_u * nn), Rational(along_w * along_w)) / (uu * nn);
    return level * level / nn / shorter;
}

std::optional<BoxQuestion> top(const Questions& questions, Dice& dice, bool exact) {
    BoxQuestion question = element_question(questions, dice);
    const std::optional<Aim> target = aim(questions, question, dice);
    if (!target) return {};
    const std::optional<Rational> square = height_through(Frame(question), question.margin, target->vertex);
    if (!square) return {};
    const auto below = beside_root(*square, false, NumberFormat::any),
               above = beside_root(*square, true, NumberFormat::any);
    if (!below || !above) return {};

    question.height = *below;
    const Relation inside = relation_to(questions, *target, question);
    question.height = *above;
    if (relation_to(questions, *target, question) == inside) return {};

    if (exact) {
        const auto root = exact_root(*square);
        if (!root) return {};
        question.height = *root;
    } else {
        const auto beside = beside_root(*square, dice.coin(), questions.format());
        if (!beside) return {};
        question.height = *beside;
    }
    return question;
}

/// The root about one of its corners, 2^power times as large; the box keeps its height.
std::optional<BoxQuestion> scaled(const Questions& questions, Dice& dice, int power) {
    const Root& root = dice.of(questions.roots().all());
    BoxQuestion question = root_question(questions, root);
    const auto count = static_cast<std::size_t>(question.corners.count);
    const RationalPoint centre = question.corners.points[dice.below(count)].rational();
    const bool own = dice.coin();
    for (; power != 0; power /= 2) {
        const Rational factor(std::ldexp(1.0, power));
        BoxQuestion candidate = question;
        for (std::size_t k = 0; k < count; ++k)
            candidate.corners.points[k] =
                ExactPoint(centre + factor * (question.corners.points[k].rational() - centre));
        candidate.margin = dice.coin() ? Rational(0) : question.margin;
        // Over a large element a low box: its top stays among the polygons.
        candidate.height = power > 0 ? Rational(question.height / factor) : question.height;
        if (!own) candidate.polygon = no_polygon;
        if (fits(candidate, questions.format())) return candidate;
    }
    return {};
}

struct Kind {
    const char* name;
    std::optional<BoxQuestion> (*make)(const Questions&, Dice&);
};

constexpr std::array<Kind, 8> kinds{{
    {"seam", seam},
    {"plane", plane},
    {"side", [](const Questions& q, Dice& d) { return side(q, d, true); }},
    {"side-ulp", [](const Questions& q, Dice& d) { return side(q, d, false); }},
    {"top", [](const Questions& q, Dice& d) { return top(q, d, true); }},
    {"top-ulp", [](const Questions& q, Dice& d) { return top(q, d, false); }},
    {"far", [](const Questions& q, Dice& d) { return scaled(q, d, 1 + static_cast<int>(d.below(40))); }},
    {"small", [](const Questions& q, Dice& d) { return scaled(q, d, -1 - static_cast<int>(d.below(40))); }},
}};

}  // namespace

std::vector<std::string> hard_box_kinds() {
    std::vector<std::string> names;
    for (const Kind& kind : kinds) names.emplace_back(kind.name);
    return names;
}

BoxTask hard_box(const Questions& questions, std::size_t wanted, Dice dice) {
    const Kind& kind = kinds[wanted];
    for (int attempt = 0; attempt < attempts; ++attempt)
        if (auto question = kind.make(questions, dice); question && fits(*question, questions.format()))
            return {std::move(*question), kind.name};
    return {*plane(questions, dice), "plane"};
}

}  // namespace cob
