#include "report/segment_report.hpp"

#include <string>
#include <vector>

namespace cob {
namespace {

std::string rounded(const RationalPoint& point) {
    return "(" + to_text(to_nearest(point.x)) + ", " + to_text(to_nearest(point.y)) + ", " +
           to_text(to_nearest(point.z)) + ")";
}

/// As it is, and rounded where that differs.
std::string exact(const RationalPoint& point) {
    const std::string text = "(" + to_text(point.x) + ", " + to_text(point.y) + ", " + to_text(point.z) + ")";
    return text == rounded(point) ? text : text + ", rounded " + rounded(point);
}

std::string exact(const Rational& parameter) {
    const std::string text = to_text(parameter), near = to_text(to_nearest(parameter));
    return text == near ? text : text + ", rounded " + near;
}

const char* words(Covering covering) {
    switch (covering) {
        case Covering::none:
            return "covered by nothing";
        case Covering::sector:
            return "covered by another piece's sector";
        case Covering::seam:
            return "on a seam where two pieces meet";
    }
    return "";
}

class Writer {
public:
    explicit Writer(const SegmentReport& report)
        : report_(report), x_(report.segment.from.rational()), y_(report.segment.to.rational()) {}

    std::string text() {
        text_ = "from " + exact(x_) + "\nto   " + exact(y_) + "\n" +
                "visibility: " + to_text(report_.explanation.visibility) + "\n";
        const std::vector<ExplainedContact>& contacts = report_.explanation.details;
        if (contacts.empty()) text_ += "The open segment meets no piece.\n";
        for (std::size_t first = 0; first < contacts.size();) {
            std::size_t last = first;
            while (last < contacts.size() && contacts[last].contact.parameter == contacts[first].contact.parameter)
                ++last;
            point(first, last);
            first = last;
        }
        why();
        return text_;
    }

private:
    std::string place(const Rational& parameter) const { return exact(RationalPoint(x_ + parameter * (y_ - x_))); }

    std::string piece(PieceId id) const {
        const Piece& p = report_.scene.piece(id);
        const Polygon& polygon = report_.scene.polygon(p.polygon);
        std::string text = "polygon " + std::to_string(p.polygon);
        if (polygon.line > 0) text += " (line " + std::to_string(polygon.line) + ")";
        if (polygon.piece_count > 1)
            text += ", piece " + std::to_string(id - static_cast<PieceId>(polygon.first_piece)) + " of " +
                    std::to_string(polygon.piece_count);
        return text;
    }

    std::string vertex(VertexId id) const { return rounded(to_rational(report_.scene.position(id))); }
    std::string corner(PieceId id, int k) const {
        const View<VertexId> corners = report_.scene.corners(report_.scene.piece(id));
        return vertex(corners[k % static_cast<int>(corners.size())]);
    }
    std::string ray(const std::array<VertexId, 2>& direction) const {
        return vertex(direction[0]) + " -> " + vertex(direction[1]);
    }

    /// All contacts at one point of the segment.
    void point(std::size_t first, std::size_t last) {
        const std::vector<ExplainedContact>& contacts = report_.explanation.details;
        const Rational& parameter = contacts[first].contact.parameter;
        text_ += "at " + place(parameter) + " (parameter " + exact(parameter) + "):\n";
        bool seam = false, closes = false, inside = false, in_plane = false;
        for (std::size_t k = first; k < last; ++k) {
            const ExplainedContact& contact = contacts[k];
            one(contact);
            const bool sector =
                contact.contact.kind == ContactKind::side || contact.contact.kind == ContactKind::corner;
            seam = seam || sector;
            closes = closes || (sector && contact.blocks);
            inside = inside || contact.contact.kind == ContactKind::inside;
            in_plane = in_plane || contact.contact.kind == ContactKind::in_plane;
        }
        if (inside) text_ += "  => blocked here: a piece is crossed inside.\n";
        if (closes) text_ += "  => blocked here: the sectors and the seams between them cover the full turn.\n";
        if (seam && !closes && !inside)
            text_ += "  => grazing here: the sectors leave a direction open, so light passes beside them.\n";
        if (in_plane && !seam && !inside) text_ += "  => grazing here: running within a plane crosses nothing.\n";
    }

    void one(const ExplainedContact& detail) {
        const Contact& contact = detail.contact;
        text_ += "  " + piece(contact.piece) + ": ";
        const std::string side = detail.from_visible_side ? "from its visible side" : "from behind";
        switch (contact.kind) {
            case ContactKind::inside:
                text_ += "crossed inside, " + side + "\n";
                return;
            case ContactKind::in_plane:
                text_ += "met within its plane, up to " + place(detail.last) + " (parameter " + exact(detail.last) +
                         "); takes no part in closing\n";
                return;
            case ContactKind::side:
                text_ += "touched on side " + std::to_string(contact.index) + ", " +
                         corner(contact.piece, contact.index) + " to " + corner(contact.piece, contact.index + 1) +
                         ", " + side + "\n";
                break;
            case ContactKind::corner:
                text_ += "touched at corner " + std::to_string(contact.index) + ", " +
                         corner(contact.piece, contact.index) + ", " + side + "\n";
                break;
        }
        text_ += "    its sector, seen along the segment, runs counter-clockwise\n";
        text_ += "      from the direction " + ray(detail.begin) + ", " + words(detail.begin_covering) + ",\n";
        text_ += "      to the direction   " + ray(detail.end) + ", " + words(detail.end_covering) + "\n";
    }

    void why() {
        switch (report_.explanation.visibility) {
            case Visibility::clear:
                text_ += "Clear: contact at an end alone does not count, and there is no other.\n";
                return;
            case Visibility::grazing:
                text_ += "Grazing: pieces are touched, but none is crossed inside and none close around a point.\n";
                return;
            case Visibility::blocked:
                if (report_.nearest_blocker == no_polygon)
                    text_ += "Blocked: by several polygons together, none of which blocks by itself.\n";
                else
                    text_ += "Blocked: the first polygon that blocks by itself is " +
                             std::to_string(report_.nearest_blocker) + ".\n";
                return;
        }
    }

    const SegmentReport& report_;
    RationalPoint x_, y_;
    std::string text_;
};

}  // namespace

std::string segment_text(const SegmentReport& report) {
    return Writer(report).text();
}

}  // namespace cob
