#include "report/disagreement_report.hpp"
#include "report/text.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace cob::report {
namespace {

/// Embree is not asked about this share of the segment at either end.
constexpr double embree_offset = 1e-4;
constexpr std::size_t most_polygons = 8;

struct Place {
    double x = 0, y = 0;
};
using Line = std::array<Place, 2>;

double length(const Point& v) {
    return std::hypot(v.x, v.y, v.z);
}

/// The plane of the picture: its origin is the contact, x runs along the segment, y across it and across the nearest
/// side of the piece; the unit is the segment's length.
class Section {
public:
    Section(const Scene& scene, const EmbreeDisagreement& about) : scene_(scene) {
        const Point from = about.segment.from.nearest(), d = about.segment.to.nearest() - from;
        length_ = length(d);
        origin_ = from + about.parameter * d;
        along_ = (1 / length_) * d;
        across_ = about.across;
        if (!(length(across_) > 0)) across_ = cross(along_, std::abs(along_.x) < 0.5 ? Point{1, 0, 0} : Point{0, 1, 0});
        across_ = (1 / length(across_)) * across_;
        normal_ = cross(along_, across_);
    }

    double length_of_segment() const { return length_; }
    /// The piece cut by the plane; nothing where it does not cross it.
    std::optional<Line> cut(PieceId id) const {
        const View<VertexId> c = scene_.corners(scene_.piece(id));
        std::vector<Place> ends;
        for (std::size_t k = 0; k < c.size(); ++k) {
            const Point a = scene_.position(c[static_cast<std::ptrdiff_t>(k)]) - origin_;
            const Point b = scene_.position(c[static_cast<std::ptrdiff_t>((k + 1) % c.size())]) - origin_;
            const double above_a = dot(normal_, a), above_b = dot(normal_, b);
            if ((above_a > 0) == (above_b > 0)) continue;
            const Point p = a + (above_a / (above_a - above_b)) * (b - a);
            ends.push_back({dot(along_, p) / length_, dot(across_, p) / length_});
        }
        if (ends.size() < 2) return std::nullopt;
        return Line{ends[0], ends[1]};
    }

private:
    const Scene& scene_;
    Point origin_, along_, across_, normal_;
    double length_ = 1;
};

/// The part of a line in the window of this half width around the contact.
std::optional<Line> clipped(const Line& line, double half) {
    double first = 0, last = 1;
    const auto halve = [&](double from, double to) {  // keeps what is at most `half` on either side
        const double d = to - from;
        for (const double side : {-1.0, 1.0}) {
            const double inside_from = half - side * from, change = -side * d;
            if (change == 0 && inside_from < 0) last = -1;
            if (change > 0) first = std::max(first, -inside_from / change);
            if (change < 0) last = std::min(last, -inside_from / change);
        }
    };
    halve(line[0].x, line[1].x);
    halve(line[0].y, line[1].y);
    if (!(first <= last)) return std::nullopt;
    const auto at = [&](double t) {
        return Place{line[0].x + t * (line[1].x - line[0].x), line[0].y + t * (line[1].y - line[0].y)};
    };
    return Line{at(first), at(last)};
}

double distance_from_contact(const Line& line) {
    const double x = line[1].x - line[0].x, y = line[1].y - line[0].y, square = x * x + y * y;
    const double t = square > 0 ? std::clamp(-(line[0].x * x + line[0].y * y) / square, 0.0, 1.0) : 0;
    return std::hypot(line[0].x + t * x, line[0].y + t * y);
}

Curve curve(const std::string& title, const Line& line, Curve::Style style = Curve::Style::lines) {
    return {title, {{line[0].x, line[0].y}, {line[1].x, line[1].y}}, style};
}

std::string in_words(const Scene& scene, const EmbreeDisagreement& about) {
    const std::string polygon =
        about.piece < 0 ? "every polygon" : "polygon " + std::to_string(scene.piece(about.piece).polygon);
    return about.blocked ? "blocked by " + polygon + ", and Embree hits nothing"
                         : "clear of " + polygon + ", and Embree hits it";
}

}  // namespace

std::string disagreement_table(const Scene& scene, const std::vector<EmbreeDisagreement>& disagreements) {
    if (disagreements.empty()) return "";
    std::map<std::string, std::array<int, 3>> counts;
    for (const EmbreeDisagreement& d : disagreements) ++counts[d.kind][d.blocked ? (d.at_end ? 0u : 1u) : 2u];
    std::string text = "Embree's triangles against the exact answers\n";
    text +=
        printed("%-11s %22s %20s %15s\n", "kind", "blocked, missed at end", "blocked, missed else", "clear, yet hit");
    for (const auto& [kind, count] : counts)
        text += printed("%-11s %22d %20d %15d\n", kind.c_str(), count[0], count[1], count[2]);
    for (const EmbreeDisagreement& worst : worst_of_each_kind(disagreements)) {
        text += "the worst of kind " + worst.kind + ": from";
        for (const ExactPoint* end : {&worst.segment.from, &worst.segment.to}) {
            if (end == &worst.segment.to) text += " to";
            for (int axis = 0; axis < 3; ++axis) text += " " + to_text(end->nearest()[axis]);
        }
        text += ": " + in_words(scene, worst) + printed(", %.2g from its nearest side or end\n", worst.clearance);
    }
    return text;
}

std::vector<EmbreeDisagreement> worst_of_each_kind(const std::vector<EmbreeDisagreement>& disagreements) {
    std::map<std::string, const EmbreeDisagreement*> first;
    for (const EmbreeDisagreement& d : disagreements) first.emplace(d.kind, &d);
    std::vector<EmbreeDisagreement> worst;
    for (const auto& [kind, disagreement] : first) worst.push_back(*disagreement);
    return worst;
}

Plot disagreement_plot(const Scene& scene, const EmbreeDisagreement& about) {
    const Section section(scene, about);
    // 1. A window that holds the contact, and the end or the side that matters.
    const double to_end = std::min(about.parameter, 1 - about.parameter);
    const double half = about.at_end ? 2 * std::max(to_end, embree_offset)
                                     : std::clamp(4 * about.clearance / section.length_of_segment(), 1e-6, 1.0);
    // 2. What stands there, the nearest first.
    std::vector<std::pair<PieceId, Line>> lines;
    for (PieceId id = 0; id < static_cast<PieceId>(scene.pieces().size()); ++id)
        if (const auto whole = section.cut(id))
            if (const auto part = clipped(*whole, half)) lines.emplace_back(id, *part);
    std::stable_sort(lines.begin(), lines.end(), [](const auto& a, const auto& b) {
        return distance_from_contact(a.second) < distance_from_contact(b.second);
    });
    if (lines.size() > most_polygons) lines.resize(most_polygons);

    Plot plot;
    plot.title = about.kind + ": " + in_words(scene, about);
    plot.x_label = "along the segment, in its lengths";
    plot.y_label = "across it, in the same unit";
    const double begin = -about.parameter, end = 1 - about.parameter;
    const auto part = [&](double from, double to) { return clipped({Place{from, 0}, Place{to, 0}}, half); };
    if (const auto whole = part(begin, end)) plot.curves.push_back(curve("the segment", *whole));
    if (const auto asked = part(begin + embree_offset, end - embree_offset))
        plot.curves.push_back(curve("what Embree is asked", *asked, Curve::Style::lines_and_points));
    for (const auto& [id, line] : lines)
        plot.curves.push_back(curve("polygon " + std::to_string(scene.piece(id).polygon), line));
    return plot;
}

}  // namespace cob::report
