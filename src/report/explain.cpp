#include "report/explain.hpp"

#include "arithmetic/text.hpp"
#include "geometry/candidate_list.hpp"
#include "report/box_coordinates.hpp"
#include "report/text.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace cob {
namespace {

std::string rounded(const Rational& value) {
    return rounded_text(value, 6);
}

/// "1/3 (about 0.333333)", and alone what is short anyway.
std::string number(const Rational& value) {
    const std::string exact = to_text(value), about = rounded(value);
    return exact == about ? exact : exact + " (about " + about + ")";
}

std::string root_of(const Rational& squared) {
    return "sqrt(" + to_text(squared) + ") (about " + rounded_root_text(squared, 6) + ")";
}

std::string vector_text(const RationalPoint& v) {
    return "(" + to_text(v.x) + ", " + to_text(v.y) + ", " + to_text(v.z) + ")";
}

/// " about (0.333333, 0, 1)", and nothing where that says no more.
std::string rounded_vector(const RationalPoint& v) {
    const std::string text = "(" + rounded(v.x) + ", " + rounded(v.y) + ", " + rounded(v.z) + ")";
    return text == vector_text(v) ? "" : " about " + text;
}

/// " < ", " = " or " > ": a comparison that decides something.
const char* against(const Rational& value, const Rational& limit) {
    return value < limit ? " < " : value == limit ? " = " : " > ";
}

std::string list(const std::vector<PolygonId>& polygons) {
    std::string text = polygons.size() == 1 ? "polygon" : "polygons";
    for (std::size_t k = 0; k < polygons.size(); ++k)
        text += (k == 0 ? " " : k + 1 == polygons.size() ? " and " : ", ") + std::to_string(polygons[k]);
    return text;
}

/// Writes the explanation, part by part.
class ElementExplanation {
public:
    ElementExplanation(const Scene& scene, const Roots& roots, const ExplainedElement& what)
        : scene_(scene),
          roots_(roots),
          what_(what),
          root_(roots[what.element.root]),
          question_(box_question(scene, root_, what.element, what.margin, what.height)),
          coordinates_(question_),
          box_(question_) {}

    std::string write(const CandidateSource& source) {
        element();
        box();
        BoxClassifier classifier(scene_);
        Classification found;
        classifier.from_scene(box_, source, found);
        polygons(source, found);
        state(found);
        return text_;
    }

private:
    void line(const std::string& text) { text_ += text + "\n"; }

    void element() {
        const Polygon& polygon = scene_.polygon(root_.polygon);
        line("Element " + to_address(roots_, what_.element) +
             (what_.number ? ", box " + std::to_string(*what_.number) : ""));
        const std::string& material = scene_.material(root_.polygon).name;
        line("  on polygon " + std::to_string(root_.polygon) + " (line " + std::to_string(polygon.line) +
             (material.empty() ? "" : ", material " + material) + "), piece " +
             std::to_string(root_.piece - static_cast<PieceId>(polygon.first_piece)) + " of " +
             std::to_string(polygon.piece_count) + (polygon.planar ? "" : ", which is not planar") +
             (polygon.convex ? "" : "; the polygon is not convex"));
        for (int k = 0; k < question_.corners.count; ++k) {
            const RationalPoint corner = question_.corners.points[static_cast<std::size_t>(k)].rational();
            line("  corner " + std::to_string(k) + "  " + vector_text(corner) + rounded_vector(corner));
        }
    }

    void box() {
        line("");
        line("Box (SPEC 4), margin " + number(what_.margin) + ", height " + number(what_.height));
        line("  u = " + vector_text(coordinates_.u()) + ", the direction of the longest side of the piece");
        line("  n = " + vector_text(coordinates_.n()) + ", the normal");
        line("  w = n x u = " + vector_text(coordinates_.w()));
        line("  widened extent along u: " + root_of(coordinates_.extent_squared_u()));
        line("  widened extent along w: " + root_of(coordinates_.extent_squared_w()));
        line("  h = height x the shorter of the two: " + root_of(coordinates_.height_squared()));
        line("  base corners, a (along u) and b (along w) from 0 to 1:");
        for (const auto& [a, b] : {std::pair(0, 0), std::pair(1, 0), std::pair(1, 1), std::pair(0, 1)}) {
            const RationalPoint corner = coordinates_.base_corner(a, b);
            line("    a = " + std::to_string(a) + ", b = " + std::to_string(b) + ": " + vector_text(corner) +
                 rounded_vector(corner));
        }
        line("  The box is closed at its sides and top and open at its base: 0 < z <= h.");
    }

    void polygons(const CandidateSource& source, const Classification& found) {
        const std::vector<PolygonId> near = polygons_in(source, box_.bounds());
        line("");
        line("Polygons whose bounds meet those of the box; heights as (z/h)^2 with the sign of z, so 1 is the top:");
        std::size_t next = 0;
        bool any = false;
        for (const PolygonId id : near) {
            if (id == root_.polygon) continue;
            while (next < found.neighbours.size() && found.neighbours[next].polygon < id) ++next;
            const bool met = next < found.neighbours.size() && found.neighbours[next].polygon == id;
            polygon(id, met ? found.neighbours[next].answer : BoxAnswer{});
            any = true;
        }
        if (!any) line("  none");
    }

    void polygon(PolygonId id, const BoxAnswer& answer) {
        std::vector<PieceOverBase> pieces;
        for (std::uint32_t k = 0; k < scene_.polygon(id).piece_count; ++k)
            pieces.push_back(
                clip_to_base(scene_, static_cast<PieceId>(scene_.polygon(id).first_piece + k), coordinates_));
        if (relation_in_words(scene_, id, coordinates_, pieces) != answer.relation)
            throw std::logic_error("the explanation of polygon " + std::to_string(id) + " disagrees with relate()");

        line("  polygon " + std::to_string(id) + ": " + to_text(answer.relation) + ", " +
             (answer.covers ? "covers" : "does not cover") + ", shared " + to_text(shared(scene_, root_.polygon, id)) +
             (scene_.is_light(id) ? ", a light that " : "") +
             (!scene_.is_light(id)      ? ""
              : faces(scene_, id, box_) ? "faces the element"
                                        : "does not face the element"));
        Rational area = 0;
        for (const PieceOverBase& piece : pieces) {
            this->piece(piece, pieces.size() > 1);
            area += piece.area;
        }
        verdict(answer, area);
    }

    void piece(const PieceOverBase& piece, bool named) {
        const std::string name =
            named
                ? "piece " +
                      std::to_string(piece.piece - static_cast<PieceId>(
                                                       scene_.polygon(scene_.piece(piece.piece).polygon).first_piece)) +
                      ": "
                : "";
        if (piece.corners.empty()) {
            line("    " + name + "nothing of it is over or under the base: " + miss(piece.piece));
            return;
        }
        const Rational low = coordinates_.signed_square_height(piece.lowest),
                       high = coordinates_.signed_square_height(piece.highest);
        line("    " + name +
             (piece.over_interior ? "over the inside of the base, " + number(piece.area) + " of it"
                                  : "over the rim of the base only") +
             ", from (z/h)^2 = " + number(low) + " to " + number(high));
        line("      lowest" + std::string(against(low, 1)) + "1, highest" + against(high, 0) + "0");
    }

    /// Which side of the base a piece is beyond, by the exact range of its corners.
    std::string miss(PieceId id) const {
        std::optional<BoxPoint> least, most;
        for (const VertexId vertex : scene_.corners(scene_.piece(id))) {
            const BoxPoint p = coordinates_(to_rational(scene_.position(vertex)));
            if (!least) least = most = p;
            least = {std::min(least->a, p.a), std::min(least->b, p.b), std::min(least->z, p.z)};
            most = {std::max(most->a, p.a), std::max(most->b, p.b), std::max(most->z, p.z)};
        }
        if (least->a > 1) return "its least a = " + number(least->a) + " > 1";
        if (most->a < 0) return "its greatest a = " + number(most->a) + " < 0";
        if (least->b > 1) return "its least b = " + number(least->b) + " > 1";
        if (most->b < 0) return "its greatest b = " + number(most->b) + " < 0";
        return "it passes a corner of it";
    }

    void verdict(const BoxAnswer& answer, const Rational& area) {
        switch (answer.relation) {
            case Relation::crossing:
                line("    so it meets the open inside of the box: close");
                break;
            case Relation::boundary:
                line("    so it touches the box at a side or the top only: close");
                break;
            case Relation::coplanar:
                line("    so it lies in the element's plane and casts no shadow: not close");
                break;
            case Relation::base:
                line("    so it touches the base only, which is open: not close");
                break;
            case Relation::disjoint:
                line("    so it does not meet the box: not close");
                break;
        }
        if (!is_close(answer.relation)) return;
        if (answer.covers)
            line("    it covers: seen along n it hides the whole base (share " + number(area) +
                 " with all pieces), at 0 < z <= h everywhere");
        else if (area < 1)
            line("    it cannot cover: seen along n it hides at most " + number(area) + " of the base");
        else
            line("    it does not cover: not all of it over the base is at 0 < z <= h, or its pieces overlap");
    }

    void state(const Classification& found) {
        line("");
        line(std::string("State: ") + to_text(found.state));
        const bool one = found.close.size() == 1;
        switch (found.state) {
            case BufferState::occluded:
                line("  " + list(found.cover) + (found.cover.size() == 1 ? " covers" : " cover") +
                     " the whole box, and no light that is close faces the element.");
                line("  Paper: an object that covers the whole box (i.e. intersects all the box's edges) shuts the");
                line("  element out: totally occluded. Step 1: no shot at it.");
                break;
            case BufferState::close:
                line("  " + list(found.close) + (one ? " is" : " are") + " close.");
                if (!found.cover.empty())
                    line("  " + list(found.cover) + " would occlude it, but the close light " + list(found.light) +
                         " faces it: a light below the sheet (paper, figure 6).");
                line("  Paper: close objects cast sharp shadows. Step 3: the buffer is not empty, so the element is");
                line("  refined and its children receive the shot.");
                break;
            default:
                line("  No polygon is close.");
                line("  Paper: what is not close casts no sharp shadow. Step 3: an empty buffer: shoot.");
        }
    }

    const Scene& scene_;
    const Roots& roots_;
    const ExplainedElement& what_;
    const Root& root_;
    BoxQuestion question_;
    BoxCoordinates coordinates_;
    Box box_;
    std::string text_;
};

}  // namespace

std::string explain(const Scene& scene, const Roots& roots, const CandidateSource& source,
                    const ExplainedElement& element) {
    return ElementExplanation(scene, roots, element).write(source);
}

}  // namespace cob
