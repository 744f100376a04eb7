#include "golden/twin_check.hpp"

#include "cob/tables.hpp"
#include "cob/verify.hpp"
#include "naive/box.hpp"
#include "naive/visibility.hpp"

#include <filesystem>

namespace cob::test {

namespace {

constexpr std::size_t listed = 5;

/// The polygons of the set, read by the reader that consumers use, and which of them are lights.
std::vector<naive::SceneItem> read_items(const std::string& set) {
    std::vector<naive::SceneItem> items;
    for (const verify::Polygon& polygon : verify::load_set(set).polygons) {
        std::vector<Point> corners;
        for (const verify::Vector& p : polygon.loop) corners.push_back({p[0], p[1], p[2]});
        items.push_back({naive::prepare(corners), false});
    }
    const Scene scene = read_obj(set + "/scene.obj", {true, false});
    for (PolygonId id = 0; id < scene.polygon_count(); ++id)
        items[static_cast<std::size_t>(id)].emits = scene.is_light(id);
    return items;
}

void differ(TwinCheck& check, const std::string& what, const std::string& set, const std::string& twin) {
    if (check.differences.size() < listed) check.differences.push_back(what + ": set " + set + ", twin " + twin);
}

std::string words(const char* state, const std::vector<int>& close, const std::vector<int>& cover,
                  const std::vector<int>& light) {
    std::string text = state;
    for (const auto* list : {&close, &cover, &light}) {
        text += " |";
        for (const int id : *list) text += " " + std::to_string(id);
    }
    return text;
}

void check_boxes(const std::string& set, const std::vector<naive::SceneItem>& items, TwinCheck& check) {
    TableReader<BoxRow> boxes(set + "/boxes.csv");
    TableReader<StateRow> states(set + "/states.csv");
    TableReader<RelationRow> relations(set + "/relations.csv");
    RelationRow next;
    bool more = relations.next(next);
    BoxRow row;
    StateRow state;
    while (boxes.next(row)) {
        naive::BoxQuestion question{
            row.question.polygon, {}, row.question.u.rational(), row.question.margin, row.question.height};
        for (int k = 0; k < row.question.corners.count; ++k)
            question.corners.push_back(row.question.corners.points[static_cast<std::size_t>(k)].rational());
        const naive::Box box = naive::prepare(question);
        const std::string name = "box " + std::to_string(row.box);
        if (!box.refused.empty()) differ(check, name, "asked", box.refused);

        const std::vector<naive::Answer> answers = naive::relate_all(items, question.polygon, box);
        const naive::State expected = naive::state(answers);
        if (!states.next(state) || state.box != row.box) return differ(check, name, "no state", expected.name);
        const std::vector<int> none;
        const std::string twin = words(expected.name, expected.close, expected.cover, expected.light);
        const std::string ours = words(to_text(state.state), state.close, state.cover, state.light);
        if (ours != twin) differ(check, name, ours, twin);
        ++check.boxes;

        for (int polygon = 0; polygon < static_cast<int>(items.size()); ++polygon) {
            const naive::Answer& answer = answers[static_cast<std::size_t>(polygon)];
            const bool has = more && next.box == row.box && next.polygon == polygon;
            std::string found = "disjoint", wanted = naive::to_text(answer.relation);
            if (has) {
                found = std::string(to_text(next.relation)) + (next.covers ? " covers " : " ") + to_text(next.shared);
                more = relations.next(next);
            }
            if (answer.relation != naive::Relation::disjoint) {
                const naive::Shared shared =
                    question.polygon < 0 ? naive::Shared::none
                                         : naive::shared(items[static_cast<std::size_t>(question.polygon)].polygon,
                                                         items[static_cast<std::size_t>(polygon)].polygon);
                wanted += std::string(answer.covers ? " covers " : " ") + naive::to_text(shared);
            }
            if (found != wanted) differ(check, name + " polygon " + std::to_string(polygon), found, wanted);
            ++check.pairs;
        }
    }
    if (states.next(state)) differ(check, "states.csv", "rows are left", "none");
    if (more) differ(check, "relations.csv", "rows are left", "none");
}

void check_segments(const std::string& set, const std::vector<naive::SceneItem>& items, TwinCheck& check) {
    std::vector<const naive::Polygon*> polygons;
    for (const naive::SceneItem& item : items)
        if (item.polygon.refused.empty()) polygons.push_back(&item.polygon);
    TableReader<SegmentRow> segments(set + "/segments.csv");
    TableReader<VisibilityRow> answers(set + "/visibility.csv");
    SegmentRow row;
    VisibilityRow answer;
    while (segments.next(row)) {
        const std::string name = "segment " + std::to_string(row.segment);
        const RationalPoint from = row.from.rational(), to = row.to.rational();
        const std::string wanted = naive::to_text(naive::visibility(polygons, from, to));
        if (!answers.next(answer) || answer.segment != row.segment) return differ(check, name, "no answer", wanted);
        if (to_text(answer.visibility) != wanted) differ(check, name, to_text(answer.visibility), wanted);

        // SPEC 7: from and to are "the polygons that the ends lie on".
        for (const auto& [point, id] : {std::pair{&from, row.from_polygon}, std::pair{&to, row.to_polygon}}) {
            if (id < 0) continue;
            bool on = false;
            for (const naive::Piece& piece : items[static_cast<std::size_t>(id)].polygon.pieces)
                on = on || naive::lies_on(*point, piece);
            if (!on) differ(check, name, "an end on polygon " + std::to_string(id), "beside it");
        }
        ++check.segments;
    }
    if (answers.next(answer)) differ(check, "visibility.csv", "rows are left", "none");
}

}  // namespace

TwinCheck check_with_twin(const std::string& set) {
    TwinCheck check;
    const std::vector<naive::SceneItem> items = read_items(set);
    if (std::filesystem::exists(set + "/boxes.csv")) check_boxes(set, items, check);
    if (std::filesystem::exists(set + "/segments.csv")) check_segments(set, items, check);
    return check;
}

}  // namespace cob::test
