/// \file
/// cob_naive_answer SET -o DIR [EVERY]: the answer tables of a golden set (SPEC 7) by the naive twin, to compare with
/// those of `cob answer` byte for byte. With EVERY only each EVERY-th row of each question. Slow.
#include "naive/box.hpp"
#include "naive/tables.hpp"
#include "naive/visibility.hpp"

#include <tbb/parallel_for.h>

#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <string>

namespace cob::naive {
namespace {

std::string joined(const std::vector<int>& ids) {
    std::string text;
    for (const int id : ids) text += (text.empty() ? "" : " ") + std::to_string(id);
    return text;
}

/// Rows of each question, answered in parallel, written in order.
template <class Row, class Answer>
std::vector<std::string> answer_rows(const std::vector<Row>& rows, std::size_t every, Answer answer) {
    std::vector<std::string> texts((rows.size() + every - 1) / every);
    tbb::parallel_for(std::size_t{0}, texts.size(), [&](std::size_t k) { texts[k] = answer(rows[k * every]); });
    return texts;
}

void write(const std::string& path, const char* header, const std::vector<std::string>& texts) {
    std::ofstream file(path, std::ios::binary);
    file << header << '\n';
    for (const std::string& text : texts) file << text;
    if (!file.flush()) throw std::runtime_error("cannot write " + path);
}

void answer(const std::string& set, const std::string& folder, std::size_t every) {
    std::vector<SceneItem> scene;
    for (const Face& face : read_faces(set + "/scene.obj")) scene.push_back({prepare(face.corners), face.emits});
    std::filesystem::create_directories(folder);

    if (const auto boxes = read_boxes(set + "/boxes.csv"); !boxes.empty()) {
        std::vector<std::string> relations(boxes.size());
        const auto states = answer_rows(boxes, every, [&](const BoxRow& row) {
            const int own = row.question.polygon;
            const auto answers = relate_all(scene, own, prepare(row.question));
            std::string& text = relations[static_cast<std::size_t>(&row - boxes.data())];
            for (std::size_t id = 0; id < answers.size(); ++id) {
                if (answers[id].relation == Relation::disjoint) continue;
                const Shared touch =
                    own < 0 ? Shared::none : shared(scene[id].polygon, scene[static_cast<std::size_t>(own)].polygon);
                text += row.id + "," + std::to_string(id) + "," + to_text(answers[id].relation) + "," +
                        (answers[id].covers ? "1," : "0,") + to_text(touch) + "\n";
            }
            const State result = state(answers);
            return row.id + "," + result.name + "," + joined(result.close) + "," + joined(result.cover) + "," +
                   joined(result.light) + "\n";
        });
        write(folder + "/states.csv", "box,state,close,cover,light", states);
        write(folder + "/relations.csv", "box,polygon,relation,covers,shared", relations);
    }
    if (const auto segments = read_segments(set + "/segments.csv"); !segments.empty()) {
        std::vector<const Polygon*> polygons;
        for (const SceneItem& item : scene)
            if (item.polygon.refused.empty()) polygons.push_back(&item.polygon);
        const auto texts = answer_rows(segments, every, [&](const SegmentRow& row) {
            return row.id + "," + to_text(visibility(polygons, row.from, row.to)) + "\n";
        });
        write(folder + "/visibility.csv", "segment,visibility", texts);
    }
}

}  // namespace
}  // namespace cob::naive

int main(int argc, char** argv) {
    if (argc < 4 || std::string(argv[2]) != "-o") {
        std::fprintf(stderr, "usage: cob_naive_answer SET -o DIR [EVERY]\n");
        return 2;
    }
    try {
        cob::naive::answer(argv[1], argv[3], argc > 4 ? std::stoul(argv[4]) : 1);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "cob_naive_answer: %s\n", error.what());
        return 2;
    }
    return 0;
}
