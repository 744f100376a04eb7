#include "naive/tables.hpp"

#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>

namespace cob::naive {

namespace {

double number(const std::string& text) {
    const auto value = parse_binary64(text);
    if (!value) throw std::runtime_error("not a number: " + text);
    return *value;
}

Rational fraction(const std::string& text) {
    const auto value = parse_exact(text);
    if (!value) throw std::runtime_error("not an exact number: " + text);
    return *value;
}

/// The fields of each row after the header.
std::vector<std::vector<std::string>> rows(const std::string& path) {
    std::vector<std::vector<std::string>> result;
    std::ifstream file(path);
    std::string line;
    std::getline(file, line);
    while (std::getline(file, line)) {
        std::vector<std::string> fields;
        std::stringstream text(line);
        for (std::string field; std::getline(text, field, ',');) fields.push_back(field);
        fields.resize(21);  // empty ones at the end
        result.push_back(fields);
    }
    return result;
}

RationalPoint point(const std::vector<std::string>& fields, std::size_t first) {
    return {fraction(fields[first]), fraction(fields[first + 1]), fraction(fields[first + 2])};
}

/// Names of the materials that emit.
void read_emitting(const std::string& path, std::map<std::string, bool>& emits) {
    std::ifstream file(path);
    std::string line, name;
    while (std::getline(file, line)) {
        std::istringstream words(line);
        std::string keyword;
        words >> keyword;
        if (keyword == "newmtl") words >> name;
        if (keyword == "Ke")
            for (std::string channel; words >> channel;) emits[name] = emits[name] || number(channel) > 0;
    }
}

}  // namespace

std::vector<Face> read_faces(const std::string& path) {
    std::ifstream file(path);
    if (!file) throw std::runtime_error("cannot read " + path);
    const std::string folder = path.substr(0, path.find_last_of('/') + 1);
    std::vector<Point> positions;
    std::vector<Face> faces;
    std::map<std::string, bool> emits;
    std::string line, material;
    while (std::getline(file, line)) {
        std::istringstream words(line.substr(0, line.find('#')));
        std::string keyword, word;
        words >> keyword;
        if (keyword == "mtllib") {
            words >> word;
            read_emitting(folder + word, emits);
        } else if (keyword == "usemtl") {
            words >> material;
        } else if (keyword == "v") {
            Point position;
            for (int axis = 0; axis < 3 && words >> word; ++axis) position[axis] = number(word);
            positions.push_back(position);
        } else if (keyword == "f") {
            Face face;
            face.emits = emits[material];
            while (words >> word) {
                const long index = std::stol(word);  // up to the first slash
                const std::size_t k = index > 0 ? static_cast<std::size_t>(index - 1)
                                                : positions.size() - static_cast<std::size_t>(-index);
                face.corners.push_back(positions.at(k));
            }
            faces.push_back(face);
        }
    }
    return faces;
}

std::vector<BoxRow> read_boxes(const std::string& path) {
    std::vector<BoxRow> result;
    for (const auto& fields : rows(path)) {
        BoxRow row;
        row.id = fields[0];
        row.question.polygon = std::stoi(fields[1]);
        for (const std::size_t first : {2, 5, 8, 11})
            if (!fields[first].empty()) row.question.corners.push_back(point(fields, first));
        row.question.u = point(fields, 14);
        row.question.margin = fraction(fields[17]);
        row.question.height = fraction(fields[18]);
        result.push_back(row);
    }
    return result;
}

std::vector<SegmentRow> read_segments(const std::string& path) {
    std::vector<SegmentRow> result;
    for (const auto& fields : rows(path)) result.push_back({fields[0], point(fields, 1), point(fields, 4)});
    return result;
}

}  // namespace cob::naive
